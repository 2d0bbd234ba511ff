#!/bin/sh
# SPDX-License-Identifier: MIT
# check_bits.sh [--once] ['COMPILER FLAGS']...: builds the core with each compiler and its flags and runs
# tests/determinism/test_golden.c: every build has to give the literal hashes. Without arguments: GCC and Clang at
# several levels of optimisation, 32-bit x86, aarch64 (NEON) under qemu, and WebAssembly (SIMD) under node. What this
# machine lacks is skipped with a sentence. --once: instruction sets and numbers of threads take turns, a fifth of the time.
# Nothing is written but a scratch folder, which goes. BOLAN_CHECK_JOBS: compilers at a time, 2 without it.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
failures=0 passed=0 once=''
if [ "${1:-}" = --once ]; then
    once=once
    shift
fi

if [ $# = 0 ]; then
    set -- 'gcc -O0' 'gcc -O1' 'gcc -O2' 'gcc -O3' 'gcc -O3 -march=native' 'gcc -O2 -ffast-math' \
        'clang -O0' 'clang -O2' 'clang -O3' 'clang -O3 -march=native' 'gcc -O2 -m32' \
        'aarch64-linux-gnu-gcc -O2' 'emcc -O1'
fi

# links COMPILER FLAGS...: whether it makes programs here.
links() {
    echo '#include <math.h>
        int main(int n, char **a) { (void)a; return sqrt(n) > 1e9; }' | "$@" -xc - -o "$scratch/links" -lm 2>/dev/null
}

# The program that runs another machine's programs, if one is needed; fails where there is none.
emulator_of() {
    case $1 in
    aarch64-*) command -v qemu-aarch64 >/dev/null && echo 'qemu-aarch64 -L /usr/aarch64-linux-gnu' ;;
    emcc*) command -v node ;;
    *-m32*) "$scratch/links" 2>/dev/null || { command -v qemu-i386 >/dev/null && echo 'qemu-i386 -cpu max'; } ;;
    esac
}

# check 'COMPILER FLAGS'
check() {
    compiler=${1%% *}
    flags=${1#"$compiler"}
    # shellcheck disable=SC2086 # flags are words
    if ! command -v "$compiler" >/dev/null || ! links $compiler $flags; then
        echo "skipped  $1: this compiler makes no such programs here"
        return 0
    fi
    if ! emulator=$(emulator_of "$1"); then
        echo "skipped  $1: neither this machine nor qemu runs its programs"
        return 0
    fi
    system='' machine='' threads=-pthread golden=golden
    case $1 in
    emcc*) # at -O1: above it runs an optimiser of JavaScript, which not every node runs
        system='-DCMAKE_SYSTEM_NAME=Generic -DCMAKE_SYSTEM_PROCESSOR=wasm32 -DCMAKE_AR='$(command -v emar)
        system="$system -DCMAKE_RANLIB=$(command -v emranlib)"
        threads='' machine='-sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=4MB -sWASM_ASYNC_COMPILATION=0' golden=golden.js
        ;;
    aarch64-*) system='-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64' ;;
    *-m32*) machine='-msse2 -mfpmath=sse' ;;
    esac
    level=$(printf '%s\n' $flags | grep '^-O' || true)
    build=$scratch/build
    rm -rf "$build"
    # shellcheck disable=SC2086
    if ! { cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release $system "-DCMAKE_C_COMPILER=$compiler" \
        "-DCMAKE_C_FLAGS=$flags" "-DBOLAN_KERNEL_OPTIMISATION=${level:--O3}" -DBOLAN_IO=OFF -DBOLAN_RENDER=OFF \
        -DBOLAN_APPS=OFF -DBOLAN_TESTS=OFF -DBOLAN_BENCH=OFF -DBOLAN_EXAMPLES=OFF &&
        cmake --build "$build" -j "${BOLAN_CHECK_JOBS:-2}" &&
        $compiler $flags $machine -fno-fast-math -ffp-contract=off -std=c17 -D_XOPEN_SOURCE=700 -I"$root/tests/cross" \
            -I"$root/tests" -I"$root/include" -I"$root/src" "-DBOLAN_SOURCE_DIR=\"$root\"" \
            "$root/tests/determinism/test_golden.c" "$build/libbolan_content.a" "$build/libbolan.a" \
            -lm $threads -o "$build/$golden"; } \
        >"$scratch/log" 2>&1; then
        tail -n 20 "$scratch/log"
        echo "FAILED   $1: it does not build"
        failures=$((failures + 1))
    elif $emulator "$build/$golden" $once >"$scratch/log" 2>&1; then
        echo "passed   $1${emulator:+ (${emulator%% *})}"
        passed=$((passed + 1))
    else
        cat "$scratch/log"
        echo "FAILED   $1: other bits"
        failures=$((failures + 1))
    fi
}

for build_of in "$@"; do check "$build_of"; done
echo "$passed passed, $failures failed"
[ $failures = 0 ]
