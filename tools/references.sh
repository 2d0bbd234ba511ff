#!/bin/sh
# SPDX-License-Identifier: MIT
# references.sh [BUILD]: draws the reference pictures of tests/images/test_references.c anew, into tests/images/references. Their PNGs
# are left in BUILD/tests/report: look at each before the references are committed.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build}
cmake --build "$build" --target test_references
rm -f "$root"/tests/images/references/*.txt
cd "$build/tests"
BOLAN_WRITE_REFERENCES=1 ./test_references
echo "look at $build/tests/report/*.png"
