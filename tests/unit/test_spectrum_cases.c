// SPDX-License-Identifier: MIT
// Whole files that have been read wrongly before, each with its right answer. Heights, periods and directions were
// computed from the same texts by other means: the trapezoid rule in frequency and over the circle, all to the digits
// given.
#include "spectrum_support.h"

static bolan_spectrum_texts texts_of(const char *name) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text(name);
    return texts;
}

static bolan_spectrum_options location(uint32_t number) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.location = number;
    return options;
}

static void a_dry_first_point_names_the_wet_ones(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("firstdry.spec");
    assert_refused(
        &texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
        "location 1 of 3, at 1, 1, has no data (NODATA) at 2024-01-01T00:00:00; 2 of the 3 have energy: 2, 3;");
    bolan_spectrum_options options = location(2);
    bolan_sea_summary s = summary_with(&texts, &options);
    assert_near(s.hs, 1.9890, 5e-5);
    assert_near(s.tm02, 6.0454, 5e-5);
    assert_near(s.from_deg, 270.0, 5e-3);
    options = location(3);
    s = summary_with(&texts, &options);
    assert_near(s.hs, 3.9955, 5e-5);
    assert_near(s.from_deg, 200.0, 5e-3);
    assert_near(s.spread_deg, 31.50, 5e-3);
    assert_int_equal(warning_count, 0);
    release_texts(&texts);
}

static void fortran_exponents_do_not_spoil_a_file(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("fexp.spec");
    bolan_spectrum_options options = record_number(0);
    assert_near(summary_with(&texts, &options).hs, 1.9890, 5e-5);
    options.record = 1; // 0.67027118-104 times whole numbers: no sea that one could see
    const double hs = summary_with(&texts, &options).hs;
    assert_true(hs > 0.0 && hs < 1e-40);
    assert_int_equal(warning_count, 0);
    release_texts(&texts);
}

static void zero_is_a_calm(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("zero.spec");
    const bolan_spectrum_options options = record_number(0);
    assert_near(summary_with(&texts, &options).hs, 0.0, 0.0);
    assert_int_equal(warning_count, 0);
    release_texts(&texts);
}

static void both_ends_of_the_circle_are_one_direction(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("wrap.spec");
    const bolan_spectrum_options options = record_number(0);
    const bolan_sea_summary s = summary_with(&texts, &options);
    assert_near(s.hs, 2.0165, 5e-5);
    assert_near(s.from_deg, 270.0, 5e-3);
    assert_near(s.spread_deg, 31.50, 5e-3);
    assert_int_equal(warning_count, 0);
    release_texts(&texts);
}

static void record_zero_is_the_earliest(void **state) {
    (void)state;
    bolan_spectrum_texts swan = texts_of("s_desc2.spec"), ndbc = texts_of("h_unsorted_dates.txt");
    bolan_measured_spectrum *spectrum = parse(&swan, 0);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2019-01-01T00:00:00");
    bolan_measured_spectrum_destroy(&spectrum);
    const bolan_spectrum_options options = record_number(0);
    assert_near(summary_with(&swan, &options).hs, 3.1292, 5e-5);
    assert_near(summary_with(&swan, &options).from_deg, 165.0, 5e-3);
    spectrum = parse(&ndbc, 0);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2000-01-01T00:00Z");
    bolan_measured_spectrum_destroy(&spectrum);
    assert_near(summary_with(&ndbc, &options).hs, 0.84853, 5e-6);
    const bolan_spectrum_options second = record_number(1);
    assert_near(summary_with(&ndbc, &second).hs, 0.83427, 5e-6);
    release_texts(&swan);
    release_texts(&ndbc);
}

static void odd_lists_of_directions_lose_no_energy(void **state) {
    (void)state;
    const bolan_spectrum_options options = record_number(0);
    bolan_spectrum_texts near = texts_of("s_near.spec"), gap = texts_of("s_gap.spec");
    assert_near(summary_with(&near, &options).hs, 2.8397, 5e-5);
    assert_int_equal(warning_count, 0);
    // The same density in every direction of the list: an even sea, once it is linear between them.
    assert_near(summary_with(&near, &options).spread_deg, bolan_degrees(sqrt(2.0)), 1e-3);
    assert_near(summary_with(&gap, &options).hs, 2.8397, 5e-5);
    assert_warned(BOLAN_LOG_SPECTRUM_GAP, "a gap of 140 degrees, between waves from 60 and from 200");
    assert_near(summary_with(&gap, &options).spread_deg, bolan_degrees(sqrt(2.0)), 1e-3);
    release_texts(&near);
    release_texts(&gap);
}

static void seas_that_cannot_be_are_refused(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("s_facbig.spec");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_IMPOSSIBLE,
                   "of 2020-01-01T00:00:00 has a significant wave height of 9895 m; expected at most 40 m");
    release_texts(&texts);
    texts = texts_of("s_ftiny.spec");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                   "s_ftiny.spec:9: expected an ascending frequency, 0.001 to 10 Hz, found \"1.1e-5\"");
    release_texts(&texts);
}

static void a_short_row_is_named_by_its_number(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("h_short.txt");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_TRUNCATED, "h_short.txt:2: the line ends");
    release_texts(&texts);
}

static void tables_of_directions_are_no_spectra(void **state) {
    (void)state;
    static const char *const names[] = {"41004d2018.txt",   "41004i2018.txt",    "41004j2018.txt",  "41004k2018.txt",
                                        "ndbc_41010.swdir", "ndbc_41010.swdir2", "ndbc_41010.swr1", "ndbc_41010.swr2"};
    static const char *const said[] = {"alpha1", "alpha2", "r1", "r2"};
    for (int i = 0; i < 8; i++) {
        bolan_spectrum_texts texts = texts_of(names[i]);
        char words[64];
        snprintf(words, sizeof words, "this is NDBC's table of %s,", said[i % 4]);
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, words);
        texts.density.name = "renamed.txt"; // the header of real-time tables says what they are
        if (i >= 4) assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, words);
        if (i < 4) assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, "whole numbers alone");
        release_texts(&texts);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dry_first_point_names_the_wet_ones),
        cmocka_unit_test(fortran_exponents_do_not_spoil_a_file),
        cmocka_unit_test(zero_is_a_calm),
        cmocka_unit_test(both_ends_of_the_circle_are_one_direction),
        cmocka_unit_test(record_zero_is_the_earliest),
        cmocka_unit_test(odd_lists_of_directions_lose_no_energy),
        cmocka_unit_test(seas_that_cannot_be_are_refused),
        cmocka_unit_test(a_short_row_is_named_by_its_number),
        cmocka_unit_test(tables_of_directions_are_no_spectra),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
