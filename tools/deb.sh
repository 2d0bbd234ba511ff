#!/bin/sh
# SPDX-License-Identifier: MIT
# deb.sh [FOLDER [BUILD]]: makes the Debian packages bolan, libbolan<version>, libbolan-dev and python3-bolan of
# packaging/debian in FOLDER, by default build-deb, and lists them. BUILD is a build folder of shared libraries whose
# objects are packaged; without it everything is compiled. The source tree stays as it is.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$source/build-deb}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
build=${2:-$folder/build}

version=$(sed -n 's/^project(bolan VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
library=libbolan${version%.*} # after the SONAME, which is major.minor
maintainer=$(sed -n 's/^Maintainer: //p' "$source/packaging/debian/control")
date=$(git -C "$source" log -1 --format=%aD 2>/dev/null || date -R -r "$source/CHANGELOG.md")

rm -rf "$folder/bolan-$version" "$folder"/*.deb "$folder"/*.changes "$folder"/*.buildinfo
mkdir "$folder/bolan-$version"
cd "$folder/bolan-$version"
cp -r "$source/packaging/debian" debian
sed -i "s/@LIBRARY@/$library/g" debian/control debian/*.in
mv debian/LIBRARY.lintian-overrides.in "debian/$library.lintian-overrides"
printf 'bolan (%s) unstable; urgency=medium\n\n  * Version %s; CHANGELOG.md says what is new.\n\n -- %s  %s\n' \
    "$version" "$version" "$maintainer" "$date" >debian/changelog
{
    sed "s/@COPYRIGHT@/$(sed -n 's/^Copyright (c) //p' "$source/LICENSE")/" "$source/packaging/debian/copyright"
    sed '1,/^Copyright/d; /./!s/^$/./; s/^/ /' "$source/LICENSE" | sed '1d'
} >debian/copyright

# make and cmake of a build around this one would hand on their jobs and flags.
unset MAKEFLAGS MFLAGS MAKELEVEL
export SOURCE="$source" BUILD="$build" LIBRARY="$library"
export DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-parallel=${BOLAN_JOBS:-2}}"
if ! dpkg-buildpackage --build=binary --no-sign >"$folder/log" 2>&1; then
    tail -n 40 "$folder/log" >&2
    echo "The packages are not built; the log is $folder/log" >&2
    exit 1
fi
ls "$folder"/*.deb
