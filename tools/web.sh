#!/bin/sh
# SPDX-License-Identifier: MIT
# The web page: build/web, by emscripten. Objects stay in build/web-obj; a program of build/ prints the scenes.
set -eu
cd "$(dirname "$0")/.."
if ! command -v emcc > /dev/null; then
    echo 'The web page needs emscripten: apt-get install emscripten' >&2
    exit 1
fi
export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}" # where Debian keeps the modules that emscripten loads
mkdir -p build/web-obj
# quietly COMMAND...: shows what it says where it fails.
quietly() {
    "$@" > build/web-obj/log 2>&1 || { cat build/web-obj/log >&2; exit 1; }
}
[ -f build/build.ninja ] || quietly cmake --preset release
quietly cmake --build build --target bolan_print_scenes
build/bolan_print_scenes > build/web-obj/scenes.new
cmp -s build/web-obj/scenes.new build/web-obj/scenes.c || cp build/web-obj/scenes.new build/web-obj/scenes.c
quietly cmake --preset web "-DBOLAN_WEB_SCENES=$PWD/build/web-obj/scenes.c" "-DBOLAN_WEB_FOLDER=$PWD/build/web"
exec cmake --build --preset web --target bolan_web
