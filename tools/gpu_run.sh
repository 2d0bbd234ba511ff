#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh [--quick] [OUT]: on this machine, what the program says of it, the tests that draw (in core and ES contexts), the
# benchmarks at both sizes, and a sheet of images. Writes OUT/report.json and OUT/report.html; OUT is ./report by default.
# Needs sh, awk and a driver of OpenGL. --quick: one test, one benchmark and one image, small. Ends with 1 when a test
# failed or a program did.
set -u
quick=
[ "${1:-}" = --quick ] && quick=yes && shift
here=$(cd "$(dirname "$0")" && pwd) out=${1:-report}
mkdir -p "$out/pictures" "$out/scratch" "$out/logs" && out=$(cd "$out" && pwd) || exit 1
failures=0

# What drivers load too is the target's own where it has it: a driver may need a newer one than is packed here.
libraries=$out/scratch/lib
mkdir -p "$libraries"
known=$( (ldconfig -p || /sbin/ldconfig -p || /usr/sbin/ldconfig -p) 2> /dev/null | awk '{ print $1 }')
for file in "$here"/lib/*; do
    name=${file##*/}
    case $name in
    libstdc++* | libgcc_s* | libz.so* | libzstd* | libexpat* | libdrm* | libX* | libxcb* | libffi* | libtinfo* | \
        libxml2* | libelf* | libwayland* | libLLVM* | libedit* | libbsd* | libmd* | liblzma* | libicu*)
        case "
$known
" in *"
$name
"*) continue ;; esac
        ;;
    esac
    ln -sf "$file" "$libraries/$name"
done
LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH LC_ALL=C

# text FILE: as the inside of a JSON string.
text() { awk '{ gsub(/\\/, "\\\\"); gsub(/"/, "\\\""); gsub(/[\001-\037]/, " "); printf "%s%s", (NR > 1 ? "\\n" : ""), $0 }' "$1"; }
# page FILE: as text of HTML.
page() { awk '{ gsub(/&/, "\\&amp;"); gsub(/</, "\\&lt;"); print }' "$1"; }
seconds() { date +%s; }

# measure NAME PROGRAM ARGUMENTS...: its JSON becomes the member NAME of the report.
measure() {
    name=$1
    shift
    echo "$name" >&2
    if "$@" > "$out/logs/$name.json" 2> "$out/logs/$name.log"; then
        [ -s "$out/logs/$name.json" ] || echo null > "$out/logs/$name.json"
    else
        echo null > "$out/logs/$name.json"
        failures=$((failures + 1))
    fi
    printf '  "%s": ' "$name" >> "$out/report.json"
    cat "$out/logs/$name.json" >> "$out/report.json"
    printf ',\n' >> "$out/report.json"
    { printf '<h2>%s</h2><pre>' "$name"; page "$out/logs/$name.json"; page "$out/logs/$name.log"; echo '</pre>'; } >> "$out/body"
}

run_test() {
    file=$1 name=${1##*/} begun=$(seconds)
    echo "$name" >&2
    (cd "$out/scratch" && BOLAN_REQUIRE_GL=1 "$file") > "$out/logs/$name.txt" 2>&1
    status=$?
    case $status in 0) word=passed ;; 77) word=skipped ;; *) word=failed failures=$((failures + 1)) ;; esac
    core=$(grep -c '  OK \] .*(core)' "$out/logs/$name.txt") es=$(grep -c '  OK \] .*(es)' "$out/logs/$name.txt")
    all=$(grep -c '  OK \]' "$out/logs/$name.txt")
    took=$(($(seconds) - begun))
    printf '%s\n    {"name": "%s", "result": "%s", "status": %d, "ok": %d, "core": %d, "es": %d, "seconds": %d, "says": "%s"}' \
        "$comma" "$name" $word $status "$all" "$core" "$es" $took \
        "$([ $word = failed ] && tail -n 12 "$out/logs/$name.txt" > "$out/scratch/tail" && text "$out/scratch/tail")" \
        >> "$out/report.json"
    echo "<tr class=$word><td>$name<td>$word<td>$all<td>$core<td>$es<td>$took</tr>" >> "$out/body"
    comma=,
}

draw() {
    scene=$1
    shift
    echo "$scene" >&2
    if "$here/bin/bolan" render "$scene" -o "$out/pictures/$scene.png" --quiet "$@" 2> "$out/logs/$scene.log"; then
        printf '%s"pictures/%s.png"' "$comma" "$scene" >> "$out/report.json"
        echo "<figure><img src=pictures/$scene.png alt=$scene><figcaption>$scene</figcaption></figure>" >> "$out/body"
        comma=', '
    else
        failures=$((failures + 1))
        { echo '<pre>'; page "$out/logs/$scene.log"; echo '</pre>'; } >> "$out/body"
    fi
}

now=$(date -u +%Y-%m-%dT%H:%M:%SZ)
: > "$out/body"
printf '{\n  "date": "%s",\n  "system": "%s",\n' "$now" "$(uname -srm)" > "$out/report.json"
measure info "$here/bin/bolan" info --json
if [ -n "$quick" ]; then
    measure frame_160x96 "$here/bin/bolan_bench" frame --json --size 160x96 open-sea
else
    for size in 1024x768 2560x1440; do
        measure frame_$size "$here/bin/bolan_bench" frame --json --size $size
        measure techniques_$size "$here/bin/bolan_bench" techniques --json --size $size
    done
    measure waves "$here/bin/bolan_bench" waves --json
    measure query "$here/bin/bolan_bench" query --json
fi
printf '  "tests": [' >> "$out/report.json"
echo '<h2>Tests</h2><table><tr><th>test<th>result<th>ok<th>core<th>ES<th>s</tr>' >> "$out/body"
comma=
for file in "$here"/tests/*; do run_test "$file"; done
printf '\n  ],\n  "pictures": [' >> "$out/report.json"
echo '</table><h2>Images</h2>' >> "$out/body"
comma=
if [ -n "$quick" ]; then
    draw open-sea --size 160x96 --quality low --samples 1
else
    for scene in open-sea storm island pond coast reef approach underwater calm; do draw $scene --size 1280x720; done
fi
printf '],\n  "failures": %d\n}\n' $failures >> "$out/report.json"
{
    echo '<!doctype html><meta charset=utf-8><title>Bolan on this machine</title>'
    echo '<style>body{font:15px sans-serif;margin:2em auto;max-width:70em}td,th{padding:0 .7em;text-align:left}'
    echo '.failed{color:#b00}figure{display:inline-block;margin:4px}img{width:34em}pre{overflow:auto;max-height:30em}</style>'
    echo "<h1>Bolan on this machine</h1><p>$now, $(uname -srm), $failures failures"
    cat "$out/body"
} > "$out/report.html"
rm -rf "$out/body" "$out/scratch"
echo "$out/report.html: $failures failures"
[ $failures = 0 ]
