// SPDX-License-Identifier: MIT
// What all formats of spectra share: the choice of a record between two, and the list of what a file holds.
#include "bolan/waves.h"
#include "spectrum_support.h"

#define SWAN_HEAD                                                                                                  \
    "SWAN 1\nTIME\n1\nLONLAT\n2\n10 50\n11 50\nAFREQ\n3\n.1\n.2\n.3\nNDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\n" \
    "m2/Hz/degr\n-99\n"
// All energy from the north at 0.1 Hz, or from the east at 0.2 Hz: 4 and 1 times 90 degrees.
#define NORTH "FACTOR\n1\n4 0 0 0\n0 0 0 0\n0 0 0 0\n"
#define EAST "FACTOR\n1\n0 0 0 0\n0 1 0 0\n0 0 0 0\n"
#define SIX "20200101.060000\n"
#define TEN "20200101.100000\n"

static bolan_spectrum_texts swan(const char *data) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("sea.spec", data);
    return texts;
}

static bolan_spectrum_options between(const char *time) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    assert_true(bolan_spectrum_options_set_record(&options, time));
    options.location = 1;
    options.interpolate = true;
    return options;
}

static void a_time_between_two_records_is_interpolated(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = swan(SWAN_HEAD TEN EAST EAST SIX NORTH NORTH); // in any order
    bolan_spectrum_options options = between("2020-01-01T07:00");
    bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_string_equal(view.time, "2020-01-01T07:00:00");
    assert_int_equal(warning_count, 0);
    assert_int_equal(last_log_id, BOLAN_LOG_SPECTRUM_NEAREST_TIME); // information
    assert_non_null(strstr(last_sentence, "between the records of 2020-01-01T06:00:00 and 2020-01-01T10:00:00"));
    double first = 0.0, second = 0.0; // of all directions, per hertz and radian over 2 pi
    for (uint32_t j = 0; j < view.direction_count; j++) {
        first += view.density[j];
        second += view.density[view.direction_count + j];
    }
    assert_near(first, 0.75 * 4.0 * 180.0 / BOLAN_PI / (2.0 * BOLAN_PI), 1e-12);
    assert_near(second, 0.25 * 1.0 * 180.0 / BOLAN_PI / (2.0 * BOLAN_PI), 1e-12);
    bolan_measured_spectrum_destroy(&spectrum);
    // A quarter of the way from the west's 4 x 0.05 Hz to 1 x 0.1 Hz, times 90 degrees.
    const double m0 = 90.0 * (0.75 * 4.0 * 0.05 + 0.25 * 1.0 * 0.1);
    assert_near(summary_with(&texts, &options).m0, m0, 1e-10);
    options = between("2020-01-01T10:00"); // a record's own time
    assert_near(summary_with(&texts, &options).m0, 90.0 * 0.1, 1e-10);
    options = between("2020-01-01T10:30"); // after the last: the nearest
    assert_near(summary_with(&texts, &options).m0, 90.0 * 0.1, 1e-10);
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME, "the nearest, of 2020-01-01T10:00:00, is taken");
    options = between("2020-01-01T06:30");
    options.interpolate = false;
    assert_near(summary_with(&texts, &options).m0, 90.0 * 4.0 * 0.05, 1e-10);
    assert_warned(BOLAN_LOG_SPECTRUM_NEAREST_TIME, "the nearest, of 2020-01-01T06:00:00, is taken");
    options = between("2020-01-01T08:00");
    options.interpolate = false; // two hours from both
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX, "2020-01-01T08:00");
}

// The tail above the last frequency is that of the mixture: its level is linear, as all densities are.
static void the_tail_of_an_interpolated_sea_is_linear_too(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = swan(SWAN_HEAD SIX "FACTOR\n1\n4 0 0 0\n0 0 0 0\n3 0 0 0\n" NORTH TEN
                                                          "FACTOR\n1\n0 0 0 0\n0 0 0 0\n1 0 0 0\n" EAST);
    double level[3];
    static const char *const times[] = {"2020-01-01T06:00", "2020-01-01T08:00", "2020-01-01T10:00"};
    for (int i = 0; i < 3; i++) {
        const bolan_spectrum_options options = between(times[i]);
        bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
        const bolan_sea_state sea_state = sea_of(spectrum);
        level[i] = bolan_sea_state_wavenumber_density(&sea_state, 0.0, -1.0); // w = 3.1, above 0.3 Hz; from the north
        bolan_measured_spectrum_destroy(&spectrum);
    }
    assert_ratio(level[0], 3.0 * level[2], 1e-9);
    assert_ratio(level[1], 2.0 * level[2], 1e-9);
}

static void records_of_other_frequencies_are_not_interpolated(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("41010.data_spec", "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n"
                                               "2020 06 08 04 50 0.2 1.5 (0.1) 2.5 (0.25)\n"
                                               "2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.2)\n");
    bolan_spectrum_options options = between("2020-06-08T04:00");
    options.location = 0;
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "the records of 2020-06-08T03:50Z and 2020-06-08T04:50Z have different frequencies");
}

// Of one seed, the sea of a time between two records is between both seas: phases are kept.
static void a_sea_changes_steadily_between_two_records(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = swan(SWAN_HEAD SIX "FACTOR\n.01\n16 1 0 0\n9 1 0 0\n4 1 0 0\n" NORTH TEN
                                                          "FACTOR\n.01\n1 16 0 0\n1 9 0 0\n1 4 0 0\n" NORTH);
    static const char *const times[] = {"2020-01-01T06:00", "2020-01-01T06:05", "2020-01-01T10:00"};
    enum { POINTS = 60 };
    static double height[3][POINTS];
    for (int i = 0; i < 3; i++) {
        const bolan_spectrum_options options = between(times[i]);
        bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.sea_state = sea_of(spectrum);
        desc.resolution = 64;
        bolan_sea *sea = NULL;
        assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
        bolan_measured_spectrum_destroy(&spectrum);
        for (int p = 0; p < POINTS; p++) height[i][p] = bolan_sea_sample_direct(sea, 37.0 * p, 11.0 * p, 100.0).height;
        bolan_sea_destroy(&sea);
    }
    double change = 0.0, whole = 0.0, power = 0.0;
    for (int p = 0; p < POINTS; p++) {
        power += height[0][p] * height[0][p];
        change += (height[1][p] - height[0][p]) * (height[1][p] - height[0][p]);
        whole += (height[2][p] - height[0][p]) * (height[2][p] - height[0][p]);
    }
    assert_true(whole > 0.3 * power);    // the sea of four hours later is another one
    assert_true(change < 0.005 * power); // that of five minutes later is not
}

static void contents_list_records_and_places(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = swan(SWAN_HEAD TEN EAST "NODATA\n" SIX NORTH NORTH);
    bolan_spectrum_contents *c = NULL;
    const size_t before = bolan_memory_in_use();
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_OK);
    assert_string_equal(c->format, "swan");
    assert_int_equal(c->record_count, 2);
    assert_string_equal(c->records[0].time, "2020-01-01T06:00:00");
    assert_near(c->records[1].seconds - c->records[0].seconds, 4.0 * 3600.0, 0.0);
    assert_near(c->records[0].seconds, 1577858400.0, 0.0); // date -u -d 2020-01-01T06:00 +%s
    assert_int_equal(c->place_count, 2);
    assert_true(c->spherical);
    assert_near(c->places[1].x, 11.0, 0.0);
    assert_near(c->places[1].y, 50.0, 0.0);
    assert_int_equal(c->frequency_count, 3);
    assert_near(c->lowest_hertz, 0.1, 1e-12);
    assert_near(c->highest_hertz, 0.3, 1e-12);
    assert_int_equal(c->direction_count, 4);
    assert_int_equal(c->read_count, 4);
    assert_int_equal(c->unreadable_count, 1);
    assert_near(c->hs_max, 4.0 * sqrt(90.0 * 4.0 * 0.05), 1e-9);
    assert_near(c->hs_min, 4.0 * sqrt(90.0 * 1.0 * 0.1), 1e-9);
    assert_near(c->tp_min, 5.0, 1e-9);
    assert_near(c->tp_max, 10.0, 1e-9);
    bolan_spectrum_contents_destroy(&c);
    assert_null(c);
    bolan_spectrum_contents_destroy(&c);
    assert_int_equal(bolan_memory_in_use(), before);
}

static void contents_of_what_cannot_be_read_are_refused_in_one_sentence(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = swan(SWAN_HEAD TEN "NODATA\nNODATA\n");
    bolan_spectrum_contents *c = NULL;
    last_log_id = (bolan_log_id)0;
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_ERROR_FORMAT);
    assert_null(c);
    assert_int_equal(last_log_id, BOLAN_LOG_SPECTRUM_NO_ENERGY);
    const bolan_spectrum_texts other = swan("hello");
    assert_int_equal(bolan_spectrum_contents_parse(&other, &c), BOLAN_ERROR_FORMAT);
    assert_int_equal(last_log_id, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT);
    assert_int_equal(bolan_memory_in_use(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_time_between_two_records_is_interpolated),
        cmocka_unit_test(the_tail_of_an_interpolated_sea_is_linear_too),
        cmocka_unit_test(records_of_other_frequencies_are_not_interpolated),
        cmocka_unit_test(a_sea_changes_steadily_between_two_records),
        cmocka_unit_test(contents_list_records_and_places),
        cmocka_unit_test(contents_of_what_cannot_be_read_are_refused_in_one_sentence),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
