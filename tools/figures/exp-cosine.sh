#!/bin/sh
# SPDX-License-Identifier: MIT
# Figures of Liu & Xie 2010 made again: exp-cosine.sh PROGRAM FOLDER.
set -eu
program=$1 folder=$2
mkdir -p "$folder"

draw() { # NAME OPTIONS...
    name=$1
    shift
    "$program" render --technique exp-cosine --time 12 --size 336x214 --samples 4 --quiet "$@" -o "$folder/exp-cosine-$name.png" >/dev/null
}

# 1: a sine, a power of a sine and e^cos over two wave lengths, each from -1 to 1
if command -v convert >/dev/null; then
    curve() { # FUNCTION of t
        awk 'BEGIN { pi = 3.14159265; e = exp(1)
                     for (x = 0; x <= 440; ++x) { t = x / 440 * 4 * pi; y = '"$1"'; printf "%d,%.1f ", x + 20, 100 - 75 * y } }'
    }
    convert -size 480x200 xc:white -fill none -stroke '#bbbbbb' -draw 'line 20,100 460,100' \
        -strokewidth 1.5 -stroke '#3a6ea5' -draw "polyline $(curve 'sin(t + pi / 2)')" \
        -stroke '#4a9a4a' -draw "polyline $(curve '2 * ((1 + sin(t + pi / 2)) / 2) ^ 2.5 - 1')" \
        -stroke '#b03a2e' -draw "polyline $(curve '2 * (exp(cos(t)) - 1 / e) / (e - 1 / e) - 1')" \
        -stroke none -fill '#3a6ea5' -annotate +30+192 'sine' -fill '#4a9a4a' -annotate +90+192 'power of a sine, 2.5' \
        -fill '#b03a2e' -annotate +250+192 'e^cos' "$folder/exp-cosine-1.png"
else
    echo 'ImageMagick is missing: figure 1 of exp-cosine is not drawn'
fi

# 4: the parts of the light, and their sum
draw 4a pond --wind 4 --sun 5,24 --paper --effects ambient
draw 4b pond --wind 4 --sun 5,24 --paper --effects diffuse
draw 4c pond --wind 4 --sun 5,24 --paper --effects specular
draw 4d pond --wind 4 --sun 5,24 --paper --effects ambient,diffuse,specular

# 5: the scene; to the letter, and as it is drawn here; and at sea
draw 5-paper pond --paper
draw 5 pond
draw sea open-sea
draw high open-sea --camera 0,0,300,230,-12
