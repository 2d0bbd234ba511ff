// SPDX-License-Identifier: MIT
// Short numbers are written as the C library's "%.*g" writes them, and read as its strtod() reads them: to the bit.
#include "support.h"

#include "bolan/base.h"

#include <string.h>

enum { TRIES = 300000 };

static uint64_t state = 88172645463325252u;
static double uniform(void) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17; // Marsaglia 2003
    return (double)(state >> 11) / 9007199254740992.0;
}

// Sizes of all kinds: many digits, few digits, floats, ties in binary.
static double some_number(int kind) {
    const double sign = uniform() < 0.5 ? -1.0 : 1.0;
    switch (kind % 5) {
    case 4: return sign * uniform() * pow(10.0, -floor(uniform() * 40.0));
    case 0: return sign * uniform() * pow(10.0, floor(uniform() * 20.0) - 8.0);
    case 1: return sign * floor(uniform() * 1e6) * pow(10.0, -floor(uniform() * 9.0));
    case 2: return (double)(float)(sign * 10.0 * uniform());
    default: return sign * ldexp(floor(uniform() * 4096.0), -(int)(uniform() * 24.0));
    }
}

static void check_written(double value, int digits) {
    char got[32], want[64];
    const int length = bolan_format_number(got, sizeof got, value, digits);
    snprintf(want, sizeof want, "%.*g", digits, value);
    assert_string_equal(got, want);
    assert_int_equal(length, (int)strlen(want));
}

static void numbers_are_written_as_by_the_c_library(void **s) {
    (void)s;
    static const double corners[] = {0.0,        -0.0,
                                     0.5,        2.5,
                                     1e-4,       9.9999999999e-5,
                                     999999.95,  9.99999999999999,
                                     1e12,       1e-300,
                                     1e300,      999999999999.5,
                                     123456.5,   (double)INFINITY,
                                     (double)NAN};
    for (int d = 1; d <= 12; d++)
        for (unsigned i = 0; i < sizeof corners / sizeof *corners; i++) check_written(corners[i], d);
    for (int i = 0; i < TRIES; i++) check_written(some_number(i), 1 + i % 12);
}

static void numbers_are_read_as_by_the_c_library(void **s) {
    (void)s;
    static const char *const texts[] = {"0",
                                        "-0",
                                        "1.",
                                        ".5",
                                        "00012",
                                        "1e5",
                                        "1e-5",
                                        "1E+22",
                                        "1e23",
                                        "123456789012345678",
                                        "0.000000000000000000000000123",
                                        "9007199254740993",
                                        "0.1e1",
                                        "-7.25e-3",
                                        "1e-300"};
    for (unsigned i = 0; i < sizeof texts / sizeof *texts; i++) {
        double got = 7.0;
        assert_true(bolan_parse_number(texts[i], strlen(texts[i]), &got));
        assert_true(got == strtod(texts[i], NULL) && signbit(got) == signbit(strtod(texts[i], NULL)));
    }
    for (int i = 0; i < TRIES; i++) {
        char text[64];
        double got;
        snprintf(text, sizeof text, i % 2 ? "%.15g" : "%.9f", some_number(i));
        assert_true(bolan_parse_number(text, strlen(text), &got));
        assert_true(got == strtod(text, NULL));
    }
}

RUN_TESTS(cmocka_unit_test(numbers_are_written_as_by_the_c_library),
          cmocka_unit_test(numbers_are_read_as_by_the_c_library))
