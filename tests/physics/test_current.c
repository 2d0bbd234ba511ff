// SPDX-License-Identifier: MIT
// Waves on a uniform current: Doppler, the conservation of action, blocking, and a sea that moves with the water.
#include "bolan/formats.h"
#include "bolan/query.h"
#include "sea_support.h"

#include <string.h>

#define TURN (2.0 * BOLAN_PI)

// A narrow, long-crested swell of 10 s toward east on a current along it.
static bolan_sea_state swell_on(double current, bolan_spectrum_frame frame) {
    bolan_wave_system swell = bolan_wave_system_default();
    swell.kind = BOLAN_SPECTRUM_OCHI_HUBBLE;
    swell.lambda = 10.0;
    swell.hs = 1.0;
    swell.peak_omega = TURN / 10.0;
    swell.from_deg = 270.0;
    swell.spreading = BOLAN_SPREADING_COS2S;
    swell.spread_s = 200.0;
    bolan_sea_state state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_system(&state, &swell), BOLAN_OK);
    state.current_x = current;
    state.frame = frame;
    return state;
}

// ---- one wave -------------------------------------------------------------------------------------------------------

// Deep water, waves of 10 s in still water that run into a current (Phillips 1977): L / L0 and H / H0. The height is
// that of the energy in a band that keeps its width over the ground.
static void a_wave_that_runs_into_a_current_follows_the_table(void **state) {
    (void)state;
    static const double table[2][3] = {{-2.0, 0.72105, 1.40929}, {2.0, 1.24299, 0.80882}};
    const double omega = TURN / 10.0, k0 = omega * omega / 9.81;
    const bolan_sea_state still = swell_on(0.0, BOLAN_FRAME_STILL);
    for (int i = 0; i < 2; i++) {
        const bolan_sea_state sea = swell_on(table[i][0], BOLAN_FRAME_STILL);
        const double k = k0 / table[i][1], sigma = sqrt(9.81 * k), group = 0.5 * sigma / k;
        assert_near(sigma + k * table[i][0], omega, 1e-5 * omega); // the table's length is that of its frequency
        const double energy = bolan_sea_state_density(&sea, sigma, 0.0) * group / (group + table[i][0]);
        assert_near(sqrt(energy / bolan_sea_state_density(&still, omega, 0.0)), table[i][2], 2e-4 * table[i][2]);
        // All of the narrow sea has nearly that height.
        assert_near(bolan_sea_state_summary(&sea).hs, table[i][2], 0.04 * table[i][2]);
    }
}

// Huang, Chen, Tung & Smith (1972), eq. 2.17: the spectrum over the frequency on the ground, deep water.
static void the_spectrum_on_a_current_is_that_of_huang(void **state) {
    (void)state;
    for (double current = -2.0; current <= 4.0; current += 1.5) {
        bolan_sea_state still = bolan_sea_state_from_wind(12.0, 270.0, 300e3);
        const bolan_sea_state none = still;
        still.current_x = current;
        still.frame = BOLAN_FRAME_STILL;
        for (double omega = 0.4; omega < 3.0; omega *= 1.2) {
            const double root2 = 1.0 + 4.0 * current * omega / 9.81;
            if (!(root2 > 0.02)) continue; // blocked
            const double root = sqrt(root2), sigma = omega * 2.0 / (1.0 + root), k = sigma * sigma / 9.81;
            const double expected = 4.0 * bolan_sea_state_density(&none, omega, 0.0) / ((1.0 + root) * (root + root2)),
                         group = 0.5 * sigma / k;
            const double got = bolan_sea_state_density(&still, sigma, 0.0) * group / (group + current);
            assert_near(got, expected, 2e-3 * expected / root2); // surface tension adds 1e-5, near blocking more
        }
    }
}

// A current of -c0/4 stops a wave: its energy is there at 0.249 and not at 0.251 of c0.
static void a_current_of_a_quarter_of_the_phase_speed_blocks(void **state) {
    (void)state;
    const double omega = TURN / 10.0, c0 = 9.81 / omega;
    assert_near(c0 / 4.0, 3.903, 1e-3);
    for (int frame = BOLAN_FRAME_GROUND; frame <= BOLAN_FRAME_STILL; frame++) {
        for (int i = 0; i < 2; i++) {
            const double share = i == 0 ? 0.249 : 0.251;
            const bolan_sea_state sea = swell_on(-share * c0, (bolan_spectrum_frame)frame);
            double most = 0.0; // over all wave numbers whose frequency on the ground is about omega
            for (double k = 0.01; k < 1.0; k *= 1.001) {
                const double on_ground = bolan_omega_from_k(k, BOLAN_DEEP) - share * c0 * k;
                if (fabs(on_ground - omega) < 2e-4 * omega)
                    most = fmax(most, bolan_sea_state_wavenumber_density(&sea, k, 0.0));
            }
            assert_true(i == 0 ? most > 0.1 : most == 0.0);
        }
    }
    // Nothing that is left goes where the current does not let it, and no density is negative or not finite.
    for (int frame = 0; frame < BOLAN_SPECTRUM_FRAMES; frame++) {
        bolan_sea_state sea = bolan_sea_state_from_wind(15.0, 250.0, 300e3);
        sea.current_x = -3.0;
        sea.current_y = 1.0;
        sea.frame = (bolan_spectrum_frame)frame;
        for (double th = -3.0; th < 3.2; th += 0.2) {
            bool blocked = false; // and all that is shorter, though ripples of a millimetre outrun the current
            for (double k = 1e-3; k < 1e5; k *= 1.3) {
                const double density = bolan_sea_state_wavenumber_density(&sea, k * cos(th), k * sin(th));
                blocked |= bolan_group_speed(k, BOLAN_DEEP) - 3.0 * cos(th) + sin(th) <= 0.0;
                assert_true(density >= 0.0 && isfinite(density));
                if (frame != BOLAN_FRAME_WATER && blocked) assert_true(density == 0.0);
            }
        }
        // A current against the waves raises them, but not without bound.
        assert_true(bolan_sea_state_summary(&sea).hs < 2.0 * sea.systems[0].hs);
    }
}

// ---- whole spectra --------------------------------------------------------------------------------------------------

static void the_frames_are_one_without_a_current(void **state) {
    (void)state;
    bolan_sea_state water = bolan_sea_state_from_wind(12.0, 250.0, 80e3);
    water.depth = 15.0;
    water.systems[0].kind = BOLAN_SPECTRUM_TMA;
    for (int frame = 1; frame < BOLAN_SPECTRUM_FRAMES; frame++) {
        bolan_sea_state other = water;
        other.frame = (bolan_spectrum_frame)frame;
        assert_true(bolan_sea_state_wavenumber_density(&other, 0.1, 0.05) ==
                    bolan_sea_state_wavenumber_density(&water, 0.1, 0.05));
        const bolan_sea_summary a = bolan_sea_state_summary(&other), b = bolan_sea_state_summary(&water);
        assert_memory_equal(&a, &b, sizeof a);
        // A current of next to nothing takes the other path to the same figures.
        other.current_x = 1e-9;
        const bolan_sea_summary c = bolan_sea_state_summary(&other);
        assert_near(c.hs, b.hs, 1e-3 * b.hs);
        assert_near(c.tp, b.tp, 0.01 * b.tp);
        assert_near(c.tm02, b.tm02, 5e-3 * b.tm02);
        assert_near(c.te, b.te, 1e-3 * b.te);
        assert_near(c.from_deg, b.from_deg, 0.1);
        assert_near(c.spread_deg, b.spread_deg, 0.1);
        assert_near(bolan_sea_state_wavenumber_density(&other, 0.1, 0.05),
                    bolan_sea_state_wavenumber_density(&water, 0.1, 0.05), 1e-4);
    }
    bolan_sea_state moving = water; // and the water does not know that it moves
    moving.current_x = 3.0;
    assert_true(bolan_sea_state_wavenumber_density(&moving, 0.1, 0.05) ==
                bolan_sea_state_wavenumber_density(&water, 0.1, 0.05));
}

// In depth, to wave vectors, over all directions: the variance that one on the ground sees stays, the flux of action
// through a line across the current too. Sums of the test's own over k and direction.
static void what_is_conserved_stays(void **state) {
    (void)state;
    bolan_sea_state none = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&none, 2.0, 11.0, 300.0, 12.0), BOLAN_OK);
    none.depth = 25.0;
    bolan_sea_state ground = none, still = none;
    ground.current_x = still.current_x = 0.8;
    ground.current_y = still.current_y = -0.6;
    ground.frame = BOLAN_FRAME_GROUND;
    still.frame = BOLAN_FRAME_STILL;
    double variance = 0.0, flux = 0.0, flux0 = 0.0;
    for (double u = log(5e-3); u < log(2.0); u += 0.01) {
        for (int d = 0; d < 144; d++) {
            const double k = exp(u + 0.005), th = TURN * d / 144, x = k * cos(th), y = k * sin(th);
            const double cell = k * k * 0.01 * TURN / 144, group = bolan_group_speed(k, 25.0);
            const double sigma = bolan_omega_from_k(k, 25.0), along = 0.8 * cos(th) - 0.6 * sin(th);
            variance += bolan_sea_state_wavenumber_density(&ground, x, y) * cell;
            flux += bolan_sea_state_wavenumber_density(&still, x, y) * cell * (group + along) / sigma;
            flux0 += bolan_sea_state_wavenumber_density(&none, x, y) * cell * group / sigma;
        }
    }
    assert_near(variance, 0.25, 1e-3 * 0.25);
    assert_near(flux, flux0, 1e-3 * flux0);
    assert_near(bolan_sea_state_summary(&ground).m0, 0.25, 1e-3 * 0.25);
    // Psi = S (d sigma/dk) / k holds on the current.
    const double sigma = bolan_omega_from_k(0.06, 25.0);
    assert_near(bolan_sea_state_wavenumber_density(&still, 0.06 * cos(-0.4), 0.06 * sin(-0.4)),
                bolan_sea_state_density(&still, sigma, -0.4) * bolan_group_speed(0.06, 25.0) / 0.06, 1e-9);
}

// TMA's factor is that of the depth and the frequency that is seen, in both forms of the density.
static void the_depth_factor_goes_with_the_frequency_that_is_seen(void **state) {
    (void)state;
    for (int frame = BOLAN_FRAME_GROUND; frame <= BOLAN_FRAME_STILL; frame++) {
        bolan_sea_state sea = bolan_sea_state_from_wind(15.0, 270.0, 100e3), jonswap;
        sea.depth = 8.0;
        sea.current_x = -1.0;
        sea.frame = (bolan_spectrum_frame)frame;
        jonswap = sea;
        sea.systems[0].kind = BOLAN_SPECTRUM_TMA;
        for (double k = 0.05; k < 1.0; k *= 1.4) {
            const double sigma = bolan_omega_from_k(k, 8.0), omega = sigma - k, group = bolan_group_speed(k, 8.0);
            if (!(group > 1.1)) continue;
            const double kh = 8.0 * bolan_k_from_omega(omega, 8.0), t = tanh(kh);
            const double factor = t * t / (1.0 + 2.0 * kh / sinh(2.0 * kh)); // Kitaigorodskii
            const double psi = bolan_sea_state_wavenumber_density(&sea, k, 0.0);
            assert_near(psi, factor * bolan_sea_state_wavenumber_density(&jonswap, k, 0.0), 1e-6 * psi);
            assert_near(psi, bolan_sea_state_density(&sea, sigma, 0.0) * group / k, 1e-9 * psi);
        }
    }
}

static void every_spectrum_and_current_makes_a_finite_sea(void **state) {
    (void)state;
    for (int kind = 0; kind < BOLAN_SPECTRUM_KINDS; kind++) {
        bolan_wave_system system = bolan_wave_system_default();
        system.kind = (bolan_spectrum_kind)kind;
        system.hs = 3.0;
        system.wind_speed = 10.0;
        bolan_sea_state sea = bolan_sea_state_default();
        assert_int_equal(bolan_sea_state_add_system(&sea, &system), BOLAN_OK);
        sea.frame = BOLAN_FRAME_STILL;
        sea.depth = kind % 2 ? 10.0 : BOLAN_DEEP;
        for (double current = -5.0; current <= 5.0; current += 10.0) {
            sea.current_x = current;
            const bolan_sea_summary s = bolan_sea_state_summary(&sea);
            const bolan_sea_limit limit = bolan_sea_state_limit(&sea);
            assert_true(isfinite(s.hs) && isfinite(s.tp) && s.hs >= 0.0 && s.hs < 8.0);
            assert_true(limit.by_depth > 0.0 && limit.by_depth <= 1.0 && limit.by_steepness > 0.0);
        }
    }
}

// A buoy's narrow peak in still water, of three frequencies: all of it follows the table within 1 %.
static void a_measured_peak_follows_the_table(void **state) {
    (void)state;
    static const char text[] =
        "SWAN 1\nLOCATIONS\n1 n\n0 0\nAFREQ\n3 n\n.0985\n.1\n.1015\nCDIR\n36 n\n0\n10\n20\n30\n40\n"
        "50\n60\n70\n80\n90\n100\n110\n120\n130\n140\n150\n160\n170\n180\n190\n200\n210\n220\n230\n"
        "240\n250\n260\n270\n280\n290\n300\n310\n320\n330\n340\n350\nQUANT\n1\nVaDens\n"
        "m2/Hz/degr\n-99\nFACTOR\n1\n"
        "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
        "9 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
        "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = (bolan_spectrum_text){"peak.spec", text, sizeof text - 1};
    bolan_measured_spectrum *peak = NULL;
    assert_int_equal(bolan_measured_spectrum_parse(&texts, NULL, &peak), BOLAN_OK);
    bolan_sea_state sea = bolan_sea_state_default();
    sea.measured = peak;
    const bolan_sea_summary still = bolan_sea_state_summary(&sea);
    static const double table[2][3] = {{-2.0, 0.72105, 1.40929}, {2.0, 1.24299, 0.80882}};
    for (int i = 0; i < 2; i++) {
        sea.current_x = table[i][0];
        sea.frame = BOLAN_FRAME_STILL;
        const bolan_sea_summary s = bolan_sea_state_summary(&sea);
        assert_near(s.hs, table[i][2] * still.hs, 0.01 * s.hs);
        assert_near(s.tp * s.tp, table[i][1] * still.tp * still.tp, 0.01 * s.tp * s.tp); // L = g T^2 / (2 pi)
        assert_near(s.from_deg, 270.0, 0.1);
    }
    sea.current_x = -4.0; // more than -3.903
    assert_true(bolan_sea_state_summary(&sea).hs < 0.02 * still.hs);
    bolan_measured_spectrum_destroy(&peak);
}

// ---- seas -----------------------------------------------------------------------------------------------------------

static bolan_sea_desc desc_on(bolan_wave_model waves, double x, double y) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.waves = waves;
    desc.resolution = 64;
    desc.sea_state.current_x = x;
    desc.sea_state.current_y = y;
    return desc;
}

// Water that moves as a whole: what is asked at x is what still water answers at x - U t, foam and normals too.
static void a_sea_drifts_with_the_water(void **state) {
    (void)state;
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        bolan_sea *still = test_sea(desc_on((bolan_wave_model)model, 0.0, 0.0));
        bolan_sea *moving = test_sea(desc_on((bolan_wave_model)model, 1.5, -0.7));
        bolan_sea_settle(still, 500.0);
        bolan_sea_settle(moving, 500.0);
        bolan_water a = bolan_water_default(), b = bolan_water_default();
        a.sea = still;
        b.sea = moving;
        for (int i = 0; i < 20; i++) {
            const bolan_dvec2 at = {17.0 * i, -31.0 * i}, was = {at.x - 750.0, at.y + 350.0};
            bolan_query_point p, q;
            bolan_query_surface(&a, &was, 1, &p);
            bolan_query_surface(&b, &at, 1, &q);
            assert_near(q.height, p.height, 5e-4); // positions in floats, slopes up to 1
            assert_near(q.normal.x, p.normal.x, 2e-3);
            assert_near(q.normal.y, p.normal.y, 2e-3);
            bolan_sea_sample s, t, u;
            bolan_sea_sample_rest(still, &was, 1, &s);
            bolan_sea_sample_rest(moving, &at, 1, &t);
            bolan_sea_sample_grid(moving, &at, NULL, 1, &u);
            assert_near(t.height, s.height, 2e-5);
            assert_near(t.foam, s.foam, 2e-5);
            assert_near(u.height, s.height, 1e-2); // a low-pass of its own
            const bolan_sea_sample d = bolan_sea_sample_direct(still, was.x, was.y, 500.0),
                                   e = bolan_sea_sample_direct(moving, at.x, at.y, 500.0);
            assert_near(e.height, d.height, 1e-5);
            assert_near(e.slope_x, d.slope_x, 1e-5);
        }
        bolan_sea_destroy(&still);
        bolan_sea_destroy(&moving);
    }
}

static void the_places_of_tiles_are_told(void **state) {
    (void)state;
    bolan_sea *sea = test_sea(desc_on(BOLAN_WAVES_FFT, 1.5, -0.7));
    assert_true(bolan_sea_cascade(sea, 1).origin_x == 0.0);
    bolan_sea_step(sea, -20.0);
    const bolan_cascade_view v = bolan_sea_cascade(sea, 1);
    assert_near(v.origin_x, -30.0, 1e-12);
    assert_near(v.origin_y, 14.0, 1e-12);
    char at_rest[17], moved[17];
    bolan_sea_hash(sea, moved);
    bolan_sea *still = test_sea(desc_on(BOLAN_WAVES_FFT, 0.0, 0.0));
    bolan_sea_step(still, -20.0);
    bolan_sea_hash(still, at_rest);
    assert_string_not_equal(moved, at_rest);
    bolan_sea_step(sea, 1e9); // 50 years later it still has a place
    assert_near(bolan_sea_cascade(sea, 1).origin_x, 1.5e9, 1.0);
    bolan_sea_destroy(&sea);
    bolan_sea_destroy(&still);
}

// The waves that are synthesised are those of the spectrum on the current: height, wave length, direction.
static void the_sea_has_the_spectrum_of_its_current(void **state) {
    (void)state;
    static const double table[2][3] = {{-2.0, 0.72105, 1.40929}, {2.0, 1.24299, 0.80882}};
    for (int i = 0; i < 2; i++) {
        for (int model = 0; model < 2; model++) {
            bolan_sea_desc desc = desc_on(model ? BOLAN_WAVES_COSINES : BOLAN_WAVES_FFT, 0.0, 0.0);
            desc.sea_state = swell_on(table[i][0], BOLAN_FRAME_STILL);
            desc.cosines.frequencies = 32;
            desc.resolution = 128;
            bolan_sea *sea = test_sea(desc);
            const bolan_sea_summary *s = bolan_sea_get_summary(sea);
            double variance = 0.0;
            for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) variance += bolan_sea_cascade(sea, c).variance;
            for (uint32_t c = 0; c < bolan_sea_component_count(sea); c++)
                variance += 0.5 * pow(bolan_sea_get_component(sea, c).amplitude, 2.0);
            assert_near(4.0 * sqrt(variance), s->hs, 0.01 * s->hs);
            // The wave length changes; the period at a fixed place does not: that of the same spectrum in still water.
            const bolan_sea_statistics measured = bolan_sea_measure(sea);
            assert_near(measured.tp, 10.0 * sqrt(table[i][1]), 0.06 * 10.0); // bins of 5 %
            const double tm02 = 10.0 / sqrt(sqrt(10.25) * tgamma(9.5) / tgamma(10.0));
            const double te = 10.0 * tgamma(10.25) / tgamma(10.0) / pow(10.25, 0.25);
            assert_near(measured.tm02, tm02, 0.012 * tm02); // the current weights the waves otherwise
            assert_near(measured.te, te, 0.012 * te);
            assert_near(measured.direction_from, 270.0, 2.0);
            for (uint32_t c = 0; c < bolan_sea_component_count(sea); c++) { // omega = sigma + k.U
                const bolan_sea_component w = bolan_sea_get_component(sea, c);
                const double sigma = bolan_omega_from_k(hypot(w.kx, w.ky), BOLAN_DEEP);
                assert_near(w.omega, sigma + w.kx * table[i][0], 1e-9);
                assert_true(w.omega > 0.0);
            }
            bolan_sea_destroy(&sea);
        }
    }
}

static void tiles_cannot_drift_and_loop(void **state) {
    (void)state;
    bolan_sea *sea = NULL;
    bolan_sea_desc desc = desc_on(BOLAN_WAVES_FFT, 0.0, 1.0);
    desc.loop_period = 60.0;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_ERROR_ARGUMENT);
    assert_null(sea);
    desc.waves = BOLAN_WAVES_COSINES;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    const bolan_dvec2 at = {12.0, 34.0};
    bolan_sea_sample a, b;
    bolan_sea_step(sea, 7.0);
    bolan_sea_sample_rest(sea, &at, 1, &a);
    bolan_sea_step(sea, 67.0);
    bolan_sea_sample_rest(sea, &at, 1, &b);
    assert_near(a.height, b.height, 1e-5);
    bolan_sea_destroy(&sea);
}

static int blocked_warnings;

static void count_blocked(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    blocked_warnings += level == BOLAN_LOG_WARNING && id == BOLAN_LOG_SEA_BLOCKED && strstr(sentence, "5 m/s") != NULL;
}

static void a_sea_that_is_blocked_is_said_to_be(void **state) {
    (void)state;
    bolan_hooks hooks = {.log = count_blocked};
    bolan_set_hooks(&hooks);
    for (int frame = 0; frame < BOLAN_SPECTRUM_FRAMES; frame++) {
        for (int against = -1; against <= 1; against += 2) {
            bolan_sea_desc desc = desc_on(BOLAN_WAVES_COSINES, 0.0, 0.0);
            desc.sea_state = swell_on(5.0 * against, (bolan_spectrum_frame)frame);
            blocked_warnings = 0;
            bolan_sea *sea = test_sea(desc);
            const bool calm = frame != BOLAN_FRAME_WATER && against < 0;
            assert_int_equal(blocked_warnings, calm);
            assert_true((bolan_sea_get_summary(sea)->hs < 0.1) == calm);
            bolan_sea_destroy(&sea);
        }
    }
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_that_runs_into_a_current_follows_the_table),
        cmocka_unit_test(the_spectrum_on_a_current_is_that_of_huang),
        cmocka_unit_test(a_current_of_a_quarter_of_the_phase_speed_blocks),
        cmocka_unit_test(the_frames_are_one_without_a_current),
        cmocka_unit_test(what_is_conserved_stays),
        cmocka_unit_test(the_depth_factor_goes_with_the_frequency_that_is_seen),
        cmocka_unit_test(every_spectrum_and_current_makes_a_finite_sea),
        cmocka_unit_test(a_measured_peak_follows_the_table),
        cmocka_unit_test(a_sea_drifts_with_the_water),
        cmocka_unit_test(the_places_of_tiles_are_told),
        cmocka_unit_test(the_sea_has_the_spectrum_of_its_current),
        cmocka_unit_test(tiles_cannot_drift_and_loop),
        cmocka_unit_test(a_sea_that_is_blocked_is_said_to_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
