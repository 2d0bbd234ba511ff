// SPDX-License-Identifier: MIT
// The reader of WAVEWATCH III's text: directions, order of the densities, times and points, and what is wrong.
#include "spectrum_support.h"

// Two frequencies and four directions, where waves go TO: 80, 350, 260 and 170 degrees, printed with three digits.
#define HEAD(points)                                                                                              \
    "'WAVEWATCH III SPECTRA'     2     4     " points " 'spectral resolution for points'\n 0.100E+00 0.200E+00\n" \
    "  0.140E+01  0.611E+01\n  0.454E+01  0.297E+01\n"
#define POINT(name, latitude, longitude) "'" name "' " latitude " " longitude "      46.6   1.45 225.6   0.18  94.1\n"
#define ONE POINT("44097     ", "40.98", "-71.12")
#define TIME_6 "20220912 060000\n"
// For each direction both frequencies: 3 and 1 in the first direction.
#define FIRST "0.300E+01 0.100E+01 0 0\n 0 0 0 0\n"
#define SECOND "0 0 0.300E+01 0.100E+01\n 0 0 0 0\n"

static bolan_spectrum_texts texts_of(const char *data) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("point.spec", data);
    return texts;
}

static void directions_are_compass_radians_that_waves_go_to(void **state) {
    (void)state;
    const bolan_spectrum_options options = bolan_spectrum_options_default();
    bolan_spectrum_texts texts = texts_of(HEAD("1") TIME_6 ONE FIRST);
    bolan_sea_summary s = summary_with(&texts, &options);
    assert_int_equal(warning_count, 0);
    assert_near(s.m0, BOLAN_PI / 2.0 * 0.5 * (3.0 + 1.0) * 0.1, 1e-12); // a bin of 90 degrees, the trapezoid rule
    assert_near(s.tp, 10.0, 1e-9);
    // 1.40, and the others less 3, 2 and 1 quarter turns: 1.3976, 1.3984, 1.3992; their mean is the first direction.
    const double evened = 180.0 + bolan_degrees((1.40 + (6.11 + 4.54 + 2.97 - 3.0 * BOLAN_PI)) / 4.0);
    assert_near(s.from_deg, evened, 1e-6);
    texts = texts_of(HEAD("1") TIME_6 ONE SECOND);
    s = summary_with(&texts, &options);
    assert_near(s.from_deg, evened - 90.0, 1e-6);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_int_equal(view.direction_count, 4); // evened out: no resampling
    assert_string_equal(view.time, "2022-09-12T06:00:00");
    for (uint32_t i = 0; i < 2; i++) // energy at one direction only, 3 and 1 per hertz
        for (uint32_t j = 0; j < 4; j++) {
            const double expected = view.density[i * 4 + j] > 0.0 ? (i ? 1.0 : 3.0) / (2.0 * BOLAN_PI) : 0.0;
            assert_near(view.density[i * 4 + j], expected, 1e-12);
        }
    bolan_measured_spectrum_destroy(&spectrum);
}

static void times_are_sorted_and_points_are_chosen(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(
        HEAD("2") "20220912 070000\n" ONE FIRST POINT("with blank", "41", "-70")
            SECOND TIME_6 ONE SECOND POINT("b", "41", "-70") "0 odd 0 0 0 0 0\n"); // short and odd, but not asked for
    bolan_spectrum_options options = record_number(1);
    assert_near(summary_with(&texts, &options).from_deg, 260.0, 0.3);
    assert_warned(BOLAN_LOG_SPECTRUM_LOCATION, "has 2 locations; the first, at -71.12, 40.98, is taken");
    options.location = 2;
    assert_near(summary_with(&texts, &options).from_deg, 170.0, 0.3);
    assert_int_equal(warning_count, 0);
    assert_true(bolan_spectrum_options_set_location(&options, "-70.1,41"));
    assert_near(summary_with(&texts, &options).from_deg, 170.0, 0.3);
    assert_true(bolan_spectrum_options_set_location(&options, "288.88,40.98")); // the first, by another turn
    assert_near(summary_with(&texts, &options).from_deg, 260.0, 0.3);
    assert_true(bolan_spectrum_options_set_location(&options, "-71,41"));
    assert_near(summary_with(&texts, &options).from_deg, 260.0, 0.3);
    assert_int_equal(warning_count, 0);
    assert_true(bolan_spectrum_options_set_record(&options, "2022-09-12T06:00"));
    assert_near(summary_with(&texts, &options).from_deg, 170.0, 0.3);
    options.location = 2;
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "a density, found \"odd\"");
    options.location = 3;
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_LOCATION, "expected 1 to 2");
    options = record_number(1);
    options.location = 1;
    options.spread_s = 3.0;
    summary_with(&texts, &options);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "point.spec: has directions of its own");
}

static void times_have_minutes_and_seconds(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HEAD("1") "20221002 061530\n" ONE FIRST);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2022-10-02T06:15:30");
    bolan_measured_spectrum_destroy(&spectrum);
}

static void what_is_wrong_is_named_with_its_line(void **state) {
    (void)state;
    const struct {
        const char *data, *said;
        bolan_log_id id;
    } cases[] = {
        {"'WAVEWATCH III SPECTRA' 1 4 1 'x'\n", "frequencies from 2 to 1000, found \"1\"", BOLAN_LOG_SPECTRUM_SYNTAX},
        {"'WAVEWATCH III SPECTRA' 2 2 1 'x'\n", "directions from 3 to 720, found \"2\"", BOLAN_LOG_SPECTRUM_SYNTAX},
        {"'WAVEWATCH III SPECTRA' 2 4 0 'x'\n", "points from 1 to", BOLAN_LOG_SPECTRUM_SYNTAX},
        {"'WAVEWATCH III SPECTRA' 2 4 1 'x'\n .1 20\n", "point.spec:2: expected an ascending",
         BOLAN_LOG_SPECTRUM_SYNTAX},
        {"'WAVEWATCH III SPECTRA' 2 4 1 'x'\n .1 .2\n 85 0\n", "a direction in radians, found \"85\"",
         BOLAN_LOG_SPECTRUM_SYNTAX},
        {HEAD("1"), "the date of the first time", BOLAN_LOG_SPECTRUM_TRUNCATED},
        {HEAD("1") "20220931 060000\n" ONE FIRST, "point.spec:5: there is no date 20220931 060000",
         BOLAN_LOG_SPECTRUM_DATE},
        {HEAD("1") "20220930 240000\n" ONE FIRST, "there is no date", BOLAN_LOG_SPECTRUM_DATE},
        {HEAD("1") "2022 060000\n" ONE FIRST, "a date such as 20220912, found \"2022\"", BOLAN_LOG_SPECTRUM_SYNTAX},
        {HEAD("1") TIME_6 "44097 40 70\n", "in quotes, found \"44097\"", BOLAN_LOG_SPECTRUM_SYNTAX},
        {HEAD("1") TIME_6, "the name of a point", BOLAN_LOG_SPECTRUM_TRUNCATED},
        {HEAD("1") TIME_6 ONE "1 2 3\n", "point.spec:7: the text ends where a density", BOLAN_LOG_SPECTRUM_TRUNCATED},
        {HEAD("1") TIME_6 ONE "1 -2 3 4 5 6 7 8\n", "-2 is negative", BOLAN_LOG_SPECTRUM_NEGATIVE},
        {HEAD("1") TIME_6 ONE "1 2e9 3 4 5 6 7 8\n", "a sea can have", BOLAN_LOG_SPECTRUM_SYNTAX},
        {HEAD("1") TIME_6 ONE "1 2e6 3 4 5 6 7 8\n", "of 2022-09-12T06:00:00 has a significant wave height",
         BOLAN_LOG_SPECTRUM_IMPOSSIBLE},
        {HEAD("1") TIME_6 ONE "1 2 3 4 5 6 7 8 9\n", "a date such as 20220912, found \"9\"", BOLAN_LOG_SPECTRUM_SYNTAX},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const bolan_spectrum_texts texts = texts_of(cases[i].data);
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, cases[i].id, cases[i].said);
    }
}

static void every_truncation_is_refused(void **state) {
    (void)state;
    static const char whole[] = HEAD("1") TIME_6 ONE FIRST;
    for (size_t size = 1; size + 3 < sizeof whole; size++) {
        char *copy = malloc(size); // exactly as long, so that a sanitizer sees any step beyond
        memcpy(copy, whole, size);
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){"cut.spec", copy, size};
        bolan_measured_spectrum *spectrum;
        assert_int_equal(bolan_measured_spectrum_parse(&texts, NULL, &spectrum), BOLAN_ERROR_FORMAT);
        assert_null(spectrum);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directions_are_compass_radians_that_waves_go_to),
        cmocka_unit_test(times_are_sorted_and_points_are_chosen),
        cmocka_unit_test(times_have_minutes_and_seconds),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(every_truncation_is_refused),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
