#!/bin/sh
# SPDX-License-Identifier: MIT
# setup.sh [GROUPS...]: installs the Debian or Ubuntu packages that this machine lacks of the groups: build (the program
# and the libraries), test (the tests; with build and docs), docs (the site), deb (Debian packages), web (the page and
# its browser), slurm (a queue of one node). Without GROUPS it is test. Silent, and without apt-get, when none is missing.
# BOLAN_SKIP_SETUP=1 leaves the machine as it is.
set -eu
[ -z "${BOLAN_SKIP_SETUP:-}" ] || exit 0

tools='build-essential cmake ninja-build pkg-config'
graphics='libegl-dev libgl-dev libgl1-mesa-dri libepoxy-dev libsdl2-dev libimgui-dev'
files='libstb-dev libyaml-dev libopenexr-dev libgdal-dev libassimp-dev zlib1g-dev libnetcdf-dev ffmpeg'
build="$tools $graphics $files"
docs='doxygen cmark-gfm python3-pygments ffmpeg'
deb='debhelper dh-python lintian python3-pip python3-setuptools python3-wheel'
shells='groff-base man-db zsh fish'
python='python3-cffi python3-numpy python3-pytest python3-matplotlib python3-pip python3-setuptools'
web='emscripten chromium'
slurm='slurmctld slurmd slurm-client munge'
test="$build $docs $shells $python libopenmpi-dev openmpi-bin glslang-tools libcmocka-dev libfftw3-dev xvfb xauth locales python3-yaml"

packages=
for group in "${@:-test}"; do
    case $group in
    build) packages="$packages $build" ;;
    docs) packages="$packages $docs" ;;
    deb) packages="$packages $deb" ;;
    web) packages="$packages $web" ;;
    slurm) packages="$packages $slurm" ;;
    test) packages="$packages $test" ;;
    *) echo "setup.sh: unknown group $group; expected build, test, docs, deb, web, slurm" >&2 && exit 2 ;;
    esac
done
packages=$(printf '%s\n' $packages | sort -u | tr '\n' ' ')

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    # Elsewhere what the build needs is known by its programs and its .pc files.
    if [ "$*" = build ] && command -v cc cmake ninja pkg-config >/dev/null &&
        pkg-config --exists egl gl epoxy sdl2 imgui yaml-0.1 OpenEXR gdal assimp zlib netcdf; then
        exit 0
    fi
    echo 'Bolan sets itself up on Debian and Ubuntu only. Install what these packages hold, then run again with' >&2
    echo 'BOLAN_SKIP_SETUP=1 in the environment:' >&2
    echo "  $packages" >&2
    exit 1
fi

# One call for all; it fails where one is unknown, and prints the rest.
# shellcheck disable=SC2086 # the list is words
installed=$(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' $packages 2>/dev/null | sed -n 's/^ii *//p') || true
missing=
for package in $packages; do
    case "
$installed
" in
    *"
$package
"*) ;;
    *) missing="$missing $package" ;;
    esac
done
[ -n "$missing" ] || exit 0

echo "Installing:$missing"
as_root=
if [ "$(id -u)" != 0 ]; then
    as_root=sudo
    if ! command -v sudo >/dev/null; then
        echo "Not root, and there is no sudo. As root, run: apt-get install$missing" >&2
        exit 1
    fi
fi
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
