// SPDX-License-Identifier: MIT
// A sea too high for its depth or too steep is lowered as a whole, with one warning; and what is left keeps what
// query.h promises.
#include "sea_support.h"

#include "bolan/query.h"

#include <string.h>

static int warnings;
static char sentence[512];

static void listen(void *user, bolan_log_level level, bolan_log_id id, const char *message) {
    (void)user;
    if (level != BOLAN_LOG_WARNING || id != BOLAN_LOG_SEA_LIMITED) return;
    warnings++;
    snprintf(sentence, sizeof sentence, "%s", message);
}

static bolan_sea *make(const bolan_sea_desc *desc) {
    bolan_sea *sea = NULL;
    warnings = 0;
    sentence[0] = '\0';
    assert_int_equal(bolan_sea_create(desc, &sea), BOLAN_OK);
    return sea;
}

static bolan_sea_state swell(double hs, double tp, double depth) {
    bolan_sea_state state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&state, hs, tp, 270.0, 50.0), BOLAN_OK);
    state.depth = depth;
    return state;
}

static void a_sea_is_no_higher_than_six_tenths_of_its_depth(void **state) {
    (void)state;
    for (int model = 0; model < BOLAN_WAVE_MODELS; model++) {
        bolan_sea_desc d = bolan_sea_desc_default();
        d.sea_state = bolan_sea_state_from_wind(10.0, 210.0, 100e3); // 2.1386 m
        d.sea_state.depth = 0.5;
        d.waves = (bolan_wave_model)model;
        d.resolution = 128;
        bolan_sea *sea = make(&d);
        assert_int_equal(warnings, 1);
        assert_non_null(
            strstr(sentence, "too high for its depth of 0.5 m: Hs lowered from 2.14 to 0.3 m, 0.6 of the depth"));
        assert_near(bolan_sea_get_summary(sea)->hs, 0.3, 1e-9);
        assert_near(bolan_sea_get_summary(sea)->m0, 0.3 * 0.3 / 16.0, 1e-9);
        assert_near(bolan_sea_get_desc(sea)->sea_state.systems[0].hs, 2.1386, 1e-3); // as it was asked for
        const bolan_sea_statistics m = bolan_sea_measure(sea);
        assert_near(m.m0_spectrum, 0.3 * 0.3 / 16.0, 1e-9);
        assert_near(m.hs / 0.3, 0.97, 0.12); // one realisation, between samples
        bolan_sea_destroy(&sea);
    }
}

// 0.142 L tanh(2 pi d / L): in deep water L = g T^2 / 2 pi; with T = 8 s 99.9 m and 14.18 m, in 5 m 53.08 m and 4.01 m.
static void a_sea_is_no_steeper_than_miche(void **state) {
    (void)state;
    const bolan_sea_state steep = swell(15.0, 8.0, BOLAN_DEEP), shallow = swell(15.0, 8.0, 5.0);
    assert_near(15.0 * bolan_sea_state_limit(&steep).by_steepness, 0.142 * 9.81 * 64.0 / (2.0 * BOLAN_PI), 0.02);
    assert_true(bolan_sea_state_limit(&steep).by_depth == 1.0);
    assert_near(15.0 * bolan_sea_state_limit(&shallow).by_steepness,
                0.142 * 53.0815 * tanh(2.0 * BOLAN_PI * 5.0 / 53.0815), 0.01);
    assert_near(15.0 * bolan_sea_state_limit(&shallow).by_depth, 3.0, 1e-6);
    // one of 14 m is let through
    const bolan_sea_state high = swell(14.0, 8.0, BOLAN_DEEP);
    assert_true(bolan_sea_state_limit(&high).by_steepness == 1.0);
    // systems add as energies: two of .8 of the limit are 1.13 of it
    bolan_sea_state two = swell(0.8 * 14.18, 8.0, BOLAN_DEEP);
    assert_int_equal(bolan_sea_state_add_swell(&two, 0.8 * 14.18, 8.0, 0.0, 50.0), BOLAN_OK);
    assert_near(bolan_sea_state_limit(&two).by_steepness, 1.0 / sqrt(2.0 * 0.64), 2e-3);
    bolan_sea_desc d = bolan_sea_desc_default();
    d.resolution = 64;
    d.sea_state = swell(40.0, 1.0, BOLAN_DEEP);
    for (int i = 0; i < 6; i++)
        assert_int_equal(bolan_sea_state_add_swell(&d.sea_state, 40.0, 1.0, 40.0 * i, 50.0), BOLAN_OK);
    bolan_sea *sea = make(&d);
    assert_int_equal(warnings, 1);
    assert_non_null(strstr(sentence, "too steep: Hs lowered from 106 to 0.222 m, by Miche's limit"));
    assert_near(bolan_sea_get_summary(sea)->hs, 0.142 * 9.81 / (2.0 * BOLAN_PI), 1e-3);
    bolan_sea_destroy(&sea);
}

static void seas_that_occur_are_left_alone(void **state) {
    (void)state;
    for (double wind = 0.5; wind <= 70.0; wind *= 1.5)
        for (double fetch = 500.0; fetch < 1e7; fetch *= 4.0) {
            const bolan_sea_state s = bolan_sea_state_from_wind(wind, 0.0, fetch);
            const bolan_sea_limit limit = bolan_sea_state_limit(&s);
            assert_true(limit.by_depth == 1.0 && limit.by_steepness == 1.0);
        }
    bolan_sea_state tma = bolan_sea_state_from_wind(15.0, 0.0, 100e3); // 1.64 m in 5 m (Bouws et al. 1985)
    tma.systems[0].kind = BOLAN_SPECTRUM_TMA;
    tma.depth = 5.0;
    assert_true(bolan_sea_state_limit(&tma).by_depth == 1.0 && bolan_sea_state_limit(&tma).by_steepness == 1.0);
    const bolan_sea_state calm = bolan_sea_state_default();
    assert_true(bolan_sea_state_limit(&calm).by_depth == 1.0 && bolan_sea_state_limit(&calm).by_steepness == 1.0);
    bolan_sea_desc d = bolan_sea_desc_default();
    bolan_sea *sea = make(&d);
    assert_int_equal(warnings, 0);
    bolan_sea_destroy(&sea);
}

// query.h: below 1 mm where the Jacobian is above .2. From half a metre of water to the ocean, as high and as steep as
// may be.
static void queries_keep_their_promise_in_shallow_and_steep_seas(void **state) {
    (void)state;
    enum { POINTS = 20000 };
    static bolan_dvec2 at[POINTS];
    static bolan_query_point answer[POINTS];
    static const double depths[] = {0.3, 0.5, 2.0, 8.0, 30.0, BOLAN_DEEP}, periods[] = {0.0, 4.0, 8.0, 14.0};
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 4; j++) {
            bolan_sea_desc d = bolan_sea_desc_default();
            d.sea_state = bolan_sea_state_from_wind(14.0, 240.0, 200e3);
            if (periods[j] > 0.0) d.sea_state = swell(20.0, periods[j], BOLAN_DEEP);
            d.sea_state.depth = depths[i];
            d.resolution = 128;
            d.seed = (uint64_t)(10 * i + j);
            bolan_sea *sea = make(&d);
            bolan_sea_step(sea, 60.0);
            const double side = 3.0 * bolan_sea_cascade(sea, 0).length;
            for (int p = 0; p < POINTS; p++) {
                const double x = p * 0.7548776662466927, y = p * 0.5698402909980532;
                at[p] = (bolan_dvec2){side * (x - floor(x)), side * (y - floor(y))};
            }
            bolan_query_surface(&(bolan_water){.sea = sea}, at, POINTS, answer);
            int broken = 0, folded = 0;
            for (int p = 0; p < POINTS; p++) {
                folded += answer[p].jacobian <= 0.2f;
                broken += answer[p].jacobian > 0.2f && !(answer[p].residual < 1e-3f);
            }
            if (broken) print_error("depth %g, period %g: %d of %d\n", depths[i], periods[j], broken, POINTS);
            assert_int_equal(broken, 0);
            assert_true(folded < POINTS / 20);
            bolan_sea_destroy(&sea);
        }
}

int main(void) {
    const bolan_hooks hooks = {.log = listen};
    bolan_set_hooks(&hooks);
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_sea_is_no_higher_than_six_tenths_of_its_depth),
                                       cmocka_unit_test(a_sea_is_no_steeper_than_miche),
                                       cmocka_unit_test(seas_that_occur_are_left_alone),
                                       cmocka_unit_test(queries_keep_their_promise_in_shallow_and_steep_seas)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
