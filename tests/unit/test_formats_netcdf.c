// SPDX-License-Identifier: MIT
// NetCDF spectra: axes in any order, record dimensions, packing, times, places, conventions, and what is wrong.
#include "netcdf_support.h"

static const double two_hertz[2] = {0.1, 0.2}, four_degrees[4] = {0, 90, 180, 270};
static const double six_and_nine[2] = {6, 9}; // hours

static bolan_spectrum_options at(uint32_t record, uint32_t location) {
    bolan_spectrum_options options = record_number(record);
    options.location = location;
    return options;
}

// Two times, two stations, two frequencies, four directions; one cell each has energy.
enum { CELLS = 2 * 2 * 2 * 4 };
static const nc_dimension ww3_axes[] = {{"time", 2}, {"station", 2}, {"frequency", 2}, {"direction", 4}};

static void write_ww3(nc_bytes *b, int version, bool records, const double *efth, const char *direction_name,
                      const char *units) {
    static const double latitudes[4] = {10, 20, 11, 21}, longitudes[4] = {-30, -40, -31, -41}; // they move
    nc_dimension axes[4];
    memcpy(axes, ww3_axes, sizeof axes);
    if (records) axes[0].length = 0;
    const nc_variable variables[] = {
        {"time", 1, {0}, six_and_nine, "units", "hours since 2020-02-28T00:00:00Z", NULL, NULL, NULL, 0, false},
        {"latitude", 2, {0, 1}, latitudes, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"longitude", 2, {0, 1}, longitudes, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"frequency", 1, {2}, two_hertz, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"direction", 1, {3}, four_degrees, "standard_name", direction_name, NULL, NULL, NULL, 0, false},
        {"efth", 4, {0, 1, 2, 3}, efth, "units", units, NULL, NULL, "_FillValue", 9e36, false}};
    nc_write(b, version, records ? 2 : 0, axes, 4, variables, 6);
}

static size_t cell(uint32_t time, uint32_t station, uint32_t frequency, uint32_t direction) {
    return ((time * 2 + station) * 2 + frequency) * 4 + direction;
}

static void times_places_and_directions_of_wavewatch(void **state) {
    (void)state;
    static nc_bytes b;
    double efth[CELLS] = {0};
    efth[cell(0, 0, 0, 0)] = 4.0; // going north
    efth[cell(0, 1, 0, 1)] = 3.0; // going east
    efth[cell(1, 0, 1, 2)] = 2.0;
    efth[cell(1, 1, 1, 3)] = 1.0;
    static const struct {
        uint32_t record, location;
        double energy, tp, from;
        const char *time;
    } expected[] = {{0, 1, 4, 10, 180, "2020-02-28T06:00Z"},
                    {0, 2, 3, 10, 270, "2020-02-28T06:00Z"},
                    {1, 1, 2, 5, 0, "2020-02-28T09:00Z"},
                    {1, 2, 1, 5, 90, "2020-02-28T09:00Z"}};
    for (int layout = 0; layout < 4; layout++) { // CDF-1 and CDF-2, fixed times and records
        write_ww3(&b, 1 + layout % 2, layout > 1, efth, "sea_surface_wave_to_direction", "m2 s rad-1");
        const bolan_spectrum_texts texts = nc_texts(&b);
        for (size_t i = 0; i < 4; i++) {
            const bolan_spectrum_options options = at(expected[i].record, expected[i].location);
            bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
            assert_string_equal(bolan_measured_spectrum_view(spectrum).time, expected[i].time);
            bolan_measured_spectrum_destroy(&spectrum);
            const bolan_sea_summary s = summary_with(&texts, &options);
            assert_near(s.m0, expected[i].energy * BOLAN_PI / 2.0 * 0.05, 1e-12);
            assert_near(s.tp, expected[i].tp, 1e-9);
            assert_near(remainder(s.from_deg - expected[i].from, 360.0), 0.0, 1e-6);
        }
        bolan_spectrum_options options = at(1, 0);
        assert_true(bolan_spectrum_options_set_location(&options, "-41,21.2"));
        assert_near(summary_with(&texts, &options).from_deg, 90.0, 1e-6);
        assert_int_equal(last_log_id, BOLAN_LOG_SPECTRUM_LOCATION);
        assert_non_null(strstr(last_sentence, "is number 2 at -41, 21, 22 km away")); // 0.2 degrees of latitude
    }
}

// Records of 9 shorts, 18 bytes: padded beside another variable with records, but not alone.
static void records_are_padded_unless_they_are_alone(void **state) {
    (void)state;
    static nc_bytes b;
    static const double three_hertz[3] = {0.1, 0.2, 0.3}, thirds[3] = {0, 120, 240};
    static const double efth[18] = {[9 + 3 + 1] = 700}; // the second time, frequency and direction
    const nc_dimension axes[] = {{"time", 0}, {"frequency", 3}, {"direction", 3}, {"moments", 2}};
    nc_variable variables[] = {
        {.name = "time", .rank = 1, .values = six_and_nine, .text_name = "units", .text = "hours since 2020-02-28"},
        {.name = "frequency", .rank = 1, .axes = {1}, .values = three_hertz},
        {.name = "direction", .rank = 1, .axes = {2}, .values = thirds},
        {.name = "efth",
         .rank = 3,
         .axes = {0, 1, 2},
         .values = efth,
         .shorts = true,
         .number_name = "scale_factor",
         .number = 0.01}};
    for (int alone = 0; alone < 2; alone++) {
        variables[0].axes[0] = alone ? 3 : 0;
        nc_write(&b, 1, 2, axes, 4, variables, 4);
        const bolan_spectrum_texts texts = nc_texts(&b);
        const bolan_spectrum_options options = record_number(1);
        const bolan_sea_summary s = summary_with(&texts, &options);
        assert_near(s.m0, 7.0 * 2.0 * BOLAN_PI / 3.0 * 0.1, 1e-9);
        assert_near(s.from_deg, 300.0, 1e-6);
        assert_near(s.tp, 5.0, 1e-9);
    }
}

static void the_file_says_from_and_degrees(void **state) {
    (void)state;
    static nc_bytes b;
    double efth[CELLS] = {0};
    efth[cell(0, 0, 0, 1)] = 4.0;
    write_ww3(&b, 1, false, efth, "sea_surface_wave_from_direction", "m2 s degree-1");
    const bolan_spectrum_texts texts = nc_texts(&b);
    const bolan_spectrum_options options = at(0, 1);
    const bolan_sea_summary s = summary_with(&texts, &options);
    assert_near(s.from_deg, 90.0, 1e-6);
    assert_near(s.m0, 4.0 * 90.0 * 0.05, 1e-10);
}

static void missing_densities_count_as_none(void **state) {
    (void)state;
    static nc_bytes b;
    double efth[CELLS];
    for (int i = 0; i < CELLS; i++) efth[i] = 9e36; // the fill value
    efth[cell(0, 0, 0, 0)] = 4.0;
    write_ww3(&b, 1, false, efth, "sea_surface_wave_to_direction", "m2 s rad-1");
    const bolan_spectrum_texts texts = nc_texts(&b);
    bolan_spectrum_options options = at(0, 1);
    assert_near(summary_with(&texts, &options).m0, 4.0 * BOLAN_PI / 2.0 * 0.05, 1e-12);
    assert_warned(BOLAN_LOG_SPECTRUM_MISSING, "87.5 % of the densities");
    options.location = 2;
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY,
                        "location 2 of 2 has no data at 2020-02-28T06:00Z");
}

// One time, four latitudes of one longitude.
static void era5_is_a_logarithm_over_numbered_axes(void **state) {
    (void)state;
    static nc_bytes b;
    static const double hour[1] = {1051152}, numbers[4] = {1, 2, 3, 4};
    static const double latitudes[4] = {50, 45, 40, 35}, longitude[1] = {10};
    double d2fd[2 * 4 * 4];
    for (int i = 0; i < 32; i++) d2fd[i] = -32767;
    d2fd[(1 * 4 + 2) * 4 + 3] = 1.0; // the second frequency, the third direction, the last latitude: 10^1
    const nc_dimension axes[] = {{"time", 1}, {"frequency", 2}, {"direction", 4}, {"latitude", 4}, {"longitude", 1}};
    nc_variable variables[] = {
        {"time", 1, {0}, hour, "units", "hours since 1900-01-01 00:00:00.0", "calendar", "gregorian", NULL, 0, false},
        {"frequency", 1, {1}, numbers, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"direction", 1, {2}, numbers, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"latitude", 1, {3}, latitudes, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"longitude", 1, {4}, longitude, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"d2fd", 4, {0, 1, 2, 3}, d2fd, "units", "m**2 s radian**-1", NULL, NULL, "_FillValue", -32767, false}};
    nc_write(&b, 2, 0, axes, 5, variables, 6);
    bolan_spectrum_texts texts = nc_texts(&b);
    bolan_spectrum_options options = at(0, 4);
    bolan_measured_spectrum *spectrum = parse_with(&texts, &options);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_string_equal(view.time, "2019-12-01T00:00Z"); // date -u -d '1900-01-01 1051152 hours'
    assert_near(view.omega[0], 2.0 * BOLAN_PI * 0.03453, 1e-12);
    assert_near(view.omega[1], 2.0 * BOLAN_PI * 0.03453 * 1.1, 1e-12);
    bolan_measured_spectrum_destroy(&spectrum);
    const bolan_sea_summary s = summary_with(&texts, &options);
    assert_near(s.m0, 10.0 * BOLAN_PI / 2.0 * 0.5 * 0.03453 * 0.1, 1e-12);
    assert_near(s.from_deg, 45.0, 1e-6); // the third of four directions goes to 225
    options.location = 3;
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_NO_ENERGY, "expected a place at sea");
    // An ensemble has one more axis, which nothing chooses from.
    const nc_dimension members[] = {{"time", 1}, {"frequency", 2}, {"direction", 4}, {"number", 4}, {"longitude", 1}};
    nc_write(&b, 2, 0, members, 5, variables, 6);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "variable d2fd: expected no axes but");
}

// CDIP's coefficients are of the compass angle FROM; NDBC gives directions and ratios.
static void buoys_give_moments(void **state) {
    (void)state;
    static nc_bytes b;
    static const double seconds[1] = {1577858400}, density[2] = {2, 1}, missing[2] = {-999.99, -999.99};
    static const double a1[2] = {-0.6, -0.6}, b1[2] = {0.6, 0.6}, here[1] = {33.5}, there[1] = {-118};
    const nc_dimension axes[] = {{"waveTime", 1}, {"waveFrequency", 2}};
    nc_variable variables[] = {
        {"waveTime", 1, {0}, seconds, "units", "seconds since 1970-01-01 00:00:00 UTC", NULL, NULL, NULL, 0, false},
        {"waveFrequency", 1, {1}, two_hertz, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"waveEnergyDensity", 2, {0, 1}, density, "units", "meter^2 second", NULL, NULL, NULL, 0, false},
        {"waveA1Value", 2, {0, 1}, a1, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"waveB1Value", 2, {0, 1}, b1, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"waveA2Value", 2, {0, 1}, missing, NULL, NULL, NULL, NULL, "_FillValue", -999.99, false},
        {"waveB2Value", 2, {0, 1}, missing, NULL, NULL, NULL, NULL, "_FillValue", -999.99, false},
        {"metaStationLatitude", 0, {0}, here, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"metaStationLongitude", 0, {0}, there, NULL, NULL, NULL, NULL, NULL, 0, false}};
    nc_write(&b, 1, 0, axes, 2, variables, 9);
    bolan_spectrum_texts texts = nc_texts(&b);
    bolan_spectrum_options options = at(0, 1);
    bolan_sea_summary s = summary_with(&texts, &options);
    assert_int_equal(warning_count, 0);
    assert_near(s.m0, 1.5 * 0.1, 1e-9);
    assert_near(s.from_deg, 135.0, 1e-6); // atan2(0.6, -0.6)
    assert_near(s.spread_deg, sqrt(2.0 * (1.0 - 0.6 * sqrt(2.0))) * 180.0 / BOLAN_PI, 1e-3);
    bolan_spectrum_contents *c = NULL;
    assert_int_equal(bolan_spectrum_contents_parse(&texts, &c), BOLAN_OK);
    assert_string_equal(c->format, "cdip");
    assert_string_equal(c->records[0].time, "2020-01-01T06:00Z");
    assert_near(c->places[0].x, -118.0, 0.0);
    assert_near(c->places[0].y, 33.5, 0.0);
    bolan_spectrum_contents_destroy(&c);

    static const double alpha1[2] = {200, 200}, r1[2] = {0.8, 0.8}, r2[2] = {0.5, 0.5}, bad[2] = {1.5, 0.5};
    const nc_dimension ndbc_axes[] = {{"time", 1}, {"frequency", 2}, {"latitude", 1}, {"longitude", 1}};
    nc_variable ndbc[] = {
        {"time", 1, {0}, seconds, "units", "seconds since 1970-01-01 00:00:00 UTC", NULL, NULL, NULL, 0, false},
        {"frequency", 1, {1}, two_hertz, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"spectral_wave_density", 4, {0, 1, 2, 3}, density, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"mean_wave_dir", 4, {0, 1, 2, 3}, alpha1, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"principal_wave_dir", 4, {0, 1, 2, 3}, alpha1, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"wave_spectrum_r1", 4, {0, 1, 2, 3}, r1, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"wave_spectrum_r2", 4, {0, 1, 2, 3}, r2, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"latitude", 1, {2}, here, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"longitude", 1, {3}, there, NULL, NULL, NULL, NULL, NULL, 0, false}};
    nc_write(&b, 1, 0, ndbc_axes, 4, ndbc, 9);
    texts = nc_texts(&b);
    s = summary_with(&texts, &options);
    assert_near(s.m0, 1.5 * 0.1, 1e-9);
    assert_near(s.from_deg, 200.0, 1e-4);
    assert_near(s.spread_deg, sqrt(2.0 * 0.2) * 180.0 / BOLAN_PI, 1e-3);
    ndbc[5].values = bad;
    nc_write(&b, 1, 0, ndbc_axes, 4, ndbc, 9);
    texts = nc_texts(&b);
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "variable wave_spectrum_r1: expected values of 0 to 1");
}

static void what_is_wrong_is_named_with_its_variable(void **state) {
    (void)state;
    static nc_bytes b;
    double efth[CELLS] = {0};
    const bolan_spectrum_options options = at(0, 1);
    efth[cell(0, 0, 0, 1)] = -1.0;
    write_ww3(&b, 1, false, efth, "sea_surface_wave_to_direction", "m2 s rad-1");
    bolan_spectrum_texts texts = nc_texts(&b);
    assert_refused_with(&texts, &options, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                        "file.nc: variable efth: expected densities");
    static const double falling[2] = {0.2, 0.1};
    const nc_dimension axes[] = {{"time", 1}, {"frequency", 2}, {"direction", 4}};
    nc_variable variables[] = {
        {"time", 1, {0}, six_and_nine, "units", "fortnights since 2020-02-28", NULL, NULL, NULL, 0, false},
        {"frequency", 1, {1}, falling, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"direction", 1, {2}, four_degrees, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"efth", 3, {0, 1, 2}, efth, NULL, NULL, NULL, NULL, NULL, 0, false}};
    nc_write(&b, 1, 0, axes, 3, variables, 4);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "variable time: expected units such as");
    variables[0].text = "days since 2020-02-30";
    nc_write(&b, 1, 0, axes, 3, variables, 4);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "variable time");
    variables[0].text = "days since 2020-02-28";
    variables[0].second_name = "calendar", variables[0].second = "360_day";
    nc_write(&b, 1, 0, axes, 3, variables, 4);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "the Gregorian calendar");
    variables[0].second = "standard";
    nc_write(&b, 1, 0, axes, 3, variables, 4);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX,
                   "variable frequency: expected ascending frequencies");
    nc_write(&b, 1, 0, axes, 3, variables, 3);
    texts = nc_texts(&b);
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT, "expected a variable efth");
    b.data[3] = 5;
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "CDF-5");
    b.data[3] = 7;
    assert_refused(&texts, 0, BOLAN_ERROR_FORMAT, BOLAN_LOG_SPECTRUM_SYNTAX, "not NetCDF of the classic layout");
}

static void every_truncation_is_refused(void **state) {
    (void)state;
    static nc_bytes b;
    double efth[CELLS] = {0};
    efth[0] = 1.0;
    write_ww3(&b, 2, true, efth, "sea_surface_wave_to_direction", "m2 s rad-1");
    for (size_t size = 4; size < b.size; size++) {
        char *copy = malloc(size); // exactly as long, so that a sanitizer sees any step beyond
        memcpy(copy, b.data, size);
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){"cut.nc", copy, size};
        bolan_measured_spectrum *spectrum;
        assert_int_equal(bolan_measured_spectrum_parse(&texts, NULL, &spectrum), BOLAN_ERROR_FORMAT);
        free(copy);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_places_and_directions_of_wavewatch),
        cmocka_unit_test(records_are_padded_unless_they_are_alone),
        cmocka_unit_test(the_file_says_from_and_degrees),
        cmocka_unit_test(missing_densities_count_as_none),
        cmocka_unit_test(era5_is_a_logarithm_over_numbered_axes),
        cmocka_unit_test(buoys_give_moments),
        cmocka_unit_test(what_is_wrong_is_named_with_its_variable),
        cmocka_unit_test(every_truncation_is_refused),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
