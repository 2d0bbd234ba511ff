// SPDX-License-Identifier: MIT
// Directional spreading: normalisation, moments and exponents.
#include "spectrum/spectrum_eval.h"
#include "spectrum_support.h"

static bolan_wave_system system_of(bolan_spreading_kind spreading, double s, double swell) {
    const bolan_wave_system system = {.kind = BOLAN_SPECTRUM_JONSWAP,
                                      .hs = 2.1386,
                                      .peak_omega = 1.00817,
                                      .gamma = 3.3,
                                      .spreading = spreading,
                                      .spread_s = s,
                                      .wind_speed = 10.0,
                                      .swell = swell};
    return system;
}

static double integral(const bolan_wave_system *system, double omega) {
    enum { STEPS = 2000 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++)
        sum += bolan_system_spreading(system, omega, -BOLAN_PI + (i + 0.5) * 2.0 * BOLAN_PI / STEPS);
    return sum * 2.0 * BOLAN_PI / STEPS;
}

static double cos2s_norm(double s) {
    return exp((2.0 * s - 1.0) * log(2.0) + 2.0 * lgamma(s + 1.0) - lgamma(2.0 * s + 1.0)) / BOLAN_PI;
}

// 1e-4 is the bound; the midpoint rule on 2000 points alone is far below it.
static void every_spreading_integrates_to_one(void **state) {
    (void)state;
    for (double swell = 0.0; swell <= 1.0; swell += 0.125)
        for (double r = 0.4; r < 30.0; r *= 1.4) {
            for (double s = 0.5; s <= 75.0; s *= 1.5) {
                const bolan_wave_system cos2s = system_of(BOLAN_SPREADING_COS2S, s, swell);
                assert_near(integral(&cos2s, r * cos2s.peak_omega), 1.0, 1e-4);
                if (r > 1.0) break; // s does not depend on the frequency
            }
            const bolan_wave_system cos2 = system_of(BOLAN_SPREADING_COS2, 0.0, swell);
            const bolan_wave_system hasselmann = system_of(BOLAN_SPREADING_HASSELMANN, 0.0, swell);
            assert_near(integral(&cos2, r * cos2.peak_omega), 1.0, 1e-4);
            for (int kind = BOLAN_SPREADING_MITSUYASU; kind < BOLAN_SPREADING_KINDS; kind++) {
                const bolan_wave_system system = system_of((bolan_spreading_kind)kind, 0.0, swell);
                assert_near(integral(&system, r * system.peak_omega), 1.0, 1e-4);
            }
            // Far above the peak s approaches 0, where cos^{2s}(th/2) has a narrow notch at 180 degrees.
            assert_near(integral(&hasselmann, r * hasselmann.peak_omega), 1.0, 1e-4);
        }
}

static void the_cos_2s_norm_is_that_of_the_gamma_function(void **state) {
    (void)state;
    static const double table[][2] = {{1, 0.318310}, {5, 0.646725}, {10, 0.903278}, {50, 1.999704}};
    for (int i = 0; i < 4; i++) {
        const bolan_wave_system system = system_of(BOLAN_SPREADING_COS2S, table[i][0], 0.0);
        assert_near(bolan_system_spreading(&system, 1.0, 0.0), table[i][1], 1e-6);
    }
    for (double s = 0.0; s < 220.0; s += 0.37) assert_ratio(bolan_spectrum_cos2s_norm(s), cos2s_norm(s), 1e-8);
}

// Circular spread sqrt(2 (1 - s/(s+1))).
static void the_spread_of_cos_2s_is_known(void **state) {
    (void)state;
    static const double table[][2] = {{1, 57.30}, {5, 33.08}, {10, 24.43}, {50, 11.35}};
    for (int i = 0; i < 4; i++) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        sea_state.system_count = 1;
        sea_state.systems[0] = system_of(BOLAN_SPREADING_COS2S, table[i][0], 0.0);
        assert_near(bolan_sea_state_summary(&sea_state).spread_deg, table[i][1], 6e-3); // printed to two decimals
    }
}

// Hasselmann, Dunckel & Ewing (1980) at U10 = 10 m/s over 100 km. At the peak D(0) = N(s).
static void the_exponent_of_hasselmann_follows_its_table(void **state) {
    (void)state;
    static const double table[][2] = {{0.6, 0.8760}, {0.8, 2.8169}, {1, 6.97}, {1.5, 4.1299}, {2, 2.2419}, {4, 0.5144}};
    const bolan_wave_system system = system_of(BOLAN_SPREADING_HASSELMANN, 0.0, 0.0);
    for (int i = 0; i < 6; i++)
        assert_ratio(bolan_system_spreading(&system, table[i][0] * system.peak_omega, 0.0), cos2s_norm(table[i][1]),
                     5e-5);
}

static void a_cos2_sea_has_no_wave_against_the_wind(void **state) {
    (void)state;
    const bolan_wave_system system = system_of(BOLAN_SPREADING_COS2, 0.0, 0.0);
    assert_near(bolan_system_spreading(&system, 1.0, 0.0), 2.0 / BOLAN_PI, 1e-12);
    assert_near(bolan_system_spreading(&system, 1.0, 1.0), 2.0 / BOLAN_PI * cos(1.0) * cos(1.0), 1e-12);
    assert_true(bolan_system_spreading(&system, 1.0, 1.6) == 0.0 && bolan_system_spreading(&system, 1.0, 3.1) == 0.0);
}

// Horvath (2015): the exponent of |cos(th/2)|^{2 s} grows by 16 tanh(wp/w) xi^2.
static void the_swell_parameter_lengthens_the_crests(void **state) {
    (void)state;
    const bolan_wave_system plain = system_of(BOLAN_SPREADING_COS2S, 3.0, 0.0),
                            swell = system_of(BOLAN_SPREADING_COS2S, 3.0, 0.8);
    for (double r = 0.7; r < 5.0; r += 0.6) {
        const double s = 3.0 + 16.0 * tanh(1.0 / r) * 0.64, w = r * plain.peak_omega;
        assert_ratio(bolan_system_spreading(&swell, w, 0.4), cos2s_norm(s) * pow(cos(0.2), 2.0 * s), 1e-7);
        assert_true(bolan_system_spreading(&swell, w, 0.0) > bolan_system_spreading(&plain, w, 0.0));
    }
    bolan_sea_state sea_state = bolan_sea_state_default();
    double previous = 1e9;
    for (double xi = 0.0; xi <= 1.0; xi += 0.25) {
        sea_state.system_count = 1;
        sea_state.systems[0] = system_of(BOLAN_SPREADING_COS2, 0.0, xi);
        const double spread = bolan_sea_state_summary(&sea_state).spread_deg;
        assert_true(spread < previous);
        previous = spread;
    }
}

// Mitsuyasu et al. (1975) at U10 = 10 m/s over 100 km.
static void the_exponent_of_mitsuyasu_follows_its_table(void **state) {
    (void)state;
    static const double table[][2] = {{0.6, 0.8352}, {0.8, 3.5195}, {1, 10.7407},
                                      {1.5, 3.8977}, {2, 1.8987},   {4, 0.3356}};
    bolan_wave_system system = system_of(BOLAN_SPREADING_MITSUYASU, 0.0, 0.0);
    for (int i = 0; i < 6; i++)
        assert_ratio(bolan_system_spreading(&system, table[i][0] * system.peak_omega, 0.0), cos2s_norm(table[i][1]),
                     5e-5);
    system.wind_speed = 1.0; // U/cp 0.1: 3600, more than the longest crests there are
    assert_ratio(bolan_system_spreading(&system, system.peak_omega, 0.0), cos2s_norm(200.0), 1e-7);
    system.wind_speed = 0.0; // U = cp
    assert_ratio(bolan_system_spreading(&system, system.peak_omega, 0.0), cos2s_norm(11.5), 1e-7);
}

// b of sech^2(b th) (Donelan, Hamilton & Hui 1985, Banner 1990), from D(0) = b / (2 tanh(b pi)).
static void the_width_of_donelan_and_banner_follows_its_branches(void **state) {
    (void)state;
    static const double table[][2] = {{0.3, 1.24},        {0.561, 1.231097}, {0.8, 1.952799},    {0.9499, 2.441303},
                                      {0.9501, 2.436883}, {1.2, 1.798868},   {1.5999, 1.237696}, {1.6001, 1.237398},
                                      {2.5, 0.788732},    {10.0, 0.458826}};
    const bolan_wave_system system = system_of(BOLAN_SPREADING_DONELAN_BANNER, 0.0, 0.0);
    for (int i = 0; i < 10; i++) {
        const double b = table[i][1], w = table[i][0] * system.peak_omega, level = 0.5 * b / tanh(b * BOLAN_PI);
        assert_ratio(bolan_system_spreading(&system, w, 0.0), level, 1e-4);
        for (double th = 0.2; th < 3.2; th += 0.49) {
            assert_ratio(bolan_system_spreading(&system, w, th), level / pow(cosh(b * th), 2.0), 2e-4);
            assert_ratio(bolan_system_spreading(&system, w, -th), bolan_system_spreading(&system, w, th), 1e-9);
        }
    }
}

// Horvath's factor times the shape, over its integral.
static void swell_lengthens_the_crests_of_sech_and_of_elfouhaily(void **state) {
    (void)state;
    for (int kind = BOLAN_SPREADING_DONELAN_BANNER; kind < BOLAN_SPREADING_KINDS; kind++) {
        const bolan_wave_system plain = system_of((bolan_spreading_kind)kind, 0.0, 0.0),
                                swell = system_of((bolan_spreading_kind)kind, 0.0, 0.7);
        for (double r = 0.7; r < 5.0; r += 0.6) {
            const double s = 16.0 * tanh(1.0 / r) * 0.49, w = r * plain.peak_omega;
            double whole = 0.0;
            for (int i = 0; i < 4000; i++) {
                const double th = (i + 0.5) / 4000 * BOLAN_PI;
                whole += bolan_system_spreading(&plain, w, th) * pow(cos(0.5 * th), 2.0 * s) * BOLAN_PI / 2000;
            }
            assert_ratio(bolan_system_spreading(&swell, w, 0.4),
                         bolan_system_spreading(&plain, w, 0.4) * pow(cos(0.2), 2.0 * s) / whole, 2e-5);
        }
    }
}

// The first moment that summaries use, against a sum over the circle.
static void the_mean_cosine_is_that_of_the_spreading(void **state) {
    (void)state;
    for (int kind = 0; kind < BOLAN_SPREADING_KINDS; kind++)
        for (double swell = 0.0; swell <= 1.0; swell += 0.5)
            for (double r = 0.5; r < 8.0; r *= 1.5) {
                const bolan_wave_system system = system_of((bolan_spreading_kind)kind, 7.0, swell);
                const spectrum_system prepared = bolan_spectrum_system_prepare(&system);
                double sum = 0.0;
                for (int i = 0; i < 4000; i++) {
                    const double th = (i + 0.5) / 4000 * BOLAN_PI;
                    sum += bolan_system_spreading(&system, r * system.peak_omega, th) * cos(th) * BOLAN_PI / 2000;
                }
                assert_near(bolan_spectrum_system_mean_cosine(&prepared, r * system.peak_omega), sum, 1e-4);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_spreading_integrates_to_one),
        cmocka_unit_test(the_cos_2s_norm_is_that_of_the_gamma_function),
        cmocka_unit_test(the_spread_of_cos_2s_is_known),
        cmocka_unit_test(the_exponent_of_hasselmann_follows_its_table),
        cmocka_unit_test(a_cos2_sea_has_no_wave_against_the_wind),
        cmocka_unit_test(the_swell_parameter_lengthens_the_crests),
        cmocka_unit_test(the_exponent_of_mitsuyasu_follows_its_table),
        cmocka_unit_test(the_width_of_donelan_and_banner_follows_its_branches),
        cmocka_unit_test(swell_lengthens_the_crests_of_sech_and_of_elfouhaily),
        cmocka_unit_test(the_mean_cosine_is_that_of_the_spreading),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
