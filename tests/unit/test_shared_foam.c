// SPDX-License-Identifier: MIT
// Foam and surf as C and shaders share them (shaders/shared/): covered shares by quadrature over what a pixel sees and
// hides, limits, closed forms.
#include "support.h"

#include "shared/foam.glsl"
#include "shared/surf.glsl"

// Shares and the quantiles of the standard normal distribution (Abramowitz & Stegun, table 26.5).
static const double quantiles[][2] = {
    {0.01, -2.32635}, {0.02, -2.05375}, {0.1, -1.28155}, {0.25, -0.67449}, {0.5, 0.0}};

// Mean cover over pixels whose means are Gaussian with variance `seen`, where each hides `hidden`.
static double mean_cover(double threshold, double seen, double hidden, double edge) {
    enum { STEPS = 4000 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        const double x = -8.0 + 16.0 * (i + 0.5) / STEPS, excess = threshold - x * sqrt(seen);
        sum += exp(-0.5 * x * x) / sqrt(2.0 * PI) * 16.0 / STEPS * foam_cover(excess, hidden + edge);
    }
    return sum;
}

// However much of the sea a pixel resolves and however soft the edge, the covered share is the one asked for.
static void the_covered_share_is_that_of_the_quantile(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof quantiles / sizeof *quantiles; ++k)
        for (double variance = 0.01; variance < 0.2; variance *= 4.0)
            for (double resolved = 0.0; resolved <= 1.0; resolved += 0.25)
                for (double edge = 0.002; edge < 0.05; edge *= 4.0) {
                    const double share = quantiles[k][0];
                    const double threshold = softened_offset(quantiles[k][1] * sqrt(variance), variance, edge);
                    const double seen = resolved * variance, hidden = variance - seen;
                    // normal_cdf() is good to 2e-4
                    assert_near(mean_cover(threshold, seen, hidden, edge), share, 2.5e-4);
                }
}

static void the_fast_cover_is_within_its_bound(void **state) {
    (void)state;
    double worst = 0.0;
    for (double x = -5.0; x <= 5.0; x += 0.01)
        worst = fmax(worst, fabs(foam_cover_fast(0.3 * x, 0.09) - 0.5 * erfc(-x / sqrt(2.0))));
    assert_near(worst, 0.105, 0.005);
    assert_near(foam_cover_fast(0.0, 0.4), 0.5, 1e-15);
    assert_near((foam_cover_fast(1e-4, 0.04) - 0.5) / 1e-4, 1.0 / sqrt(2.0 * PI * 0.04), 1e-6); // the density
}

static double quantile_of(double share) {
    double low = -8.0, high = 8.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        if (0.5 * erfc(-middle / sqrt(2.0)) < share)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void covers_have_their_limits(void **state) {
    (void)state;
    assert_near(foam_cover(0.0, 0.01), 0.5, 1e-12);
    assert_near(foam_cover(1.0, 1e-4), 1.0, 1e-12);
    assert_near(foam_cover(-1.0, 1e-4), 0.0, 1e-12);
    assert_near(foam_cover(-0.2, 0.04), 0.158655, 2e-4); // one standard deviation
    assert_near(softened_offset(-0.3, 0.04, 0.0), -0.3, 1e-15);
    assert_near(softened_offset(-0.3, 0.04, 0.12), -0.6, 1e-12); // four times the variance: twice as far
    assert_near(jacobian_variance_of(0.03, 2.0), 0.12, 1e-15);
    assert_true(jacobian_variance_of(-0.03, 2.0) == 0.0);
    assert_near(old_foam_share(0.01, 0.06), 0.05 / 0.99, 1e-15); // of what does not break
    assert_true(old_foam_share(0.4, 0.4) == 0.0 && old_foam_share(0.0, 0.0) == 0.0);
    assert_near(memory_quantile(2.0), 1.92 + 0.24, 1e-12);
    for (double share = 0.002; share < 1.0; share += 0.01) // 0.5 erfc(-x / sqrt 2) is the distribution function
        assert_near(foam_quantile(share), quantile_of(share), 0.03);
    assert_near(foam_quantile(0.5), 0.0, 1e-15);
    assert_true(foam_quantile(0.0) < -3.5 && foam_quantile(1.0) > 3.5);
    assert_true(FOAM_ALBEDO * FOAM_DENSEST > 0.5 && FOAM_ALBEDO < 0.8); // thick foam
}

// Mean of 1 - exp(-density x) over the positive x of a Gaussian.
static double mean_opacity(double mean, double variance, double density) {
    enum { STEPS = 20000 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        const double z = -9.0 + 18.0 * (i + 0.5) / STEPS, x = mean + z * sqrt(variance);
        if (x > 0.0) sum += exp(-0.5 * z * z) / sqrt(2.0 * PI) * 18.0 / STEPS * -expm1(-density * x);
    }
    return sum;
}

static void thin_foam_lets_the_water_through(void **state) {
    (void)state;
    for (double mean = -0.6; mean < 1.0; mean += 0.13)
        for (double variance = 1e-3; variance < 0.5; variance *= 5.0)
            for (double density = 0.3; density < 100.0; density *= 4.0)
                assert_near(foam_opacity(mean, variance, density), mean_opacity(mean, variance, density), 3e-3);
    assert_near(foam_opacity(2.0, 1e-6, 0.5), 1.0 - exp(-1.0), 1e-4); // Beer's law where all is resolved
    assert_near(foam_opacity(0.0, 1.0, 1e4), 0.5, 1e-3);              // thick foam hides what it covers
    assert_true(foam_opacity(-1.0, 1e-4, 30.0) == 0.0 && foam_opacity(-30.0, 1.0, 3.0) < 1e-30);
}

// What pixels resolve and what they hide come to one mean.
static void the_opacity_is_the_same_at_every_distance(void **state) {
    (void)state;
    enum { STEPS = 2000 };
    for (double share = 0.0; share < 1.0; share += 0.24) {
        double sum = 0.0;
        for (int i = 0; i < STEPS; ++i) {
            const double z = -7.0 + 14.0 * (i + 0.5) / STEPS, seen = -0.2 + z * sqrt(share * 0.04);
            sum += exp(-0.5 * z * z) / sqrt(2.0 * PI) * 14.0 / STEPS * foam_opacity(seen, 0.04 * (1.0 - share), 20.0);
        }
        assert_near(sum, mean_opacity(-0.2, 0.04, 20.0), 1e-3);
    }
}

// WMO's words for the forces of Beaufort, and white water from about 40 m/s on.
static void streaks_come_with_the_gale(void **state) {
    (void)state;
    assert_true(streak_share(13.8) == 0.0 && streak_share(0.0) == 0.0);
    assert_true(streak_share(17.0) > 0.005 && streak_share(17.0) < 0.05); // "begins to be blown"
    assert_true(streak_share(22.6) > 0.1 && streak_share(26.4) > 0.2);    // "dense"
    assert_true(streak_share(35.0) > 0.6 && streak_share(60.0) == 0.9);
    assert_near(spray_visibility(24.0), 300e3, 1e-6);                          // no less than any sky has
    assert_true(spray_visibility(30.5) > 1e4 && spray_visibility(30.5) < 8e4); // 11: "affected"
    assert_true(spray_visibility(36.0) > 1e3 && spray_visibility(36.0) < 1e4); // 12: "very seriously"
    assert_near(spray_visibility(60.0), 1000.0, 1e-6);
    assert_near(windrow_distance(15.0), 72.0, 1e-12);
    assert_near(windrow_distance(0.0), 8.0, 1e-12);
    assert_near(windrow_distance(40.0), 100.0, 1e-12);
}

static void a_bore_is_steep_in_front_and_thins_out_behind(void **state) {
    (void)state;
    enum { STEPS = 100000 };
    double mean = 0.0;
    for (int i = 0; i < STEPS; ++i) mean += bore_foam((i + 0.5) / STEPS) / STEPS;
    // the tail alone has (1 - e^-3) / 3 = 0.3167; half of the front's length is missing, at its full foam
    assert_near(mean, (1.0 - exp(-3.0)) / 3.0 - 0.5 * BORE_FRONT, 0.003);
    assert_near(BORE_MEAN, mean, 0.015);
    assert_near(bore_foam(0.0), 0.0, 1e-15);
    assert_near(bore_foam(0.03), 0.5 * exp(-0.09), 1e-12); // half way up the front
    assert_near(bore_foam(0.06), exp(-0.18), 1e-12);
    assert_near(bore_foam(1.0), exp(-3.0), 1e-12);
    assert_near(between_fronts(1.8, 2.0, 0.0), 0.0, 1e-12); // a front at each 0.9 heights of depth
    assert_near(between_fronts(0.9, 2.0, 0.25), 0.75, 1e-12);
    assert_near(between_fronts(0.45, 2.0, -1.0), 0.25, 1e-12); // whole cycles change nothing
}

static void surf_covers_the_shallows(void **state) {
    (void)state;
    const surf_look look = {.zone_full = 0.5,
                            .zone_none = 2.0,
                            .between = 0.2,
                            .edge_full = 0.1,
                            .edge_none = 0.4,
                            .edge_mean = 0.6,
                            .edge_pulse = 0.3};
    assert_near(surf_cover(0.4, 1.0, look), 1.0, 1e-15);
    assert_near(surf_cover(0.4, 0.0, look), 0.2, 1e-15);  // between the fronts
    assert_near(surf_cover(1.25, 1.0, look), 0.5, 1e-15); // halfway out
    assert_near(surf_cover(1.25, 0.5, look), 0.5 * 0.6, 1e-15);
    assert_true(surf_cover(2.1, 1.0, look) == 0.0);
    assert_near(swash_cover(0.05, 0.0, look), 0.6, 1e-15);
    assert_near(swash_cover(0.05, 0.25, look), 0.9, 1e-12);
    assert_near(swash_cover(0.05, 0.75, look), 0.3, 1e-12);
    assert_near(swash_cover(0.25, 1.25, look), 0.45, 1e-12);
    assert_true(swash_cover(0.5, 0.25, look) == 0.0);
    assert_near(shallows(-1.0, -1.5, 0.8), 1.0 - 3.0 * pow(0.5 / 2.3, 2.0) + 2.0 * pow(0.5 / 2.3, 3.0), 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_covered_share_is_that_of_the_quantile),
        cmocka_unit_test(the_fast_cover_is_within_its_bound),
        cmocka_unit_test(covers_have_their_limits),
        cmocka_unit_test(thin_foam_lets_the_water_through),
        cmocka_unit_test(the_opacity_is_the_same_at_every_distance),
        cmocka_unit_test(streaks_come_with_the_gale),
        cmocka_unit_test(a_bore_is_steep_in_front_and_thins_out_behind),
        cmocka_unit_test(surf_covers_the_shallows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
