#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER: keeps the layers. Who may include whom, where OpenGL's names may stand, and what a public header
# may show: the rules are in layers.awk. Prints every breach with file and line.
set -eu
rules=$(cd "$(dirname "$0")" && pwd)/layers.awk
cd "$1"
files=$(find include src apps examples -name '*.[ch]' -o -name '*.cpp' 2>/dev/null | sort)
if [ -z "$files" ]; then
    echo 'no source file found'
    exit 1
fi
# shellcheck disable=SC2086 # our file names hold no space
awk -f "$rules" $files
