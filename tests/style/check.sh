#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER: prints every line of C, GLSL and Markdown longer than 120 characters, with file and line. Rows
# of Markdown tables and lines of Markdown that hold one link are exempt, since they cannot be broken; so are data.
set -eu
cd "$1"
files=$({ find include src apps bench examples shaders tests tools docs -type f \
    \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.glsl' -o -name '*.md' \) \
    ! -path 'tests/data/*' ! -path 'tests/fuzz/corpus/*'
    ls ./*.md; } 2>/dev/null | sort)
[ -n "$files" ] || { echo 'no source file found' && exit 1; }
# Bytes 128 to 191 continue a character of UTF-8.
# shellcheck disable=SC2086 # our file names hold no space
LC_ALL=C awk '
    /^[ -]*\|/ && FILENAME ~ /\.md$/ { next }
    /^[^ ]*\]\([^ ]*\)[.,;]?$/ && FILENAME ~ /\.md$/ { next }
    { line = $0; gsub(/[\200-\277]/, "", line) }
    length(line) > 120 { print FILENAME ":" FNR ": " length(line) " characters; expected at most 120"; failures++ }
    END { exit failures > 0 }' $files
