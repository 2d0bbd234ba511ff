#!/bin/sh
# SPDX-License-Identifier: MIT
# views.sh [FOLDER [NAME...]]: renders 24 views of open water, 1280 x 720, and one page FOLDER/index.html that shows them
# with height, wind and sun; FOLDER is out/views without it. Views named after FOLDER are rendered alone. Look at each one:
# would you believe it is water?
set -eu
cd "$(dirname "$0")/.."
bolan=build/bolan
folder=${1:-out/views}
[ $# -eq 0 ] || shift
wanted=" $* "
mkdir -p "$folder"
rm -f "$folder/index.html"

# name | eye over the surface below it [m] | wind [m/s] | sun: azimuth,elevation [deg] | heading,pitch,fov [deg] | cover of
# clouds. The eye looks near the sun, across its light or away from it.
views='
calm-0.3       .3    1   205,50  225,-3,55   .3
breeze-0.3     .3    8   190,5   210,-2,55   .4
gale-0.3       .3   20   150,50  240,0,60    .7
calm-1          1    1   215,-5  225,-4,55   .4
breeze-1        1    8   230,50  240,-6,55   .3
gale-1          1   20   228,5   240,0,55    .6
hurricane-1     1   35   270,50  240,0,60    .95
calm-3          3    1   210,5   225,-5,50   .4
breeze-3        3    8   60,50   240,-7,50   .3
gale-3          3   20   245,50  240,-2,50   .6
hurricane-3     3   35   235,5   240,0,55    .9
calm-30        30    1   40,50   225,-9,50   .3
breeze-30      30    8   235,5   240,-8,50   .4
gale-30        30   20   100,50  240,-10,50  .6
hurricane-30   30   35   235,50  240,-10,50  .95
calm-300      300    1   225,50  225,-13,50  .2
breeze-300    300    8   230,-5  240,-10,50  .4
gale-300      300   20   250,50  240,-14,50  .6
hurricane-300 300   35   330,50  240,-14,50  .9
breeze-3000  3000    8   240,50  240,-24,50  .2
gale-3000    3000   20   235,5   240,-16,50  .3
below-1        -1    8   205,50  225,20,70   .3
below-5        -5    8   210,50  225,38,75   .3
below-20      -20   20   205,50  225,25,75   .4
'
total=$(printf '%s\n' "$views" | grep -c .)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
scene=$scratch/view.yaml

# write_scene WIND SUN COVER: the open sea under that sky. Haze thickens as spray fills the air.
write_scene() {
    cat >"$scene" <<YAML
technique: ocean
sea:
  wind: {speed: $1, from: 240}
  fetch_km: $(awk -v u="$1" 'BEGIN { print u < 3 ? 5 : 300 }')
  swell:
    - {hs: $(awk -v u="$1" 'BEGIN { print u < 3 ? 0.15 : 1.2 }'), tp: 11, from: 290, spread: 45}
  seed: 4
water: {type: IB}
sky:
  sun: {azimuth: ${2%,*}, elevation: ${2#*,}}
  visibility_km: $(awk -v u="$1" 'BEGIN { print u < 15 ? 50 : u < 25 ? 25 : 8 }')
  clouds: {cover: $3, base: 1200, seed: 5}
time: 20
YAML
}

# level: height of the surface over the scene's origin [m].
level() {
    printf 'x,y\n0,0\n' >"$scratch/origin.csv"
    "$bolan" query "$scene" --points "$scratch/origin.csv" | awk -F, 'END { print $3 }'
}

# place HEIGHT: the height in words.
place() { awk -v h="$1" 'BEGIN { printf h < 0 ? "%g m below the surface" : "%g m above the surface", h < 0 ? -h : h }'; }

done_so_far=0
printf '%s\n' "$views" | grep . | while read -r name height wind sun look cover; do
    done_so_far=$((done_so_far + 1))
    words="$(place "$height"), wind $wind m/s, sun at ${sun#*,}°"
    case $wanted in
    '  ' | *" $name "*)
        echo "$done_so_far/$total $name: $words"
        write_scene "$wind" "$sun" "$cover"
        eye=$(awk -v h="$height" -v level="$(level)" 'BEGIN { print h + level }')
        nice -n 10 "$bolan" render "$scene" -o "$folder/$name.png" --size 1280x720 --camera "0,0,$eye,$look" --quiet
        ;;
    esac
    printf '<figure><img src="%s.png" width="1280" height="720" alt="%s"><figcaption>%s: %s</figcaption></figure>\n' \
        "$name" "$name" "$name" "$words" >>"$scratch/figures"
done
{
    cat <<'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Views - Bolan</title>
<style>
body { margin: 1em; font-family: sans-serif; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(30em, 1fr)); gap: 1em; }
figure { margin: 0; }
img { width: 100%; height: auto; }
</style>
</head>
<body>
<main>
HTML
    cat "$scratch/figures"
    printf '</main>\n</body>\n</html>\n'
} >"$folder/index.html"
echo "The views are in $folder/index.html"
