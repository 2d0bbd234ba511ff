#!/bin/sh
# SPDX-License-Identifier: MIT
# docs.sh SOURCE-FOLDER OUTPUT-FOLDER: builds the API reference; any warning is a failure.
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
    if [ -e README.md ]; then printf 'INPUT += README.md\nUSE_MDFILE_AS_MAINPAGE = README.md\n'; fi
} | doxygen -
