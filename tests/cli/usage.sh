# SPDX-License-Identifier: MIT
# Help, versions, and every way to write an option wrongly: exit code 2 and one sentence that names the option.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

run --help
for name in render measure query info bake export farm; do
    grep -q "bolan $name " out || fail "--help does not list $name"
done
! grep -q 'bolan worker' out || fail '--help lists what nobody calls'
run --version
grep -q '^bolan [0-9]*\.[0-9]*\.[0-9]*$' out || fail 'no version'
for name in render measure query info bake export farm; do
    run "$name" --help
    grep -q "^usage: bolan $name" out || fail "$name --help has no usage line"
done
run render --help
grep -q -- '--camera X,Y,Z,HEADING,PITCH' out || fail 'render --help does not list --camera'
rm -f out err

status=0
"$BOLAN" > out 2> err || status=$?
[ "$status" -eq 2 ] || fail "without a command: exit code $status"
[ ! -s out ] || fail 'without a command: printed on stdout'
rm -f out err

refuse 2 'unknown command frobnicate; see bolan --help' frobnicate
refuse 2 'unknown option --wnd; see bolan measure --help' measure --wnd 3
refuse 2 'unknown option -x' measure -x
refuse 2 '--frames does not go with bolan measure' measure --frames 3
refuse 2 '--points does not go with bolan render' render --points a.csv -o a.png
refuse 2 '--wind needs a value: MPS' measure --wind
refuse 2 '--json takes no value' measure --json=yes
refuse 2 'unexpected storm; bolan measure takes one scene' measure island storm
for bad in nan NaN inf -inf -1 71 1e999 0x10 ten '' '12 ' ' 12' 1,5 --json; do
    refuse 2 "--wind is " measure --wind "$bad"
    refuse 2 "; expected a number from 0 to 70 m/s" measure "--wind=$bad"
done
for bad in nan inf 1e10 soon; do
    refuse 2 '--time is ' measure --time "$bad"
done
refuse 2 '--seed is 1.5; expected a whole number' measure --seed 1.5
refuse 2 '--seed is -1; expected a whole number' measure --seed -1
refuse 2 '--sea-state is 10' measure --sea-state 10
refuse 2 '--beaufort is 13' measure --beaufort 13
refuse 2 '--depth is 0;' measure --depth 0
refuse 2 '--threads is 65' measure --threads 65
refuse 2 '--cpu is mmx; expected auto, scalar' measure --cpu mmx
refuse 2 '--technique is lava; expected ocean' measure --technique lava
refuse 2 '--waves is exp; expected fft, cosines, exp-cosine, textures' measure --waves exp
refuse 2 '--surface is flat; expected projected, nested, quad' render --surface flat
refuse 2 '--optics is none; expected physical, mirror, phong, lit, crest' render --optics none
refuse 2 '--show is all; expected picture, mask, mesh' render --show all -o a.png
refuse 2 '--effects is foam,sparkle; expected all, none, or some of reflection' render --effects foam,sparkle -o a.png
refuse 2 '--effects is foam,,fog; expected all, none' render --effects foam,,fog -o a.png
refuse 2 '--effects does not go with bolan measure' measure --effects foam
refuse 2 '--record chooses from a spectrum file' measure --record 2
refuse 2 '--location chooses from a spectrum file' measure --location 2
refuse 2 '--from completes a spectrum file' measure --from 2
refuse 2 '--spread completes a spectrum file' measure --spread 2
refuse 2 '--from is 361; expected a number from -360 to 360 degrees' measure --spectrum a.spec --from 361
refuse 2 '--spread is 201; expected a number from 0 to 200' measure --spectrum a.spec --spread 201
refuse 2 '--wind, --beaufort and --sea-state exclude each other' measure --wind 3 --beaufort 4
refuse 2 '--fetch does not go with --beaufort' measure --fetch 30 --beaufort 4
refuse 2 '--spectrum tma is a sea of finite depth; give --depth' measure --spectrum tma
refuse 2 '--at is a place in a raster' render --at 3,4 -o a.png
refuse 2 '--at has a latitude beyond 90' render coast --at 94,3 -o a.png
refuse 2 '--at is 3; expected LAT,LON' render --at 3 -o a.png
refuse 2 '--backend is gpu; expected auto' render -o a.png --backend gpu
refuse 2 '--pixels is gpu; expected auto' render -o a.png --pixels gpu
refuse 2 '--camera is 1,2,3; expected X,Y,Z,HEADING,PITCH[,FOV]' render -o a.png --camera 1,2,3
refuse 2 '--camera is 1,2,3,4,nan' render -o a.png --camera 1,2,3,4,nan
refuse 2 'camera.pitch_deg is 100; expected -90 to 90' render -o a.png --camera 1,2,3,4,100
refuse 2 'sky.sun_elevation_deg is 100' render -o a.png --sun 3,100
refuse 2 '--water is 2C; expected I, IA' render -o a.png --water 2C
refuse 2 '--quality is best; expected low' render -o a.png --quality best
refuse 2 '--size is 640; expected WIDTHxHEIGHT' render -o a.png --size 640
refuse 2 '--size is 640x0' render -o a.png --size 640x0
refuse 2 '--size is 99999x10' render -o a.png --size 99999x10
refuse 2 '--samples is 0' render -o a.png --samples 0
refuse 2 'render needs -o FILE' render
refuse 2 'expected a name that ends in .png' render -o a.jpg
for bad in 'a%d%d.png' 'a%99999d.png' 'a%4d.png' 'a%00d.png' 'a%04d-%d.exr' 'f%d/a%+d.png' 'a%d.mp4'; do
    refuse 2 "-o $bad: expected %d or %04d, once" render -o "$bad"
done
refuse 2 '--frames 3 into one picture' render -o a.png --frames 3
refuse 2 'width and height are even' render -o a.mp4 --size 101x100
refuse 2 'query needs --points FILE' query
refuse 2 'unexpected storm; bolan info takes one file' info island storm
refuse 1 'island: cannot be read: No such file' info island
refuse 2 'there is no such scene; expected approach, calm, coast, island' measure atlantis
