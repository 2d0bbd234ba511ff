# SPDX-License-Identifier: MIT
# Where the program's files end up: links, pipes, percent signs, long names, full disks; and films whose ffmpeg fails.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

printf '0,0\n5,7\n' > points.csv
run query open-sea --points points.csv
mv out right.csv

# Links are followed; a pipe is written once, and its reader gets everything.
mkdir real
ln -s real/target.csv link.csv
run query open-sea --points points.csv -o link.csv
[ -L link.csv ] || fail 'a link was replaced'
cmp real/target.csv right.csv || fail 'the target of a link has another content'
mkfifo pipe
timeout 60 cat pipe > got &
timeout 60 "$BOLAN" query open-sea --points points.csv -o pipe || fail 'a pipe as output'
wait $!
cmp got right.csv || fail 'the reader of a pipe got something else'
[ -p pipe ] || fail 'a pipe was replaced'
"$BOLAN" query open-sea --points points.csv -o /dev/stdout | cmp - right.csv || fail '/dev/stdout'

# Modes are kept, and files that nobody may write.
chmod 600 real/target.csv
run query open-sea --points points.csv -o link.csv
[ "$(stat -c %a real/target.csv)" = 600 ] || fail 'the mode changed'
chmod 400 real/target.csv
rm -f out err
refuse 1 'link.csv: cannot be written: Permission denied' query open-sea --points points.csv -o link.csv
chmod 600 real/target.csv

# A file that may not grow is a sentence, and so is standard output that may not.
awk 'BEGIN { for (i = 0; i < 3000; i++) print i ",0" }' > many.csv
(
    ulimit -f 8
    refuse 1 'big.csv: cannot be written: File too large' query open-sea --points many.csv -o big.csv
    status=0
    "$BOLAN" query open-sea --points many.csv > big 2> said || status=$?
    [ "$status" -eq 1 ] || fail "standard output that may not grow: exit code $status"
    grep -q 'standard output cannot be written' said || fail "standard output that may not grow: $(cat said)"
    rm -f big said
)

# bake: a slash at the end, and what is there already.
run bake pond -o baked/ --frames 2
[ -f baked/index.json ] || fail 'bake -o DIR/'
ln -s nowhere lost
rm -f out err
refuse 1 'lost: cannot be written: File exists' bake pond -o lost --frames 2
refuse 1 'baked/: cannot be written: File exists' bake pond -o baked/ --frames 2
ln -s pipe pipe.mp4
refuse 1 'a video cannot go into a device or pipe' render open-sea -o pipe.mp4 --size 64x36
rm pipe.mp4
# In a folder that is not there: said before the sea is made.
refuse 1 'no/a.mp4: cannot be written' render no-scene.yaml -o no/a.mp4

need_gl
tiny='--size 64x36 --quality low --samples 1'
long=$(printf '%0247d' 0).png
# shellcheck disable=SC2086 # split on purpose
{
    # A percent sign counts in the last part of the name alone; %% is one; one that begins no pattern is itself.
    mkdir 'a%20b' 'n%d'
    run render open-sea -o 'a%20b/100% %%d%s.png' $tiny
    [ -s 'a%20b/100% %d%s.png' ] || fail "percent signs: $(ls 'a%20b')"
    [ "$(cat out)" = 'a%20b/100% %d%s.png' ] || fail "the name is printed as $(cat out)"
    run render open-sea -o 'n%d/%%-%03d-%%.png' $tiny --frames 2
    [ "$(ls 'n%d')" = "$(printf '%%-000-%%.png\n%%-001-%%.png')" ] || fail "a numbered sequence: $(ls 'n%d')"
    run render open-sea -o "$long" $tiny
    [ -s "$long" ] || fail 'a name of 251 bytes'

    # Films: ffmpeg that dies, complains, writes half, or writes nothing; the disk that is full.
    mkdir bin
    old_path=$PATH
    PATH=$PWD/bin:$PATH
    for way in 'exit 1' 'echo it is broken >&2' 'printf half > "${f#file:}"' ': > "${f#file:}"'; do
        printf '#!/bin/sh\nfor f; do :; done\ncat > /dev/null\n%s\n' "$way" > bin/ffmpeg
        chmod +x bin/ffmpeg
        rm -f out err
        refuse 1 'film.mp4: ffmpeg failed: ' render open-sea -o film.mp4 $tiny --frames 2
    done
    PATH=$old_path
    rm -f out err
    if command -v ffmpeg > /dev/null; then
        mkdir small
        if mount -t tmpfs -o size=8k tmpfs small 2> /dev/null; then
            refuse 1 'small/f.mp4: ffmpeg failed: ' render open-sea -o small/f.mp4 --size 320x180 --quality low --frames 4
            [ -z "$(ls -A small)" ] || fail "a full disk: left $(ls -A small)"
            umount small
        fi
        (
            ulimit -f 4
            refuse 1 'f.webm: ffmpeg failed: ' render open-sea -o f.webm --size 320x180 --quality low --frames 4
        )
    fi
}
[ "$(find . -name '*part*' | wc -l)" -eq 0 ] || fail 'a temporary file was left'
