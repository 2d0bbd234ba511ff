#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER PRINT-SHADER SCRATCH: compiles every shader with glslangValidator, as the engine would: each
# pass as "330 core" and "300 es", both stages; the compute shaders as "430". Does not need a GL driver.
set -eu
source=$1 print_shader=$2 scratch=$3
if ! command -v glslangValidator >/dev/null; then
    echo 'glslangValidator is missing: skipped'
    exit 77
fi
mkdir -p "$scratch"
cd "$source/shaders"
failures=0 compiled=0

# validate STAGE FILE NAME
validate() {
    if glslangValidator -S "$1" "$2" >"$scratch/log"; then
        compiled=$((compiled + 1))
    else
        failures=$((failures + 1))
        echo "$3:"
        cat "$scratch/log"
    fi
}

# try FILE NAMES...: both stages of both profiles, with the names defined
try() {
    stem=${1%.glsl}
    shift
    for profile in core es; do
        for stage in VERTEX FRAGMENT; do
            if [ $stage = VERTEX ]; then kind=vert; else kind=frag; fi
            if "$print_shader" "$stem" $stage $profile "$@" >"$scratch/$profile.$stem.$kind"; then
                validate $kind "$scratch/$profile.$stem.$kind" "$stem.glsl ($profile, $kind: $*)"
            else
                failures=$((failures + 1))
            fi
        done
    done
}

for file in *.glsl; do
    [ -e "$file" ] || continue
    try "$file"
    # every wave model on a mesh and on the quad, in the open and at a shore
    case $file in water*)
        try "$file" LAND
        try "$file" QUAD LAND
        try "$file" WAVES_EXP
        try "$file" WAVES_EXP QUAD LAND
        try "$file" WAVES_SUM QUAD
        try "$file" WAVES_MESH LAND
        try "$file" STATIC_GRID PACKED LAND
        try "$file" STATIC_GRID WAVES_EXP
        try "$file" QUAD TRIM
        try "$file" KEPT OPAQUE SPARSE
        try "$file" BOUNDS LAND
        try "$file" BOUNDS QUAD
        ;;
    ground.glsl)
        try "$file" CLIP
        ;;
    objects.glsl)
        try "$file" PICTURE CUT
        try "$file" GROUND PICTURE WET
        try "$file" GROUND PICTURE CUT WET
        ;;
    esac
done
for file in compute/*.glsl; do
    [ -e "$file" ] || continue
    awk -v folder=. '
        function put(path, line, parts) {
            if (path in seen) return
            seen[path] = 1
            while ((getline line < path) > 0)
                if (line ~ /^ *#include "/) { split(line, parts, "\""); put(folder "/" parts[2]) } else print line
            close(path)
        }
        BEGIN { print "#version 430 core"; put(ARGV[1]) }' "$file" >"$scratch/compute.${file##*/}"
    validate comp "$scratch/compute.${file##*/}" "$file (430 core)"
done
echo "$compiled shaders compiled, $failures failures"
[ $failures = 0 ] && [ $compiled -gt 0 ]
