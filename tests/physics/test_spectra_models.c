// SPDX-License-Identifier: MIT
// The wind seas of Donelan and Elfouhaily, and the two-peak families of Ochi & Hubble and Torsethaugen & Haver, against
// the formulas and figures of their papers and against quadratures of their own (g = 9.81).
#include "spectrum/spectrum_eval.h"
#include "spectrum_support.h"

#define TURN (2.0 * BOLAN_PI)

static bolan_wave_system system_of(bolan_spectrum_kind kind, double hs, double peak_omega) {
    bolan_wave_system system = bolan_wave_system_default();
    system.kind = kind;
    system.hs = hs;
    system.peak_omega = peak_omega;
    return system;
}

static bolan_sea_state sea_with(bolan_wave_system system) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_system(&sea_state, &system), BOLAN_OK);
    return sea_state;
}

// m0 of a system by the midpoint rule over ln w.
static double variance_of(const bolan_wave_system *system) {
    double sum = 0.0;
    for (double u = -1.5; u < 8.0; u += 0.004) {
        const double w = system->peak_omega * exp(u + 0.002);
        sum += bolan_system_density(system, w, BOLAN_DEEP) * w * 0.004;
    }
    return sum;
}

static void every_kind_has_the_height_that_is_asked_for(void **state) {
    (void)state;
    for (int kind = 0; kind < BOLAN_SPECTRUM_KINDS; kind++) {
        if (kind == BOLAN_SPECTRUM_TMA) continue; // deep water: JONSWAP
        for (double peak = 0.3; peak < 3.0; peak *= 2.1) {
            for (double shape = 0.6; shape <= 4.8; shape *= 2.0) {
                bolan_wave_system system = system_of((bolan_spectrum_kind)kind, 2.0, peak);
                system.gamma = 1.0 + shape;
                system.lambda = shape;
                system.wind_speed = shape * 9.81 / peak; // U/cp
                if (system.wind_speed > 70.0) continue;
                assert_ratio(variance_of(&system), 0.25, 2e-4);
                bolan_wave_system twice = system;
                twice.hs = 4.0;
                assert_ratio(bolan_system_density(&twice, 1.7 * peak, BOLAN_DEEP),
                             4.0 * bolan_system_density(&system, 1.7 * peak, BOLAN_DEEP), 1e-12);
            }
        }
    }
}

static void every_kind_peaks_at_its_peak(void **state) {
    (void)state;
    for (int kind = 0; kind < BOLAN_SPECTRUM_KINDS; kind++) {
        bolan_wave_system system = system_of((bolan_spectrum_kind)kind, 2.0, 0.8);
        system.wind_speed = 14.0;
        system.lambda = 2.2;
        const double at = bolan_system_density(&system, 0.8, BOLAN_DEEP);
        const double reach =
            kind == BOLAN_SPECTRUM_ELFOUHAILY ? 0.08 : 0.01; // of Elfouhaily's, kp is not quite the top
        for (double r = 0.3; r < 4.0; r += 0.01)
            if (fabs(r - 1.0) > reach) assert_true(bolan_system_density(&system, r * 0.8, BOLAN_DEEP) < at);
        assert_true(bolan_system_density(&system, 0.0, BOLAN_DEEP) == 0.0);
        assert_true(bolan_system_density(&system, -1.0, BOLAN_DEEP) == 0.0);
        assert_true(bolan_system_density(&system, 1e-9, BOLAN_DEEP) == 0.0);
    }
}

// ---- Donelan, Hamilton & Hui (1985) ---------------------------------------------------------------------------------

static double donelan(double wind, double age, double w) {
    const double g = 9.81, wp = age * g / wind, alpha = 0.006 * pow(age, 0.55);
    const double gamma = age < 1.0 ? 1.7 : 1.7 + 6.0 * log10(age), width = 0.08 * (1.0 + 4.0 / pow(age, 3.0));
    const double r = exp(-pow(w / wp - 1.0, 2.0) / (2.0 * width * width));
    return alpha * g * g * pow(w, -4.0) / wp * exp(-pow(wp / w, 4.0)) * pow(gamma, r);
}

static void donelan_has_the_density_and_height_of_its_paper(void **state) {
    (void)state;
    static const double table[][2] = {{1.0, 2.0964}, {0.83, 2.9722}, {2.0, 0.6861}}; // U10 = 10 m/s
    for (int i = 0; i < 3; i++) {
        const double age = table[i][0], fetch = 100.0 / 9.81 * pow(11.6 / age, 1.0 / 0.23);
        const bolan_sea_state sea_state = bolan_sea_state_from_donelan(10.0, 225.0, fetch);
        assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
        const bolan_wave_system *s = &sea_state.systems[0];
        assert_int_equal(s->kind, BOLAN_SPECTRUM_DONELAN);
        assert_int_equal(s->spreading, BOLAN_SPREADING_DONELAN_BANNER);
        assert_ratio(s->peak_omega, age * 0.981, 1e-9);
        assert_ratio(s->hs, table[i][1], 1e-4);
        for (double w = 0.5 * s->peak_omega; w < 12.0; w *= 1.2)
            assert_ratio(bolan_system_density(s, w, BOLAN_DEEP), donelan(10.0, age, w), 1e-6);
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        assert_ratio(summary.hs, table[i][1], 1e-4);
        assert_near(summary.from_deg, 225.0, 1e-6);
    }
    // From the fully developed age on nothing grows, and the shortest fetches keep the shape of U/cp = 5.
    assert_ratio(bolan_sea_state_from_donelan(10.0, 0.0, HUGE_VAL).systems[0].peak_omega, 0.83 * 0.981, 1e-12);
    bolan_wave_system young = system_of(BOLAN_SPECTRUM_DONELAN, 1.0, 2.0), oldest = young;
    young.wind_speed = 5.0 * 9.81 / 2.0;
    oldest.wind_speed = 9.0 * 9.81 / 2.0;
    assert_ratio(bolan_system_density(&oldest, 2.1, BOLAN_DEEP), bolan_system_density(&young, 2.1, BOLAN_DEEP), 1e-12);
}

// ---- Elfouhaily et al. (1997) ---------------------------------------------------------------------------------------

// B(k) of the paper, eq. 30 to 44, with km, cm and c of it, and the cut on the short waves.
static double elfouhaily_curvature(double wind, double age, double k, double *delta) {
    const double g = 9.81, km = 370.0, cm = 0.23, kp = g * pow(age / wind, 2.0);
    const double c = sqrt(g / k * (1.0 + pow(k / km, 2.0))), cp = sqrt(g / kp * (1.0 + pow(kp / km, 2.0)));
    const double z0 = 3.7e-5 * wind * wind / g * pow(age, 0.9), friction = 0.41 * wind / log(10.0 / z0);
    const double gamma = age < 1.0 ? 1.7 : 1.7 + 6.0 * log10(age), width = 0.08 * (1.0 + 4.0 / pow(age, 3.0));
    const double cut = exp(-1.25 * pow(kp / k, 2.0));
    const double peak = pow(gamma, exp(-pow(sqrt(k / kp) - 1.0, 2.0) / (2.0 * width * width)));
    const double long_waves =
        0.5 * 0.006 * sqrt(age) * cp / c * cut * peak * exp(-age / sqrt(10.0) * (sqrt(k / kp) - 1.0));
    const double alpha = 0.01 * (1.0 + (friction > cm ? 3.0 : 1.0) * log(friction / cm));
    *delta = tanh(log(2.0) / 4.0 + 4.0 * pow(c / cp, 2.5) + 0.13 * friction / cm * pow(cm / c, 2.5));
    return long_waves + 0.5 * alpha * cm / c * exp(-0.25 * pow(k / km - 1.0, 2.0)) * cut;
}

static void elfouhaily_has_the_curvature_of_its_paper(void **state) {
    (void)state;
    for (double wind = 5.0; wind <= 20.0; wind += 5.0) {
        for (double age = 0.84; age < 3.0; age *= 1.5) {
            // eq. 37: the fetch of a wave age
            const double fetch =
                2.2e4 * pow(atanh(fmin(pow(age / 0.84, -4.0 / 3.0), 1.0 - 1e-15)), 2.5) * wind * wind / 9.81;
            const bolan_sea_state sea_state = bolan_sea_state_from_elfouhaily(wind, 270.0, fetch); // toward east
            assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
            assert_ratio(sea_state.systems[0].peak_omega, age * 9.81 / wind, 1e-4); // gravity alone in the paper
            for (double k = 0.3 * 9.81 * pow(age / wind, 2.0); k < 2e3; k *= 1.5) {
                double delta;
                const double b = elfouhaily_curvature(wind, age, k, &delta), k4 = k * k * k * k;
                for (double th = -1.5; th < 1.6; th += 0.5) {
                    const double psi = b / k4 * (1.0 + delta * cos(2.0 * th)) / BOLAN_PI;
                    assert_ratio(bolan_sea_state_wavenumber_density(&sea_state, k * cos(th), k * sin(th)), psi, 5e-3);
                }
                assert_true(bolan_sea_state_wavenumber_density(&sea_state, -k, 0.3 * k) == 0.0);
            }
        }
    }
}

// Hs, slope variance, and at 10 m/s its parts: integrals of the paper's formula with U/cp = 0.84.
static void elfouhaily_has_the_height_and_slopes_of_its_integrals(void **state) {
    (void)state;
    static const double table[][3] = {
        {5, 0.6441, 0.0322}, {10, 2.606, 0.0622}, {15, 5.869, 0.0853}, {20, 10.42, 0.1020}};
    for (int i = 0; i < 4; i++) {
        const bolan_sea_state sea_state = bolan_sea_state_from_elfouhaily(table[i][0], 270.0, HUGE_VAL);
        const spectrum_eval eval = bolan_spectrum_eval_prepare(&sea_state);
        double m0 = 0.0, up = 0.0, cross = 0.0;
        for (double u = log(1e-4); u < log(1e5); u += 0.02) {
            const double k = exp(u);
            for (double th = -BOLAN_PI / 2 + 0.01; th < BOLAN_PI / 2; th += BOLAN_PI / 157) {
                const double x = k * cos(th), y = k * sin(th), cell = k * k * 0.02 * BOLAN_PI / 157;
                const double part = bolan_spectrum_eval_psi(&eval, x, y) * cell;
                m0 += part;
                up += part * x * x;
                cross += part * y * y;
            }
        }
        assert_ratio(4.0 * sqrt(m0), table[i][1], 1e-3);
        assert_ratio(sea_state.systems[0].hs, table[i][1], 5e-4);
        assert_ratio(up + cross, table[i][2], 2e-3); // printed to three digits
        if (i == 1) {
            assert_ratio(up, 0.0366, 2e-3);
            assert_ratio(cross, 0.0256, 2e-3);
        }
    }
}

// ---- Ochi & Hubble (1976) -------------------------------------------------------------------------------------------

static void ochi_hubble_has_the_density_of_its_paper(void **state) {
    (void)state;
    for (double lambda = 0.1; lambda < 10.0; lambda *= 1.7) {
        bolan_wave_system s = system_of(BOLAN_SPECTRUM_OCHI_HUBBLE, 3.0, 0.7);
        s.lambda = lambda;
        for (double w = 0.35; w < 9.0; w *= 1.3) {
            const double m = lambda + 0.25; // eq. 2: (4 lambda + 1) / 4
            const double expected = 0.25 * pow(m * pow(0.7, 4.0), lambda) / tgamma(lambda) * 9.0 *
                                    pow(w, -(4.0 * lambda + 1.0)) * exp(-m * pow(0.7 / w, 4.0));
            assert_ratio(bolan_system_density(&s, w, BOLAN_DEEP), expected, 1e-11);
        }
    }
    bolan_wave_system one = system_of(BOLAN_SPECTRUM_OCHI_HUBBLE, 3.0, 0.7), zero = one;
    const bolan_wave_system pm = system_of(BOLAN_SPECTRUM_PIERSON_MOSKOWITZ, 3.0, 0.7);
    one.lambda = 1.0;
    for (double w = 0.35; w < 9.0; w *= 1.3) {
        assert_ratio(bolan_system_density(&one, w, BOLAN_DEEP), bolan_system_density(&pm, w, BOLAN_DEEP), 1e-11);
        assert_true(bolan_system_density(&zero, w, BOLAN_DEEP) == bolan_system_density(&one, w, BOLAN_DEEP));
    }
}

// Table 2b for Hs = 5 m: height, peak and lambda of both peaks of the most probable member and of three others.
static void the_members_of_ochi_and_hubble_are_those_of_the_table(void **state) {
    (void)state;
    static const struct {
        uint32_t member;
        double hs[2], omega[2], lambda[2];
    } table[] = {
        {0, {4.20, 2.70}, {0.556174, 0.946260}, {3.00, 1.129508}},
        {1, {4.75, 1.55}, {0.556174, 1.191800}, {1.35, 1.489229}},
        {6, {3.85, 3.20}, {0.444331, 0.610000}, {4.50, 1.294118}},
        {10, {3.10, 3.95}, {0.510157, 0.886529}, {2.60, 0.375357}},
    };
    for (int i = 0; i < 4; i++) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        assert_int_equal(bolan_sea_state_add_ochi_hubble(&sea_state, 5.0, table[i].member, 200.0), BOLAN_OK);
        assert_int_equal(sea_state.system_count, 2);
        for (int p = 0; p < 2; p++) {
            const bolan_wave_system *s = &sea_state.systems[p];
            assert_int_equal(s->kind, BOLAN_SPECTRUM_OCHI_HUBBLE);
            assert_ratio(s->hs, table[i].hs[p], 5e-3); // the squares of the table do not quite add to 1
            assert_ratio(s->peak_omega, table[i].omega[p], 2e-6);
            assert_ratio(s->lambda, table[i].lambda[p], 2e-6);
            assert_true(s->from_deg == 200.0);
        }
    }
    for (uint32_t member = 0; member < BOLAN_OCHI_HUBBLE_MEMBERS; member++) {
        for (double hs = 0.5; hs <= 40.0; hs *= 2.0) {
            bolan_sea_state sea_state = bolan_sea_state_default();
            assert_int_equal(bolan_sea_state_add_ochi_hubble(&sea_state, hs, member, 0.0), BOLAN_OK);
            assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
            assert_ratio(hypot(sea_state.systems[0].hs, sea_state.systems[1].hs), hs, 1e-12);
        }
    }
}

// ---- Torsethaugen & Haver (2004) ------------------------------------------------------------------------------------

// The published normalisation: G0 = 3.26, A_gamma = (1 + 1.1 (ln gamma)^1.19) / gamma.
static void torsethaugen_has_the_density_of_its_paper(void **state) {
    (void)state;
    assert_ratio(bolan_spectrum_tail4_integral(0.0, 0.07, 0.09), tgamma(0.75) / 4.0, 1e-9);
    assert_near(4.0 / tgamma(0.75), 3.26, 0.005);
    for (double gamma = 1.0; gamma <= 10.0; gamma *= 1.6) {
        bolan_wave_system s = system_of(BOLAN_SPECTRUM_TORSETHAUGEN, 3.0, 0.7);
        s.gamma = gamma;
        for (double f = 0.55; f < 6.0; f *= 1.21) {
            const double width = f < 1.0 ? 0.07 : 0.09,
                         peak = pow(gamma, exp(-pow(f - 1.0, 2.0) / (2.0 * width * width)));
            const double level = 3.26 * (1.0 + 1.1 * pow(log(gamma), 1.19)) / gamma;
            // S(w) = S(f) / (2 pi), S(f) = (Hs^2 / 16) Tp level f^-4 exp(-f^-4) peak; their fit is good to 3.5 %.
            const double expected = 9.0 / 16.0 / 0.7 * level / pow(f, 4.0) * exp(-pow(f, -4.0)) * peak;
            assert_ratio(bolan_system_density(&s, 0.7 * f, BOLAN_DEEP), expected, 0.035);
        }
    }
}

// Hs, Tp -> heights, periods and gamma, by hand from table 1.
static void the_peaks_of_torsethaugen_are_those_of_the_table(void **state) {
    (void)state;
    static const double table[][8] = {
        // Hs, Tp, first Hs, Tp, gamma, second Hs, Tp, gamma
        {3.0, 7.0, 2.5503975, 7.0, 1.8967136, 1.5797064, 11.518847, 1.0},
        {3.0, 14.0, 2.2730108, 14.0, 3.5224391, 1.9579127, 8.2567355, 1.0},
    };
    for (int i = 0; i < 2; i++) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        assert_int_equal(bolan_sea_state_add_torsethaugen(&sea_state, table[i][0], table[i][1], 300.0), BOLAN_OK);
        assert_int_equal(sea_state.system_count, 2);
        for (int p = 0; p < 2; p++) {
            const bolan_wave_system *s = &sea_state.systems[p];
            assert_int_equal(s->kind, BOLAN_SPECTRUM_TORSETHAUGEN);
            assert_ratio(s->hs, table[i][2 + 3 * p], 1e-5);
            assert_ratio(TURN / s->peak_omega, table[i][3 + 3 * p], 1e-5);
            assert_ratio(s->gamma, table[i][4 + 3 * p], 1e-5);
            assert_true(s->from_deg == 300.0);
            assert_true(s->spread_s == ((p == 0) == (i == 0) ? 10.0 : 30.0)); // the swell has the longer crests
        }
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        assert_ratio(summary.hs, table[i][0], 1e-4);
        assert_ratio(summary.tp, table[i][1], 0.01);
    }
    for (double hs = 1e-3; hs <= 40.0; hs *= 2.7) { // no height and period makes what is no sea
        for (double tp = 1.0; tp <= 60.0; tp *= 1.3) {
            bolan_sea_state sea_state = bolan_sea_state_default();
            assert_int_equal(bolan_sea_state_add_torsethaugen(&sea_state, hs, tp, 0.0), BOLAN_OK);
            assert_ratio(hypot(sea_state.systems[0].hs, sea_state.systems[1].hs), hs, 1e-9);
        }
    }
}

// ---- what is refused ------------------------------------------------------------------------------------------------

static void a_pair_that_does_not_fit_leaves_the_sea_as_it_was(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_default();
    for (int i = 0; i < BOLAN_MAX_WAVE_SYSTEMS - 1; i++)
        assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 10.0, 0.0, 30.0), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_ochi_hubble(&sea_state, 2.0, 0, 0.0), BOLAN_ERROR_ARGUMENT);
    assert_non_null(strstr(last_sentence, "8 systems; expected fewer than 8"));
    assert_int_equal(bolan_sea_state_add_torsethaugen(&sea_state, 2.0, 9.0, 0.0), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(sea_state.system_count, BOLAN_MAX_WAVE_SYSTEMS - 1);
}

#define REFUSED(call, id, part)                                \
    do {                                                       \
        bolan_sea_state sea_state = bolan_sea_state_default(); \
        last_sentence[0] = '\0';                               \
        assert_int_equal(call, BOLAN_ERROR_ARGUMENT);          \
        assert_int_equal(last_log_id, BOLAN_LOG_##id);         \
        assert_non_null(strstr(last_sentence, part));          \
        assert_int_equal(sea_state.system_count, 0);           \
    } while (0)

static void arguments_outside_their_ranges_are_refused(void **state) {
    (void)state;
    REFUSED(bolan_sea_state_add_ochi_hubble(&sea_state, -1.0, 0, 0.0), OUT_OF_RANGE, "hs is -1; expected 0 to 40 m");
    REFUSED(bolan_sea_state_add_ochi_hubble(&sea_state, (double)NAN, 0, 0.0), NOT_FINITE, "hs");
    REFUSED(bolan_sea_state_add_ochi_hubble(&sea_state, 3.0, 11, 0.0), OUT_OF_RANGE, "member is 11; expected 0 to 10");
    REFUSED(bolan_sea_state_add_ochi_hubble(&sea_state, 3.0, 0, 1e30), OUT_OF_RANGE, "from_deg");
    REFUSED(bolan_sea_state_add_torsethaugen(&sea_state, 41.0, 9.0, 0.0), OUT_OF_RANGE, "hs is 41");
    REFUSED(bolan_sea_state_add_torsethaugen(&sea_state, 3.0, 0.0, 0.0), OUT_OF_RANGE, "tp is 0; expected 1 to 60 s");
    REFUSED(bolan_sea_state_add_torsethaugen(&sea_state, 3.0, (double)INFINITY, 0.0), NOT_FINITE, "tp");
    REFUSED(bolan_sea_state_add_torsethaugen(&sea_state, 3.0, 9.0, (double)NAN), NOT_FINITE, "from_deg");
    bolan_sea_state none = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_torsethaugen(&none, 0.0, 9.0, 0.0), BOLAN_OK);
    assert_int_equal(none.system_count, 0); // no height, no waves
}

static void winds_and_fetches_at_their_extremes_make_valid_seas(void **state) {
    (void)state;
    static const double winds[] = {0.0, 1e-9, 0.05, 1.0, 8.0, 30.0, 70.0}, fetches[] = {1e-9, 1.0, 1e4, 1e7, HUGE_VAL};
    for (int i = 0; i < 7; i++) {
        for (int j = 0; j < 5; j++) {
            const bolan_sea_state seas[2] = {bolan_sea_state_from_donelan(winds[i], 10.0, fetches[j]),
                                             bolan_sea_state_from_elfouhaily(winds[i], 10.0, fetches[j])};
            for (int k = 0; k < 2; k++) {
                assert_int_equal(bolan_sea_state_validate(&seas[k]), BOLAN_OK);
                const bolan_sea_summary s = bolan_sea_state_summary(&seas[k]);
                assert_true(isfinite(s.hs) && isfinite(s.tm02) && s.hs >= 0.0);
                if (seas[k].system_count > 0) assert_ratio(s.hs, seas[k].systems[0].hs, 1e-3);
            }
        }
    }
    assert_int_equal(bolan_sea_state_from_donelan((double)NAN, 0.0, 1e5).system_count, 0);
    assert_int_equal(bolan_sea_state_from_elfouhaily(8.0, 0.0, (double)NAN).system_count, 0);
    assert_int_equal(bolan_sea_state_from_elfouhaily(8.0, 0.0, -1.0).system_count, 0);
    const bolan_sea_state bad = bolan_sea_state_from_donelan(80.0, 0.0, 1e5);
    assert_int_equal(bolan_sea_state_validate(&bad), BOLAN_ERROR_ARGUMENT);
}

static void every_spectrum_is_a_sea_of_its_height(void **state) {
    (void)state;
    for (int kind = 0; kind < BOLAN_SPECTRUM_KINDS; kind++) {
        bolan_wave_system system = system_of((bolan_spectrum_kind)kind, 2.0, 0.9);
        for (int edge = 0; edge < 8; edge++) { // fields at the ends of their ranges, together
            system.peak_omega = edge & 1 ? 50.0 : 0.1;
            system.wind_speed = edge & 2 ? 70.0 : 0.0;
            system.gamma = edge & 4 ? 10.0 : 1.0;
            system.lambda = edge & 4 ? 10.0 : 0.1;
            const bolan_sea_state sea_state = sea_with(system);
            const bolan_sea_summary s = bolan_sea_state_summary(&sea_state);
            assert_true(isfinite(s.hs) && isfinite(s.te) && isfinite(s.spread_deg));
            // lambda 0.1 falls as w^-1.4: 6 % of its energy lies above 1000 wp.
            assert_ratio(s.hs, kind == BOLAN_SPECTRUM_TMA ? s.hs : 2.0, system.lambda == 0.1 ? 0.04 : 1e-3);
            assert_true(isfinite(bolan_sea_state_wavenumber_density(&sea_state, 1e-9, 0.0)));
            assert_true(isfinite(bolan_sea_state_wavenumber_density(&sea_state, 1e9, -1e9)));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_has_the_height_that_is_asked_for),
        cmocka_unit_test(every_kind_peaks_at_its_peak),
        cmocka_unit_test(donelan_has_the_density_and_height_of_its_paper),
        cmocka_unit_test(elfouhaily_has_the_curvature_of_its_paper),
        cmocka_unit_test(elfouhaily_has_the_height_and_slopes_of_its_integrals),
        cmocka_unit_test(ochi_hubble_has_the_density_of_its_paper),
        cmocka_unit_test(the_members_of_ochi_and_hubble_are_those_of_the_table),
        cmocka_unit_test(torsethaugen_has_the_density_of_its_paper),
        cmocka_unit_test(the_peaks_of_torsethaugen_are_those_of_the_table),
        cmocka_unit_test_setup_teardown(a_pair_that_does_not_fit_leaves_the_sea_as_it_was, capture_log, release_log),
        cmocka_unit_test_setup_teardown(arguments_outside_their_ranges_are_refused, capture_log, release_log),
        cmocka_unit_test_setup_teardown(winds_and_fetches_at_their_extremes_make_valid_seas, capture_log, release_log),
        cmocka_unit_test(every_spectrum_is_a_sea_of_its_height),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
