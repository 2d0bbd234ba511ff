#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh SOURCE-FOLDER: every public header compiles alone, as C17 and as C++17, without a warning, and twice in one file.
set -eu
folder=$1/include
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0 compiled=0

# compile COMPILER STANDARD LANGUAGE HEADER
compile() {
    printf '#include "%s"\n#include "%s"\n' "$4" "$4" >"$scratch/unit"
    if "$1" "-std=$2" -x "$3" -Wall -Wextra -Wpedantic -Wshadow -Werror -I"$folder" -fsyntax-only "$scratch/unit"; then
        compiled=$((compiled + 1))
    else
        echo "$4 does not compile alone as $2"
        failures=$((failures + 1))
    fi
}

for path in "$folder"/bolan/*.h; do
    header=bolan/${path##*/}
    compile "${CC:-cc}" c17 c "$header"
    compile "${CXX:-c++}" c++17 c++ "$header"
done
echo "$compiled compiled, $failures failures"
[ $failures = 0 ] && [ $compiled -gt 0 ]
