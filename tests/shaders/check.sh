#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER PRINT-SHADER PRINT-VARIANTS SCRATCH: compiles every shader with glslangValidator, as the engine
# would: each pass as "330 core" and "300 es", both stages, and every variant that the optics of the water list; what a
# host includes; the compute shaders as "430 core" and "310 es". Does not need a GL driver.
set -eu
source=$1 print_shader=$2 print_variants=$3 scratch=$4
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
    flat=$(echo "$stem" | tr / -)
    shift
    for profile in core es; do
        for stage in VERTEX FRAGMENT; do
            if [ $stage = VERTEX ]; then kind=vert; else kind=frag; fi
            if "$print_shader" "$stem" $stage $profile "$@" >"$scratch/$profile.$flat.$kind"; then
                validate $kind "$scratch/$profile.$flat.$kind" "$stem.glsl ($profile, $kind: $*)"
            else
                failures=$((failures + 1))
            fi
        done
    done
}

for file in *.glsl papers/*.glsl; do
    try "$file"
    case $file in ground.glsl)
        try "$file" CLIP
        ;;
    objects.glsl)
        try "$file" PICTURE CUT
        try "$file" GROUND PICTURE WET
        try "$file" GROUND PICTURE CUT WET
        ;;
    motion.glsl)
        try "$file" WATER
        try "$file" WATER LAND BOUND_WAVES
        ;;
    surfaces.glsl)
        try "$file" OBJECT
        try "$file" OBJECT MOTION
        ;;
    wireframe.glsl)
        try "$file" FILL
        try "$file" QUAD TRIM LAND
        ;;
    esac
done

# what a host includes: after its own #version, in either stage
for file in include/*.glsl; do
    for profile in '330 core' '300 es'; do
        for kind in vert frag; do
            host=$scratch/host.${profile#* }.$kind
            printf '#version %s\n' "$profile" >"$host"
            cat "$file" >>"$host"
            printf 'void main() {}\n' >>"$host"
            validate $kind "$host" "$file ($profile, $kind)"
        done
    done
done

# every variant that the table of the water's programs can list
rm -rf "$scratch/variants"
mkdir "$scratch/variants"
if "$print_variants" "$source/shaders" "$scratch/variants"; then
    (cd "$scratch/variants" && ls | xargs -P 2 -n 32 glslangValidator) >"$scratch/log" || failures=$((failures + 1))
    grep -B 1 -A 2 '^ERROR' "$scratch/log" | head -40 || true
    compiled=$((compiled + $(ls "$scratch/variants" | wc -l)))
else
    failures=$((failures + 1))
fi
# the passes of the compute backend, as "430 core" and "310 es"
# try_compute STEM NAMES...
try_compute() {
    stem=compute/$1
    shift
    for profile in core es; do
        file=$scratch/compute.$profile.comp
        if "$print_shader" $stem COMPUTE $profile "$@" >"$file"; then
            validate comp "$file" "$stem.glsl ($profile: $*)"
        else
            failures=$((failures + 1))
        fi
    done
}
for size in 32 64 128 256 512 1024; do
    for name in "" TICKS; do try_compute sea_rows SIZE=$size $name; done
    for name in "" TICKS PACKED HOST; do try_compute sea_columns SIZE=$size $name; done
done
try_compute sea_levels
for name in "" PACKED; do try_compute sea_foam_law $name; done
echo "$compiled shaders compiled, $failures failures"
[ $failures = 0 ] && [ $compiled -gt 0 ]
