#!/bin/sh
# SPDX-License-Identifier: MIT
# The web page: build/web, by emscripten. Objects stay in build/web-obj. Needs a configured build/ for its scenes.
set -eu
cd "$(dirname "$0")/.."
if ! command -v emcc > /dev/null; then
    echo 'The web page needs emscripten: apt-get install emscripten' >&2
    exit 1
fi
export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}" # where Debian keeps the modules that emscripten loads
mkdir -p build/web-obj
cmake --build build --target bolan_print_scenes > build/web-obj/scenes.log || { cat build/web-obj/scenes.log >&2; exit 1; }
build/bolan_print_scenes > build/web-obj/scenes.new
cmp -s build/web-obj/scenes.new build/web-obj/scenes.c || cp build/web-obj/scenes.new build/web-obj/scenes.c
if ! log=$(cmake --preset web -DBOLAN_WEB_SCENES="$PWD/build/web-obj/scenes.c" -DBOLAN_WEB_FOLDER="$PWD/build/web" 2>&1); then
    printf '%s\n' "$log" >&2
    exit 1
fi
exec cmake --build --preset web --target bolan_web
