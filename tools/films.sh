#!/bin/sh
# SPDX-License-Identifier: MIT
# films.sh [FOLDER [NAME...]]: renders short films of storm, reef, underwater and waterline, an eye at the surface of a
# breeze, and says how much the mean brightness jumps from frame to frame. FOLDER is out/films without it. Films named
# after FOLDER are rendered alone. Needs ffmpeg. Environment:
#     SIZE    pixels, 640x360 without it
#     LENGTH  of a film [s], 10 without it
#     BOLAN   the program, build/bolan without it
set -eu
cd "$(dirname "$0")/.."
bolan=${BOLAN:-build/bolan}
size=${SIZE:-640x360}
seconds=${LENGTH:-10}
rate=25
folder=${1:-out/films}
[ $# -eq 0 ] || shift
wanted=" $* "
mkdir -p "$folder"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM

cat >"$scratch/waterline.yaml" <<'YAML'
technique: ocean
sea:
  wind: {speed: 6, from: 240}
  fetch_km: 60
  seed: 4
water: {type: IB}
sky:
  sun: {azimuth: 190, elevation: 40}
  visibility_km: 50
  clouds: {cover: 0.3, base: 1200, seed: 5}
camera: {position: [0, 0, 0.02], heading: 225, pitch: 0, fov: 65}
time: 20
YAML

# jumps FILM: mean and largest change of the mean luma from one frame to the next [1/255].
jumps() {
    ffmpeg -v error -i "$1" -vf signalstats,metadata=print:key=lavfi.signalstats.YAVG:file=- -f null - |
        awk -F= '/YAVG/ { if (n++) { d = $2 - last; if (d < 0) d = -d; sum += d; if (d > most) { most = d; at = n } }
                          last = $2 }
                 END { if (n > 1) printf "mean luma changes by %.2f a frame, by %.2f at most, in frame %d\n",
                                         sum / (n - 1), most, at }'
}

done_so_far=0
for name in storm reef underwater waterline; do
    done_so_far=$((done_so_far + 1))
    case $wanted in
    '  ' | *" $name "*) ;;
    *) continue ;;
    esac
    scene=$name
    set --
    case $name in
    storm) set -- --camera 0,0,14,283,-4,42 ;; # the scene's own eye is under water after two seconds
    waterline) scene=$scratch/waterline.yaml ;;
    esac
    echo "$done_so_far/4 $name: $seconds s, $size"
    nice -n 10 "$bolan" render "$scene" "$@" -o "$folder/$name.mp4" --size "$size" --fps "$rate" \
        --frames $((seconds * rate)) --quiet
    jumps "$folder/$name.mp4"
done
echo "The films are in $folder"
