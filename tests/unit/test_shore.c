// SPDX-License-Identifier: MIT
// What shallow water leaves of a wave.
#include "support.h"

#include "bolan/shore.h"

static void attenuation_is_the_hyperbolic_tangent(void **state) {
    (void)state;
    for (double depth = 0.01; depth < 60.0; depth *= 1.07) {
        for (double hs = 0.05; hs < 15.0; hs *= 1.5) {
            // seven terms of the continued fraction leave 3e-6 up to x = 3.4 and 1.2e-4 where it is cut, at 4.9
            double tolerance = 0.6 * depth / hs > 3.4 ? 1.3e-4 : 4e-6;
            assert_near(bolan_shore_attenuation((float)depth, (float)hs), tanh(0.6 * depth / hs), tolerance);
        }
    }
}

static void attenuation_is_none_on_land_and_full_in_deep_water(void **state) {
    (void)state;
    assert_true(bolan_shore_attenuation(0.0f, 1.0f) == 0.0f);
    assert_true(bolan_shore_attenuation(-3.0f, 1.0f) == 0.0f);
    assert_true(bolan_shore_attenuation(1000.0f, 4.0f) == 1.0f);
    assert_true(bolan_shore_attenuation(1e30f, 1.0f) == 1.0f);
    assert_true(bolan_shore_attenuation(0.5f, 0.0f) == 1.0f);
}

static void waves_stay_below_the_breaking_limit(void **state) {
    (void)state;
    // tanh(x) <= x: the height that is kept, hs * tanh(0.6 d / hs), is at most 0.6 of the depth; McCowan's limit is 0.78
    for (float depth = 0.05f; depth < 20.0f; depth *= 1.3f) {
        for (float hs = 0.1f; hs < 12.0f; hs *= 1.4f) {
            assert_true(hs * bolan_shore_attenuation(depth, hs) <= 0.6f * depth * 1.00001f);
        }
    }
}

RUN_TESTS(cmocka_unit_test(attenuation_is_the_hyperbolic_tangent),
          cmocka_unit_test(attenuation_is_none_on_land_and_full_in_deep_water),
          cmocka_unit_test(waves_stay_below_the_breaking_limit))
