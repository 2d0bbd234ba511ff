// SPDX-License-Identifier: MIT
// The sums of waves against the numbers of their papers (Liu, Xu & Chen 2009; Liu & Xie 2010) and of linear theory.
#include "sea_support.h"

#include "bolan/query.h"
#include "waves/sum/exp_cosine.h"

#define TURN (2.0 * BOLAN_PI)

// The spectrum of the paper: S = 0.78 w^-5 exp(-3.11 / (w^4 H^2)), H = 3 m, cos^2 about east. Its m0 is 0.78 H^2 / (4 *
// 3.11).
static const double paper_m0 = 0.78 * 9.0 / (4.0 * 3.11), paper_b = 3.11 / 9.0;

static bolan_sea_desc paper_desc(void) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_COSINES;
    d.sea_state = bolan_sea_state_default();
    d.sea_state.system_count = 1;
    d.sea_state.systems[0] = (bolan_wave_system){.kind = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ,
                                                 .hs = 4.0 * sqrt(paper_m0),
                                                 .peak_omega = pow(0.8 * paper_b, 0.25),
                                                 .gamma = 1.0,
                                                 .from_deg = 270.0,
                                                 .spreading = BOLAN_SPREADING_COS2};
    return d;
}

static double wave_number(const bolan_sea_component *c) { return hypot(c->kx, c->ky); }

static void equal_energy_has_the_sixteen_frequencies_and_one_amplitude(void **state) {
    (void)state;
    static const double printed[16] = {.5619, .6181, .6569, .6905,  .7224,  .7542,  .7870,  .8218,
                                       .8597, .9023, .9517, 1.0114, 1.0877, 1.1942, 1.3688, 1.8163};
    bolan_sea *sea = test_sea(paper_desc());
    assert_int_equal(bolan_sea_component_count(sea), 128);
    assert_int_equal(bolan_sea_cascade_count(sea), 0);
    double m0 = 0.0, m2 = 0.0;
    for (uint32_t i = 0; i < 16; i++) {
        double squares = 0.0;
        for (uint32_t j = 0; j < 8; j++) {
            const bolan_sea_component c = bolan_sea_get_component(sea, 8 * i + j);
            assert_near(c.omega, printed[i], 6e-5); // printed to half of 1e-4; the running energy adds 1e-5
            squares += c.amplitude * c.amplitude;
            m0 += 0.5 * c.amplitude * c.amplitude;
            m2 += 0.5 * c.amplitude * c.amplitude * c.omega * c.omega;
        }
        assert_near(sqrt(squares), 0.26559, 1e-5); // sqrt(2 m0 / 16)
    }
    assert_near(m0, 0.564309, 1e-5);
    assert_near(4.0 * sqrt(m0), 3.005, 5e-4);
    // m2 = (0.78 / 4) B^{-1/2} Gamma(1/2): the tail beyond the last frequency is what is missing.
    assert_near(m2 / (0.195 / sqrt(paper_b) * sqrt(BOLAN_PI)), 0.915, 1e-3);
    bolan_sea_destroy(&sea);
}

static void eight_directions_share_as_cos2_does(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(paper_desc());
    for (uint32_t j = 0; j < 8; j++) {
        const bolan_sea_component c = bolan_sea_get_component(sea, j);
        const double th =
            (j + 0.5) * BOLAN_PI / 8.0 - BOLAN_PI / 2.0; // from east; (2/pi) cos^2 dth adds up to 1 exactly
        assert_near(atan2(c.ky, c.kx), th, 1e-9);
        assert_near(0.5 * c.amplitude * c.amplitude,
                    paper_m0 / 16.0 * 2.0 / BOLAN_PI * pow(cos(th), 2.0) * BOLAN_PI / 8.0, 1e-6 * paper_m0);
    }
    bolan_sea_destroy(&sea);
}

static void the_field_has_the_paper_s_height_and_not_a_twentieth_of_its_variance(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(paper_desc());
    bolan_sea_step(sea, 100.0);
    const bolan_sea_statistics s = bolan_sea_measure(sea);
    assert_near(s.hs, 3.005, 0.02); // 65536 places: a sampling error of 0.3 %
    assert_true(s.m0_field > 0.5);  // the form without the root has 0.0282
    assert_near(s.direction_from, 270.0, 1e-6);
    assert_near(s.spread, bolan_degrees(sqrt(2.0 * (1.0 - 8.0 / (3.0 * BOLAN_PI)))), 0.5); // N = 8 for an integral
    assert_near(s.tp, TURN / 0.72511, 0.05 * TURN / 0.72511); // from 16 frequencies, one per 5 % at the peak
    assert_near(s.skewness, 0.0, 0.05);
    assert_near(s.kurtosis, 3.0, 0.1);
    bolan_sea_destroy(&sea);
}

// The squared envelope of waves in one direction: eta and D are a Hilbert pair.
static double envelope(const bolan_sea *sea, double t) {
    const bolan_sea_sample s = bolan_sea_sample_direct(sea, 3.0, 5.0, t);
    const double l = bolan_sea_get_desc(sea)->choppiness, height = s.height - bolan_sea_lift(sea, 0, 0.0);
    return sqrt(height * height + (s.dx * s.dx + s.dy * s.dy) / (l * l));
}

static double envelope_difference(const bolan_sea *sea, double shift) {
    double sum = 0.0;
    for (int i = 0; i < 60; i++) sum += pow(envelope(sea, 1.7 * i + shift) - envelope(sea, 1.7 * i), 2.0);
    return sqrt(sum / 60.0);
}

static void equal_width_repeats_after_32_seconds_and_equal_energy_does_not(void **state) {
    (void)state;
    bolan_sea_desc d = paper_desc();
    d.cosines.directions = 1;
    d.cosines.split = BOLAN_SPLIT_EQUAL_WIDTH;
    bolan_sea *sea = test_sea(d);
    const double step = bolan_sea_get_component(sea, 1).omega - bolan_sea_get_component(sea, 0).omega;
    assert_near(step, 0.1962, 1e-4);
    assert_near(bolan_sea_get_component(sea, 0).omega, 0.4856 + 0.0981, 2e-4);
    assert_near(bolan_sea_get_component(sea, 15).omega, 3.6246 - 0.0981, 2e-4);
    double variance = 0.0;
    for (uint32_t i = 0; i < 16; i++) variance += 0.5 * pow(bolan_sea_get_component(sea, i).amplitude, 2.0);
    assert_near(variance, 0.996 * paper_m0, 1e-4); // what lies between the two quantiles
    assert_near(TURN / step, 32.0, 0.05);
    assert_true(envelope_difference(sea, TURN / step) < 1e-4);
    assert_true(envelope_difference(sea, 0.5 * TURN / step) > 0.2);
    bolan_sea_destroy(&sea);
    d.cosines.split = BOLAN_SPLIT_EQUAL_ENERGY;
    sea = test_sea(d);
    for (double shift = 15.0; shift < 300.0; shift += 0.5) assert_true(envelope_difference(sea, shift) > 0.1);
    bolan_sea_destroy(&sea);
}

static void the_mean_direction_is_the_sea_state_s(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) {
        bolan_sea_desc d = bolan_sea_desc_default();
        d.sea_state = bolan_sea_state_from_wind(4.0 + 2.0 * i, 47.0 * i, 100e3);
        if (i & 1)
            assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 1.0, 12.0, 47.0 * i + 60.0 - 360.0, 30.0),
                             BOLAN_OK);
        d.waves = i & 2 ? BOLAN_WAVES_EXP_COSINE : BOLAN_WAVES_COSINES;
        d.cosines.split = i & 4 ? BOLAN_SPLIT_EQUAL_WIDTH : BOLAN_SPLIT_EQUAL_ENERGY;
        bolan_sea *sea = test_sea(d);
        const bolan_sea_statistics s = bolan_sea_measure(sea);
        const bolan_sea_summary wanted = bolan_sea_state_summary(&d.sea_state);
        assert_near(remainder(s.direction_from - wanted.from_deg, 360.0), 0.0, 2.0);
        assert_near(s.hs / wanted.hs, 1.0, 0.02); // sampling
        bolan_sea_destroy(&sea);
    }
}

static bolan_sea_desc one_wave(bolan_wave_model model) {
    bolan_sea_desc d = paper_desc();
    d.waves = model;
    d.cosines.frequencies = d.cosines.directions = d.exp_cosine.wave_count = 1;
    return d;
}

static void a_wave_runs_to_where_k_points_at_its_phase_speed(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        bolan_sea *sea = test_sea(one_wave((bolan_wave_model)model));
        const bolan_sea_component c = bolan_sea_get_component(sea, 0);
        assert_true(c.kx > 0.0 && fabs(c.ky) < 1e-9 * c.kx); // from the west
        const double speed = 9.81 / c.omega;                 // deep water; tension adds 1e-7
        double least = 1e30, best = 1e30, back = 1e30;
        for (double x = -1.0; x <= 1.0; x += 0.01) { // metres ahead of where it should be
            double sum = 0.0, other = 0.0;
            for (int i = 0; i < 10; i++) {
                const double at = 13.0 * i;
                bolan_dvec2 place[3] = {{at, 0.0}, {at + speed * 60.0 + x, 0.0}, {at - speed * 60.0 + x, 0.0}};
                bolan_sea_sample s[3];
                bolan_sea_step(sea, 0.0);
                bolan_sea_sample_rest(sea, place, 1, s);
                bolan_sea_step(sea, 60.0);
                bolan_sea_sample_rest(sea, place + 1, 2, s + 1);
                sum += pow((double)(s[1].height - s[0].height), 2.0);
                other += pow((double)(s[2].height - s[0].height), 2.0);
            }
            if (sum < least) {
                least = sum;
                best = x;
            }
            back = fmin(back, other);
        }
        assert_true(least < 1e-8);
        assert_near(best, 0.0, 0.02); // of 60 s at 13 m/s: 3e-5
        assert_true(back > 0.01);     // nothing is found on the other side
        bolan_sea_destroy(&sea);
    }
}

// L / L0 of waves of 10 s that run into a current of -2 and +2 m/s (deep water, Phillips 1977).
static void a_current_shifts_the_period_by_the_table(void **state) {
    (void)state;
    static const double current[2] = {-2.0, 2.0}, length_ratio[2] = {0.72105, 1.24299};
    for (int i = 0; i < 2; i++) {
        bolan_sea_desc d = one_wave(BOLAN_WAVES_COSINES);
        const double k = TURN / (length_ratio[i] * 9.81 * 100.0 / TURN), own = sqrt(9.81 * k);
        d.sea_state.systems[0].peak_omega = own * pow(log(2.0) / 1.25, 0.25); // the median of P-M is then `own`
        d.sea_state.current_x = current[i];
        bolan_sea *sea = test_sea(d);
        const bolan_sea_component c = bolan_sea_get_component(sea, 0);
        assert_near(wave_number(&c), k, 1e-4 * k);
        assert_near(TURN / c.omega, 10.0, 0.005); // five digits in the table, and how the median is found
        bolan_sea_destroy(&sea);
    }
}

static void a_current_carries_the_sea_along(void **state) {
    (void)state;
    bolan_sea_desc d = paper_desc();
    bolan_sea *still = test_sea(d);
    d.sea_state.current_x = 1.5;
    d.sea_state.current_y = -0.7;
    bolan_sea *moving = test_sea(d);
    bolan_sea_step(still, 500.0);
    bolan_sea_step(moving, 500.0);
    for (int i = 0; i < 20; i++) {
        const bolan_dvec2 at = {17.0 * i, -31.0 * i}, was = {at.x - 750.0, at.y + 350.0};
        bolan_sea_sample a, b;
        bolan_sea_sample_rest(moving, &at, 1, &a);
        bolan_sea_sample_rest(still, &was, 1, &b);
        assert_near(a.height, b.height, 2e-5); // 128 phases to 1e-7
    }
    bolan_sea_destroy(&still);
    bolan_sea_destroy(&moving);
}

// ---- points against the sum in double -------------------------------------------------------------------------------

static void points_agree_with_the_sum_in_double(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        bolan_sea_desc d = bolan_sea_desc_default();
        d.waves = (bolan_wave_model)model;
        d.cosines.frequencies = 24;
        bolan_sea *sea = test_sea(d);
        bolan_sea_step(sea, 1234.5);
        for (int i = 0; i < 60; i++) {
            const double far = i < 20 ? 1.0 : i < 40 ? 1e4 : 1e6;
            const bolan_dvec2 at = {far * cos(i), far * sin(i)};
            bolan_sea_sample a;
            bolan_sea_sample_grid(sea, &at, NULL, 1, &a);
            const bolan_sea_sample b = bolan_sea_sample_direct(sea, at.x, at.y, 1234.5);
            // A phase is good to 2^-27 of a turn and the sine to 1e-7: 192 waves of 5 cm, k up to 3 rad/m.
            assert_near(a.height, b.height, 3e-6);
            assert_near(a.dx, b.dx, 3e-6);
            assert_near(a.dy, b.dy, 3e-6);
            assert_near(a.slope_x, b.slope_x, 3e-6);
            assert_near(a.slope_y, b.slope_y, 3e-6);
            assert_near(a.jacobian, b.jacobian, 3e-6);
            assert_true(a.foam >= 0.0f);
        }
        bolan_sea_destroy(&sea);
    }
}

static void waves_fade_from_four_to_two_spacings(void **state) {
    (void)state;
    enum { COUNT = 40 };
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_COSINES;
    bolan_sea *sea = test_sea(d);
    bolan_dvec2 at[COUNT];
    float spacing[COUNT];
    bolan_sea_sample got[COUNT];
    for (int i = 0; i < COUNT; i++) {
        at[i] = (bolan_dvec2){7.3 * i, 100.0 - 3.1 * i};
        spacing[i] = (float)(0.1 * pow(1.25, i)); // 0.1 to 600 m
    }
    spacing[0] = 0.0f;
    bolan_sea_sample_grid(sea, at, spacing, COUNT, got);
    for (int i = 0; i < COUNT; i++) {
        double height = 0.0, dx = 0.0;
        for (uint32_t w = 0; w < bolan_sea_component_count(sea); w++) {
            const bolan_sea_component c = bolan_sea_get_component(sea, w);
            const double t = fmin(fmax(TURN / wave_number(&c) / (2.0 * (double)spacing[i]) - 1.0, 0.0), 1.0);
            const double th = c.kx * at[i].x + c.ky * at[i].y + c.phase, fade = t * t * (3.0 - 2.0 * t);
            height += fade * c.amplitude * cos(th);
            dx -= fade * c.drift * c.kx / wave_number(&c) * sin(th);
        }
        assert_near(got[i].height - bolan_sea_lift(sea, 0, (double)spacing[i]), height, 3e-6);
        assert_near(got[i].dx, dx, 3e-6);
    }
    assert_true(got[COUNT - 1].height == 0.0f && got[COUNT - 1].jacobian == 1.0f);
    bolan_sea_destroy(&sea);
}

static void queries_agree_with_the_map_inverted_in_double(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        for (int far = 0; far < 2; far++) {
            bolan_sea_desc d = bolan_sea_desc_default();
            d.sea_state = bolan_sea_state_from_wind(12.0, 200.0, 200e3);
            d.waves = (bolan_wave_model)model;
            bolan_sea *sea = test_sea(d);
            bolan_sea_step(sea, 7.25);
            for (int i = 0; i < 50; i++) {
                const bolan_dvec2 x = {far * 1e6 + 17.31 * i, far * -1e6 - 5.3 * i};
                double x0 = x.x, y0 = x.y;
                bolan_sea_sample s = bolan_sea_sample_direct(sea, x0, y0, 7.25);
                for (int n = 0; n < 80; n++) { // contracts by 1 - J
                    x0 += x.x - (x0 + (double)s.dx), y0 += x.y - (y0 + (double)s.dy);
                    s = bolan_sea_sample_direct(sea, x0, y0, 7.25);
                }
                bolan_query_point p;
                float height;
                bolan_query_surface(&(bolan_water){.sea = sea}, &x, 1, &p);
                bolan_query_heights(&(bolan_water){.sea = sea}, &x, 1, &height);
                assert_true(p.residual < 1e-3f || p.jacobian <= 0.2f);
                if (s.jacobian < 0.3f) continue;
                assert_near(p.height, s.height, 1e-4); // the residual's tenth of a millimetre, and slope below 1
                assert_near(height, s.height, 1e-4);
                assert_near(-p.normal.x / p.normal.z, s.slope_x, 1e-4);
                assert_near(-p.normal.y / p.normal.z, s.slope_y, 1e-4);
            }
            bolan_sea_destroy(&sea);
        }
    }
}

// ---- slopes and foam ------------------------------------------------------------------------------------------------

static void slopes_are_those_of_the_waves_and_cox_and_munk_s_rest(void **state) {
    (void)state;
    for (int model = BOLAN_WAVES_COSINES; model <= BOLAN_WAVES_EXP_COSINE; model++) {
        bolan_sea_desc d = bolan_sea_desc_default();
        d.waves = (bolan_wave_model)model;
        d.choppiness = 0.0;
        bolan_sea *sea = test_sea(d);
        double mss = 0.0, up, cross;
        const double s = d.exp_cosine.sharpness, a2 = pow(1.0 / sinh(s), 2.0);
        for (uint32_t i = 0; i < bolan_sea_component_count(sea); i++) {
            const bolan_sea_component c = bolan_sea_get_component(sea, i);
            const double share = model == BOLAN_WAVES_COSINES ? 0.5 : a2 * 0.5 * s * exp_cosine_bessel(1, 2.0 * s);
            mss += c.amplitude * c.amplitude * wave_number(&c) * wave_number(&c) * share;
        }
        bolan_cox_munk(d.sea_state.wind_speed, &up, &cross);
        float out[3];
        bolan_sea_unresolved_slopes(sea, 1e6, 1e6, 0.3, out);
        assert_near(out[0] + out[2], up + cross, 1e-6);
        bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.3, out);
        assert_near(out[0] + out[2], up + cross - mss, 1e-6);
        assert_near(bolan_sea_measure(sea).mss, mss, 0.02 * mss); // sampling
        const float *texel = bolan_sea_slope_table(sea) + 4 * 15; // angle 0, round, i = 15
        const double major = exp2(15.0 / 1.5 - 11.0);
        bolan_sea_unresolved_slopes(sea, major, major, 0.0, out);
        assert_near(texel[0], out[0], 1e-9);
        bolan_sea_destroy(&sea);
    }
}

static void whitecaps_cover_what_monahan_says(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(14.0, 10.0, 300e3);
    d.waves = BOLAN_WAVES_COSINES;
    bolan_sea *sea = test_sea(d);
    bolan_sea_step(sea, 33.0);
    const double cover = bolan_sea_measure(sea).whitecap_fraction, wanted = bolan_monahan_cover(14.0);
    assert_true(cover > wanted / 1.5 && cover < wanted * 1.5);
    bolan_sea_destroy(&sea);
    d.waves = BOLAN_WAVES_EXP_COSINE; // nothing is displaced: no Jacobian tells the crests
    sea = test_sea(d);
    assert_true(bolan_sea_foam_threshold(sea) < -1e29);
    bolan_sea_destroy(&sea);
}

// ---- exp(cos) -------------------------------------------------------------------------------------------------------

static void exp_cos_has_the_paper_s_numbers(void **state) {
    (void)state;
    assert_near(exp_cosine_mean(1.0), 1.2660659, 1e-5);
    assert_near(exp_cosine_variance(1.0), 0.6766625, 1e-5);
    assert_near(sqrt(exp_cosine_variance(1.0)), 0.82259, 1e-5);
    assert_near(exp_cosine_steepest(1.0), 1.4585285, 1e-5);
    assert_near(exp_cosine_slope_variance(1.0), 0.7953184, 1e-5);
    assert_near(exp_cosine_skewness(1.0), 0.505, 5e-4);
    assert_near(2.0 / exp_cosine_scale(1.0), 2.3504024, 1e-5); // the range
    static const double harmonic[4] = {1.13032, 0.27150, 0.04434, 0.00547};
    for (int n = 0; n < 4; n++) assert_near(2.0 * exp_cosine_bessel(n + 1, 1.0), harmonic[n], 1e-5);
    assert_near(exp_cosine_stokes_steepness(1.0), 0.480, 5e-4);
    assert_near(exp_cosine_stokes_steepness(0.5), 0.247, 5e-4);
    assert_near(exp_cosine_stokes_steepness(0.25), 0.125, 5e-4);
}

// One wave of s = 1, as the sea makes it, over one length.
static void one_exp_wave_has_the_paper_s_crest_trough_and_steepest_slope(void **state) {
    (void)state;
    enum { COUNT = 20000 };
    bolan_sea_desc d = one_wave(BOLAN_WAVES_EXP_COSINE);
    d.exp_cosine.sharpness = 1.0;
    bolan_sea *sea = test_sea(d);
    const bolan_sea_component c = bolan_sea_get_component(sea, 0);
    double top = 0.0, low = 0.0, steep = 0.0, mean = 0.0, above = 0.0, variance = 0.0, slope = 0.0;
    for (int i = 0; i < COUNT; i++) {
        const bolan_dvec2 at = {i * TURN / c.kx / COUNT, 40.0};
        bolan_sea_sample s;
        bolan_sea_sample_rest(sea, &at, 1, &s);
        const double unit = c.amplitude * exp_cosine_scale(1.0), h = s.height / unit, g = s.slope_x / unit / c.kx;
        top = fmax(top, h), low = fmin(low, h), steep = fmax(steep, fabs(g));
        mean += h / COUNT, variance += h * h / COUNT, slope += g * g / COUNT, above += (h > 0.0) / (double)COUNT;
        assert_true(s.dx == 0.0f && s.dy == 0.0f && s.jacobian == 1.0f && s.foam == 0.0f);
    }
    assert_near(top, 1.4522, 5e-5); // four digits are printed
    assert_near(low, -0.8982, 5e-5);
    assert_near(steep, 1.4585285, 1e-5);
    assert_near(mean, 0.0, 1e-5);
    assert_near(variance, 0.6766625, 1e-5);
    assert_near(slope, 0.7953184, 1e-5);
    assert_near(above, 0.424, 1e-3);
    double vertical, horizontal;
    bolan_sea_bounds(sea, &vertical, &horizontal);
    assert_near(vertical, 1.4522 * c.amplitude * exp_cosine_scale(1.0), 1e-4);
    assert_true(horizontal == 0.0);
    assert_near(0.5 * (top - low) * exp_cosine_scale(1.0), 1.0, 1e-5); // the range is 2 amplitude
    bolan_sea_destroy(&sea);
}

static void a_blunt_exp_wave_is_a_cosine(void **state) {
    (void)state;
    bolan_sea_desc d = one_wave(BOLAN_WAVES_EXP_COSINE);
    d.exp_cosine.sharpness = 0.01;
    bolan_sea *blunt = test_sea(d);
    const bolan_sea_component c = bolan_sea_get_component(blunt, 0);
    assert_near(c.amplitude, sqrt(2.0 * paper_m0), 1e-4);
    for (int i = 0; i < 50; i++) {
        const bolan_dvec2 at = {5.0 * i, 0.0};
        bolan_sea_sample s;
        bolan_sea_sample_rest(blunt, &at, 1, &s);
        // The second harmonic is s / 4 of the first.
        assert_near(s.height, c.amplitude * cos(c.kx * at.x + c.phase), 0.0026 * c.amplitude);
    }
    bolan_sea_destroy(&blunt);
}

static void eight_exp_waves_are_skewed_and_not_too_steep(void **state) {
    (void)state;
    bolan_sea_desc d = paper_desc();
    d.waves = BOLAN_WAVES_EXP_COSINE;
    bolan_sea *sea = test_sea(d);
    assert_int_equal(bolan_sea_component_count(sea), 8);
    const bolan_sea_statistics s = bolan_sea_measure(sea);
    assert_near(s.m0_field, paper_m0, 0.02 * paper_m0);
    assert_near(s.jacobian_min, 1.0, 0.0);
    // Independent waves of one variance: each wave's skewness over sqrt(8).
    assert_near(s.skewness, exp_cosine_skewness(0.5) / sqrt(8.0), 0.02);
    assert_true(s.mss < 0.02); // P-M up to 2.5 peak frequencies
    bolan_sea_destroy(&sea);
}

// ---- loop -----------------------------------------------------------------------------------------------------------

static void a_sum_with_a_loop_repeats(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_COSINES;
    d.loop_period = 60.0;
    bolan_sea *sea = test_sea(d);
    for (int i = 0; i < 10; i++) {
        const bolan_sea_sample a = bolan_sea_sample_direct(sea, 3.0 * i, 7.0, 11.0);
        const bolan_sea_sample b = bolan_sea_sample_direct(sea, 3.0 * i, 7.0, 71.0);
        assert_near(a.height, b.height, 1e-6);
    }
    bolan_sea_destroy(&sea);
}

RUN_TESTS(cmocka_unit_test(equal_energy_has_the_sixteen_frequencies_and_one_amplitude),
          cmocka_unit_test(eight_directions_share_as_cos2_does),
          cmocka_unit_test(the_field_has_the_paper_s_height_and_not_a_twentieth_of_its_variance),
          cmocka_unit_test(equal_width_repeats_after_32_seconds_and_equal_energy_does_not),
          cmocka_unit_test(the_mean_direction_is_the_sea_state_s),
          cmocka_unit_test(a_wave_runs_to_where_k_points_at_its_phase_speed),
          cmocka_unit_test(a_current_shifts_the_period_by_the_table), cmocka_unit_test(a_current_carries_the_sea_along),
          cmocka_unit_test(points_agree_with_the_sum_in_double), cmocka_unit_test(waves_fade_from_four_to_two_spacings),
          cmocka_unit_test(queries_agree_with_the_map_inverted_in_double),
          cmocka_unit_test(slopes_are_those_of_the_waves_and_cox_and_munk_s_rest),
          cmocka_unit_test(whitecaps_cover_what_monahan_says), cmocka_unit_test(exp_cos_has_the_paper_s_numbers),
          cmocka_unit_test(one_exp_wave_has_the_paper_s_crest_trough_and_steepest_slope),
          cmocka_unit_test(a_blunt_exp_wave_is_a_cosine),
          cmocka_unit_test(eight_exp_waves_are_skewed_and_not_too_steep), cmocka_unit_test(a_sum_with_a_loop_repeats))
