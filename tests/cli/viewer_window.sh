#!/bin/sh
# SPDX-License-Identifier: MIT
# `bolan view` opens a real window under a virtual X server and shows the sea in it, the right way up, with its panel.
set -eu
if ! command -v xvfb-run >/dev/null; then
    if [ "${BOLAN_REQUIRE_GL:-}" = 1 ]; then
        echo 'xvfb-run is not installed, and BOLAN_REQUIRE_GL is 1'
        exit 1
    fi
    echo 'skipped: xvfb-run is not installed'
    exit 77
fi
"${CC:-cc}" -O1 -w "$BOLAN_SOURCE_DIR/tests/cli/viewer_pixels.c" -o viewer_pixels -lm

fail() {
    echo "$1"
    exit 1
}

# Eight frames of an open sea under a high sun behind the camera's shoulder: no glitter in the picture.
xvfb-run -a -s '-screen 0 1280x1024x24' "$BOLAN" view open-sea --size 1024x768 --sun 200,55 --camera 0,0,12,20,-4,50 \
    --frames 8 --screenshot window.png >report.txt
cat report.txt
# SDL without a display would have drawn into nothing and said all was well.
grep -q '^8 frames of 1024 x 768 on x11, ' report.txt || fail 'the window was not on the X server'
test "$(od -An -tx1 -N4 window.png | tr -d ' ')" = 89504e47 || fail 'window.png is not a PNG'

# mean R G B and deviation of: sky, sea, and the panel's place over the sky
sky=$(./viewer_pixels window.png 0.45 0.02 0.98 0.30)
sea=$(./viewer_pixels window.png 0.45 0.65 0.98 0.98)
panel=$(./viewer_pixels window.png 0.02 0.04 0.30 0.30)
echo "sky $sky, sea $sea, panel $panel"
# shellcheck disable=SC2086 # split on purpose
set -- $sky $sea $panel
sky_light=$(($1 + $2 + $3))
sea_light=$(($5 + $6 + $7))
panel_light=$((${9} + ${10} + ${11}))
test "$sea_light" -gt 20 || fail 'the sea is black'
test "$sky_light" -lt 750 || fail 'the sky is burnt out'
test "$sky_light" -gt $((sea_light + 60)) || fail 'the sky is not brighter than the sea: upside down, or unlit'
test "$3" -gt $(($1 + 10)) || fail 'the sky is not blue'
test "$8" -ge 3 || fail 'the sea is one flat colour: no waves'
test "$panel_light" -lt $((sky_light * 3 / 4)) || fail 'the panel does not darken the sky behind it'

# Ten frames of a sea that stands are a third of a second; one is of the full size, four add a sample each, the others
# show what is kept.
xvfb-run -a -s '-screen 0 1280x1024x24' "$BOLAN" view open-sea --size 512x320 --sun 200,55 --camera 0,0,12,20,-4,50 \
    --samples 4 --frames 17 --screenshot still.png >still.txt
cat still.txt
! grep -q refined report.txt || fail 'a running sea was refined'
grep -q '^refined: 4 samples$' still.txt || fail 'the standing sea was not refined to 4 samples'
"$BOLAN" render open-sea --size 512x320 --sun 200,55 --camera 0,0,12,20,-4,50 --quality medium --samples 4 -o fine.png \
    2>/dev/null
still=$(./viewer_pixels still.png 0.75 0.65 0.98 0.98)
fine=$(./viewer_pixels fine.png 0.75 0.65 0.98 0.98)
test "$still" = "$fine" || fail "the mean of a window is $still, that of render $fine"
