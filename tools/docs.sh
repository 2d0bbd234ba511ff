#!/bin/sh
# SPDX-License-Identifier: MIT
# docs.sh SOURCE-FOLDER OUTPUT-FOLDER: builds the API reference. Any warning is a failure: a function, type, enum or macro
# without a comment, a reference that leads nowhere. A plain member of a documented struct may stand by its name alone.
set -eu
cd "$1"
if ! command -v doxygen >/dev/null; then
    echo 'doxygen is missing: skipped'
    exit 77
fi
mkdir -p "$2"
{
    cat docs/Doxyfile
    echo "OUTPUT_DIRECTORY = $2"
    for page in README.md CONTRIBUTING.md CHANGELOG.md; do
        if [ -e $page ]; then echo "INPUT += $page"; fi
    done
    if [ -e README.md ]; then echo 'USE_MDFILE_AS_MAINPAGE = README.md'; fi
} | doxygen - 2>"$2/log"
if grep -v 'Member .* (variable) .* is not documented' "$2/log"; then exit 1; fi
