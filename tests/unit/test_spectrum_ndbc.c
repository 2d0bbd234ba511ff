// SPDX-License-Identifier: MIT
// The NDBC reader: both layouts, the four direction tables, record order, and every way a text can be wrong.
#include "spectrum_support.h"

// The rectangle and trapezoid sums below: density 2 m2/Hz at 0.1 Hz between two empty bands 0.1 Hz apart is 0.2 m2.
#define HISTORY "YYYY MM DD hh   .0500   .1000   .2000\n"
#define REAL_TIME "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n"
#define REAL_ROW "2020 06 08 03 50 0.225 0.000 (0.050) 2.000 (0.100) 0.000 (0.200) \n"
#define COMPANION "#YY  MM DD hh mm alpha1_1 (freq_1) ... >\n"

static bolan_spectrum_texts texts_of(const char *data) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("41010.data_spec", data);
    return texts;
}

static bolan_sea_summary summary_of(const bolan_spectrum_texts *texts, uint32_t record) {
    bolan_measured_spectrum *spectrum = parse(texts, record);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    bolan_measured_spectrum_destroy(&spectrum);
    return summary;
}

static void a_history_table_takes_its_direction_from_the_caller(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 .00 2.00 999.00\n2000 01 01 01 .00 .00 3.00\n");
    texts.from_deg = 200.0;
    texts.spread_s = 50.0;
    const bolan_sea_summary s = summary_of(&texts, 0);
    assert_near(s.m0, 0.5 * (0.2 - 0.05) * 2.0, 1e-9);
    assert_near(s.tp, 10.0, 1e-9);
    assert_near(s.from_deg, 200.0, 1e-6);
    assert_near(s.spread_deg, 11.35, 0.01); // cos-2s, s = 50
    assert_near(summary_of(&texts, 1).tp, 5.0, 1e-9);
    assert_near(summary_of(&texts, 1).from_deg, 200.0, 1e-6);
}

static void old_years_have_two_digits_and_new_tables_have_minutes(void **state) {
    (void)state;
    const char *const texts[3][2] = {{"YY MM DD hh .1 .2\n96 12 31 23 1 1\n", "1996-12-31T23:00Z"},
                                     {"#YY  MM DD hh mm .1 .2\n2012 12 31 23 40 1 1\n", "2012-12-31T23:40Z"},
                                     {"YYYY MM DD hh mm .1 .2\r\n2005 01 02 03 04 1 1\r\n", "2005-01-02T03:04Z"}};
    for (int i = 0; i < 3; i++) {
        const bolan_spectrum_texts t = texts_of(texts[i][0]);
        bolan_measured_spectrum *spectrum = parse(&t, 0);
        assert_string_equal(bolan_measured_spectrum_view(spectrum).time, texts[i][1]);
        bolan_measured_spectrum_destroy(&spectrum);
    }
}

static void record_zero_is_the_earliest_in_either_order(void **state) {
    (void)state;
    const bolan_spectrum_texts newest_first =
        texts_of(REAL_TIME REAL_ROW "2020 06 08 02 50 9.999 1.0 (0.05) 0.0 (0.1)\n");
    assert_near(summary_of(&newest_first, 0).tp, 20.0, 1e-9);
    assert_near(summary_of(&newest_first, 1).tp, 10.0, 1e-9);
    const bolan_spectrum_texts oldest_first = texts_of(HISTORY "1999 12 31 23 1 0 0\n2000 01 01 00 0 1 0\n");
    assert_near(summary_of(&oldest_first, 0).tp, 20.0, 1e-9);
    assert_near(summary_of(&oldest_first, 1).tp, 10.0, 1e-9);
}

#define ROW(a, b, c) "2020 06 08 03 50 " a " (0.050) " b " (0.100) " c " (0.200)\n"

static bolan_spectrum_texts directional_texts(void) {
    bolan_spectrum_texts texts = texts_of(REAL_TIME REAL_ROW);
    texts.swdir = literal("41010.swdir", COMPANION ROW("999.0", "144.0", "999.0"));
    texts.swdir2 = literal("41010.swdir2", COMPANION ROW("999.0", "150.0", "999.0"));
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "0.82", "999.00"));
    texts.swr2 = literal("41010.swr2", COMPANION ROW("999.00", "0.57", "999.00"));
    return texts;
}

// alpha1 is where the waves come FROM, and r1 fixes the circular spread sqrt(2 (1 - r1)).
static void reported_direction_and_spread_survive(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = directional_texts();
    const bolan_sea_summary s = summary_of(&texts, 0);
    assert_near(s.m0, 0.15, 1e-9);
    assert_near(s.from_deg, 144.0, 1e-3); // the fit of maximum entropy stops at 1e-7 of the moments
    assert_near(s.spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 1e-3);
}

static void history_ratios_are_hundredths(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 0 2 0\n");
    texts.swdir = literal("swdir", HISTORY "2000 01 01 00 999 30 999\n");
    texts.swr1 = literal("swr1", HISTORY "2000 01 01 00 999 82 999\n");
    assert_near(summary_of(&texts, 0).from_deg, 30.0, 1e-6);
    assert_near(summary_of(&texts, 0).spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 0.01); // bins of 5 degrees
}

static void missing_direction_tables_fall_back_step_by_step(void **state) {
    (void)state;
    bolan_spectrum_texts texts = directional_texts();
    texts.swr2.data = NULL; // r1 alone: cos-2s with the same spread
    assert_near(summary_of(&texts, 0).from_deg, 144.0, 1e-6);
    assert_near(summary_of(&texts, 0).spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 0.01);
    texts.swr1.data = NULL; // the direction alone: the caller's exponent
    texts.spread_s = 5.0;
    assert_near(summary_of(&texts, 0).from_deg, 144.0, 1e-6);
    assert_near(summary_of(&texts, 0).spread_deg, 33.08, 0.01);
    texts.swdir.data = NULL; // nothing
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 02 50 10.0 (0.100)\n"); // of another hour
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    texts.swdir = literal("41010.swdir", COMPANION ROW("20.0", "999.0", "90.0")); // from the nearest lower band
    assert_near(summary_of(&texts, 0).from_deg, 20.0, 1e-6);
}

static void noise_that_fits_no_distribution_is_clipped_and_renormalised(void **state) {
    (void)state;
    bolan_spectrum_texts texts = directional_texts();
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "0.10", "999.00"));
    texts.swr2 = literal("41010.swr2", COMPANION ROW("999.00", "1.00", "999.00"));
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    for (uint32_t i = 0; i < view.frequency_count * view.direction_count; i++) assert_true(view.density[i] >= 0.0);
    bolan_measured_spectrum_destroy(&spectrum);
    assert_near(summary_of(&texts, 0).m0, 0.15, 1e-9);
}

static void refuse(const char *data, bolan_log_id id, const char *part) {
    const bolan_spectrum_texts texts = texts_of(data);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, id, part);
}

static void what_is_wrong_is_named_with_its_line(void **state) {
    (void)state;
    refuse("YYYY MM DD hh", BOLAN_LOG_SPECTRUM_TRUNCATED, "41010.data_spec:1");
    refuse("YYYY MM\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "the header YYYY MM DD hh");
    refuse(HISTORY, BOLAN_LOG_SPECTRUM_TRUNCATED, "a row of densities");
    refuse(HISTORY "2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a value for every frequency");
    refuse(HISTORY "2000 01 01 00 1 2 3 4\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "41010.data_spec:2: expected the end of the line, found \"4\"");
    refuse(HISTORY "2000 13 01 00 1 2 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "a month 1 to 12, found \"13\"");
    refuse(HISTORY "2000 01 01 00 1 -2 3\n", BOLAN_LOG_SPECTRUM_NEGATIVE, "-2");
    refuse(HISTORY "2000 01 01 00 1 nan 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "found \"nan\"");
    refuse(HISTORY "2000 01 01 00 1 1e300 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "expected 0 to 1e+06");
    refuse(HISTORY "2000 01 01 00 0 0 999\n", BOLAN_LOG_SPECTRUM_NO_ENERGY, "2000-01-01T00:00Z");
    refuse("YYYY MM DD hh .2 .1\n2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "41010.data_spec:1: expected an ascending frequency");
    refuse("YYYY MM DD hh .2\n2000 01 01 00 1\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "a second frequency");
    refuse(REAL_TIME "2020 06 08 03 50 0.2 1.0 0.1\n", BOLAN_LOG_SPECTRUM_SYNTAX, "such as (0.033), found \"0.1\"");
    refuse(REAL_TIME "2020 06 08 03 50 0.2 1.0\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "such as (0.033)");
    refuse(REAL_TIME "2020 06 08 03 50 0.2 1.0 (\n", BOLAN_LOG_SPECTRUM_SYNTAX, "such as (0.033)");
    refuse(REAL_TIME "2020 06 08\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "an hour");
    const bolan_spectrum_texts whole = texts_of(REAL_TIME REAL_ROW);
    assert_refused(&whole, 1, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX, "expected 0 to 0");
    bolan_spectrum_texts texts = directional_texts();
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "7.30", "999.00"));
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                   "41010.swr1:2: 7.3 at 0.1 Hz; expected 0 to 1");
    texts = directional_texts();
    texts.swdir = literal("41010.swdir", "");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_TRUNCATED, "41010.swdir:1");
}

static void a_thousand_and_one_frequencies_are_too_many(void **state) {
    (void)state;
    enum { SIZE = 40000 };
    char *data = malloc(SIZE);
    int n = snprintf(data, SIZE, REAL_TIME "2020 06 08 03 50 0.2");
    for (int i = 1; i <= 1001; i++) n += snprintf(data + n, (size_t)(SIZE - n), " 1.0 (%.3f)", i * 0.001);
    refuse(data, BOLAN_LOG_SPECTRUM_SYNTAX, "after 1000 frequencies");
    free(data);
}

static void every_truncation_of_the_only_row_is_refused(void **state) {
    (void)state;
    static const char whole[] = HISTORY "2000 01 01 00 1.00 2.00 3.00";
    for (size_t size = 0; size + 4 < sizeof whole - 1; size++) {
        char *copy = malloc(size ? size : 1);
        memcpy(copy, whole, size);
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){"cut.txt", copy, size};
        bolan_measured_spectrum *spectrum;
        assert_int_equal(bolan_measured_spectrum_parse(&texts, 0, &spectrum), BOLAN_ERROR_FORMAT);
        assert_null(spectrum);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_history_table_takes_its_direction_from_the_caller),
        cmocka_unit_test(old_years_have_two_digits_and_new_tables_have_minutes),
        cmocka_unit_test(record_zero_is_the_earliest_in_either_order),
        cmocka_unit_test(reported_direction_and_spread_survive),
        cmocka_unit_test(history_ratios_are_hundredths),
        cmocka_unit_test(missing_direction_tables_fall_back_step_by_step),
        cmocka_unit_test(noise_that_fits_no_distribution_is_clipped_and_renormalised),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(a_thousand_and_one_frequencies_are_too_many),
        cmocka_unit_test(every_truncation_of_the_only_row_is_refused),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
