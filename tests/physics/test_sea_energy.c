// SPDX-License-Identifier: MIT
// Energy, slopes and direction of the synthesised sea against the spectrum that was asked for.
#include "sea_support.h"

enum { SEEDS = 20, TIMES = 8 };

// JONSWAP of 10 m/s over 100 km, cos^2: m0 = 0.285843 m2, Hs = 2.1386 m, from the moments of Hasselmann et al. (1973).
static bolan_sea_desc reference(uint32_t n) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(10.0, 210.0, 100e3);
    desc.sea_state.systems[0].spreading = BOLAN_SPREADING_COS2;
    desc.resolution = n;
    return desc;
}

static double expected_variance(const bolan_sea *sea) {
    double sum = 0.0;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) sum += bolan_sea_cascade(sea, i).variance;
    return sum;
}

static double field_variance(const bolan_sea *sea) {
    double sum = 0.0;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, i);
        static float nodes[256 * 256];
        test_nodes(&v, nodes);
        sum += test_mean_product(&v, nodes, nodes);
    }
    return sum;
}

// At a time the energy of a tile swings by some percent, because waves of one mode beat.
static void twenty_seas_have_the_energy_of_their_modes(void **state) {
    (void)state;
    bolan_sea_desc desc = reference(128);
    double ratio = 0.0;
    for (uint32_t s = 0; s < SEEDS; s++) {
        desc.seed = 100 + s;
        bolan_sea *sea = test_sea(desc);
        double one = 0.0;
        for (int t = 0; t < TIMES; t++) {
            bolan_sea_step(sea, 977.0 * t);
            bolan_sea_fields(sea);
            one += field_variance(sea) / expected_variance(sea) / TIMES;
        }
        assert_near(sqrt(one), 1.0, 0.015); // Hs of one realisation, over the tile and time
        ratio += one / SEEDS;
        bolan_sea_destroy(&sea);
    }
    assert_near(ratio, 1.0, 0.01);
}

static void the_cascades_hold_the_spectrum_once(void **state) {
    (void)state;
    const double winds[] = {4.0, 8.0, 12.0, 20.0};
    for (uint32_t n = 64; n <= 256; n *= 2) {
        for (int w = 0; w < 4; w++) {
            bolan_sea_desc desc = reference(n);
            desc.sea_state = bolan_sea_state_from_wind(winds[w], 210.0, 300e3);
            bolan_sea *sea = test_sea(desc);
            const double ratio = expected_variance(sea) / bolan_sea_state_summary(&desc.sea_state).m0;
            assert_true(ratio > 0.98 && ratio < 1.03);
            bolan_sea_destroy(&sea);
        }
    }
}

static void one_cascade_and_its_tail_hold_the_spectrum(void **state) {
    (void)state;
    bolan_sea_desc desc = reference(256);
    desc.fft.cascade_count = 1;
    desc.length = 1000.0; // as in the published check: 0.9889 of m0 within the Nyquist square
    bolan_sea *sea = test_sea(desc);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
    assert_near(bolan_sea_state_summary(&desc.sea_state).m0, 0.285843, 0.0005); // 0.1 % and the digits of alpha
    // Above the ring S = alpha g^2 w^-5 to within 1 %, so what is left out is alpha g^2 / (4 w^4) = alpha / (4 k^2).
    const double tail = 0.010061 / (4.0 * v.k_max * v.k_max);
    assert_near((v.variance + tail) / 0.285843, 1.0, 0.02);
    bolan_sea_destroy(&sea);
}

static void a_narrow_swell_loses_nothing_between_the_modes(void **state) {
    (void)state;
    bolan_sea_desc desc = test_calm_desc(256);
    assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 2.0, 14.0, 300.0, 75.0), BOLAN_OK);
    bolan_sea *sea = test_sea(desc);
    assert_near(expected_variance(sea) / bolan_sea_state_summary(&desc.sea_state).m0, 1.0, 0.02);
    bolan_sea_destroy(&sea);
}

// Small tiles: the peak is narrower than a cell of the lattice, and lies anywhere in it. What one sample at the cell's
// middle would say is off by tens of percent; 8 x 8 samples are good to a percent.
static void a_peak_narrower_than_a_cell_is_not_missed(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) {
        bolan_sea_desc desc = test_calm_desc(64);
        assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 2.0, 14.0, 300.0, 200.0), BOLAN_OK);
        desc.sea_state.systems[0].gamma = 10.0;
        desc.length = 900.0 + 70.0 * i; // 3 to 4.5 peak wave lengths
        bolan_sea *sea = test_sea(desc);
        assert_near(expected_variance(sea) / 0.25, 1.0, 0.03);
        bolan_sea_destroy(&sea);
    }
}

// Integral of k^2 Psi over the ring, on a polar grid, by the public spectrum alone.
static double ring_slope_variance(const bolan_sea_state *state, double k_min, double k_max) {
    double sum = 0.0;
    const int rings = 400, directions = 72;
    const double step = log(k_max / k_min) / rings;
    for (int i = 0; i < rings; i++) {
        const double k = k_min * exp((i + 0.5) * step);
        for (int d = 0; d < directions; d++) {
            const double angle = 2.0 * BOLAN_PI * d / directions;
            const double psi = bolan_sea_state_wavenumber_density(state, k * cos(angle), k * sin(angle));
            sum += psi * k * k * k * k * step * (2.0 * BOLAN_PI / directions);
        }
    }
    return sum;
}

static void slopes_are_those_of_the_spectrum(void **state) {
    (void)state;
    bolan_sea_desc desc = reference(256);
    desc.fft.cascade_count = 1;
    desc.length = 1000.0;
    desc.choppiness = 0.0;
    double mean = 0.0, expected = 0.0;
    const uint32_t seeds = 8;
    for (uint32_t s = 0; s < seeds; s++) {
        desc.seed = s;
        bolan_sea *sea = test_sea(desc);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
        mean += bolan_sea_measure(sea).mss / seeds;
        // Without the roll-off, which begins at ten times the wave number of the peak (60.6 m), beyond the ring's end.
        expected = ring_slope_variance(&desc.sea_state, 2.0 * BOLAN_PI / 1000.0, v.k_max);
        bolan_sea_destroy(&sea);
    }
    assert_near(mean / expected, 1.0, 0.03);
}

static void slopes_resolved_and_not_add_up_to_cox_and_munk(void **state) {
    (void)state;
    for (double wind = 4.0; wind <= 20.0; wind += 4.0) {
        bolan_sea_desc desc = reference(256);
        desc.sea_state = bolan_sea_state_from_wind(wind, 210.0, 300e3);
        bolan_sea *sea = test_sea(desc);
        float rest[3];
        bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        const double total = m.mss + rest[0] + rest[2];
        assert_near(total, 0.003 + 5.12e-3 * wind, 0.004 + 0.1 * (0.003 + 5.12e-3 * wind)); // Cox & Munk 1954, their
                                                                                            // scatter
        // Along the wind, which blows to 60 degrees from the east, and across it.
        const double c = cos(BOLAN_PI / 3.0), s = sin(BOLAN_PI / 3.0), along = c * c * rest[0] + s * s * rest[2];
        const double up = m.mss_up + along + 2.0 * c * s * rest[1];
        const double cross = m.mss_cross + s * s * rest[0] + c * c * rest[2] - 2.0 * c * s * rest[1];
        assert_true(cross / up > 0.54 && cross / up <= 1.0);
        assert_near(cross / up, (0.003 + 1.92e-3 * wind) / (3.16e-3 * wind), 0.06);
        bolan_sea_destroy(&sea);
    }
}

static void a_calm_has_few_ripples(void **state) {
    (void)state;
    bolan_sea_desc desc = test_calm_desc(256);
    assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 2.0, 12.0, 300.0, 50.0), BOLAN_OK);
    bolan_sea *sea = test_sea(desc);
    double mss = 0.0;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) mss += bolan_sea_cascade(sea, i).mss;
    assert_true(mss < 0.003 + 0.004); // Cox & Munk's clean surface without wind, and its error
    bolan_sea_destroy(&sea);
}

static double angle_between(double a, double b) { return remainder(a - b, 360.0); }

static void waves_come_from_where_they_were_asked_to(void **state) {
    (void)state;
    for (double from = 20.0; from < 360.0; from += 80.0) {
        bolan_sea_desc desc = reference(128);
        desc.sea_state = bolan_sea_state_from_wind(10.0, from, 100e3);
        double offset = 0.0;
        for (uint32_t s = 0; s < 10; s++) {
            desc.seed = s;
            bolan_sea *sea = test_sea(desc);
            offset += angle_between(bolan_sea_measure(sea).direction_from, from) / 10.0;
            bolan_sea_destroy(&sea);
        }
        assert_near(offset, 0.0, 2.0);
    }
}

// From the fields, not the modes: the energy flux -<d eta/dt grad eta> points where waves go.
static void the_fields_move_where_the_modes_say(void **state) {
    (void)state;
    bolan_sea_desc desc = reference(128);
    desc.fft.cascade_count = 2;
    bolan_sea *sea = test_sea(desc);
    for (uint32_t index = 0; index < 2; index++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, index);
        const size_t points = (size_t)v.n * v.n;
        float *before = malloc(points * sizeof(float));
        const double dt = index == 0 ? 0.05 : 0.01;
        bolan_sea_step(sea, 50.0 - dt);
        bolan_sea_fields(sea);
        twin_copy(&v, TWIN_TEXELS(&v, height), before);
        bolan_sea_step(sea, 50.0 + dt);
        bolan_sea_fields(sea);
        for (uint32_t p = 0; p < points; p++)
            before[p] = twin_at(TWIN_TEXELS(&v, height), p % v.n, p / v.n) - before[p];
        bolan_sea_step(sea, 50.0);
        bolan_sea_fields(sea);
        const double east = -test_mean_product(&v, before, v.slope_x),
                     north = -test_mean_product(&v, before, v.slope_y);
        assert_near(angle_between(bolan_math_to_compass_from(atan2(north, east)), 210.0), 0.0, 6.0); // of one
                                                                                                     // realisation
        free(before);
    }
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(twenty_seas_have_the_energy_of_their_modes),
          cmocka_unit_test(the_cascades_hold_the_spectrum_once),
          cmocka_unit_test(one_cascade_and_its_tail_hold_the_spectrum),
          cmocka_unit_test(a_narrow_swell_loses_nothing_between_the_modes),
          cmocka_unit_test(a_peak_narrower_than_a_cell_is_not_missed),
          cmocka_unit_test(slopes_are_those_of_the_spectrum),
          cmocka_unit_test(slopes_resolved_and_not_add_up_to_cox_and_munk), cmocka_unit_test(a_calm_has_few_ripples),
          cmocka_unit_test(waves_come_from_where_they_were_asked_to),
          cmocka_unit_test(the_fields_move_where_the_modes_say))
