#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the benchmarks: the program's own, then every other in build/.
set -eu
cd "$(dirname "$0")/.."
if [ -x build/bolan_bench ]; then build/bolan_bench; fi
for program in build/bench_*; do
    if [ -f "$program" ] && [ -x "$program" ]; then
        echo "$program"
        "$program"
    fi
done
