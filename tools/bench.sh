#!/bin/sh
# SPDX-License-Identifier: MIT
# bench.sh [FOLDER]: runs every benchmark of build/bolan_bench, prints the tables, and at the end the rows of the README's
# section "Numbers" as this machine has them. The figures stay as JSON in FOLDER, out/bench without it. On a machine that does
# something else meanwhile only the ratios mean anything.
set -eu
cd "$(dirname "$0")/.."
bench=build/bolan_bench
folder=${1:-out/bench}
if [ ! -x $bench ]; then
    echo "$bench is not built: it needs FFTW, bolan_io and bolan_render" >&2
    exit 1
fi
mkdir -p "$folder"

# measure NAME COMMAND...: the benchmark's JSON into a file; it says what it does.
measure() {
    name=$1
    shift
    echo "bolan bench $*" >&2
    "$bench" "$@" --json >"$folder/$name.json"
}
# number FILE KEY PATTERN...: of the one record (a line) with all patterns.
number() {
    file=$folder/$1.json
    key=$2
    shift 2
    lines=$(cat "$file")
    for pattern in "$@"; do lines=$(printf '%s\n' "$lines" | grep -F "$pattern"); done
    printf '%s\n' "$lines" | sed -n "s/.*\"$key\": \([-0-9.e+]*\).*/\1/p" | head -n 1
}
# row LABEL TO FILE PATTERN...: of the README's table. Two digits.
row() {
    label=$1
    to=$2
    shift 2
    file=$1
    shift
    awk -v label="$label" -v to="$to" -v ms="$(number "$file" ms "$@")" -v ratio="$(number "$file" ratio "$@")" '
        function two(x) { return x >= 10 ? sprintf("%.0f", x) : sprintf("%.1f", x) }
        BEGIN { if (ms == "" || ratio == "") exit 1; printf "| %s | %s ms | %s | %s|\n", label, two(ms), two(ratio), to == "" ? "" : to " " }' ||
        {
            echo "bench.sh: $folder/$file.json has no figure for: $label" >&2
            exit 1
        }
}

measure waves waves
measure query query
measure frame frame open-sea pond
measure flight-sim frame --technique flight-sim open-sea
measure nested-grid frame --technique nested-grid open-sea
measure exp-cosine frame --technique exp-cosine open-sea
measure exp-cosine-low frame --technique exp-cosine --quality low open-sea
echo "bolan bench techniques" >&2
"$bench" techniques | tee "$folder/techniques.txt"
for program in build/bench_*; do
    if [ -f "$program" ] && [ -x "$program" ]; then
        echo "$program"
        "$program"
    fi
done

machine=$(sed -n 's/.*"machine": "\([^"]*\)".*/\1/p' "$folder/waves.json" | head -n 1)
echo
echo "The README's rows on this machine ($machine):"
echo
echo '| | time | ratio | to |'
echo '|---|---|---|---|'
row 'one cascade of 256², all 8 fields, one thread' 'FFTW doing the four bare transforms' waves '"n": 256, "cascades": 1, "threads": 1,'
row 'one cascade of 512²' '' waves '"n": 512, "cascades": 1, "threads": 1,'
row 'one cascade of 1024²' '' waves '"n": 1024, "cascades": 1, "threads": 1,'
row '100 000 heights scattered over 10 km, one thread' 'memory streaming the samples read' \
    query '"heights, scattered over 10 km"' '"points": 100000,' '"threads": 1,'
row '1 000 000 heights and normals, two threads' '' query '"heights and normals, scattered"' '"points": 1000000,' '"threads": 2,'
row 'a frame of `open-sea`, 1024×768, medium, software OpenGL' 'a full-screen pass of 6 bilinear texture fetches' \
    frame '"scene": "open-sea"'
row 'the same by `flight-sim`' '' flight-sim '"scene": "open-sea"'
row 'by `nested-grid`' '' nested-grid '"scene": "open-sea"'
row 'by `exp-cosine`' '' exp-cosine '"scene": "open-sea"'
row 'by `exp-cosine`, at low quality' '' exp-cosine-low '"scene": "open-sea"'
row 'a frame of `pond` by `two-triangle`, medium' '' frame '"scene": "pond"'
