// SPDX-License-Identifier: MIT
// Sea states: constructors, tables, and the sentence for every field that is outside its range.
#include "spectrum_support.h"

static bolan_sea_state good(void) {
    bolan_sea_state sea_state = bolan_sea_state_from_wind(12.0, 225.0, 300e3);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 2.0, 14.0, 300.0, 40.0), BOLAN_OK);
    return sea_state;
}

static void constructed_seas_are_valid(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
    assert_int_equal(sea_state.system_count, 0);
    sea_state = good();
    assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
    assert_int_equal(sea_state.system_count, 2);
    for (double wind = 0.0; wind <= 70.0; wind += 0.7)
        for (double fetch = 1.0; fetch < 1e7; fetch *= 30.0) {
            sea_state = bolan_sea_state_from_wind(wind, 359.0, fetch);
            assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
        }
    for (double beaufort = 0.0; beaufort <= 12.0; beaufort += 0.5) {
        sea_state = bolan_sea_state_from_beaufort(beaufort, 10.0);
        assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
        if (beaufort == floor(beaufort)) // v = 0.836 B^1.5 lies in the class
            assert_int_equal(bolan_beaufort_from_wind(sea_state.wind_speed), (int)beaufort);
    }
}

static void a_douglas_degree_makes_a_sea_of_that_degree(void **state) {
    (void)state;
    for (int degree = 0; degree <= 9; degree++) {
        const bolan_sea_state sea_state = bolan_sea_state_from_douglas(degree, 10.0);
        assert_int_equal(bolan_sea_state_validate(&sea_state), BOLAN_OK);
        const bolan_sea_summary s = bolan_sea_state_summary(&sea_state);
        assert_int_equal(bolan_douglas_from_hs(s.hs), degree);
        if (degree > 0)                                    // Pierson-Moskowitz: Tp = 5.0028 sqrt(Hs)
            assert_ratio(s.tp, 5.0028 * sqrt(s.hs), 2e-3); // that figure is rounded from 0.78 and 3.11
    }
}

// WMO code table 3700: an exact bound belongs to the lower class.
static void a_bound_belongs_to_the_lower_douglas_class(void **state) {
    (void)state;
    static const double bounds[] = {0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0};
    for (int degree = 0; degree < 9; degree++) {
        assert_int_equal(bolan_douglas_from_hs(bounds[degree]), degree);
        assert_int_equal(bolan_douglas_from_hs(bounds[degree] + 1e-6), degree + 1);
        assert_true(bolan_douglas_table[degree].hs_max == bounds[degree]);
    }
    assert_string_equal(bolan_douglas_table[5].name, "rough");
}

static void beaufort_classes_are_those_of_the_wmo(void **state) {
    (void)state;
    static const double lowest[] = {0, 0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7};
    static const double highest[] = {0.2, 1.5, 3.3, 5.4, 7.9, 10.7, 13.8, 17.1, 20.7, 24.4, 28.4, 32.6, 99.0};
    for (int force = 0; force <= 12; force++) {
        assert_int_equal(bolan_beaufort_from_wind(lowest[force]), force);
        assert_int_equal(bolan_beaufort_from_wind(highest[force]), force);
        assert_int_equal(bolan_beaufort_table[force].force, force);
    }
    assert_near(bolan_beaufort_table[8].wave_height, 5.5, 0.0);
}

static void calm_air_leaves_the_sea_flat(void **state) {
    (void)state;
    const bolan_sea_state calm = bolan_sea_state_from_wind(0.0, 90.0, 1e5);
    const bolan_sea_summary s = bolan_sea_state_summary(&calm);
    assert_true(s.m0 == 0.0 && s.hs == 0.0 && s.tp == 0.0);
    assert_true(bolan_sea_state_wavenumber_density(&calm, 0.1, 0.2) == 0.0);
}

static void a_swell_that_does_not_fit_is_refused(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, -1.0, 10.0, 0.0, 30.0), BOLAN_ERROR_ARGUMENT);
    assert_non_null(strstr(last_sentence, "hs is -1; expected 0 to 40 m"));
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 0.0, 0.0, 30.0), BOLAN_ERROR_ARGUMENT);
    assert_non_null(strstr(last_sentence, "tp is 0"));
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, NAN, 0.0, 30.0), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(last_log_id, BOLAN_LOG_NOT_FINITE);
    assert_int_equal(sea_state.system_count, 0);
    for (int i = 0; i < BOLAN_MAX_WAVE_SYSTEMS; i++)
        assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 10.0, 0.0, 30.0), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.0, 10.0, 0.0, 30.0), BOLAN_ERROR_ARGUMENT);
    assert_non_null(strstr(last_sentence, "8 systems"));
    assert_int_equal(sea_state.system_count, 8);
}

static void refuse(const bolan_sea_state *sea_state, bolan_log_id id, const char *part) {
    last_log_id = (bolan_log_id)0;
    assert_int_equal(bolan_sea_state_validate(sea_state), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(last_log_id, id);
    if (!strstr(last_sentence, part)) print_error("got \"%s\"\n", last_sentence);
    assert_non_null(strstr(last_sentence, part));
}

#define REFUSE(field, value, id, part)      \
    do {                                    \
        bolan_sea_state bad = good();       \
        bad.field = (value);                \
        refuse(&bad, BOLAN_LOG_##id, part); \
    } while (0)

static void each_field_is_refused_by_name(void **state) {
    (void)state;
    REFUSE(system_count, 9, OUT_OF_RANGE, "system_count is 9; expected 0 to 8");
    REFUSE(depth, 0.0, OUT_OF_RANGE, "depth is 0; expected 0.1 to 10000 m");
    REFUSE(depth, NAN, NOT_FINITE, "depth is not a finite number");
    REFUSE(wind_speed, 71.0, OUT_OF_RANGE, "bolan_sea_state: wind_speed is 71; expected 0 to 70 m/s");
    REFUSE(wind_from_deg, INFINITY, NOT_FINITE, "wind_from_deg");
    REFUSE(current_x, 6.0, OUT_OF_RANGE, "current_x is 6; expected -5 to 5 m/s");
    REFUSE(current_y, -INFINITY, NOT_FINITE, "current_y is not a finite number");
    REFUSE(frame, (bolan_spectrum_frame)3, BAD_ARGUMENT, "frame is 3; expected 0 to 2");
    REFUSE(systems[1].kind, (bolan_spectrum_kind)8, BAD_ARGUMENT, "systems[1].kind is 8");
    REFUSE(systems[1].hs, 41.0, OUT_OF_RANGE, "systems[1].hs is 41; expected 0 to 40 m");
    REFUSE(systems[0].peak_omega, 0.05, OUT_OF_RANGE, "systems[0].peak_omega is 0.05; expected 0.1 to 50 rad/s");
    REFUSE(systems[0].gamma, 0.5, OUT_OF_RANGE, "systems[0].gamma is 0.5; expected 1 to 10");
    REFUSE(systems[0].lambda, 0.05, OUT_OF_RANGE, "systems[0].lambda is 0.05; expected 0.1 to 10");
    REFUSE(systems[0].lambda, NAN, NOT_FINITE, "systems[0].lambda");
    REFUSE(systems[0].from_deg, 400.0, OUT_OF_RANGE, "systems[0].from_deg");
    REFUSE(systems[0].spreading, (bolan_spreading_kind)9, BAD_ARGUMENT, "systems[0].spreading");
    REFUSE(systems[0].spread_s, 201.0, OUT_OF_RANGE, "systems[0].spread_s");
    REFUSE(systems[0].wind_speed, -1.0, OUT_OF_RANGE, "systems[0].wind_speed");
    REFUSE(systems[0].swell, 1.5, OUT_OF_RANGE, "systems[0].swell");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constructed_seas_are_valid),
        cmocka_unit_test(a_douglas_degree_makes_a_sea_of_that_degree),
        cmocka_unit_test(a_bound_belongs_to_the_lower_douglas_class),
        cmocka_unit_test(beaufort_classes_are_those_of_the_wmo),
        cmocka_unit_test(calm_air_leaves_the_sea_flat),
        cmocka_unit_test(a_swell_that_does_not_fit_is_refused),
        cmocka_unit_test(each_field_is_refused_by_name),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
