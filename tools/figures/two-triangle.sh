#!/bin/sh
# SPDX-License-Identifier: MIT
# sh tools/figures/two-triangle.sh BOLAN_PROGRAM OUT_FOLDER: the figures of Ma, Zhu & Gong 2006 made again.
set -eu
bolan=$1
out=$2
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Figure 3: eq. 7 (dashed) and the two straight lines of eq. 8, as a drawing.
awk 'BEGIN {
    w = 440; h = 300; left = 46; top = 12; right = 12; bottom = 40
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" w "\" height=\"" h "\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"" w "\" height=\"" h "\" fill=\"white\"/>"
    for (i = 0; i <= 4; i++) {
        y = h - bottom - (h - top - bottom) * i / 4
        printf "<path d=\"M%d %.1fH%d\" stroke=\"#ddd\"/><text x=\"8\" y=\"%.1f\">%.1f</text>\n", left, y, w - right, y + 4, 0.2 * i
    }
    for (i = 0; i <= 9; i += 3) {
        x = left + (w - left - right) * i / 9
        printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%d°</text>\n", x, h - 22, 10 * i
    }
    pi = atan2(0, -1)
    for (i = 0; i <= 180; i++) {
        theta = i / 180 * pi / 2; s = sin(theta)
        exact = sqrt((1 - s * s) / (1.333 * 1.333 - s * s)); line = theta <= 0.8 ? 0.75 - 0.16 * theta : 1.26 - 0.8 * theta
        x = left + (w - left - right) * i / 180; scale = (h - top - bottom) / 0.8
        a = a (i ? "L" : "M") sprintf("%.1f %.1f", x, h - bottom - scale * exact)
        b = b (i ? "L" : "M") sprintf("%.1f %.1f", x, h - bottom - scale * line)
    }
    print "<path d=\"" a "\" fill=\"none\" stroke=\"#0060c0\" stroke-width=\"2\" stroke-dasharray=\"7 4\"/>"
    print "<path d=\"" b "\" fill=\"none\" stroke=\"#c03020\" stroke-width=\"2\"/>"
    printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">angle in the air, from the vertical</text>\n", left + (w - left - right) / 2, h - 5
    print "<text x=\"300\" y=\"40\" fill=\"#0060c0\">eq. 7</text><text x=\"300\" y=\"58\" fill=\"#c03020\">eq. 8</text></svg>"
}' </dev/null >"$out/two-triangle-3-factor.svg"

shot() { # NAME OPTIONS
    name=$1
    shift
    "$bolan" render pond --size 480x360 --samples 4 --quality high --quiet "$@" -o "$out/two-triangle-$name.png"
}
shot 4-reflection --paper --effects reflection
shot 5-refraction --paper --effects refraction
shot 7-bump --paper --effects bump
shot 8-distortion --paper --effects reflection,refraction,distortion
shot 10-all --paper
shot exact
shot below --camera 3,-14,-0.6,-40,6,70 --water IB

# Figures 6 and 9: height map, normal map, detail, light on the bottom.
"$bolan" bake pond --frames 2 --quiet -o "$work/tiles"
cp "$work/tiles/normal_000.png" "$out/two-triangle-6b-normal.png"
cp "$work/tiles/detail_000.png" "$out/two-triangle-6c-detail.png"
cp "$work/tiles/caustics_000.png" "$out/two-triangle-9-caustics.png"
if command -v convert >/dev/null 2>&1; then
    convert "$work/tiles/height_000.pgm" -depth 8 "$out/two-triangle-6a-height.png"
    # Bright enough for the eye, and few enough colours for a manual.
    convert "$out/two-triangle-6c-detail.png" -colors 64 PNG8:"$work/detail.png" && mv "$work/detail.png" "$out/two-triangle-6c-detail.png"
    convert "$out/two-triangle-6b-normal.png" -colors 128 PNG8:"$work/normal.png" && mv "$work/normal.png" "$out/two-triangle-6b-normal.png"
    convert "$out/two-triangle-9-caustics.png" -colorspace Gray -depth 8 "$work/caustics.png" &&
        mv "$work/caustics.png" "$out/two-triangle-9-caustics.png"
    for name in 4-reflection 5-refraction 7-bump 8-distortion 10-all exact below; do
        convert "$out/two-triangle-$name.png" -colors 255 PNG8:"$work/small.png" && mv "$work/small.png" "$out/two-triangle-$name.png"
    done
fi
