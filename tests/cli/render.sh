# SPDX-License-Identifier: MIT
# bolan render: pictures, sequences and films of a size that software OpenGL draws at once; the same ones every time.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

# Refusals need no OpenGL.
refuse 1 'no/such/a.png: cannot be written: No such file or directory' render open-sea -o no/such/a.png
refuse 1 'no/such/a.exr: cannot be written: No such file or directory' render open-sea -o no/such/a.exr
refuse 2 'the camera stands 3 m below the water' render open-sea -o a.png --technique flight-sim --camera 0,0,-3,0,0
mkdir folder.png
refuse 1 'folder.png: cannot be written: Is a directory' render open-sea -o folder.png
need_gl
refuse 1 'no/such/a.mp4: cannot be written: No such file or directory' render open-sea -o no/such/a.mp4 --size 64x36 --quality low
full_path=$PATH
PATH=/nowhere:/bin
if ! command -v ffmpeg > /dev/null; then
    refuse 1 'the program ffmpeg was not found' render open-sea -o a.mp4 --size 64x36 --quality low
fi
PATH=$full_path

tiny='--size 96x54 --quality low --samples 1'
# shellcheck disable=SC2086 # split on purpose
{
    run render open-sea -o a.png $tiny
    [ "$(cat out)" = 'a.png' ] || fail 'the path is not printed'
    [ "$(od -An -tx1 -N4 a.png | tr -d ' ')" = 89504e47 ] || fail 'a.png is not a PNG'
    # Width and height stand in bytes 16 to 23.
    [ "$(od -An -tx1 -j16 -N8 a.png | tr -d ' ')" = 0000006000000036 ] || fail 'a.png is not 96 x 54'
    run render open-sea -o b.png $tiny --threads 1 --quiet
    [ ! -s out ] || fail '--quiet prints'
    cmp a.png b.png || fail 'the same scene gave another picture'
    run render open-sea -o c.png $tiny --time 25
    ! cmp -s a.png c.png || fail 'the sea stands still'
    run render open-sea -o d.exr $tiny
    [ "$(od -An -tx1 -N4 d.exr | tr -d ' ')" = 762f3101 ] || fail 'd.exr is not an EXR'
    run render open-sea -o 'frame-%03d.png' $tiny --frames 3 --fps 10
    [ "$(echo frame-*.png)" = 'frame-000.png frame-001.png frame-002.png' ] || fail "frames: $(echo frame-*)"
    cmp a.png frame-000.png || fail 'the first frame is another picture'
    ! cmp -s frame-000.png frame-001.png || fail 'the second frame equals the first'
    if command -v ffmpeg > /dev/null; then
        for name in film.mp4 film.webm; do
            run render open-sea -o "$name" $tiny --frames 4 --fps 10
            [ -s "$name" ] || fail "no $name"
        done
    fi
}
# In tiles, with guard bands that are cut off, the image is the same to a level of 255.
refuse 2 'expected at most 268435456 pixels in all' render open-sea -o a.png --size 65536x5000
if "$BOLAN" view --help > out 2>&1; then
    refuse 2 'a window has at most 16384 pixels each way' view open-sea --size 20000x500
fi
refuse 2 '--tile is 100; expected a whole number from 448 to 16384' render open-sea -o a.png --tile 100
run render open-sea -o whole.png --size 700x500 --quality low --samples 1
run render open-sea -o tiles.png --size 700x500 --quality low --samples 1 --tile 448
if command -v python3 > /dev/null; then
    python3 "$BOLAN_SOURCE_DIR/tests/cli/compare_png.py" whole.png tiles.png 1 || fail 'tiles are not the whole'
    ! python3 "$BOLAN_SOURCE_DIR/tests/cli/compare_png.py" a.png c.png 1 > out 2>&1 || fail 'every image is the same'
fi
[ "$(find . -name '*.part*' | wc -l)" -eq 0 ] || fail 'a temporary file was left'
