#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER: keeps the layers. Who may include whom, where OpenGL's names may stand, and what a public header
# may show: the rules are in layers.awk. Prints every breach with file and line.
set -eu
rules=$(cd "$(dirname "$0")" && pwd)/layers.awk
cd "$1"
files=$({ find include src apps examples -name '*.[ch]' -o -name '*.cpp'; find shaders/shared -name '*.glsl'; } \
    2>/dev/null | sort)
if [ -z "$files" ]; then
    echo 'no source file found'
    exit 1
fi
# shellcheck disable=SC2086 # our file names hold no space
awk -f "$rules" $files

# Every OpenGL function that is called must come from the table of src/render/gl/loader.h, or the host's loader would
# be passed by.
list=src/render/gl/loader.h
if [ -f $list ]; then
    called=$(grep -hoE '\bgl[A-Z][A-Za-z0-9_]+ *\(' src/render/gl/*.c | tr -d ' (' | sort -u)
    for name in $called; do
        grep -q "X(${name#gl})" $list && grep -qE "^#define $name bolan_gl_(called|asked)\(${name#gl}\)" $list && continue
        echo "src/render/gl: $name is called and not named in loader.h"
        exit 1
    done
fi
