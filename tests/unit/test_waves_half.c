// SPDX-License-Identifier: MIT
// The integer conversion to half against IEEE 754's definition: the nearest half, ties to the even one.
#include "support.h"

#include "math/half.h"

// A finite half as a double, by the format's definition.
static double value_of(uint16_t half) {
    const int exponent = half >> 10 & 31, mantissa = half & 1023;
    const double magnitude = exponent == 0 ? ldexp(mantissa, -24) : ldexp(1024 + mantissa, exponent - 25);
    return half & 0x8000 ? -magnitude : magnitude;
}

static void every_half_comes_back(void **state) {
    (void)state;
    for (uint32_t half = 0; half < 0x10000u; half++) {
        if ((half >> 10 & 31) == 31) continue;
        assert_int_equal(half_from_float((float)value_of((uint16_t)half)), half);
    }
}

static void it_rounds_to_nearest_and_ties_to_even(void **state) {
    (void)state;
    for (uint32_t half = 0; half < 0x7bffu; half++) {
        const double low = value_of((uint16_t)half), high = value_of((uint16_t)(half + 1)), middle = 0.5 * (low + high);
        const uint32_t even = half + (half & 1u);
        assert_int_equal(half_from_float((float)middle), even);
        assert_int_equal(half_from_float(nextafterf((float)middle, 0.0f)), half);
        assert_int_equal(half_from_float(nextafterf((float)middle, 1e9f)), half + 1);
        assert_int_equal(half_from_float(-(float)middle), even | 0x8000u);
    }
}

static void what_is_too_large_is_infinite(void **state) {
    (void)state;
    assert_int_equal(half_from_float(65519.0f), 0x7bff); // the largest half is 65504; 65520 is the tie
    assert_int_equal(half_from_float(65520.0f), 0x7c00);
    assert_int_equal(half_from_float(1e30f), 0x7c00);
    assert_int_equal(half_from_float(-INFINITY), 0xfc00);
    assert_int_equal(half_from_float(NAN) & 0x7e00, 0x7e00);
}

RUN_TESTS(cmocka_unit_test(every_half_comes_back), cmocka_unit_test(it_rounds_to_nearest_and_ties_to_even),
          cmocka_unit_test(what_is_too_large_is_infinite))
