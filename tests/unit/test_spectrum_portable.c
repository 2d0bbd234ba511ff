// SPDX-License-Identifier: MIT
// The portable elementary functions against libm. Their bounds: a handful of roundings of 1.1e-16 each.
#include "spectrum/portable.h"
#include "spectrum_support.h"

static void exp_and_log_agree_with_libm(void **state) {
    (void)state;
    for (double x = -700.0; x < 700.0; x += 0.1371) assert_ratio(portable_exp(x), exp(x), 8e-16);
    for (double x = 1e-300; x < 1e300; x *= 1.7) assert_ratio(portable_log(x), log(x), 4e-16);
    for (double x = 0.5; x < 2.0; x += 0.0013) assert_near(portable_log(x), log(x), 4e-16 * fabs(log(x)) + 2e-17);
    assert_true(portable_exp(-1e9) == 0.0 && portable_exp(-HUGE_VAL) == 0.0);
    assert_true(isfinite(portable_exp(1e9)));
}

static void pow_loses_what_its_exponent_magnifies(void **state) {
    (void)state;
    for (double x = 0.01; x < 50.0; x *= 1.3)
        for (double y = -6.0; y < 6.0; y += 0.7)
            assert_ratio(portable_pow(x, y), pow(x, y), 4e-15); // |y ln x| < 24 half units in the last place
}

static void tanh_is_accurate_from_shallow_to_deep(void **state) {
    (void)state;
    for (double x = 1e-12; x < 100.0; x *= 1.21) assert_ratio(portable_tanh(x), tanh(x), 8e-16);
    assert_true(portable_tanh(0.0) == 0.0);
}

static void angles_run_once_around_the_circle(void **state) {
    (void)state;
    for (double a = 0.0; a < 6.283; a += 0.0137) assert_near(portable_angle(3.0 * sin(a), 3.0 * cos(a)), a, 2e-15);
    assert_true(portable_angle(0.0, 0.0) == 0.0);
    const double just_below = portable_angle(-1e-20, 1.0);
    assert_true(just_below >= 0.0 && just_below < 2.0 * BOLAN_PI);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exp_and_log_agree_with_libm),
        cmocka_unit_test(pow_loses_what_its_exponent_magnifies),
        cmocka_unit_test(tanh_is_accurate_from_shallow_to_deep),
        cmocka_unit_test(angles_run_once_around_the_circle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
