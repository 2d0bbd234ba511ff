// SPDX-License-Identifier: MIT
// The SWAN reader: directions, units, several times and locations, and every way a text can be wrong.
#include "spectrum_support.h"

#define HEAD "SWAN   1   Swan standard spectral file\n$ a remark\n"
#define TIMES "TIME   time-dependent data\n 1  time coding option\n"
#define PLACE "LONLAT  spherical\n 1  number of locations\n 174.67 -38.17\n"
#define FREQUENCIES "AFREQ  absolute\n 3  number of frequencies\n 0.1\n 0.2\n 0.3\n"
#define NAUTICAL "NDIR  nautical\n 4  number of directions\n 45\n 135\n 225\n 315\n"
#define CARTESIAN "CDIR  Cartesian\n 4  number of directions\n 45\n 135\n 225\n 315\n"
#define QUANTITY(name) "QUANT\n 1 number\n" name "  densities\n unit\n -99  exception value\n"
#define VADENS QUANTITY("VaDens")
#define BLOCK "FACTOR\n 0.5\n 0 0 0 0\n 2 0 0 0\n 0 0 0 0\n"
#define WHOLE HEAD TIMES PLACE FREQUENCIES NAUTICAL VADENS "20161011.013000  date\n" BLOCK

static bolan_spectrum_texts texts_of(const char *data) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = literal("sea.spec", data);
    return texts;
}

static bolan_sea_summary summary_of(const char *data, uint32_t record) {
    const bolan_spectrum_texts texts = texts_of(data);
    bolan_measured_spectrum *spectrum = parse(&texts, record);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    bolan_measured_spectrum_destroy(&spectrum);
    return summary;
}

// One bin of density 2 * 0.5 m2/Hz/degree, 90 degrees wide; the trapezoid rule gives its frequency 0.1 Hz: 9 m2.
static void the_variance_is_factor_times_number_times_bin(void **state) {
    (void)state;
    assert_near(summary_of(WHOLE, 0).m0, 9.0, 1e-9);
    assert_near(summary_of(WHOLE, 0).tp, 5.0, 1e-9);
    const bolan_sea_summary joules =
        summary_of(HEAD TIMES PLACE FREQUENCIES NAUTICAL QUANTITY("EnDens") "20161011.000000\n" BLOCK, 0);
    assert_near(joules.m0, 9.0 / (1025.0 * 9.81), 1e-9); // J/m2 is rho g times m2
}

static void nautical_directions_come_from_and_cartesian_ones_go_to(void **state) {
    (void)state;
    assert_near(summary_of(WHOLE, 0).from_deg, 45.0, 1e-9); // the first column: FROM the north-east
    // Cartesian 45 degrees goes to the north-east, so it comes from the south-west.
    assert_near(summary_of(HEAD TIMES PLACE FREQUENCIES CARTESIAN VADENS "20161011.000000\n" BLOCK, 0).from_deg, 225.0,
                1e-9);
}

static void the_view_is_ascending_in_mathematical_angle(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(WHOLE);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_int_equal(view.direction_count, 4);
    for (uint32_t j = 0; j < 4; j++) {
        assert_near(view.theta[j], BOLAN_PI / 4.0 + j * BOLAN_PI / 2.0, 1e-12);
        // FROM 45 is TO 225 compass, which is 225 mathematical: the third bin.
        assert_near(view.density[4 + j], j == 2 ? 180.0 / BOLAN_PI / (2.0 * BOLAN_PI) : 0.0, 1e-12);
    }
    assert_near(view.omega[2], 2.0 * BOLAN_PI * 0.3, 1e-12);
    assert_string_equal(view.time, "2016-10-11T01:30:00");
    bolan_measured_spectrum_destroy(&spectrum);
}

static void unsorted_directions_and_windows_line_ends_are_read(void **state) {
    (void)state;
    const bolan_sea_summary s = summary_of("SWAN 1\r\nLOCATIONS\r\n1 n\r\n0 0\r\nRFREQ\r\n2 n\r\n.1\r\n.2\r\nNDIR\r\n4 "
                                           "n\r\n225\r\n135\r\n45\r\n-45\r\nQUANT\r\n1\r\n"
                                           "VaDens\r\nm2/Hz/degr\r\n-99\r\nFACTOR\r\n1E+0\r\n0 1 0 0\r\n0 1 0 0\r\n",
                                           0);
    assert_near(s.from_deg, 135.0, 1e-9);
    assert_near(s.m0, 9.0, 1e-9); // 1 m2/Hz/degr x 90 degr x 0.1 Hz; a file without TIME has one record
}

// Five directions over a quarter circle, 20 degrees apart: the rest of the circle stays empty and no energy is lost.
static void a_sector_of_directions_keeps_its_energy_and_direction(void **state) {
    (void)state;
    const bolan_sea_summary s = summary_of(HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n5 n\n200\n220\n240\n260\n280\n" VADENS
                                                      "FACTOR\n1\n0 1 1 1 0\n0 1 1 1 0\n",
                                           0);
    assert_near(s.m0, 3.0 * 20.0 * 0.1, 1e-9);
    assert_near(s.from_deg, 240.0, 1e-6);
}

static void a_record_is_a_time_at_the_first_location(void **state) {
    (void)state;
    static const char two[] =
        HEAD TIMES "LOCATIONS\n 2  n\n 0 0\n 1 1\n" FREQUENCIES NAUTICAL VADENS "20200101.000000\nZERO\n" BLOCK
                   "20200101.060000\nFACTOR\n 1\n 0 0 0 0\n 0 0 2 0\n 0 -99 0 0\nNODATA\n"
                   "20200101.120000\n" BLOCK "ZERO\n";
    assert_near(summary_of(two, 1).from_deg, 225.0, 1e-9);
    assert_near(summary_of(two, 1).m0, 18.0, 1e-9); // -99 is a missing value, not an energy
    assert_near(summary_of(two, 2).from_deg, 45.0, 1e-9);
    const bolan_spectrum_texts texts = texts_of(two);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY, "2020-01-01T00:00:00");
    assert_refused(&texts, 3, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX, "expected 0 to 2");
}

static void refuse(const char *data, bolan_log_id id, const char *part) {
    const bolan_spectrum_texts texts = texts_of(data);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, id, part);
}

static void what_is_wrong_is_named_with_its_line(void **state) {
    (void)state;
    refuse("", BOLAN_LOG_SPECTRUM_EMPTY, "sea.spec: the text is empty");
    refuse(" \n\t\r\n", BOLAN_LOG_SPECTRUM_EMPTY, "empty");
    refuse("hello", BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT, "sea.spec:1");
    refuse("\x89PNG\r\n\x1a\n", BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT, "sea.spec:1");
    refuse("SWAN 1\nSPICE\n", BOLAN_LOG_SPECTRUM_SYNTAX, "sea.spec:2: expected TIME");
    refuse(HEAD PLACE "AFREQ\n 999999999 n\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "frequencies from 2 to 1000, found \"999999999\"");
    refuse(HEAD PLACE "AFREQ\n -3 n\n", BOLAN_LOG_SPECTRUM_SYNTAX, "frequencies from 2 to 1000");
    refuse(HEAD PLACE "AFREQ\n 2.5 n\n", BOLAN_LOG_SPECTRUM_SYNTAX, "frequencies from 2 to 1000");
    refuse(HEAD PLACE "AFREQ\n 2 n\n0.2\n0.1\n", BOLAN_LOG_SPECTRUM_SYNTAX,
           "sea.spec:9: expected an ascending frequency");
    refuse(HEAD PLACE "AFREQ\n 2 n\n0\n0.1\n", BOLAN_LOG_SPECTRUM_SYNTAX, "ascending frequency");
    refuse(HEAD PLACE FREQUENCIES "NDIR\n 1 n\n 0\n", BOLAN_LOG_SPECTRUM_SYNTAX, "directions from 3 to 720");
    refuse(HEAD PLACE FREQUENCIES "NDIR\n 3 n\n 0\n 0\n 120\n" VADENS "FACTOR\n1\n1 1 1\n1 1 1\n1 1 1\n",
           BOLAN_LOG_SPECTRUM_SYNTAX, "two directions are the same");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL "QUANT\n 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "2-D spectrum");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL QUANTITY("HSIGN") BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "VaDens or EnDens");
    refuse(HEAD FREQUENCIES NAUTICAL VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "LOCATIONS or LONLAT");
    refuse(HEAD PLACE FREQUENCIES VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "NDIR or CDIR");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "NODATA\n", BOLAN_LOG_SPECTRUM_NO_ENERGY, "no energy");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "FACTOR\n 1\n 0 0 0 0 0 0 -1 0 0 0 0 0\n",
           BOLAN_LOG_SPECTRUM_NEGATIVE, "-1");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "FACTOR\n -1\n", BOLAN_LOG_SPECTRUM_NEGATIVE, "-1");
}

static void numbers_that_are_none_are_refused(void **state) {
    (void)state;
    static const char *const words[] = {"nan", "inf",   "-inf",  "1e999", "0x10", "1e",
                                        "--1", "1.2.3", "*****", "1_0",   "."};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char data[1024];
        snprintf(data, sizeof data, "%s%s 0 0 0 0 0 0 0 0 0 0 0\n",
                 HEAD PLACE FREQUENCIES NAUTICAL VADENS "FACTOR\n 1\n", words[i]);
        refuse(data, BOLAN_LOG_SPECTRUM_SYNTAX, "expected a density, found");
    }
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "FACTOR\n 1e300\n 1e9 0 0 0 0 0 0 0 0 0 0 0\n",
           BOLAN_LOG_SPECTRUM_SYNTAX, "a sea can have");
}

// Cut anywhere, the text is refused with one sentence; only the last line end may be missing.
static void every_truncation_is_refused(void **state) {
    (void)state;
    const bolan_spectrum_texts whole = texts_of(WHOLE);
    for (size_t size = 0; size + 2 < sizeof WHOLE - 1; size++) {
        char *copy = malloc(size ? size : 1); // exactly as long, so that a sanitizer sees any step beyond
        memcpy(copy, WHOLE, size);
        bolan_spectrum_texts texts = whole;
        texts.density = (bolan_spectrum_text){"cut.spec", copy, size};
        bolan_measured_spectrum *spectrum;
        last_log_id = (bolan_log_id)0;
        assert_int_equal(bolan_measured_spectrum_parse(&texts, 0, &spectrum), BOLAN_ERROR_FORMAT);
        assert_null(spectrum);
        assert_true(last_log_id >= BOLAN_LOG_SPECTRUM_EMPTY && last_log_id <= BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void a_spread_outside_its_range_is_refused(void **state) {
    (void)state;
    bolan_spectrum_texts texts = texts_of(WHOLE);
    texts.spread_s = -1.0;
    assert_refused(&texts, 0, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "spread_s");
    texts.spread_s = 10.0;
    texts.from_deg = NAN;
    assert_refused(&texts, 0, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "from_deg");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_variance_is_factor_times_number_times_bin),
        cmocka_unit_test(nautical_directions_come_from_and_cartesian_ones_go_to),
        cmocka_unit_test(the_view_is_ascending_in_mathematical_angle),
        cmocka_unit_test(unsorted_directions_and_windows_line_ends_are_read),
        cmocka_unit_test(a_sector_of_directions_keeps_its_energy_and_direction),
        cmocka_unit_test(a_record_is_a_time_at_the_first_location),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(numbers_that_are_none_are_refused),
        cmocka_unit_test(every_truncation_is_refused),
        cmocka_unit_test(a_spread_outside_its_range_is_refused),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
