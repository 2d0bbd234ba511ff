// SPDX-License-Identifier: MIT
// What `measure` says, foam, and the slopes that a footprint does not resolve.
#include "sea_support.h"

#include "bolan/query.h"

static void a_linear_sea_is_gaussian(void **state) {
    (void)state;
    double skewness = 0.0, kurtosis = 0.0;
    const int seeds = 20;
    for (int s = 0; s < seeds; s++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.resolution = 128;
        desc.choppiness = 0.0;
        desc.seed = (uint64_t)s;
        bolan_sea *sea = test_sea(desc);
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        skewness += m.skewness / seeds;
        kurtosis += m.kurtosis / seeds;
        bolan_sea_destroy(&sea);
    }
    assert_near(skewness, 0.0, 0.05);
    assert_near(kurtosis, 3.0, 0.1);
}

// Linear motion of the parcels makes no skewness at second order, only a set-down of the mean (Nouguier, Guerin &
// Chapron 2009, "Choppy wave" model): with J = 1 + div D, E[h^2 J] and E[h^3 J] are fixed by E[h div D] alone and
// cancel in the third cumulant.
static void a_choppy_sea_stays_unskewed(void **state) {
    (void)state;
    double skewness = 0.0;
    const int seeds = 20;
    for (int s = 0; s < seeds; s++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.resolution = 128;
        desc.seed = (uint64_t)s;
        bolan_sea *sea = test_sea(desc);
        skewness += bolan_sea_measure(sea).skewness / seeds;
        bolan_sea_destroy(&sea);
    }
    assert_near(skewness, 0.0, 0.05);
}

static void periods_and_heights_are_those_of_the_sea_state(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(15.0, 30.0, 100e3);
    double hs = 0.0;
    bolan_sea_statistics m = {0};
    for (uint32_t s = 0; s < 10; s++) {
        desc.seed = s;
        desc.resolution = 128;
        bolan_sea *sea = test_sea(desc);
        m = bolan_sea_measure(sea);
        hs += m.hs / 10.0;
        bolan_sea_destroy(&sea);
    }
    // JONSWAP of 15 m/s, 100 km (Hasselmann et al. 1973)
    assert_near(hs / 3.0638, 1.0, 0.01);
    assert_near(m.tp / 7.1341, 1.0, 0.05);
    assert_near(m.tm02 / 5.5461, 1.0, 0.03);
    assert_near(m.m0_spectrum, 3.0638 * 3.0638 / 16.0, 0.002);
}

static void whitecaps_cover_what_monahan_saw(void **state) {
    (void)state;
    double previous = -1.0;
    for (double wind = 7.0; wind <= 20.0; wind += 3.25) {
        double cover = 0.0;
        for (uint32_t s = 0; s < 4; s++) {
            bolan_sea_desc desc = bolan_sea_desc_default();
            desc.sea_state = bolan_sea_state_from_wind(wind, 200.0, 300e3);
            desc.seed = s;
            bolan_sea *sea = test_sea(desc);
            bolan_sea_step(sea, 333.0); // a time that the threshold was not found at
            cover += bolan_sea_measure(sea).whitecap_fraction / 4.0;
            bolan_sea_destroy(&sea);
        }
        const double monahan = 3.84e-6 * pow(wind, 3.41); // Monahan & O'Muircheartaigh 1980
        assert_true(cover > monahan / 1.5 && cover < monahan * 1.5);
        assert_true(cover > previous);
        previous = cover;
    }
}

// From a calm to a hurricane: 0, then more with every wind, up to Monahan's .95, which 38 m/s reaches.
static void whitecaps_grow_with_the_wind(void **state) {
    (void)state;
    static const double winds[] = {0.0, 0.5, 3.0, 6.0, 12.0, 20.0, 28.0, 31.0, 32.0, 34.0, 36.0, 40.0, 55.0, 70.0};
    static const bolan_wave_model models[] = {BOLAN_WAVES_FFT, BOLAN_WAVES_COSINES, BOLAN_WAVES_TEXTURES};
    for (int m = 0; m < 3; m++) {
        double previous = 0.0, threshold = 0.0;
        for (size_t i = 0; i < sizeof winds / sizeof *winds; i++) {
            bolan_sea_desc desc = bolan_sea_desc_default();
            desc.sea_state = bolan_sea_state_from_wind(winds[i], 200.0, HUGE_VAL);
            desc.waves = models[m];
            desc.resolution = 128;
            bolan_sea *sea = test_sea(desc);
            const double cover = bolan_sea_measure(sea).whitecap_fraction, monahan = bolan_monahan_cover(winds[i]);
            if (winds[i] == 0.0) assert_true(cover == 0.0 && bolan_sea_foam_threshold(sea) == -1e30);
            if (winds[i] > 5.0) assert_near(cover / monahan, 1.0, monahan > 0.1 ? 0.1 : 0.5);
            assert_true(cover >= previous - (monahan == 0.95 ? 0.02 : 0.0)); // one time of one sea where nothing grows
            previous = cover;
            threshold = bolan_sea_foam_threshold(sea);
            bolan_sea_destroy(&sea);
        }
        assert_true(previous > 0.9 && threshold > 1.0);
    }
}

// A wind without waves has no crest for its foam.
static void a_wind_without_waves_has_no_foam(void **state) {
    (void)state;
    bolan_sea_desc desc = test_calm_desc(64);
    desc.sea_state.wind_speed = 40.0;
    bolan_sea *sea = test_sea(desc);
    assert_true(bolan_sea_foam_threshold(sea) == -1e30 && bolan_sea_measure(sea).whitecap_fraction == 0.0);
    bolan_sea_destroy(&sea);
}

// What is measured is what is asked: mean, variance, slopes and shape of 100 000 queries scattered over the tile.
static void the_surface_is_measured_as_a_query_answers_it(void **state) {
    (void)state;
    enum { POINTS = 100000 };
    static bolan_dvec2 at[POINTS];
    static bolan_query_point answer[POINTS];
    static const bolan_wave_model models[] = {BOLAN_WAVES_FFT, BOLAN_WAVES_COSINES, BOLAN_WAVES_EXP_COSINE};
    for (int model = 0; model < 3; model++) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.waves = models[model];
        desc.resolution = 128; // with 256 the water between samples is hardly lower than at them
        bolan_sea *sea = test_sea(desc);
        bolan_sea_step(sea, 40.0);
        const double side = model == 0 ? bolan_sea_cascade(sea, 0).length : 3000.0;
        for (int i = 0; i < POINTS; i++) // jittered rows and columns: nothing of the sea's own places
            at[i] = (bolan_dvec2){side * (i % 400 + 0.5 * (i % 3)) / 400.0, side * (i / 400 + 0.3 * (i % 5)) / 250.0};
        bolan_query_surface(&(bolan_water){.sea = sea}, at, POINTS, answer);
        double sum = 0.0, square = 0.0, xx = 0.0, yy = 0.0, third = 0.0;
        for (int i = 0; i < POINTS; i++) {
            const bolan_vec3 n = answer[i].normal;
            sum += answer[i].height / (double)POINTS;
            square += (double)answer[i].height * answer[i].height / POINTS;
            third += pow(answer[i].height, 3.0) / POINTS;
            xx += (double)(n.x * n.x / (n.z * n.z)) / POINTS;
            yy += (double)(n.y * n.y / (n.z * n.z)) / POINTS;
        }
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        const double variance = square - sum * sum;
        assert_near(m.m0_field / variance, 1.0, model == 0 ? 0.015 : 0.06); // sampling: of a sum, elsewhere
        assert_near(m.hs, 4.0 * sqrt(m.m0_field), 1e-9);
        assert_near(m.mss / (xx + yy), 1.0, 0.05);
        assert_near(m.mss_up + m.mss_cross, m.mss, 1e-12);
        assert_near(m.mean_level - sum, 0.0, 0.004 * m.hs);
        assert_near(m.skewness, (third - 3.0 * sum * square + 2.0 * sum * sum * sum) / pow(variance, 1.5), 0.06);
        assert_true(m.mss_up > m.mss_cross);
        bolan_sea_destroy(&sea);
    }
}

static void a_flat_calm_is_flat(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(test_calm_desc(64));
    bolan_sea_step(sea, 5.0);
    const bolan_sea_statistics m = bolan_sea_measure(sea);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal);
    assert_true(m.hs == 0.0 && m.mss == 0.0 && m.jacobian_min == 1.0 && m.jacobian_mean == 1.0);
    assert_true(m.whitecap_fraction == 0.0 && vertical == 0.0 && horizontal == 0.0);
    assert_true(bolan_sea_foam_threshold(sea) == -1e30);
    bolan_sea_destroy(&sea);
}

// Present pinch of a sample.
static double pinch_of(const bolan_cascade_view *v, size_t p, const bolan_sea_desc *desc) {
    return fmin(fmax(-((double)v->dxx[p] + (double)v->dyy[p]) * desc->choppiness, 0.0), 3.0);
}

// Every sample of every row, over some ticks and between them. A view's planes are made where it is asked for.
static void foam_decays_from_its_peaks(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    desc.foam_decay = 2.0;
    desc.choppiness = 0.8;
    desc.sea_state.wind_speed = 0.0; // which would carry the foam from sample to sample: see test_waves_on_demand.c
    bolan_sea *sea = test_sea(desc);
    const size_t points = (size_t)desc.resolution * desc.resolution;
    double *memory = calloc(points, sizeof *memory);
    uint32_t remembered[2] = {0}; // samples of even and odd rows
    // A memory of 3 is gone after 10 s, 5 foam_decay: what fades by keep and loses that much a tick ends there.
    const double loss = 1.001 * 3.0 * exp(-5.0) * (1.0 - exp(-0.25 / 2.0)) / (1.0 - exp(-5.0));
    for (uint32_t step = 0; step <= 8; step++) { // a jump, of which the present value alone is left; then half ticks
        bolan_sea_step(sea, 100.0 + 0.125 * step);
        const bolan_cascade_view v = bolan_sea_cascade(sea, 2);
        const bool tick = step % 2 == 0;
        const double ticks = step == 0 ? 0.0 : tick ? 1.0 : 0.5;
        for (size_t p = 0; p < points; p++) {
            const double left = memory[p] * exp(-ticks * 0.25 / 2.0) - ticks * loss, pinch = pinch_of(&v, p, &desc);
            assert_near(v.foam[p], fmax(left, pinch), 5e-6); // the loss is 0.1 % more than that
            if (tick && step > 0) remembered[p / v.n % 2] += left > pinch + 0.01;
            if (tick && step > 0) memory[p] = fmax(left, pinch);
        }
    }
    assert_true(remembered[0] > points / 4 && remembered[1] > points / 4); // of 4 ticks of half of the points
    bolan_sea_step(sea, 99.0);                                             // backwards
    const bolan_cascade_view v = bolan_sea_cascade(sea, 2);
    for (size_t p = 0; p < points; p++) assert_near(v.foam[p], pinch_of(&v, p, &desc), 1e-6);
    free(memory);
    bolan_sea_destroy(&sea);
}

static void bounds_hold(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 128;
    bolan_sea *sea = test_sea(desc);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal);
    double hs = 0.0;
    for (uint32_t i = 0; i < 4; i++) hs += bolan_sea_cascade(sea, i).variance;
    double lift = 0.0;
    for (uint32_t i = 0; i < 4; i++) lift += bolan_sea_lift(sea, i, 0.0);
    assert_true(lift > 0.0);
    assert_near(vertical, 6.0 * sqrt(hs) + lift, 1e-9);
    assert_near(horizontal / (vertical - lift), 1.0, 0.01); // deep water: orbits are circles
    for (int s = 0; s < 2000; s++) {
        const bolan_dvec2 at = {7.7 * s, 3.3 * s};
        bolan_sea_sample q;
        bolan_sea_sample_rest(sea, &at, 1, &q);
        assert_true(fabs(q.height) < vertical && hypot(q.dx, q.dy) < horizontal);
    }
    bolan_sea_destroy(&sea);
}

// A footprint takes what a Gaussian blur of the slope field takes.
static void a_footprint_removes_what_a_blur_removes(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.fft.cascade_count = 1;
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 0);
    float rest[3], some[3], all[3];
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    bolan_sea_unresolved_slopes(sea, 1e5, 1e5, 0.0, all);
    assert_near(all[0] + all[2] - rest[0] - rest[2], v.mss, 1e-6);
    bolan_sea_unresolved_slopes(sea, 8.0, 2.0, 0.5, some);
    double expected = 0.0; // by the public spectrum over the ring: 1 - exp(-(8 k_major)^2 - (2 k_minor)^2)
    const double dk = 2.0 * BOLAN_PI / v.length / 2.0;
    for (int j = -80; j <= 80; j++) {
        for (int i = -80; i <= 80; i++) {
            const double kx = (i + 0.5) * dk, ky = (j + 0.5) * dk, k2 = kx * kx + ky * ky;
            if (k2 >= v.k_max * v.k_max) continue;
            const double a = 8.0 * (kx * cos(0.5) + ky * sin(0.5)), b = 2.0 * (ky * cos(0.5) - kx * sin(0.5));
            expected += k2 * bolan_sea_state_wavenumber_density(&desc.sea_state, kx, ky) * dk * dk *
                        (1.0 - exp(-a * a - b * b));
        }
    }
    assert_near((some[0] + some[2] - rest[0] - rest[2]) / expected, 1.0, 0.03); // bins of a quarter octave and 11
                                                                                // degrees
    bolan_sea_destroy(&sea);
}

// Of a wind without waves all of Cox & Munk's slopes are left: 3.16e-3 U along it and 0.003 + 1.92e-3 U across,
// whichever way it blows. From 240 degrees it goes 30 degrees north of east, from 330 60 degrees south of east.
static void what_the_waves_leave_lies_along_the_wind(void **state) {
    (void)state;
    static const double wind[][2] = {{240.0, 30.0}, {330.0, -60.0}, {120.0, 150.0}, {270.0, 0.0}};
    for (int i = 0; i < 4; i++) {
        bolan_sea_desc desc = test_calm_desc(32);
        desc.sea_state.wind_speed = 10.0;
        desc.sea_state.wind_from_deg = wind[i][0];
        bolan_sea *sea = test_sea(desc);
        const double c = cos(bolan_radians(wind[i][1])), s = sin(bolan_radians(wind[i][1])), up = 0.0316,
                     cross = 0.0222;
        float rest[3];
        bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
        assert_near(rest[0], c * c * up + s * s * cross, 1e-7);
        assert_near(rest[1], c * s * (up - cross), 1e-7);
        assert_near(rest[2], s * s * up + c * c * cross, 1e-7);
        assert_near(bolan_sea_slope_table(sea)[1], rest[1], 1e-6); // a footprint of 4 mm takes nothing more
        bolan_sea_destroy(&sea);
    }
}

// Peaks all over a bin of 5 %: without the parabola through its neighbours they would be off by up to 2.5 %.
static void the_peak_period_is_found_between_the_bins(void **state) {
    (void)state;
    double worst = 0.0, signed_sum = 0.0;
    for (int i = 0; i < 8; i++) {
        bolan_sea_desc desc = test_calm_desc(512);
        desc.fft.cascade_count = 1;
        desc.length = 8000.0; // many rings of the lattice in a bin
        const double tp = 9.0 * pow(1.05, i / 8.0);
        assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 1.0, tp, 250.0, 10.0), BOLAN_OK);
        desc.sea_state.systems[0].gamma = 1.0; // a peak wider than a bin
        bolan_sea *sea = test_sea(desc);
        const double error = bolan_sea_measure(sea).tp / tp - 1.0;
        worst = fmax(worst, fabs(error));
        signed_sum += error / 8.0;
        bolan_sea_destroy(&sea);
    }
    print_message("Tp: worst error %.4f, mean %.4f\n", worst, signed_sum);
    assert_true(worst < 0.006); // the parabola fits a peak that is steeper below
    assert_near(signed_sum, 0.0, 0.004);
}

// A square of two spacings takes a wave of two out and leaves sin(pi/2)/(pi/2) = 0.64 of one of four. The swell is as
// good as one wave, and runs along x, or along y.
static void a_coarse_grid_averages_over_two_spacings(void **state) {
    (void)state;
    enum { COUNT = 4000 };
    static bolan_dvec2 at[COUNT];
    static float spacing[COUNT];
    static bolan_sea_sample whole[COUNT], some[COUNT];
    for (double from = 180.0; from <= 270.0; from += 90.0) {
        bolan_sea_desc desc = test_calm_desc(128);
        assert_int_equal(bolan_sea_state_add_swell(&desc.sea_state, 1.0, 8.0, from, 200.0), BOLAN_OK); // 99.92 m
        desc.sea_state.systems[0].gamma = 10.0;
        desc.fft.cascade_count = 1;
        desc.choppiness = 0.0;
        bolan_sea *sea = test_sea(desc);
        static const double kept[][2] = {{2.0, 0.06}, {4.0, 0.637}, {8.0, 0.90}, {100.0, 1.0}};
        for (int k = 0; k < 4; k++) {
            double all = 0.0, left = 0.0;
            for (int i = 0; i < COUNT; i++) {
                at[i] = (bolan_dvec2){3.1 * i, 5.3 * (i % 997)};
                spacing[i] = (float)(99.92 / kept[k][0]);
            }
            bolan_sea_sample_rest(sea, at, COUNT, whole);
            bolan_sea_sample_grid(sea, at, spacing, COUNT, some);
            for (int i = 0; i < COUNT; i++) {
                all += (double)(whole[i].height * whole[i].height);
                left += (double)(some[i].height * whole[i].height);
            }
            assert_near(left / all, kept[k][1], k == 0 ? 0.1 : 0.08); // waves beside the peak, most of them shorter
        }
        bolan_sea_destroy(&sea);
    }
}

static void the_slope_table_is_the_function(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.resolution = 64;
    bolan_sea *sea = test_sea(desc);
    const float *table = bolan_sea_slope_table(sea);
    for (uint32_t l = 0; l < BOLAN_SLOPE_TABLE_ANGLE; l += 3) {
        for (uint32_t j = 0; j < BOLAN_SLOPE_TABLE_ASPECT; j += 2) {
            for (uint32_t i = 0; i < BOLAN_SLOPE_TABLE_MAJOR; i += 5) {
                const double major = pow(2.0, i / 1.5 - 11.0);
                float expected[3];
                bolan_sea_unresolved_slopes(sea, major, major / (1 << j), l * BOLAN_PI / 8.0, expected);
                const float *texel = table + ((l * BOLAN_SLOPE_TABLE_ASPECT + j) * BOLAN_SLOPE_TABLE_MAJOR + i) * 4;
                for (int q = 0; q < 3; q++) assert_near(texel[q], expected[q], 1e-7);
            }
        }
    }
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(a_linear_sea_is_gaussian), cmocka_unit_test(a_choppy_sea_stays_unskewed),
          cmocka_unit_test(periods_and_heights_are_those_of_the_sea_state),
          cmocka_unit_test(whitecaps_cover_what_monahan_saw), cmocka_unit_test(whitecaps_grow_with_the_wind),
          cmocka_unit_test(a_wind_without_waves_has_no_foam),
          cmocka_unit_test(the_surface_is_measured_as_a_query_answers_it), cmocka_unit_test(a_flat_calm_is_flat),
          cmocka_unit_test(foam_decays_from_its_peaks), cmocka_unit_test(bounds_hold),
          cmocka_unit_test(a_footprint_removes_what_a_blur_removes), cmocka_unit_test(the_slope_table_is_the_function),
          cmocka_unit_test(what_the_waves_leave_lies_along_the_wind),
          cmocka_unit_test(the_peak_period_is_found_between_the_bins),
          cmocka_unit_test(a_coarse_grid_averages_over_two_spacings))
