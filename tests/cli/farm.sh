# SPDX-License-Identifier: MIT
# bolan farm: files of equal bytes by any number of processes, what is finished is kept, what is damaged is drawn again,
# a process that dies costs its frame, and tables are read as the command line is.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

refuse 2 'farm needs -o' farm open-sea
refuse 2 'expected a numbered name' farm open-sea -o a.png
refuse 2 'expected a numbered name' farm open-sea -o a-%d.mp4
refuse 2 'expected a numbered name' farm open-sea -o a.tiff
refuse 2 '--outputs is picture,depth; expected some of picture' farm open-sea -o out --outputs picture,depth
refuse 2 '--part is 3/3; expected K/N' farm open-sea -o out --part 3/3
refuse 2 '--part is 1; expected K/N' farm open-sea -o out --part 1
refuse 2 '--processes does not go with bolan render' render open-sea -o a.png --processes 2
refuse 2 'worker is started by bolan farm alone' worker
refuse 1 'no/such: cannot be made' farm open-sea -o no/such --frames 2

# Tables: a wrong cell is refused with its line before anything is drawn.
refuse 1 'none.csv: cannot be read' farm none.csv -o out
table() {
    printf "$1" > t.csv # with its escapes
    shift
    refuse 2 "$@" farm t.csv -o out
}
table '' 't.csv: no row'
table 'scene,wind\n' 't.csv: no row'
table 'scene,wnd\nopen-sea,3\n' 't.csv:1: the column wnd; expected scene, or an option'
table 'scene,output\nopen-sea,3\n' 't.csv:1: the column output; expected scene'
table 'wind,wind\n3,3\n' 't.csv:1: the column wind stands twice'
table 'scene,wind\nopen-sea\n' 't.csv:2: 1 cells; expected 2'
table 'scene,wind\nopen-sea,3,4\n' 't.csv:2: 3 cells; expected 2'
table 'scene,wind\nopen-sea,"3\n' 't.csv:2: a quote is wrong in cell 2'
table '# seas\n\nscene,wind\nopen-sea,3\nopen-sea,71\n' 't.csv:5: --wind is 71; expected a number from 0 to 70 m/s'
table 'scene,camera\natlantis,\n' 't.csv:2: atlantis: there is no such scene'
printf 'wind\n3\n' > t.csv
refuse 2 '--frames does not go with a table' farm t.csv -o out --frames 2
rm t.csv
need_gl

tiny='--technique exp-cosine --size 160x90 --quality low --samples 1 --pixels fragment'
# A machine that is slow is told of the progress, on stderr.
film="open-sea $tiny --fps 10 --frames 5 --quiet"

# same A B: two folders hold the same files with the same bytes.
same() { diff -r "$1" "$2" > difference || fail "$1 and $2: $(cat difference)"; }
# has_no_part: nothing unfinished is left.
has_no_part() { [ -z "$(find . -name '*.part*')" ] || fail "left $(find . -name '*.part*')"; }

# shellcheck disable=SC2086 # split on purpose
{
    run farm $film -o one --processes 1
    [ ! -s out ] || fail '--quiet prints'
    run farm ${film% --quiet} -o one --processes 1
    [ "$(cat out)" = one/manifest.json ] || fail 'the name of the manifest is not printed'
    [ "$(ls one | wc -l)" -eq 11 ] || fail "one holds $(ls one)"
    run farm $film -o two --processes 2
    same one two
    run render $film -o 'r-%d.png'
    for i in 0 1 2 3 4; do cmp "r-$i.png" "one/00000$i.png" || fail "frame $i is not that of bolan render"; done
    ! cmp -s r-0.png r-1.png || fail 'the sea stands still'
}
# The hashes are those of sha256sum, and the manifest's.
sed -n 's/.*"\([^"]*png\)": "\([0-9a-f]*\)".*/\2  one\/\1/p' one/manifest.json > sums
[ "$(wc -l < sums)" -eq 5 ] || fail "the manifest lists $(cat sums)"
sha256sum -c sums > out || fail "$(cat out)"

# What is finished stays; what is missing, damaged or of other parameters is drawn.
cp -r one kept
touch -d '2001-01-01' kept/*
rm kept/000001.png kept/000003.json kept/manifest.json
printf x >> kept/000002.png
printf unfinished > kept/000001.png.part999999999
# shellcheck disable=SC2086
run farm $film -o kept --processes 1
same one kept
for i in 0 4; do [ "$(date -r "kept/00000$i.png" +%Y)" = 2001 ] || fail "frame $i was drawn again"; done
for i in 1 2 3; do [ "$(date -r "kept/00000$i.png" +%Y)" != 2001 ] || fail "frame $i was not drawn again"; done

# wait_until COMMAND...: the command succeeds, while the farm runs.
wait_until() {
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ "$tries" -lt 2400 ] || fail "waited in vain for $*: $(cat err)"
        kill -0 "$farm" 2> /dev/null || fail "the farm ended by itself: $(cat err)"
        sleep 0.05
    done
}
begin_hurt() {
    rm -rf hurt
    status=0
    # shellcheck disable=SC2086
    "$BOLAN" farm $film -o hurt --processes 2 > out 2> err &
    farm=$!
}
has_two() { workers=$(ps -o pid= --ppid "$farm") && [ "$(echo "$workers" | wc -l)" -eq 2 ]; }
has_frame() { [ -n "$(find hurt -name '0*.json' 2> /dev/null)" ]; }

# A process dies while it draws its first frame, which takes it longer than any other.
begin_hurt
wait_until has_two
kill -KILL "$(echo "$workers" | head -n 1)"
wait "$farm" || status=$?
[ "$status" -eq 1 ] || fail "a dead process: exit code $status"
[ "$(wc -l < err)" -eq 1 ] || fail "a dead process: $(cat err)"
grep -q '^bolan: 1 of 5 frames failed: [0-9] (its process was ended by signal 9); the same command draws' err ||
    fail "a dead process: $(cat err)"
[ "$(grep -c '"reason": "its process was ended by signal 9"' hurt/manifest.json)" -eq 1 ] || fail 'the manifest knows of no failure'
[ "$(find hurt -name '*.png' | wc -l)" -eq 4 ] || fail "a dead process cost more than its frame: $(ls hurt)"
# The farm is killed after a frame.
begin_hurt
wait_until has_two
wait_until has_frame
kill -KILL "$farm" 2> /dev/null || true
wait "$farm" || status=$?
tries=0
# shellcheck disable=SC2086
while kill -0 $workers 2> /dev/null; do
    tries=$((tries + 1))
    [ "$tries" -lt 200 ] || fail 'processes without a farm live on'
    sleep 0.05
done
has_no_part
# shellcheck disable=SC2086
run farm $film -o hurt --processes 1
same one hurt

# Layers stand in one file of floats.
# shellcheck disable=SC2086
run farm $film -o layers --processes 1 --frames 1 --outputs linear,distance,normal,segmentation,motion
[ ! -e layers/000000.png ] || fail 'a picture that was not asked for'
for channel in R G B Z normal.X normal.Y normal.Z motion.X motion.Y motion.Z segmentation; do
    head -c 2000 layers/000000.exr | grep -aq "$channel" || fail "the layers lack $channel"
done
grep -q '"layers' layers/manifest.json && fail 'the manifest names the folder'

# A table: the columns are options, a quoted cell holds commas, an empty cell is not given.
cat > seas.csv << 'END'
# three seas
scene, seed, wind, time, camera
open-sea, 1, 12, 3.5, "0,0,4,200,-5"

island,,,,
open-sea, 7, , 20, "10,20,6,90,-10,70"
END
# shellcheck disable=SC2086
{
    run farm seas.csv $tiny -o 's-%02d.png' --processes 1 --quiet
    run farm seas.csv $tiny -o 's-%02d.png' --processes 1
    [ "$(cat out)" = s-manifest.json ] || fail "the manifest is $(cat out)"
    run render open-sea --seed 1 --wind 12 --time 3.5 --camera 0,0,4,200,-5 $tiny -o r.png
    cmp r.png s-00.png || fail 'the first row is another picture'
    run render island $tiny -o r.png
    cmp r.png s-01.png || fail 'the second row is another picture'
    run render open-sea --seed 7 --time 20 --camera 10,20,6,90,-10,70 $tiny -o r.png
    cmp r.png s-02.png || fail 'the third row is another picture'
}
grep -q '"frame": 2, "time": 20, "line": 6, ' s-manifest.json || fail 'the manifest does not name the line of a row'
grep -q '"camera.heading_deg": 200,' s-00.json || fail 'the record lacks the camera'
grep -q '"backend": "auto",' s-00.json || fail 'the record lacks what makes the waves'
grep -q '"pixels": "fragment",' s-00.json || fail 'the record lacks what shades the pixels'
grep -q '"sea.seed": 7,' s-02.json || fail 'the record lacks the seed'
has_no_part
