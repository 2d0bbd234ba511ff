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
    const bolan_spectrum_options options = record_number(record);
    return summary_with(&texts, &options);
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
    assert_int_equal(warning_count, 0); // a sector is no gap
    const bolan_sea_summary full =
        summary_of(HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n5 n\n200\n220\n240\n260\n280\n" VADENS
                              "FACTOR\n1\n1 1 1 1 1\n1 1 1 1 1\n",
                   0);
    assert_near(full.m0, 5.0 * 20.0 * 0.1, 1e-9); // the rims are a step wide, not half of the gap
}

// The mean direction [deg] of a density that rises linearly from a to b and falls to c, by a midpoint sum.
static double triangle_mean(double a, double b, double c) {
    double x = 0.0, y = 0.0;
    for (int i = 0; i < 10000; i++) {
        const double at = a + (i + 0.5) * (c - a) / 10000, h = at < b ? (at - a) / (b - a) : (c - at) / (c - b);
        x += h * cos(bolan_radians(at));
        y += h * sin(bolan_radians(at));
    }
    return bolan_degrees(atan2(y, x));
}

// Where the step varies the density is linear between neighbours: the widths are 120, 105, 60, 75 degrees.
static void uneven_directions_are_integrated_by_the_trapezoid_rule(void **state) {
    (void)state;
    const char *const head = HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n4 n\n0\n150\n210\n270\n" VADENS "FACTOR\n1\n";
    const struct {
        const char *values;
        double width, from;
    } cases[] = {{"1 0 0 0\n1 0 0 0\n", 120.0, triangle_mean(-90, 0, 150)},
                 {"0 1 0 0\n0 1 0 0\n", 105.0, triangle_mean(0, 150, 210)},
                 {"0 0 1 0\n0 0 1 0\n", 60.0, 210.0},
                 {"0 0 0 1\n0 0 0 1\n", 75.0, triangle_mean(210, 270, 360)}};
    for (size_t i = 0; i < 4; i++) {
        char data[1024];
        snprintf(data, sizeof data, "%s%s", head, cases[i].values);
        const bolan_sea_summary s = summary_of(data, 0);
        assert_near(s.m0, cases[i].width * 0.1, 1e-9);
        assert_near(remainder(s.from_deg - cases[i].from, 360.0), 0.0, 0.05); // bins of 5 degrees
    }
    assert_warned(BOLAN_LOG_SPECTRUM_GAP, "a gap of 150 degrees, between waves from 0 and from 150");
    // The same density everywhere is an even sea.
    char data[1024];
    snprintf(data, sizeof data, "%s1 1 1 1\n1 1 1 1\n", head);
    assert_near(summary_of(data, 0).spread_deg, bolan_degrees(sqrt(2.0)), 1e-4);
}

static void a_direction_that_comes_twice_counts_once(void **state) {
    (void)state;
    const char *const head = HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n5 n\n0\n90\n180\n270\n360\n" VADENS "FACTOR\n1\n";
    char data[1024];
    snprintf(data, sizeof data, "%s 3 1 0 0 3\n 2 0 0 0 2\n", head);
    assert_near(summary_of(data, 0).m0, 90.0 * 0.1 * 0.5 * (4.0 + 2.0), 1e-9);
    assert_int_equal(warning_count, 0);
    const bolan_spectrum_texts texts = texts_of(data);
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    assert_int_equal(bolan_measured_spectrum_view(spectrum).direction_count, 4);
    bolan_measured_spectrum_destroy(&spectrum);
    snprintf(data, sizeof data, "%s 3 1 0 0 3\n 2 0 0 0 1\n", head);
    const bolan_spectrum_texts other = texts_of(data);
    assert_refused(&other, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "the same, with other densities");
    // A hundredth of a degree apart they are two directions.
    const bolan_sea_summary close = summary_of(HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n5 n\n0\n.01\n90\n180\n270\n" VADENS
                                                          "FACTOR\n1\n 1 3 0 0 0\n 1 3 0 0 0\n",
                                               0);
    assert_near(close.m0, (1.0 * 45.005 + 3.0 * 45.0) * 0.1, 1e-9);
    const bolan_spectrum_texts few =
        texts_of(HEAD PLACE "AFREQ\n2 n\n.1\n.2\nNDIR\n3 n\n0\n90\n360\n" VADENS "FACTOR\n1\n 1 0 1\n 1 0 1\n");
    assert_refused(&few, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "too few directions are distinct");
}

// ---- records --------------------------------------------------------------------------------------------------------

#define AT_6 "20200101.060000\n"
static void records_are_sorted_by_time_and_found_by_date(void **state) {
    (void)state;
    static const char three[] = HEAD TIMES PLACE FREQUENCIES NAUTICAL VADENS
        "20200102.000000\nFACTOR\n 1\n 0 0 0 0\n 0 2 0 0\n 0 0 0 0\n"
        "20191231.235959\nFACTOR\n 1\n 0 0 0 0\n 0 0 2 0\n 0 0 0 0\n" AT_6 BLOCK;
    static const char *const times[3] = {"2019-12-31T23:59:59", "2020-01-01T06:00:00", "2020-01-02T00:00:00"};
    const double from[3] = {225.0, 45.0, 135.0};
    const bolan_spectrum_texts texts = texts_of(three);
    for (uint32_t i = 0; i < 3; i++) {
        bolan_measured_spectrum *spectrum = parse(&texts, i);
        assert_string_equal(bolan_measured_spectrum_view(spectrum).time, times[i]);
        bolan_measured_spectrum_destroy(&spectrum);
        bolan_spectrum_options options = bolan_spectrum_options_default();
        strcpy(options.time, times[i]);
        assert_near(summary_with(&texts, &options).from_deg, from[i], 1e-9);
        assert_near(summary_of(three, i).from_deg, from[i], 1e-9);
        assert_int_equal(warning_count, 0);
    }
    assert_refused(&texts, 3, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX, "expected 0 to 2");
}

static void impossible_dates_are_refused(void **state) {
    (void)state;
    const struct {
        const char *date, *said;
        bolan_log_id id;
    } dates[] = {{"9999-99-99T99:99:99", "such as 20161011.013000, found", BOLAN_LOG_SPECTRUM_SYNTAX},
                 {"20200230.000000", "there is no date 20200230.000000", BOLAN_LOG_SPECTRUM_DATE},
                 {"20201301.000000", "there is no date", BOLAN_LOG_SPECTRUM_DATE},
                 {"20200101.240000", "there is no date", BOLAN_LOG_SPECTRUM_DATE},
                 {"20200101.006000", "there is no date", BOLAN_LOG_SPECTRUM_DATE},
                 {"20200101.000060", "there is no date", BOLAN_LOG_SPECTRUM_DATE},
                 {"10660101.000000", "there is no date", BOLAN_LOG_SPECTRUM_DATE},
                 {"99999999.999999", "there is no date", BOLAN_LOG_SPECTRUM_DATE}};
    for (size_t i = 0; i < sizeof dates / sizeof *dates; i++) {
        char data[1024];
        snprintf(data, sizeof data, "%s%s date\n%s", HEAD TIMES PLACE FREQUENCIES NAUTICAL VADENS, dates[i].date,
                 BLOCK);
        const bolan_spectrum_texts texts = texts_of(data);
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, dates[i].id, dates[i].said);
        assert_non_null(strstr(last_sentence, "sea.spec:24:"));
    }
    // Times that are coded another way are not read; the records count as in the text.
    const char *const coded = HEAD "TIME\n 2 code\n" PLACE FREQUENCIES NAUTICAL VADENS "30-May-87 15:30:00\n" BLOCK
                                   "29-May-87 15:30:00\nZERO\n";
    assert_near(summary_of(coded, 0).m0, 9.0, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_DATE, "coded by option 2");
    assert_near(summary_of(coded, 1).m0, 0.0, 0.0);
    const bolan_spectrum_texts texts = texts_of(coded);
    bolan_spectrum_options options = bolan_spectrum_options_default();
    strcpy(options.time, "1987-05-30T15:30");
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX,
                        "no times that can be read");
}

static void a_calm_is_a_sea_and_no_data_is_none(void **state) {
    (void)state;
    const char *const head = HEAD PLACE FREQUENCIES NAUTICAL VADENS;
    char data[1024];
    static const char *const calms[] = {"ZERO\n", "FACTOR\n 1\n 0 0 0 0\n 0 0 0 0\n 0 0 0 0\n",
                                        "FACTOR\n 0\n 1 2 3 4\n 1 2 3 4\n 1 2 3 4\n"};
    for (int i = 0; i < 3; i++) {
        snprintf(data, sizeof data, "%s%s", head, calms[i]);
        const bolan_sea_summary s = summary_of(data, 0);
        assert_true(s.m0 == 0.0 && s.hs == 0.0 && s.tp == 0.0);
        assert_int_equal(warning_count, 0);
        const bolan_spectrum_texts texts = texts_of(data);
        bolan_measured_spectrum *spectrum = parse(&texts, 0);
        const bolan_sea_state sea_state = sea_of(spectrum);
        assert_true(bolan_sea_state_wavenumber_density(&sea_state, 3.0, 4.0) == 0.0); // nor a tail
        bolan_measured_spectrum_destroy(&spectrum);
    }
    snprintf(data, sizeof data, "%sFACTOR\n 1\n -99 -99 -99 -99 -99 -99 -99 -99 -99 -99 -99 -99\n", head);
    const bolan_spectrum_texts texts = texts_of(data);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
                   "every density of the record is the exc");
    snprintf(data, sizeof data, "%sFACTOR\n 0.5\n -99 0 0 0\n 2 0 -99 0\n 0 0 0 -99\n", head);
    assert_near(summary_of(data, 0).m0, 9.0, 1e-9); // -99 is a missing value, not an energy
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "25.0 % of the densities");
}

// ---- locations ------------------------------------------------------------------------------------------------------

#define FROM_SE "FACTOR\n 0.5\n 0 0 0 0\n 0 2 0 0\n 0 0 0 0\n"
#define FROM_SW "FACTOR\n 0.5\n 0 0 0 0\n 0 0 2 0\n 0 0 0 0\n"
#define PLACES(kind) kind "\n 3  n\n 174.6 -38.2 'one'\n -179.9 10 two\n 179 60\n"
#define THREE_PLACES PLACES("LONLAT") FREQUENCIES NAUTICAL VADENS

static bolan_spectrum_options at_location(const char *text) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    assert_true(bolan_spectrum_options_set_location(&options, text));
    return options;
}

static void a_location_is_chosen_by_number_or_place(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(HEAD THREE_PLACES BLOCK FROM_SE FROM_SW);
    const struct {
        const char *location;
        double from;
        int warnings;
    } cases[] = {{"1", 45, 0},
                 {"2", 135, 0},
                 {"3", 225, 0},
                 {"174.6,-38.2", 45, 0},
                 {"-185.4, -38.2", 45, 0}, // the same place by another turn
                 {"179.55,-89", 45, 1},    // as above: the nearest to the pole
                 {"180.1,10", 135, 0},     // over the date line
                 {"174.6,38.2", 225, 1},   // 22 degrees of latitude beat 28
                 {"0,80", 225, 1},         // over the pole: 40 degrees to the third, 90 to the second
                 {"179.9,60.3", 225, 1}};  // 60 km: worth a word
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const bolan_spectrum_options options = at_location(cases[i].location);
        assert_near(summary_with(&texts, &options).from_deg, cases[i].from, 1e-9);
        assert_int_equal(warning_count, cases[i].warnings);
    }
    // 0.9 degrees of longitude at 60 north and 0.3 of latitude, on the sphere of 6371 km: 50.0 and 33.4 km.
    assert_warned(BOLAN_LOG_SPECTRUM_LOCATION, "nearest to 179.9, 60.3 is number 3 at 179, 60, 60 km away");
    bolan_spectrum_options options = bolan_spectrum_options_default();
    assert_near(summary_with(&texts, &options).from_deg, 45.0, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_LOCATION, "has 3 locations; the first, at 174.6, -38.2, is taken; give location");
    options.location = 4;
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_LOCATION,
                        "location 4 was asked for; expected 1 to 3");
    // Of two that are as near, the first.
    const bolan_spectrum_texts twins =
        texts_of(HEAD "LOCATIONS\n 3  n\n 5 5\n 1 1\n 1 1\n" FREQUENCIES NAUTICAL VADENS BLOCK FROM_SE FROM_SW);
    options = at_location("0,0");
    assert_near(summary_with(&twins, &options).from_deg, 135.0, 1e-9);
    // The same numbers as metres: the plane has no date line.
    const bolan_spectrum_texts plane =
        texts_of(HEAD PLACES("LOCATIONS") FREQUENCIES NAUTICAL VADENS BLOCK FROM_SE FROM_SW);
    options = at_location("-170,0");
    assert_near(summary_with(&plane, &options).from_deg, 135.0, 1e-9);
    options = at_location("180.1,10");
    assert_near(summary_with(&plane, &options).from_deg, 45.0, 1e-9);
    assert_int_equal(warning_count, 0);
}

static void a_dry_location_counts_the_others(void **state) {
    (void)state;
    const bolan_spectrum_options plain = bolan_spectrum_options_default(), second = at_location("2");
    const bolan_spectrum_texts dry = texts_of(HEAD THREE_PLACES "NODATA\n" FROM_SE "ZERO\n");
    assert_refused_with(
        &dry, &plain, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
        "location 1 of 3, at 174.6, -38.2, has no data (NODATA); 1 of the 3 have energy: 2; give location");
    assert_near(summary_with(&dry, &second).from_deg, 135.0, 1e-9);
    const bolan_spectrum_texts flat =
        texts_of(HEAD THREE_PLACES "NODATA\n" FROM_SE "FACTOR\n 1\n 0 0 0 0\n 0 0 0 0\n 0 0 -99 0\n");
    assert_refused_with(&flat, &plain, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY, "1 of the 3 have energy: 2;");
    const bolan_spectrum_texts all_dry =
        texts_of(HEAD TIMES THREE_PLACES "20200101.000000\n" BLOCK FROM_SE FROM_SW AT_6 "ZERO\nNODATA\nNODATA\n");
    bolan_spectrum_options later = at_location("2");
    later.record = 1;
    assert_refused_with(
        &all_dry, &later, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
        "location 2 of 3, at -179.9, 10, has no data (NODATA) at 2020-01-01T06:00:00; 0 of the 3 have energy");
}

static void a_record_is_a_time_at_a_location(void **state) {
    (void)state;
    static const char two[] =
        HEAD TIMES "LOCATIONS\n 2  n\n 0 0\n 1 1\n" FREQUENCIES NAUTICAL VADENS "20200101.000000\nZERO\n" BLOCK
                   "20200101.060000\nFACTOR\n 1\n 0 0 0 0\n 0 0 2 0\n 0 -99 0 0\nNODATA\n"
                   "20200101.120000\n" BLOCK "ZERO\n";
    assert_near(summary_of(two, 1).from_deg, 225.0, 1e-9);
    assert_near(summary_of(two, 1).m0, 18.0, 1e-9); // -99 is a missing value, not an energy
    assert_near(summary_of(two, 2).from_deg, 45.0, 1e-9);
    assert_near(summary_of(two, 0).m0, 0.0, 0.0);
    const bolan_spectrum_texts texts = texts_of(two);
    const bolan_spectrum_options second = at_location("2");
    assert_near(summary_with(&texts, &second).from_deg, 45.0, 1e-9);
    assert_refused(&texts, 3, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_SPECTRUM_TIME_INDEX, "expected 0 to 2");
}

// Odd numbers, short blocks and an end in the middle: only what is asked for need be right.
static void what_is_not_asked_for_spoils_nothing(void **state) {
    (void)state;
    const bolan_spectrum_texts texts =
        texts_of(HEAD TIMES "LOCATIONS\n 2  n\n 0 0\n 1 1\n" FREQUENCIES NAUTICAL VADENS
                            "20200101.000000\nFACTOR\n 1\n 0 *** 0 0\n -3 nan 0x1 0\n 0 0 0 0\n" FROM_SE
                            "20200101.060000\n" FROM_SW "FACTOR\n 1\n 0 0 0 0\n 2 2\n" // short
                            "20200101.120000\n" BLOCK "FACTOR\n 1\n 0 0");             // the end
    bolan_spectrum_options first = at_location("1"), second = at_location("2");
    assert_near(summary_with(&texts, &second).from_deg, 135.0, 1e-9);
    assert_refused_with(&texts, &first, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "a density, found \"***\"");
    first.record = second.record = 1;
    assert_near(summary_with(&texts, &first).from_deg, 225.0, 1e-9);
    assert_refused_with(&texts, &second, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "a density, found \"20200101.120000\"");
    first.record = second.record = 2;
    assert_near(summary_with(&texts, &first).from_deg, 45.0, 1e-9);
    assert_refused_with(&texts, &second, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_TRUNCATED, "a density");
}

static void too_many_blocks_or_densities_are_refused(void **state) {
    (void)state;
    const bolan_spectrum_options plain = bolan_spectrum_options_default();
    bolan_spectrum_texts texts = texts_of(HEAD PLACE FREQUENCIES NAUTICAL VADENS BLOCK BLOCK);
    assert_refused_with(&texts, &plain, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "sea.spec:27: expected the end of the text after the last location, found \"FACTOR\"");
    texts = texts_of(HEAD TIMES PLACE FREQUENCIES NAUTICAL VADENS "20200101.000000\n" BLOCK "7\n" AT_6 BLOCK);
    assert_refused_with(&texts, &plain, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "such as 20161011.013000, found \"7\"");
}

// ---- 1-D ------------------------------------------------------------------------------------------------------------

#define QUANTITIES(direction)                                                                      \
    "QUANT\n 3 number\nVaDens densities\nm2/Hz\n -0.9900E+02\n" direction "\ndegr\n -0.9990E+03\n" \
    "DSPRDEGR\ndegr\n -0.9000E+01\n"
#define TABLE "LOCATION 1\n 0.1E+01 60.0 20.0\n 0.2E+01 60.0 20.0\n 0.0 -999 -9\n"

static void a_1d_file_has_a_direction_and_a_spread_a_band(void **state) {
    (void)state;
    // Trapezoid rule on 0.1, 0.2, 0.3 Hz: 1 x 0.05 + 2 x 0.1.
    bolan_sea_summary s = summary_of(HEAD PLACE FREQUENCIES QUANTITIES("NDIR") TABLE, 0);
    assert_near(s.m0, 0.25, 1e-12);
    assert_near(s.tp, 5.0, 1e-9);
    assert_near(s.from_deg, 60.0, 1e-6);
    assert_near(s.spread_deg, 20.0, 0.05); // cos-2s on bins of 5 degrees
    assert_int_equal(warning_count, 0);
    s = summary_of(HEAD PLACE FREQUENCIES QUANTITIES("CDIR") TABLE, 0); // to 60 mathematical: from 210 compass
    assert_near(s.from_deg, 210.0, 1e-6);
    s = summary_of(HEAD PLACE FREQUENCIES "QUANT\n1 n\nEnDens\nJ/m2/Hz\n-99\nLOCATION 1\n1\n2\n0\n", 0);
    assert_near(s.m0, 0.25 / (1025.0 * 9.81), 1e-12);
    assert_near(s.from_deg, 270.0, 1e-6);
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "has no directions; the waves come from 270 degrees");
    // Two locations, two times, words in the place of values, missing ones.
    const char *const more = HEAD TIMES "LOCATIONS\n 3  n\n 0 0\n 1 1\n 2 2\n" FREQUENCIES QUANTITIES(
        "NDIR") "20200101.000000\n" TABLE "LOCATION 2\nNODATA\nLOCATION 3\nZERO\n"
                "20200101.060000\nNODATA\nLOCATION 2\n 1 30 10\n -99 30 10\n 3 -999 -9\nLOCATION 3\n 1 30 10\n bad\n";
    const bolan_spectrum_texts texts = texts_of(more);
    bolan_spectrum_options options = at_location("2");
    options.record = 1;
    s = summary_with(&texts, &options);
    assert_int_equal(warning_count, 2); // a density and a direction
    assert_near(s.m0, 1.0 * 0.05 + 2.0 * 0.1 + 3.0 * 0.05, 1e-12);
    assert_near(s.from_deg, 30.0, 1e-6);
    assert_near(s.spread_deg, 10.0, 0.05);
    options.record = 0;
    assert_refused_with(
        &texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
        "location 2 of 3, at 1, 1, has no data (NODATA) at 2020-01-01T00:00:00; 1 of the 3 have energy: 1;");
    options = at_location("3");
    assert_near(summary_with(&texts, &options).hs, 0.0, 0.0);
    assert_int_equal(warning_count, 0);
    options.record = 1;
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "a value for every quantity, found \"bad\"");
}

static void what_is_wrong_in_a_1d_file_is_named(void **state) {
    (void)state;
    const struct {
        const char *row, *said;
    } rows[] = {{"-1 60 20", "is negative"},
                {"1 800 20", "a direction in degrees, found \"800\""},
                {"1 60 82", "a spread of 0 to 81 degrees, found \"82\""},
                {"1 60 -1", "a spread of 0 to 81 degrees"},
                {"1e10 60 20", "a density that a sea can have"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char data[1024];
        snprintf(data, sizeof data, "%sLOCATION 1\n 1 60 20\n %s\n 0 60 20\n",
                 HEAD PLACE FREQUENCIES QUANTITIES("NDIR"), rows[i].row);
        const bolan_spectrum_texts texts = texts_of(data);
        assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, i ? BOLAN_LOG_SPECTRUM_SYNTAX : BOLAN_LOG_SPECTRUM_NEGATIVE,
                       rows[i].said);
    }
    bolan_spectrum_texts texts = texts_of(HEAD PLACE FREQUENCIES QUANTITIES("HSIGN") TABLE);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "NDIR, CDIR or DSPRDEGR, found \"HSIGN\"");
    texts = texts_of(HEAD PLACE FREQUENCIES "QUANT\n1\nNDIR\ndegr\n-999\nLOCATION 1\n1\n1\n1\n");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "a quantity VaDens or EnDens");
    texts = texts_of(HEAD PLACE FREQUENCIES QUANTITIES("NDIR") TABLE "5\n");
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "the end of the text");
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
           BOLAN_LOG_SPECTRUM_SYNTAX, "too few directions are distinct");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL "QUANT\n 3\n", BOLAN_LOG_SPECTRUM_SYNTAX, "2-D spectrum");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL QUANTITY("HSIGN") BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "VaDens or EnDens");
    refuse(HEAD FREQUENCIES NAUTICAL VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "LOCATIONS or LONLAT");
    refuse(HEAD PLACE FREQUENCIES VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "NDIR or CDIR");
    refuse(HEAD PLACE NAUTICAL VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX, "AFREQ or RFREQ");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "NODATA\n", BOLAN_LOG_SPECTRUM_NO_ENERGY, "location 1 of 1");
    refuse("SWAN 99\n" PLACE FREQUENCIES NAUTICAL VADENS BLOCK, BOLAN_LOG_SPECTRUM_SYNTAX,
           "sea.spec:1: expected the version of the format from 1 to 1, found \"99\"");
    refuse(HEAD PLACE "AFREQ\n 2 n\n.0009\n.1\n", BOLAN_LOG_SPECTRUM_SYNTAX, "0.001 to 10 Hz, found \".0009\"");
    refuse(HEAD PLACE "AFREQ\n 2 n\n9\n10.1\n", BOLAN_LOG_SPECTRUM_SYNTAX, "0.001 to 10 Hz, found \"10.1\"");
    refuse(HEAD PLACE FREQUENCIES NAUTICAL VADENS "FACTOR\n 1000\n 0 0 0 0\n 2 0 0 0\n 0 0 0 0\n",
           BOLAN_LOG_SPECTRUM_IMPOSSIBLE, "has a significant wave height of 536.7 m; expected at most 40 m");
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
        assert_true(last_log_id >= BOLAN_LOG_SPECTRUM_EMPTY && last_log_id <= BOLAN_LOG_SPECTRUM_DATE);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

// Fortran prints exponents of three digits without their letter.
static void exponents_of_three_digits_have_no_letter(void **state) {
    (void)state;
    const char *const head = HEAD PLACE FREQUENCIES NAUTICAL VADENS;
    char data[1024];
    snprintf(data, sizeof data, "%sFACTOR\n 0.05+001\n 0 0 0 0\n 2 0.7-104 0 0\n 0 0 0 0\n", head);
    assert_near(summary_of(data, 0).m0, 9.0, 1e-9);
    snprintf(data, sizeof data, "%sFACTOR\n 0.5-1\n", head); // that would be another number
    refuse(data, BOLAN_LOG_SPECTRUM_SYNTAX, "found \"0.5-1\"");
    refuse(HEAD PLACE "AFREQ\n 2 n\n0.1\n0.2+001\n", BOLAN_LOG_SPECTRUM_SYNTAX, "found \"0.2+001\"");
}

static void options_outside_their_ranges_are_refused(void **state) {
    (void)state;
    const bolan_spectrum_texts texts = texts_of(WHOLE);
    const bolan_spectrum_options plain = bolan_spectrum_options_default();
    bolan_spectrum_options options = plain;
    const double bad_spreads[] = {-1.0, 201.0, HUGE_VAL}, bad_froms[] = {-361.0, 361.0, -HUGE_VAL};
    for (int i = 0; i < 3; i++) {
        const bolan_log_id id = isfinite(bad_spreads[i]) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE;
        options = plain;
        options.spread_s = bad_spreads[i];
        assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, id, "spread_s");
        options = plain;
        options.from_deg = bad_froms[i];
        assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, id, "from_deg");
    }
    options = plain;
    options.place[0] = 3.0;
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_NOT_FINITE, "place");
    options = plain;
    options.place[0] = 3.0;
    options.place[1] = HUGE_VAL;
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_NOT_FINITE, "place[1]");
    options = plain;
    memset(options.time, '2', sizeof options.time);
    assert_refused_with(&texts, &options, BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "time is 222");
    options = plain;
    options.from_deg = 20.0; // the text has directions
    assert_near(summary_with(&texts, &options).from_deg, 45.0, 1e-9);
    assert_warned(BOLAN_LOG_SPECTRUM_UNUSED, "sea.spec: has directions of its own");
    bolan_measured_spectrum *spectrum = NULL;
    assert_int_equal(bolan_measured_spectrum_parse(&texts, NULL, &spectrum), BOLAN_OK); // NULL: the defaults
    bolan_measured_spectrum_destroy(&spectrum);
}

static void records_and_locations_are_read_from_words(void **state) {
    (void)state;
    bolan_spectrum_options o = bolan_spectrum_options_default();
    assert_true(bolan_spectrum_options_set_record(&o, "2018-01-01T06:00"));
    assert_string_equal(o.time, "2018-01-01T06:00");
    assert_int_equal(o.record, 0);
    assert_true(bolan_spectrum_options_set_record(&o, "12"));
    assert_string_equal(o.time, "");
    assert_int_equal(o.record, 12);
    static const char *const no_records[] = {"",
                                             "-1",
                                             "1.5",
                                             "x",
                                             "2018-02-29",
                                             "2018-1-1",
                                             "2018-01-01T",
                                             "2018",
                                             "20180101.5",
                                             "2018-01-01T25:00",
                                             "2018-01-01T06:00:00Zx"};
    for (size_t i = 0; i < sizeof no_records / sizeof *no_records; i++) {
        const bool year = strcmp(no_records[i], "2018") == 0; // a number
        assert_true(bolan_spectrum_options_set_record(&o, no_records[i]) == year);
        assert_int_equal(o.record, i < 7 ? 12 : 2018);
    }
    assert_true(bolan_spectrum_options_set_location(&o, "3"));
    assert_true(o.location == 3 && isnan(o.place[0]) && isnan(o.place[1]));
    assert_true(bolan_spectrum_options_set_location(&o, "174.67,-38.17"));
    assert_true(o.location == 0 && o.place[0] == 174.67 && o.place[1] == -38.17);
    static const char *const no_locations[] = {"", "0", "-1", "1.5", "x", "1,", ",1", "1,2,3", "1 2"};
    for (size_t i = 0; i < sizeof no_locations / sizeof *no_locations; i++)
        assert_false(bolan_spectrum_options_set_location(&o, no_locations[i]));
    assert_true(o.location == 0 && o.place[0] == 174.67 && o.place[1] == -38.17);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_variance_is_factor_times_number_times_bin),
        cmocka_unit_test(nautical_directions_come_from_and_cartesian_ones_go_to),
        cmocka_unit_test(the_view_is_ascending_in_mathematical_angle),
        cmocka_unit_test(unsorted_directions_and_windows_line_ends_are_read),
        cmocka_unit_test(a_sector_of_directions_keeps_its_energy_and_direction),
        cmocka_unit_test(uneven_directions_are_integrated_by_the_trapezoid_rule),
        cmocka_unit_test(a_direction_that_comes_twice_counts_once),
        cmocka_unit_test(records_are_sorted_by_time_and_found_by_date),
        cmocka_unit_test(impossible_dates_are_refused),
        cmocka_unit_test(a_calm_is_a_sea_and_no_data_is_none),
        cmocka_unit_test(a_location_is_chosen_by_number_or_place),
        cmocka_unit_test(a_dry_location_counts_the_others),
        cmocka_unit_test(a_record_is_a_time_at_a_location),
        cmocka_unit_test(what_is_not_asked_for_spoils_nothing),
        cmocka_unit_test(too_many_blocks_or_densities_are_refused),
        cmocka_unit_test(a_1d_file_has_a_direction_and_a_spread_a_band),
        cmocka_unit_test(what_is_wrong_in_a_1d_file_is_named),
        cmocka_unit_test(exponents_of_three_digits_have_no_letter),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(numbers_that_are_none_are_refused),
        cmocka_unit_test(every_truncation_is_refused),
        cmocka_unit_test(options_outside_their_ranges_are_refused),
        cmocka_unit_test(records_and_locations_are_read_from_words),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
