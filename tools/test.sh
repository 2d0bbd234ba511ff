#!/bin/sh
# SPDX-License-Identifier: MIT
# Every test: the release build, then those of the libraries again under AddressSanitizer and UndefinedBehaviorSanitizer.
# Ends with the line "N passed, N failed, N skipped"; the exit status tells whether all that ran passed.
set -eu
cd "$(dirname "$0")/.."
passed=0 failed=0 skipped=0

finish() {
    echo "$passed passed, $failed failed, $skipped skipped"
    [ "$failed" = 0 ]
    exit
}

# build PRESET TARGETS...: configures and builds; ends the run where that fails.
build() {
    preset=$1
    shift
    echo "== building: $preset"
    if ! log=$(cmake --preset "$preset" 2>&1); then
        printf '%s\n' "$log"
    elif cmake --build --preset "$preset" --target "$@"; then
        return
    fi
    echo "The $preset build failed"
    failed=$((failed + 1))
    finish
}

# run FOLDER CTEST-ARGUMENTS...: runs the tests and adds up their cases.
run() {
    folder=$1 status=0
    shift
    echo "== testing: $folder"
    ctest --test-dir "$folder" -j "${BOLAN_TEST_JOBS:-2}" --output-on-failure --no-tests=error \
        --output-log "$folder/ctest.log" "$@" || status=$?
    counts=$(awk -f tools/count_tests.awk "$folder/ctest.log" "$folder/Testing/Temporary/LastTest.log")
    # shellcheck disable=SC2086 # three numbers
    set -- $counts
    # A failure that the log does not show (no test found, ctest itself) counts too.
    if [ "$status" != 0 ] && [ "$2" = 0 ]; then set -- "$1" 1 "$3"; fi
    passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
}

build release all
run build
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
export BOLAN_TEST_SHORT=1
build asan bolan_tests_core bolan_tests_gl
# Without the statistics of seas: they call the functions that the other tests call, more often.
run build-asan -L '^(unit|physics|determinism|kernels|fuzz)$' \
    -E 'physics/test_(sea_(statistics|correlation|energy|surface|bands|buoys|motion)|record_sea|far_away)$'
# Those that draw: without the search for leaks, which the driver's threads upset at the end of a program; the tests count
# the memory of the renderer themselves.
export ASAN_OPTIONS=detect_leaks=0:strict_string_checks=1:allocator_may_return_null=1
# Without those that measure light, or compare the waves of test_sea_compute in pictures: their code is the others'.
run build-asan -L '^(shaders|twins|images)$' \
    -E 'test_(references|light_bands|light_laws|traced_light|scene_colors|views|view_tiles|clouds_above|same_picture|land_mirror|tonemap|backends)$'
finish
