// SPDX-License-Identifier: MIT
// As much of cmocka as a test of pure functions needs, for machines that have no cmocka: another processor under an
// emulator. A failed assertion ends the program. tools/check_bits.sh compiles tests/determinism/test_golden.c with it.
#ifndef BOLAN_TESTS_CROSS_CMOCKA_H
#define BOLAN_TESTS_CROSS_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest {
    const char *name;
    void (*function)(void **state);
};

#define cmocka_unit_test(f) \
    { #f, f }
#define print_error(...) ((void)fprintf(stderr, __VA_ARGS__))
#define print_message(...) ((void)printf(__VA_ARGS__))

static inline void _fail(const char *file, int line) {
    fprintf(stderr, "%s:%d: failed\n", file, line);
    exit(1);
}
static inline void _assert_true(int good, const char *what, const char *file, int line) {
    if (good) return;
    fprintf(stderr, "%s\n", what);
    _fail(file, line);
}
#define assert_true(c) _assert_true(!!(c), #c, __FILE__, __LINE__)
#define assert_int_equal(a, b) _assert_true((a) == (b), #a " == " #b, __FILE__, __LINE__)
#define skip() exit(77)

static inline int run_tests(const struct CMUnitTest *tests, size_t count) {
    for (size_t i = 0; i < count; i++) {
        tests[i].function(NULL);
        printf("passed: %s\n", tests[i].name);
    }
    return 0;
}
#define cmocka_run_group_tests(tests, setup, teardown) run_tests(tests, sizeof(tests) / sizeof *(tests))

#endif
