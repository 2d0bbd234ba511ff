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
    const bolan_spectrum_options options = record_number(record);
    return summary_with(texts, &options);
}

static bolan_spectrum_options from_and_spread(double from_deg, double spread_s) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.from_deg = from_deg;
    options.spread_s = spread_s;
    return options;
}

static void a_history_table_takes_its_direction_from_the_caller(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 .00 2.00 .00\n2000 01 01 01 .00 .00 3.00\n");
    bolan_spectrum_options options = from_and_spread(200.0, 50.0);
    bolan_sea_summary s = summary_with(&texts, &options);
    assert_int_equal(warning_count, 0); // nothing stands in
    assert_near(s.m0, 0.5 * (0.2 - 0.05) * 2.0, 1e-9);
    assert_near(s.tp, 10.0, 1e-9);
    assert_near(s.from_deg, 200.0, 1e-6);
    assert_near(s.spread_deg, 11.35, 0.01); // cos-2s, s = 50
    options.record = 1;
    s = summary_with(&texts, &options);
    assert_near(s.tp, 5.0, 1e-9);
    assert_near(s.from_deg, 200.0, 1e-6);
    assert_int_equal(warning_count, 0);
}

// sqrt(2 (1 - r1)) with r1 = s / (s + 1), as for every cos-2s.
static double spread_of(double s) { return bolan_degrees(sqrt(2.0 / (s + 1.0))); }

static void what_stands_in_for_directions_is_one_warning(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 0 2 0\n");
    const double none = (double)NAN;
    const struct {
        double from, spread, expected_from, expected_spread;
        const char *said;
    } cases[] = {
        {none, none, 270.0, 10.0,
         "the waves come from 270 degrees and cos-2s has the exponent 10; give from and spread"},
        {30.0, none, 30.0, 10.0, "beside it; cos-2s has the exponent 10; give spread to choose"},
        {-270.0, none, 90.0, 10.0, "cos-2s has the exponent 10; give spread to choose"},
        {none, 40.0, 270.0, 40.0, "beside it; the waves come from 270 degrees; give from to choose"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const bolan_spectrum_options options = from_and_spread(cases[i].from, cases[i].spread);
        const bolan_sea_summary s = summary_with(&texts, &options);
        assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, cases[i].said);
        assert_non_null(strstr(last_sentence, "2000-01-01T00:00Z has no table of directions"));
        assert_near(s.from_deg, cases[i].expected_from, 1e-6);
        assert_near(s.spread_deg, spread_of(cases[i].expected_spread), 0.02); // bins of 5 degrees
    }
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

static void record_zero_is_the_earliest_in_any_order(void **state) {
    (void)state;
    const bolan_spectrum_texts newest_first =
        texts_of(REAL_TIME REAL_ROW "2020 06 08 02 50 9.999 1.0 (0.05) 0.0 (0.1)\n");
    assert_near(summary_of(&newest_first, 0).tp, 20.0, 1e-9);
    assert_near(summary_of(&newest_first, 1).tp, 10.0, 1e-9);
    const bolan_spectrum_texts mixed =
        texts_of(HISTORY "2000 01 05 00 0 1 0\n1999 12 31 23 1 0 0\n2000 01 05 01 0 0 1\n2000 01 04 23 0 0 2\n");
    const double periods[4] = {20.0, 5.0, 10.0, 5.0};
    for (uint32_t i = 0; i < 4; i++) assert_near(summary_of(&mixed, i).tp, periods[i], 1e-9);
    bolan_measured_spectrum *spectrum = parse(&mixed, 1);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2000-01-04T23:00Z");
    assert_int_equal(bolan_measured_spectrum_view(spectrum).record_count, 4);
    bolan_measured_spectrum_destroy(&spectrum);
    // Before 1970, and two rows of one time, which stay as in the text.
    const bolan_spectrum_texts old =
        texts_of(HISTORY "1969 01 01 00 0 0 1\n1968 01 01 00 0 1 0\n1971 01 01 00 0 1 0\n1968 01 01 00 1 0 0\n");
    const double old_periods[4] = {10.0, 20.0, 5.0, 10.0};
    for (uint32_t i = 0; i < 4; i++) assert_near(summary_of(&old, i).tp, old_periods[i], 1e-9);
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
    assert_int_equal(warning_count, 0);
    texts.swr1.data = NULL; // the direction alone: the caller's exponent
    const bolan_spectrum_options options = from_and_spread((double)NAN, 5.0);
    assert_near(summary_with(&texts, &options).from_deg, 144.0, 1e-6);
    assert_near(summary_with(&texts, &options).spread_deg, 33.08, 0.01);
    assert_int_equal(warning_count, 0);
    assert_near(summary_of(&texts, 0).spread_deg, spread_of(10.0), 0.02);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has directions but no spreads; cos-2s has the exponent 10");
    texts.swdir.data = NULL; // nothing
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has no table of directions beside it");
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 02 49 10.0 (0.100)\n"); // 61 minutes earlier
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "2020-06-08T03:50Z has no row within an hour in 41010.swdir");
    texts.swdir = literal("41010.swdir", COMPANION); // no row at all
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has no row within an hour in 41010.swdir");
    texts.swdir = literal("41010.swdir", COMPANION ROW("999.0", "999.0", "999.0"));
    assert_near(summary_of(&texts, 0).from_deg, 270.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has only 999 in 41010.swdir");
    // A spread without a direction is still a spread.
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "0.82", "999.00"));
    assert_near(summary_of(&texts, 0).spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 0.01);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "the waves come from 270 degrees; give from to choose");
}

// Energy of 0.1 m2 in the first band, 0.2 in the second: each band's direction is seen in the mean of all.
#define THREE_BANDS "2020 06 08 03 50 9.999 4.0 (0.050) 2.666666666666667 (0.100) 0.000 (0.200)\n"

static void bands_without_a_direction_take_the_nearest(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of(REAL_TIME THREE_BANDS);
    bolan_spectrum_options options = from_and_spread((double)NAN, 200.0);
    // Above the last that has one: the nearest lower band's.
    texts.swdir = literal("41010.swdir", COMPANION ROW("20.0", "999.0", "90.0"));
    assert_near(summary_with(&texts, &options).from_deg, 20.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "66.7 % of the energy");
    // Below the first that has one: that first one's, not the caller's.
    texts.swdir = literal("41010.swdir", COMPANION ROW("999.0", "60.0", "90.0"));
    assert_near(summary_with(&texts, &options).from_deg, 60.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "33.3 % of the energy");
    assert_near(summary_with(&texts, &options).spread_deg, spread_of(200.0), 0.1);
    // A band without energy needs none.
    texts.swdir = literal("41010.swdir", COMPANION ROW("60.0", "60.0", "999.0"));
    assert_near(summary_with(&texts, &options).from_deg, 60.0, 1e-6);
    assert_int_equal(warning_count, 0);
    // Spreads likewise.
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "0.82", "999.00"));
    options.spread_s = (double)NAN;
    assert_near(summary_with(&texts, &options).spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 0.01);
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "33.3 % of the energy");
}

static void directions_of_another_time_within_the_hour_stand_in(void **state) {
    (void)state;
    static const char rows[] = "2020 06 08 04 45 45.0 (0.100)\n2020 06 08 03 00 10.0 (0.100)\n"
                               "2020 06 08 02 50 99.0 (0.100)\n";
    bolan_spectrum_texts texts = texts_of(REAL_TIME REAL_ROW);
    char table[512];
    snprintf(table, sizeof table, "%s%s", COMPANION, rows);
    texts.swdir = literal("41010.swdir", table);
    const bolan_spectrum_options options = from_and_spread((double)NAN, 5.0);
    assert_near(summary_with(&texts, &options).from_deg, 10.0, 1e-6); // 50 minutes before, not 55 after
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME,
                  "41010.swdir: there is no row of 2020-06-08T03:50Z; the nearest, of 2020-06-08T03:00Z, is taken");
    // The ratios are of the directions' time, also where the density's own time is there.
    texts.swr1 = literal("41010.swr1", COMPANION "2020 06 08 03 50 0.1 (0.100)\n2020 06 08 03 00 0.82 (0.100)\n");
    const bolan_spectrum_options plain = bolan_spectrum_options_default();
    assert_near(summary_with(&texts, &plain).spread_deg, bolan_degrees(sqrt(2.0 * (1.0 - 0.82))), 0.01);
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME, "41010.swdir");
    // Of two that are as near, the first in the text.
    texts.swr1.data = NULL;
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 04 40 45.0 (0.100)\n2020 06 08 03 00 10.0 (0.100)\n");
    assert_near(summary_with(&texts, &options).from_deg, 45.0, 1e-6);
    // A ratio of another time than the direction's is none.
    texts.swdir = literal("41010.swdir", COMPANION ROW("999.0", "144.0", "999.0"));
    texts.swr1 = literal("41010.swr1", COMPANION "2020 06 08 03 20 0.3 (0.100)\n");
    assert_near(summary_with(&texts, &plain).spread_deg, spread_of(10.0), 0.02);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has directions but no spreads");
}

static void options_that_the_text_does_not_need_are_said(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = directional_texts();
    bolan_spectrum_options options = from_and_spread(10.0, (double)NAN);
    assert_near(summary_with(&texts, &options).from_deg, 144.0, 1e-3);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "41010.data_spec: has directions of its own; from is not used");
    options = from_and_spread((double)NAN, 3.0);
    summary_with(&texts, &options);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "has spreads of its own; spread is not used");
    options = from_and_spread(10.0, 3.0);
    summary_with(&texts, &options);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "from and spread are not used");
    bolan_spectrum_texts no_spread = texts;
    no_spread.swr1.data = NULL; // only one of the two is of use
    summary_with(&no_spread, &options);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "has directions of its own; from is not used");
    options = bolan_spectrum_options_default();
    options.location = 1;
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_LOCATION, "of one buoy");
}

// 1 m2/Hz at 0.1 Hz, 4 at 0.3: the gap at 0.15 is 1.75, by a quarter of the way. Trapezoid rule.
static void missing_densities_are_interpolated_and_said(void **state) {
    (void)state;
    const bolan_spectrum_options options = from_and_spread(0.0, 5.0);
    bolan_spectrum_texts texts = texts_of("YYYY MM DD hh .10 .15 .30\n2000 01 01 00 1 999 4.5\n");
    const double middle = 1.0 + 0.25 * 3.5;
    const double m0 = 1.0 * 0.025 + middle * 0.1 + 4.5 * 0.075;
    assert_near(summary_with(&texts, &options).m0, m0, 1e-9);
    char share[64];
    snprintf(share, sizeof share, "1 of the 3 densities of the record of 2000-01-01T00:00Z");
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, share);
    snprintf(share, sizeof share, "interpolated, %.1f %% of the energy", 100.0 * middle * 0.1 / m0);
    assert_non_null(strstr(last_sentence, share));
    // Two in a row, and those at the ends, which have nothing on one side.
    texts = texts_of("YYYY MM DD hh .10 .20 .30 .40 .50\n2000 01 01 00 2.5 999 999 1 999\n");
    assert_near(summary_with(&texts, &options).m0, 2.5 * 0.05 + 2.0 * 0.1 + 1.5 * 0.1 + 1.0 * 0.1, 1e-9);
    texts = texts_of("YYYY MM DD hh .10 .20 .30\n2000 01 01 00 999 1.5 2\n");
    assert_near(summary_with(&texts, &options).m0, 1.5 * 0.1 + 2.0 * 0.05, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "interpolated, 0.0 % of the energy");
    texts = texts_of("YYYY MM DD hh .10 .20 .30 .40\n2000 01 01 00 9.5 .5 999 2.5\n"); // the nearest on each side
    assert_near(summary_with(&texts, &options).m0, 9.5 * 0.05 + 0.5 * 0.1 + 1.5 * 0.1 + 2.5 * 0.05, 1e-9);
    texts = texts_of("YYYY MM DD hh .10 .20 .30\n2000 01 01 00 999 999 999\n");
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY, "marked as missing");
    texts = texts_of("YYYY MM DD hh .10 .20 .30\n2000 01 01 00 0 0 0\n"); // a calm
    assert_near(summary_with(&texts, &options).hs, 0.0, 0.0);
    assert_int_equal(warning_count, 0);
}

// The moments of one band, as they come out of the grid: lengths and angles (FROM).
typedef struct moments {
    double r1, alpha1, r2, alpha2;
} moments;

static moments moments_of(const bolan_spectrum_texts *texts, uint32_t band) {
    bolan_measured_spectrum *spectrum = parse(texts, 0);
    const bolan_measured_view v = bolan_measured_spectrum_view(spectrum);
    double sum = 0.0, c[2] = {0.0, 0.0}, s[2] = {0.0, 0.0};
    for (uint32_t j = 0; j < v.direction_count; j++) {
        const double d = v.density[band * v.direction_count + j];
        sum += d;
        for (int n = 0; n < 2; n++) c[n] += d * cos((n + 1) * v.theta[j]), s[n] += d * sin((n + 1) * v.theta[j]);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    const moments m = {hypot(c[0], s[0]) / sum, bolan_math_to_compass_from(atan2(s[0], c[0])), hypot(c[1], s[1]) / sum,
                       bolan_math_to_compass_from(0.5 * atan2(s[1], c[1]))};
    return m;
}

static void all_four_moments_survive_and_the_second_lies_about_the_first(void **state) {
    (void)state;
    bolan_spectrum_texts texts = directional_texts();
    moments m = moments_of(&texts, 1);
    assert_near(m.r1, 0.82, 1e-6); // the fit of maximum entropy stops at 1e-7
    assert_near(m.alpha1, 144.0, 1e-4);
    assert_near(m.r2, 0.57, 1e-6);
    assert_near(remainder(m.alpha2 - 150.0, 180.0), 0.0, 1e-4);
    // Without a first direction the second says nothing: cos-2s by r1, whose r2 is s (s - 1) / ((s + 1) (s + 2)).
    texts.swdir = literal("41010.swdir", COMPANION ROW("999.0", "999.0", "999.0"));
    const double s = 0.82 / 0.18;
    m = moments_of(&texts, 1);
    assert_near(m.alpha1, 270.0, 1e-6);
    assert_near(m.r2, s * (s - 1.0) / ((s + 1.0) * (s + 2.0)), 1e-4); // bins of 5 degrees
    // Waves from nearly everywhere: a small r1 is a spread too.
    texts.swr1 = literal("41010.swr1", COMPANION ROW("999.00", "0.10", "999.00"));
    assert_near(moments_of(&texts, 1).r1, 0.10, 0.01); // the cusp opposite the mean falls between bins
}

static void bands_are_matched_by_their_rounded_frequencies(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of("YYYY MM DD hh mm .0375 .1 .2\n2020 06 08 03 50 9.5 .0 .0\n");
    const bolan_spectrum_options options = from_and_spread((double)NAN, 5.0);
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 03 50 33.0 (0.038) 77.0 (0.100)\n");
    assert_near(summary_with(&texts, &options).from_deg, 33.0, 1e-6); // NDBC prints three decimals
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 03 50 33.0 (0.037) 77.0 (0.100)\n");
    assert_near(summary_with(&texts, &options).from_deg, 33.0, 1e-6);
    texts.swdir = literal("41010.swdir", COMPANION "2020 06 08 03 50 33.0 (0.0385) 77.0 (0.100)\n"); // another band
    assert_near(summary_with(&texts, &options).from_deg, 77.0, 1e-6);
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
    refuse("YYYY MM\n", BOLAN_LOG_SPECTRUM_TRUNCATED, "the header YYYY MM DD hh or #YY MM DD hh mm");
    refuse(HISTORY, BOLAN_LOG_SPECTRUM_TRUNCATED, "a row of densities");
    refuse(HISTORY "2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_TRUNCATED,
           "41010.data_spec:2: the line ends where a value for every frequency");
    refuse(HISTORY "2000 01 01 00 1 2 \r\n\n2000 01 01 01 1 2 3\n", BOLAN_LOG_SPECTRUM_TRUNCATED,
           "41010.data_spec:2: the line ends");
    refuse(HISTORY "2000 01 01 00 1 2 3 4\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "41010.data_spec:2: expected the end of the line, found \"4\"");
    refuse(HISTORY "2000 01 01 00 1 -2 3\n", BOLAN_LOG_SPECTRUM_NEGATIVE, "-2");
    refuse(HISTORY "2000 01 01 00 1 nan 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "found \"nan\"");
    refuse(HISTORY "2000 01 01 00 1.5 1e300 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "expected 0 to 1e+06");
    refuse(HISTORY "2000 01 01 00 .5 5000.5 3\n", BOLAN_LOG_SPECTRUM_IMPOSSIBLE, "expected at most 40 m");
    refuse("YYYY MM DD hh .2 .1\n2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "41010.data_spec:1: expected an ascending frequency");
    refuse("YYYY MM DD hh .2 11\n2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_SYNTAX, "0.001 to 10, found \"11\"");
    refuse("YYYY MM DD hh .0009 .1\n2000 01 01 00 1 2\n", BOLAN_LOG_SPECTRUM_SYNTAX, "found \".0009\"");
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
    static const char *const bad[] = {"-1.0", "361.0"};
    for (int i = 0; i < 2; i++) {
        char row[128];
        snprintf(row, sizeof row, COMPANION "2020 06 08 03 50 10.0 (0.050) %s (0.100)\n", bad[i]);
        texts = directional_texts();
        texts.swdir2 = literal("41010.swdir2", row);
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "expected 0 to 360 degrees");
    }
    texts = texts_of(HISTORY "2000 01 01 00 0 2 0\n");
    texts.swr1 = literal("swr1", HISTORY "2000 01 01 00 999 101 999\n");
    texts.swdir = literal("swdir", HISTORY "2000 01 01 00 999 10 999\n");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                   "swr1:2: 101 at 0.1 Hz; expected 0 to 100");
    texts = directional_texts();
    texts.swdir = literal("41010.swdir", "");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_TRUNCATED, "41010.swdir:1");
}

static void impossible_dates_are_refused(void **state) {
    (void)state;
    const struct {
        const char *date, *said;
    } dates[] = {{"2000 13 01 00", "a month 1 to 12, found \"13\""},
                 {"2000 00 01 00", "a month 1 to 12, found \"00\""},
                 {"2000 02 30 00", "a day 1 to 29 of that month, found \"30\""},
                 {"2001 02 29 00", "a day 1 to 28 of that month, found \"29\""},
                 {"1900 02 29 00", "a day 1 to 28 of that month"},
                 {"2000 04 31 00", "a day 1 to 30 of that month"},
                 {"2000 01 00 00", "a day 1 to 31 of that month, found \"00\""},
                 {"2000 01 01 24", "an hour 0 to 23, found \"24\""},
                 {"2000.5 01 01 00", "a whole year, found \"2000.5\""},
                 {"2000 01 1.5 00", "found \"1.5\""},
                 {"3000 01 01 00", "a whole year, found \"3000\""},
                 {"1066 01 01 00", "the year 1066"}};
    for (size_t i = 0; i < sizeof dates / sizeof *dates; i++) {
        char data[256];
        snprintf(data, sizeof data, "%s2000 01 01 00 1 2 3\n%s 1 2 3\n", HISTORY, dates[i].date);
        refuse(data, strstr(dates[i].said, "the year") ? BOLAN_LOG_SPECTRUM_DATE : BOLAN_LOG_SPECTRUM_SYNTAX,
               dates[i].said);
        assert_non_null(strstr(last_sentence, "41010.data_spec:3:"));
    }
    refuse("YYYY MM DD hh mm .1 .2\n2000 01 01 00 60 1 2\n", BOLAN_LOG_SPECTRUM_SYNTAX, "a minute 0 to 59, found");
    const bolan_spectrum_texts leap = texts_of(HISTORY "2000 02 29 23 1 2 3\n1996 02 29 00 1 2 3\n");
    bolan_measured_spectrum *spectrum = parse(&leap, 1);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2000-02-29T23:00Z");
    bolan_measured_spectrum_destroy(&spectrum);
}

// Tables of directions and ratios look like densities but for a word in the header, or a letter in the name.
static void other_tables_are_refused_by_name(void **state) {
    (void)state;
    static const char *const names[4] = {"alpha1", "alpha2", "r1", "r2"};
    static const char *const said[4] = {"alpha1, the mean direction", "alpha2, the principal direction",
                                        "r1, the first", "r2, the second"};
    for (int i = 0; i < 4; i++) {
        char data[256], name[32];
        snprintf(data, sizeof data, "#YY  MM DD hh mm %s_1 (freq_1) ... >\n2020 06 08 03 50 0.5 (0.1) 0.6 (0.2)\n",
                 names[i]);
        refuse(data, BOLAN_LOG_SPECTRUM_WRONG_TABLE, said[i]);
        assert_non_null(strstr(last_sentence, "41010.data_spec:1:"));
        snprintf(name, sizeof name, "data/41004%c2018part.txt", "dijk"[i]);
        bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 85 86 87\n");
        texts.density.name = name;
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, said[i]);
        name[10] = "DIJK"[i];
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, said[i]);
    }
    // Whole numbers that would be 14 m of sea, under no name; the same with decimals is a sea.
    refuse(HISTORY "2000 01 01 00 85 86 87\n", BOLAN_LOG_SPECTRUM_WRONG_TABLE,
           "41010.data_spec:2: whole numbers alone");
    bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 85.1 86.2 87.3\n");
    assert_ratio(summary_of(&texts, 0).hs, 4.0 * sqrt(0.5 * (0.05 * (85.1 + 86.2) + 0.1 * (86.2 + 87.3))), 1e-9);
    // A name and a sea of 14 m together tell, also with decimals; five digits are no year.
    texts.density.name = "41004d2018.txt";
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, said[0]);
    texts.density.name = "41004d20181.txt";
    assert_true(summary_of(&texts, 0).hs > 10.0);
    // Decimals and a small sea are densities, whatever the name.
    texts = texts_of(HISTORY "2000 01 01 00 0.85 0.86 0.87\n");
    texts.density.name = "sound2018.txt";
    assert_true(summary_of(&texts, 0).hs > 1.0);
    refuse("#YY  MM DD hh mm WVHT  SwH  SwP\n2020 06 08 03 50 0.9 0.4 9.1\n", BOLAN_LOG_SPECTRUM_WRONG_TABLE,
           "41010.data_spec:1: this is NDBC's table of wave heights (WVHT)");
    refuse("#YY  MM DD hh mm WDIR WSPD GST  WVHT   DPD\n", BOLAN_LOG_SPECTRUM_WRONG_TABLE, "(WVHT)");
    refuse("#YY  MM DD hh mm WDIR WSPD\n", BOLAN_LOG_SPECTRUM_SYNTAX, "spec_1 (freq_1) (real time), found \"WDIR\"");
    texts = directional_texts();
    texts.swdir = literal("41010.swdir", "#YY MM DD hh mm r1_1 (freq_1)\n" ROW("0.1", "0.2", "0.3"));
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, "41010.swdir:1");
    texts = directional_texts();
    texts.swr2 = literal("41010.swr2", REAL_TIME REAL_ROW);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_WRONG_TABLE, "expected r1 or r2");
}

// A row that is not asked for may be short, but not of another date.
static void a_row_that_is_not_asked_for_spoils_nothing(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 01 00 1\n2000 01 01 01 0 x -3\n2000 01 01 02 0 1 0\n");
    assert_near(summary_of(&texts, 2).tp, 10.0, 1e-9);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_TRUNCATED, "41010.data_spec:2: the line ends");
    assert_refused(&texts, 1, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "41010.data_spec:3");
}

static void a_record_can_be_asked_for_by_its_date(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HISTORY "2000 01 02 00 0 1 0\n2000 01 01 00 1 0 0\n");
    bolan_spectrum_options options = from_and_spread(0.0, 5.0);
    options.record = 77; // the date goes over it
    strcpy(options.time, "2000-01-02T00:00Z");
    assert_near(summary_with(&texts, &options).tp, 10.0, 1e-9);
    assert_int_equal(warning_count, 0);
    strcpy(options.time, "2000-01-01");
    assert_near(summary_with(&texts, &options).tp, 20.0, 1e-9);
    assert_int_equal(warning_count, 0);
    strcpy(options.time, "2000-01-01T23:00:00");
    assert_near(summary_with(&texts, &options).tp, 10.0, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME,
                  "there is no record of 2000-01-01T23:00:00; the nearest, of 2000-01-02T00:00Z, is taken");
    strcpy(options.time, "2000-01-01T00:30");
    assert_near(summary_with(&texts, &options).tp, 20.0, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME, "the nearest, of 2000-01-01T00:00Z, is taken");
    strcpy(options.time, "2000-01-01T22:59:59");
    assert_refused_with(
        &texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX,
        "2 records, from 2000-01-01T00:00Z to 2000-01-02T00:00Z (the nearest is of 2000-01-02T00:00Z)");
    strcpy(options.time, "2000-02-30");
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "time is 2000-02-30");
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

static void companions_have_the_names_that_ndbc_gives_them(void **state) {
    (void)state;
    static const struct {
        const char *density, *tables[BOLAN_SPECTRUM_COMPANIONS];
    } cases[] = {
        {"a/46042.data_spec", {"a/46042.swdir", "a/46042.swdir2", "a/46042.swr1", "a/46042.swr2"}},
        {"b/41004w2018.txt", {"b/41004d2018.txt", "b/41004i2018.txt", "b/41004j2018.txt", "b/41004k2018.txt"}},
        {"51000W2001", {"51000D2001", "51000I2001", "51000J2001", "51000K2001"}},
    };
    char name[64];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (uint32_t t = 0; t < BOLAN_SPECTRUM_COMPANIONS; t++) {
            assert_true(bolan_spectrum_companion(cases[i].density, t, name, sizeof name));
            assert_string_equal(name, cases[i].tables[t]);
        }
    // A direction's own file, a name of another kind, and room for all but the last byte.
    assert_false(bolan_spectrum_companion("41004d2018.txt", 0, name, sizeof name));
    assert_false(bolan_spectrum_companion("record.spec", 0, name, sizeof name));
    assert_string_equal(name, "");
    assert_true(bolan_spectrum_companion("1.data_spec", 1, name, sizeof "1.swdir2"));
    assert_false(bolan_spectrum_companion("1.data_spec", 1, name, sizeof "1.swdir2" - 1));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(companions_have_the_names_that_ndbc_gives_them),
        cmocka_unit_test(a_history_table_takes_its_direction_from_the_caller),
        cmocka_unit_test(old_years_have_two_digits_and_new_tables_have_minutes),
        cmocka_unit_test(record_zero_is_the_earliest_in_any_order),
        cmocka_unit_test(reported_direction_and_spread_survive),
        cmocka_unit_test(history_ratios_are_hundredths),
        cmocka_unit_test(missing_direction_tables_fall_back_step_by_step),
        cmocka_unit_test(what_stands_in_for_directions_is_one_warning),
        cmocka_unit_test(bands_without_a_direction_take_the_nearest),
        cmocka_unit_test(directions_of_another_time_within_the_hour_stand_in),
        cmocka_unit_test(options_that_the_text_does_not_need_are_said),
        cmocka_unit_test(missing_densities_are_interpolated_and_said),
        cmocka_unit_test(impossible_dates_are_refused),
        cmocka_unit_test(other_tables_are_refused_by_name),
        cmocka_unit_test(a_row_that_is_not_asked_for_spoils_nothing),
        cmocka_unit_test(a_record_can_be_asked_for_by_its_date),
        cmocka_unit_test(all_four_moments_survive_and_the_second_lies_about_the_first),
        cmocka_unit_test(bands_are_matched_by_their_rounded_frequencies),
        cmocka_unit_test(noise_that_fits_no_distribution_is_clipped_and_renormalised),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(a_thousand_and_one_frequencies_are_too_many),
        cmocka_unit_test(every_truncation_of_the_only_row_is_refused),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
