#!/bin/sh
# SPDX-License-Identifier: MIT
# Shows the default scene: in a window where there is a display, else as a picture and a film in out/.
set -eu
cd "$(dirname "$0")/.."
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    echo 'Opening a window on the default scene (build/bolan view)'
    exec build/bolan view
fi
mkdir -p out
echo 'There is no display: rendering a picture, then a film of 10 seconds'
build/bolan render island -o out/island.png --size 1920x1080
# Medium, as the viewer: software OpenGL takes a second and more for a frame of high quality.
build/bolan render island -o out/island.mp4 --size 1280x720 --frames 300 --fps 30 --quality medium
echo 'The default scene is in:'
echo '  out/island.png'
echo '  out/island.mp4'
