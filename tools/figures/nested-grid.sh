#!/bin/sh
# SPDX-License-Identifier: MIT
# Figures of Liu, Xu & Chen 2009 made again: nested-grid.sh PROGRAM FOLDER.
set -eu
program=$1 folder=$2
mkdir -p "$folder"

draw() { # NAME OPTIONS...
    name=$1
    shift
    "$program" render open-sea --technique nested-grid --time 12 --size 360x230 --samples 4 --quiet "$@" \
        -o "$folder/nested-grid-$name.png" >/dev/null
}

# 1 and 3: levels of detail and what joins them, from above and from a deck
draw 1 --show mesh --camera 0,0,300,230,-40,110
draw 3 --show mesh --camera 0,0,120,230,-30,60
# 5: waves only where a narrower view than the picture's would see them
draw 5 --show mesh --paper --camera 0,0,40,230,-20,90 --wind 18
# 6: the result; to the letter, and as it is drawn here
draw 6-paper --paper
draw 6 --camera 0,0,8,230,-5
draw high --camera 0,0,100,230,-10
draw low-sun --sun 230,5 --camera 0,0,20,230,-6
