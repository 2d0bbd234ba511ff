# SPDX-License-Identifier: MIT
# INT, TERM, HUP and QUIT end every long command at once, also when they come twice, and leave nothing behind. At once
# is a tenth of a second on an idle machine; the bound of 5 s leaves room for the tests that run beside this one. The
# exit code tells an interrupted command from one that came to its end. INT is sent as well although a shell starts
# background jobs with it ignored: the program listens.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

mkdir work bin
cd work

# now: milliseconds
now() { echo $(($(date +%s%N) / 1000000)); }

# listens: the program has begun to catch signals.
# The last digit holds HUP (1), INT (2) and QUIT (4); a shell that has yet to become the program catches none of them.
listens() { grep -q '^SigCgt:.*[67]$' "/proc/$process/status"; }

# interrupt 'SIGNALS' READY ARGUMENTS...: starts the program, waits until the shell command READY succeeds (and then a
# little), sends the signals, 10 ms apart.
interrupt() {
    signals=$1
    ready=$2
    shift 2
    "$BOLAN" "$@" > ../out 2> ../err < /dev/null &
    process=$!
    tries=0
    until eval "$ready"; do
        tries=$((tries + 1))
        [ "$tries" -lt 600 ] || fail "bolan $*: never came as far as: $ready"
        kill -0 "$process" 2> /dev/null || fail "bolan $*: ended by itself: $(cat ../err)"
        sleep 0.05
    done
    sleep 0.05
    before=$(now)
    for signal in $signals; do
        kill "-$signal" "$process" 2> /dev/null || true
        sleep 0.01
    done
    status=0
    wait "$process" || status=$?
    took=$(($(now) - before))
    [ "$status" -eq 130 ] || fail "bolan $* after $signals: exit code $status, expected 130"
    [ "$took" -lt 5000 ] || fail "bolan $* after $signals: took $took ms"
    [ -z "$(ls -A)" ] || fail "bolan $* after $signals: left $(ls -A)"
    [ ! -s ../err ] || fail "bolan $* after $signals: said $(cat ../err)"
}

# Commands that need no OpenGL.
awk 'BEGIN { for (i = 0; i < 400000; i++) print i * 3 "," i % 1000 }' > ../many.csv
for signal in INT TERM HUP QUIT 'INT INT'; do
    interrupt "$signal" listens query storm --points ../many.csv -o answers.csv
done
interrupt TERM 'ls tiles.part*/height_001.pgm > /dev/null 2>&1' bake pond -o tiles --frames 64
interrupt 'INT INT' 'ls tiles.part* > /dev/null 2>&1' bake pond -o tiles/ --frames 64
interrupt HUP listens measure storm --threads 1
mkfifo ../silent
interrupt TERM listens query open-sea --points ../silent
rm ../silent

# A terminal that goes away ends the program, unless somebody asked for it not to.
(
    trap '' HUP
    "$BOLAN" query open-sea --points ../many.csv > ../out 2> ../err &
    process=$!
    until listens; do sleep 0.05; done
    kill -HUP "$process"
    wait "$process"
) || fail 'nohup is not obeyed'

need_gl
tiny='--size 96x54 --quality low'
# shellcheck disable=SC2086 # split on purpose
{
    # One picture of many samples is not waited for.
    interrupt INT 'sleep 4' render open-sea -o one.exr --size 640x360 --quality ultra --samples 256
    mkdir ../frames
    interrupt TERM '[ -e ../frames/s-0001.png ]' render open-sea -o '../frames/s-%04d.png' $tiny --frames 100000
    [ "$(find ../frames -name '*part*' | wc -l)" -eq 0 ] || fail 'a sequence left a part of a picture'
}

# An ffmpeg that hangs, with a child of its own that hangs too.
printf '#!/bin/sh\nsleep 1000 & echo $! > ../bin/sleeper; echo > ../bin/started; wait\n' > ../bin/ffmpeg
chmod +x ../bin/ffmpeg
PATH=$(cd ../bin && pwd):$PATH
export PATH
for signal in 'INT INT' HUP; do
    rm -f ../bin/started
    # shellcheck disable=SC2086
    interrupt "$signal" '[ -e ../bin/started ]' render open-sea -o film.mp4 $tiny --frames 100000
    case $(ps -o stat= -p "$(cat ../bin/sleeper)" || true) in
    '' | Z*) ;;
    *) fail "after $signal a process of ffmpeg lives on" ;;
    esac
done
