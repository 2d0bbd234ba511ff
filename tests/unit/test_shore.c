// SPDX-License-Identifier: MIT
// What shallow water leaves of a wave.
#include "support.h"

#include "bolan/coast.h"
#include "bolan/ground.h"

static void attenuation_is_the_hyperbolic_tangent(void **state) {
    (void)state;
    for (double depth = 0.01; depth < 60.0; depth *= 1.07) {
        for (double hs = 0.05; hs < 15.0; hs *= 1.5) {
            // seven terms of the continued fraction leave 3e-6 up to x = 3.4 and 1.2e-4 where it is cut, at 4.9
            double tolerance = 0.6 * depth / hs > 3.4 ? 1.3e-4 : 4e-6;
            assert_near(bolan_coast_attenuation((float)depth, (float)hs), tanh(0.6 * depth / hs), tolerance);
        }
    }
}

static void attenuation_is_none_on_land_and_full_in_deep_water(void **state) {
    (void)state;
    assert_true(bolan_coast_attenuation(0.0f, 1.0f) == 0.0f);
    assert_true(bolan_coast_attenuation(-3.0f, 1.0f) == 0.0f);
    assert_true(bolan_coast_attenuation(1000.0f, 4.0f) == 1.0f);
    assert_true(bolan_coast_attenuation(1e30f, 1.0f) == 1.0f);
    assert_true(bolan_coast_attenuation(0.5f, 0.0f) == 1.0f);
}

static void waves_stay_below_the_breaking_limit(void **state) {
    (void)state;
    // tanh(x) <= x: the height that is kept, hs * tanh(0.6 d / hs), is at most 0.6 of the depth; McCowan's limit is
    // 0.78
    for (float depth = 0.05f; depth < 20.0f; depth *= 1.3f) {
        for (float hs = 0.1f; hs < 12.0f; hs *= 1.4f) {
            assert_true(hs * bolan_coast_attenuation(depth, hs) <= 0.6f * depth * 1.00001f);
        }
    }
}

// The bands of a gale over a swell, together and one by one.
static void bands_together_stay_below_the_limit_of_one_sea(void **state) {
    (void)state;
    static const float band_hs[4] = {2.5f, 3.1f, 0.6f, 0.1f};
    const double whole = sqrt(2.5 * 2.5 + 3.1 * 3.1 + 0.6 * 0.6 + 0.1 * 0.1);
    for (float depth = 0.05f; depth < 60.0f; depth *= 1.3f) {
        float keep[4];
        double local = 0.0;
        bolan_coast_attenuations(depth, band_hs, 4, keep);
        for (int i = 0; i < 4; i++) local += (double)(keep[i] * keep[i]) * (double)(band_hs[i] * band_hs[i]);
        assert_near(sqrt(local) / whole, tanh(0.6 * (double)depth / whole), 1.4e-4);
        assert_true(sqrt(local) <= 0.6001 * (double)depth);
        // the lower a band the more it keeps; each keeps what it would alone times one factor
        assert_true(keep[0] >= keep[1] && keep[2] >= keep[0] && keep[3] >= keep[2] && keep[3] <= 1.000001f);
        const float alone = bolan_coast_attenuation(depth, 2.5f) / bolan_coast_attenuation(depth, 0.6f);
        assert_near(keep[0] / keep[2], alone, 1e-5);
        float one;
        bolan_coast_attenuations(depth, band_hs + 1, 1, &one);
        assert_near(one, bolan_coast_attenuation(depth, 3.1f), 1e-6);
    }
    float land[2] = {1.0f, 1.0f};
    bolan_coast_attenuations(-0.1f, band_hs, 2, land);
    assert_true(land[0] == 0.0f && land[1] == 0.0f);
}

RUN_TESTS(cmocka_unit_test(attenuation_is_the_hyperbolic_tangent),
          cmocka_unit_test(attenuation_is_none_on_land_and_full_in_deep_water),
          cmocka_unit_test(waves_stay_below_the_breaking_limit),
          cmocka_unit_test(bands_together_stay_below_the_limit_of_one_sea))
