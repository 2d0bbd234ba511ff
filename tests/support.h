// SPDX-License-Identifier: MIT
// What every test includes: cmocka with the headers it forgets, and the data of tests/data.
#ifndef BOLAN_TESTS_SUPPORT_H
#define BOLAN_TESTS_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/// A whole test program: RUN_TESTS(cmocka_unit_test(it_does_this), ...).
#define RUN_TESTS(...)                                    \
    int main(void) {                                      \
        const struct CMUnitTest tests[] = {__VA_ARGS__};  \
        return cmocka_run_group_tests(tests, NULL, NULL); \
    }

/// |a - b| <= tolerance, saying all three where it is not so (cmocka's own is for float alone, and is silent).
#define assert_near(a, b, tolerance) \
    assert_near_at((double)(a), (double)(b), (double)(tolerance), #a, __FILE__, __LINE__)

static inline void assert_near_at(double a, double b, double tolerance, const char *what, const char *file, int line) {
    if (fabs(a - b) <= tolerance) return;
    print_error("%s = %.17g, expected %.17g within %.3g\n", what, a, b, tolerance);
    _fail(file, line);
}

/// The path of a file of tests/data, in @p path.
static inline const char *test_data(const char *name, char *path, size_t size) {
    snprintf(path, size, "%s/tests/data/%s", BOLAN_SOURCE_DIR, name);
    return path;
}

#endif
