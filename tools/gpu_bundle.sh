#!/bin/sh
# SPDX-License-Identifier: MIT
# gpu_bundle.sh [--quick] BUILD-FOLDER OUT: packs the program, the benchmarks, the tests that draw, and the libraries they
# need into OUT, an archive (NAME.tar.xz) or a folder. On any Linux with a driver, of a C library not older than this
# machine's, run.sh in it measures and tests, and writes report.json and report.html. docs/measuring.md says how.
# --quick: one test alone, for run.sh --quick.
set -eu
quick=
[ "${1:-}" = --quick ] && quick=yes && shift
[ $# = 2 ] || {
    echo "usage: gpu_bundle.sh [--quick] BUILD-FOLDER OUT.tar.xz|OUT-FOLDER" >&2
    exit 2
}
source=$(cd "$(dirname "$0")/.." && pwd) build=$(cd "$1" && pwd) out=$2
case $out in *.tar.xz) folder=$(mktemp -d)/bolan-gpu ;; *) folder=$out ;; esac
mkdir -p "$folder/bin" "$folder/lib" "$folder/tests"

# strip_to FILE FOLDER
strip_to() {
    cp -L "$1" "$2/" && strip --strip-unneeded "$2/$(basename "$1")" 2> /dev/null || true
}

# Tests that read no file of the source.
tests=test_gl_layer
if [ -z "$quick" ]; then
    tests=
    for file in "$source"/tests/shaders/test_*.c "$source"/tests/images/test_*.c; do
        grep -q 'BOLAN_SOURCE_DIR\|references/' "$file" || tests="$tests $(basename "$file" .c)"
    done
fi
strip_to "$build/bolan" "$folder/bin"
strip_to "$build/bolan_bench" "$folder/bin"
for test in $tests; do
    [ ! -x "$build/tests/$test" ] || strip_to "$build/tests/$test" "$folder/tests"
done

# The C library and OpenGL are the target's own.
ldd "$build/bolan" "$build/bolan_bench" "$build"/tests/test_gl_layer |
    awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u |
    grep -Ev '/(libc|libm|libdl|libpthread|librt|libresolv|ld-linux[^/]*|libEGL|libGL[^/]*|libOpenGL)\.so' |
    while read -r library; do strip_to "$library" "$folder/lib"; done
cp "$source/tools/gpu_run.sh" "$folder/run.sh"
chmod +x "$folder/run.sh"
[ "$folder" = "$out" ] && exit 0

# The tests hold the same libraries, so the dictionary is larger than a few of them together.
(cd "$(dirname "$folder")" && tar -c --owner=0 --group=0 bolan-gpu | xz --lzma2=preset=6,dict=128MiB) > "$out"
rm -rf "$(dirname "$folder")"
bytes=$(wc -c < "$out")
echo "$out: $((bytes / 1000000)) MB, $(echo $tests | wc -w) tests"
[ "$bytes" -le 60000000 ] || {
    echo "$out is larger than 60 MB" >&2
    exit 1
}
