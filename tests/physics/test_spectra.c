// SPDX-License-Identifier: MIT
// Model spectra against the closed forms and tables of their papers (g = 9.81).
#include "spectrum/spectrum_eval.h"
#include "spectrum_support.h"

static bolan_wave_system system_of(bolan_spectrum_kind kind, double hs, double peak_omega, double gamma) {
    const bolan_wave_system system = {.kind = kind, .hs = hs, .peak_omega = peak_omega, .gamma = gamma};
    return system;
}

static bolan_sea_summary summary_of(bolan_wave_system system, double depth) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.system_count = 1;
    sea_state.systems[0] = system;
    sea_state.depth = depth;
    return bolan_sea_state_summary(&sea_state);
}

// Pierson & Moskowitz (1964): S = 8.10e-3 g^2 w^-5 exp(-0.74 (g/(U w))^4), U at 19.5 m.
static void pierson_moskowitz_has_the_density_of_its_paper(void **state) {
    (void)state;
    const double g = BOLAN_GRAVITY, wind = 10.0;
    const bolan_wave_system pm = system_of(BOLAN_SPECTRUM_PIERSON_MOSKOWITZ, 2.13298, 0.86050, 9.0);
    for (double w = 0.5; w < 6.0; w += 0.25) {
        const double expected = 8.10e-3 * g * g * pow(w, -5.0) * exp(-0.74 * pow(g / (wind * w), 4.0));
        assert_ratio(bolan_system_density(&pm, w, BOLAN_DEEP), expected, 2e-4); // Hs and wp are given to 6 digits
    }
    const bolan_sea_summary summary = summary_of(pm, BOLAN_DEEP);
    assert_ratio(summary.hs, 2.13298, 1e-6);
    assert_ratio(summary.tp, 7.3018, 1e-5);
    assert_ratio(summary.tm02, 5.1870, 1e-4);
}

// C(gamma) of a g^2 = (5/16) Hs^2 wp^4 C(gamma), exact quadrature to five digits.
static void the_jonswap_normalisation_is_exact(void **state) {
    (void)state;
    static const double table[][2] = {{1, 1.0}, {2, 0.80281}, {3.3, 0.65576}, {5, 0.53809}, {7, 0.44940}};
    for (size_t i = 0; i < 5; i++) assert_near(1.0 / bolan_spectrum_peak_integral(log(table[i][0])), table[i][1], 5e-6);
    for (double gamma = 1.0; gamma <= 10.0; gamma += 0.37) // the fit against the variance, integrated by Simpson's rule
        assert_ratio(summary_of(system_of(BOLAN_SPECTRUM_JONSWAP, 4.0, 0.7, gamma), BOLAN_DEEP).m0, 1.0, 1e-6);
}

static void mean_periods_follow_the_peak_enhancement(void **state) {
    (void)state;
    static const double tz[][2] = {{1, 0.7104}, {3.3, 0.7774}, {7, 0.8285}};
    static const double te[3] = {0.8572, 0.9033, 0.9312};
    for (int i = 0; i < 3; i++) {
        const bolan_sea_summary s = summary_of(system_of(BOLAN_SPECTRUM_JONSWAP, 2.0, 0.8, tz[i][0]), BOLAN_DEEP);
        assert_near(s.tm02 / s.tp, tz[i][1], 6e-5); // printed to four digits
        assert_near(s.te / s.tp, te[i], 6e-5);
    }
    // Pierson-Moskowitz: T01 / Tp from the Gamma function.
    const bolan_sea_summary pm = summary_of(system_of(BOLAN_SPECTRUM_PIERSON_MOSKOWITZ, 2.0, 0.8, 1), BOLAN_DEEP);
    assert_near(pm.tm01 / pm.tp, 0.7718, 6e-5);
}

// Hasselmann et al. (1973): wind, fetch -> peak, height, peak period, zero-crossing period.
static void a_wind_over_a_fetch_raises_the_sea_of_jonswap(void **state) {
    (void)state;
    static const double table[][7] = {{5, 10, 0.012308, 2.73660, 0.3210, 2.2960, 1.7849},
                                      {10, 100, 0.010061, 1.00817, 2.1386, 6.2322, 4.8449},
                                      {15, 100, 0.012026, 0.88072, 3.0638, 7.1341, 5.5461}};
    for (int i = 0; i < 3; i++) {
        const bolan_sea_state sea_state = bolan_sea_state_from_wind(table[i][0], 225.0, table[i][1] * 1e3);
        const bolan_wave_system *s = &sea_state.systems[0];
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        const double tail = bolan_system_density(s, 20.0 * s->peak_omega, BOLAN_DEEP) * pow(20.0 * s->peak_omega, 5.0);
        assert_ratio(tail / (BOLAN_GRAVITY * BOLAN_GRAVITY), table[i][2], 1e-3); // alpha g^2 w^-5
        assert_near(s->peak_omega, table[i][3], 6e-6);
        assert_near(summary.hs, table[i][4], 6e-5);
        assert_near(summary.tp, table[i][5], 6e-5);
        assert_near(summary.tm02, table[i][6], 2e-4);
        assert_near(summary.from_deg, 225.0, 1e-9);
    }
    // 20 m/s over 500 km would be 9.6857 m high, more than the sea of that wind that is fully developed.
    const bolan_sea_summary long_fetch =
        summary_of(system_of(BOLAN_SPECTRUM_JONSWAP, 9.6857, 0.46795, 3.3), BOLAN_DEEP);
    assert_near(long_fetch.tp, 13.4270, 2e-4);
    assert_near(long_fetch.tm02, 10.4381, 2e-4);
    const bolan_sea_state capped = bolan_sea_state_from_wind(20.0, 225.0, 500e3);
    assert_near(capped.systems[0].peak_omega, 0.46795, 6e-6);
    assert_ratio(capped.systems[0].hs, 0.20925 * 20.52 * 20.52 / 9.81, 1e-5); // Pierson & Moskowitz, U19.5 = 1.026 U10
}

// Hs and Tp never fall with the fetch, and no sea is higher than Pierson & Moskowitz's of its wind.
static void a_growing_sea_never_falls(void **state) {
    (void)state;
    for (double wind = 3.0; wind <= 39.0; wind += 6.0) {
        const double developed = fmin(0.20925 * pow(1.026 * wind, 2.0) / 9.81, 40.0);
        double hs = 0.0, peak = INFINITY;
        for (double fetch = 300.0; fetch < 2e7; fetch *= 1.05) {
            const bolan_wave_system s = bolan_sea_state_from_wind(wind, 0.0, fetch).systems[0];
            assert_true(s.hs >= hs && s.hs <= developed * 1.00001 && s.peak_omega <= peak);
            hs = s.hs;
            peak = s.peak_omega;
        }
        assert_ratio(hs, developed, 1e-5);
    }
}

// The peak's enhancement gives way over the last tenth: 3.3 from 1.1 of the fully developed peak on, half-way 2.15.
static void the_peak_loses_its_enhancement_over_the_last_tenth(void **state) {
    (void)state;
    const double peak_pm = 0.87716 * 9.81 / (1.026 * 10.0);
    static const double at[][2] = {{1.3, 3.3}, {1.11, 3.3}, {1.075, 2.725}, {1.05, 2.15}, {1.01, 1.23}, {0.99, 1.0}};
    for (int i = 0; i < 6; i++) {
        const double fetch = pow(22.0 / (at[i][0] * peak_pm), 3.0) * 9.81 * 9.81 / 10.0;
        const bolan_wave_system s = bolan_sea_state_from_wind(10.0, 0.0, fetch).systems[0];
        assert_near(s.gamma, at[i][1], 1e-3);
        assert_near(s.peak_omega, fmax(at[i][0], 1.0) * peak_pm, 1e-5);
    }
}

static void a_long_fetch_ends_in_the_fully_developed_sea(void **state) {
    (void)state;
    const bolan_sea_state sea_state = bolan_sea_state_from_wind(20.0 / 1.026, 0.0, 1e7); // 20 m/s at 19.5 m
    assert_int_equal(sea_state.systems[0].kind, BOLAN_SPECTRUM_PIERSON_MOSKOWITZ);
    assert_ratio(sea_state.systems[0].hs, 8.53194, 2e-5);
    assert_ratio(2.0 * BOLAN_PI / sea_state.systems[0].peak_omega, 14.6036, 2e-5);
    double previous = bolan_sea_state_from_wind(20.0, 0.0, 4e5).systems[0].hs;
    for (double fetch = 4e5; fetch < 9e5; fetch *= 1.002) { // no jump where the two laws meet
        const double hs = bolan_sea_state_from_wind(20.0, 0.0, fetch).systems[0].hs;
        assert_ratio(hs, previous, 0.003);
        previous = hs;
    }
}

// Kitaigorodskii's factor at w_h = w sqrt(h/g); Bouws et al. (1985).
static void tma_follows_kitaigorodskii(void **state) {
    (void)state;
    static const double table[][2] = {{0.25, 0.031247}, {0.5, 0.124805}, {0.75, 0.278684}, {1, 0.482770},
                                      {1.25, 0.703805}, {1.5, 0.878529}, {2, 0.993359}};
    const double depth = 10.0;
    const bolan_wave_system tma = system_of(BOLAN_SPECTRUM_TMA, 3.0, 0.5, 3.3);
    const bolan_wave_system deep = system_of(BOLAN_SPECTRUM_JONSWAP, 3.0, 0.5, 3.3);
    for (int i = 0; i < 7; i++) {
        const double w = table[i][0] / sqrt(depth / BOLAN_GRAVITY);
        assert_near(bolan_system_density(&tma, w, depth) / bolan_system_density(&deep, w, depth), table[i][1], 1e-5);
    }
    static const double heights[][2] = {{5, 1.6409}, {10, 2.1747}, {20, 2.7089}, {50, 3.0455}, {BOLAN_DEEP, 3.0638}};
    for (int i = 0; i < 5; i++) { // U10 = 15 m/s over 100 km
        const bolan_wave_system s = system_of(BOLAN_SPECTRUM_TMA, 3.0638, 0.88072, 3.3);
        assert_near(summary_of(s, heights[i][0]).hs, heights[i][1], 1e-4);
    }
}

static void the_wave_vector_density_holds_the_whole_variance(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_from_wind(10.0, 225.0, 100e3);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 12.0, 300.0, 25.0), BOLAN_OK);
    for (sea_state.depth = 8.0; sea_state.depth <= 8000.0; sea_state.depth *= 1000.0) {
        const double m0 = bolan_sea_state_summary(&sea_state).m0;
        assert_ratio(m0, (2.1386 * 2.1386 + 1.0) / 16.0, 1e-4);
        assert_ratio(wavenumber_variance(&sea_state, 1e-3, 500.0, 900, 180), m0, 1e-3); // the midpoint rule's steps
    }
}

static void the_wave_vector_density_is_the_density_times_the_jacobian(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_from_wind(12.0, 250.0, 80e3);
    sea_state.systems[0].kind = BOLAN_SPECTRUM_TMA;
    sea_state.depth = 15.0;
    for (double k = 0.02; k < 300.0; k *= 1.9)
        for (double th = -1.0; th < 1.5; th += 0.7) {
            const double w = bolan_omega_from_k(k, sea_state.depth);
            const double expected =
                bolan_sea_state_density(&sea_state, w, th) * bolan_group_speed(k, sea_state.depth) / k;
            // k comes back from w with 1e-12, which the steep spreading of short waves does not enlarge beyond 1e-9.
            assert_near(bolan_sea_state_wavenumber_density(&sea_state, k * cos(th), k * sin(th)), expected,
                        1e-9 * expected + 1e-300);
        }
    assert_true(bolan_sea_state_wavenumber_density(&sea_state, 0.0, 0.0) == 0.0);
}

static void waves_go_where_the_wind_blows(void **state) {
    (void)state;
    // A wind from the west (270) drives waves east: +x.
    const bolan_sea_state west = bolan_sea_state_from_wind(10.0, 270.0, 100e3);
    assert_true(bolan_sea_state_wavenumber_density(&west, 0.1, 0.0) >
                1e3 * bolan_sea_state_wavenumber_density(&west, -0.1, 0.0));
    const bolan_sea_state north = bolan_sea_state_from_wind(10.0, 0.0, 100e3); // from the north: -y
    assert_true(bolan_sea_state_wavenumber_density(&north, 0.0, -0.1) >
                1e3 * bolan_sea_state_wavenumber_density(&north, 0.0, 0.1));
    assert_near(bolan_sea_state_summary(&north).from_deg, 0.0, 1e-9);
}

static void cox_and_munk_and_monahan_give_their_regressions(void **state) {
    (void)state;
    double up, cross;
    bolan_cox_munk(10.0, &up, &cross);
    assert_near(up, 0.0316, 1e-9);
    assert_near(cross, 0.0222, 1e-9);
    assert_near(up + cross, 0.0542, 5e-4); // their regression of the total was fitted apart: 0.003 + 5.12e-3 U
    bolan_cox_munk(1.0, &up, &cross);      // their least wind was 0.7 m/s
    assert_near(cross, 0.00492, 1e-9);
    bolan_cox_munk(0.0, &up, &cross);
    assert_true(up == 0.0 && cross == 0.0); // a calm mirrors
    static const double cover[][2] = {{5, 0.00093}, {10, 0.00987}, {15, 0.0393}, {20, 0.105}, {25, 0.225}};
    for (int i = 0; i < 5; i++)
        assert_ratio(bolan_monahan_cover(cover[i][0]), cover[i][1], 6e-3); // printed to two or three digits
    assert_true(bolan_monahan_cover(0.0) == 0.0 && bolan_monahan_cover(70.0) == 0.95);
    // Callaghan et al. 2008, by hand from the printed regressions
    static const double callaghan[][2] = {{5.0, 6.99e-5},  {8.0, 2.53e-3},  {10.0, 7.95e-3},
                                          {15.0, 0.02358}, {20.0, 0.05119}, {50.0, 0.6777}};
    for (size_t i = 0; i < sizeof callaghan / sizeof *callaghan; i++)
        assert_ratio(bolan_callaghan_cover(callaghan[i][0]), callaghan[i][1], 3e-3);
    assert_true(bolan_callaghan_cover(3.7) == 0.0 && bolan_callaghan_cover(70.0) == 0.95);
    assert_ratio(bolan_breaker_cover(10.0), 5.01e-4, 2e-3);
    assert_ratio(bolan_breaker_cover(20.0), 4.603e-3, 2e-3);
    assert_true(bolan_breaker_cover(3.0) == 0.0 && bolan_breaker_cover(4.0) == bolan_callaghan_cover(4.0));
    assert_ratio(bolan_monahan_cover(35.0), 3.84e-6 * pow(35.0, 3.41), 1e-9);
}

// Psi = 2 A exp(-1/(kL)^2) k^-4 cos^2 e^{-k^2 l^2} where the wind blows to: the printed form without the 2 is spread
// over k and
// -k alike (Tessendorf 2001, eq. 40-41). A = alpha / (2 pi) = 1.289e-3 has the tail of Pierson & Moskowitz.
static double phillips(double wind, double kx, double ky) {
    const double l = wind * wind / BOLAN_GRAVITY, k2 = kx * kx + ky * ky, small = l / 1000.0;
    if (kx <= 0.0) return 0.0;
    return 2.0 * 0.0081 / (2.0 * BOLAN_PI) * exp(-1.0 / (k2 * l * l)) / (k2 * k2) * (kx * kx / k2) *
           exp(-k2 * small * small);
}

static void phillips_has_the_density_of_its_formula(void **state) {
    (void)state;
    for (double wind = 5.0; wind <= 20.0; wind += 5.0) {
        const bolan_sea_state sea_state = bolan_sea_state_from_phillips(wind, 270.0); // toward east
        const double l = wind * wind / BOLAN_GRAVITY;
        assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
        for (double k = 0.3 / l; k < 2000.0 / l; k *= 1.3) {
            for (double th = -3.0; th < 3.1; th += 0.375) {
                const double kx = k * cos(th), ky = k * sin(th), expected = phillips(wind, kx, ky);
                // Capillary waves are no part of the formula: with 1 + t, t = 7.17e-5 k^2 / g, in place of 1, w is
                // larger by t/2 and Psi off by some t; the cut, whose k is w^2 / g, by 2 t (k l)^2.
                const double t = BOLAN_SURFACE_TENSION_SEA * k * k / BOLAN_GRAVITY, kl = k * l / 1000.0;
                assert_near(bolan_sea_state_wavenumber_density(&sea_state, kx, ky), expected,
                            expected * (1e-4 + (3.0 + 4.0 * kl * kl) * t) + 1e-30);
            }
        }
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        const double a = 0.0081 / (2.0 * BOLAN_PI);
        assert_near(a, 1.289e-3, 5e-7);
        assert_ratio(summary.hs, 4.0 * sqrt(a * BOLAN_PI * l * l / 2.0), 1e-5); // the cut takes 1e-6
        assert_ratio(summary.tp, 2.0 * BOLAN_PI * wind / (BOLAN_GRAVITY * pow(0.8, 0.25)),
                     0.01); // found on steps of 0.5 %
        assert_near(summary.from_deg, 270.0, 1e-6);
    }
}

static void phillips_ends_at_its_small_waves(void **state) {
    (void)state;
    const bolan_sea_state sea_state = bolan_sea_state_from_phillips(20.0, 270.0);
    const double l = 400.0 / BOLAN_GRAVITY / 1000.0, g = BOLAN_GRAVITY;
    bolan_wave_system cut = sea_state.systems[0], whole = cut;
    whole.kind = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    for (double kl = 0.1; kl < 4.0; kl += 0.3) {
        const double w = sqrt(g * kl / l);
        assert_ratio(bolan_system_density(&cut, w, BOLAN_DEEP) / bolan_system_density(&whole, w, BOLAN_DEEP),
                     exp(-kl * kl), 1e-6);
    }
    assert_true(bolan_system_density(&cut, sqrt(g * 25.0 / l), BOLAN_DEEP) == 0.0);
    bolan_sea_state calm = bolan_sea_state_from_phillips(0.0, 270.0);
    assert_int_equal(calm.system_count, 0);
    calm = bolan_sea_state_from_phillips(80.0, 270.0); // refused by validation, not here
    assert_int_not_equal(bolan_sea_state_validate(&calm), BOLAN_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pierson_moskowitz_has_the_density_of_its_paper),
        cmocka_unit_test(phillips_has_the_density_of_its_formula),
        cmocka_unit_test(phillips_ends_at_its_small_waves),
        cmocka_unit_test(the_jonswap_normalisation_is_exact),
        cmocka_unit_test(mean_periods_follow_the_peak_enhancement),
        cmocka_unit_test(a_wind_over_a_fetch_raises_the_sea_of_jonswap),
        cmocka_unit_test(a_long_fetch_ends_in_the_fully_developed_sea),
        cmocka_unit_test(a_growing_sea_never_falls),
        cmocka_unit_test(the_peak_loses_its_enhancement_over_the_last_tenth),
        cmocka_unit_test(tma_follows_kitaigorodskii),
        cmocka_unit_test(the_wave_vector_density_holds_the_whole_variance),
        cmocka_unit_test(the_wave_vector_density_is_the_density_times_the_jacobian),
        cmocka_unit_test(waves_go_where_the_wind_blows),
        cmocka_unit_test(cox_and_munk_and_monahan_give_their_regressions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
