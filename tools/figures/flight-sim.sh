#!/bin/sh
# SPDX-License-Identifier: MIT
# The figures of Ni, Zhang & Tan again, and an approach from 10 km: sh tools/figures/flight-sim.sh BOLAN_PROGRAM OUT_FOLDER
set -eu
bolan=$1
out=$2
mkdir -p "$out"

draw() { # file, then options
    file=$out/flight-sim-$1.png
    shift
    "$bolan" render "$@" --size 340x191 --samples 2 --quality medium --quiet -o "$file"
}

# Figures 2 and 3: the same sea before (a normal map that mirrors) and after (light through crests, foam at the shore), and the mask
near=-2900,-3200,300,39,-9,48
before=reflection,refraction,distortion,glitter,ambient,diffuse
draw before approach --camera=$near --effects $before
draw after approach --camera=$near
draw mask approach --camera=$near --show mask

# Light through crests: our mask, the paper's, none
crest="open-sea --technique flight-sim --wind 15 --sun 215,22 --camera=0,0,4,230,-3,50"
draw crests $crest
draw crests-paper $crest --paper
draw crests-none $crest --effects $before,foam

# From the cockpit down to the sea
draw 10km approach
draw 3km approach --camera=-6000,-7200,3000,39,-18,48
draw 30m approach --camera=-2000,-2100,30,39,-8,48
draw 3m approach --camera=-1900,-1990,3,39,-4,48
draw beach approach --camera=-1000,-900,20,39,-12,48
