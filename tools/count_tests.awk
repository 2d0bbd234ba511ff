# SPDX-License-Identifier: MIT
# awk -f count_tests.awk CTEST-OUTPUT LastTest.log: prints "passed failed skipped". A cmocka program counts by its cases,
# any other test as one. The second file has the programs' output, but only the first tells skipped from passed.
function close_test() {
    if (!open) return
    if (!cases) {
        if (name in skipped_tests) skip = 1
        else if (outcome == "Passed") ok = 1
    }
    if (outcome == "Failed" && !bad) bad = 1 # crashed, timed out, or failed in set-up
    passed += ok; failed += bad; skipped += skip
    open = 0
}
/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .*\*\*\*Skipped/ { sub(/^.*#[0-9]+: /, ""); skipped_tests[$1] = 1; next }
/^[0-9]+\/[0-9]+ Testing: / { close_test(); open = 1; name = $3; outcome = "Failed"; cases = ok = bad = skip = 0 }
/^\[  PASSED  \] [0-9]+ test\(s\)/ { ok += $4; cases = 1 }
/^\[  FAILED  \] [0-9]+ test\(s\)/ { bad += $4; cases = 1 }
/^\[  SKIPPED \] [0-9]+ test\(s\)/ { skip += $4; cases = 1 }
/^Test Passed\.$/ { outcome = "Passed" }
/^Test (Failed|timeout)/ { outcome = "Failed" }
END { close_test(); print passed + 0, failed + 0, skipped + 0 }
