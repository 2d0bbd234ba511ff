// SPDX-License-Identifier: MIT
// Real files of buoys and models: height, periods, direction and spread of each, computed independently from the same
// bytes (trapezoid rule in frequency, rectangle rule in direction) or printed by the buoy itself, to 0.5 % and 0.5
// degrees. Each direction fails when its format is turned: FROM for TO, or compass for mathematical.
#include "netcdf_support.h"

typedef struct expected_sea {
    const char *file;
    uint32_t record, location;
    double hs, tp, tm02, te, from_deg, spread_deg; // from_deg < 0: the file has no directions
} expected_sea;

static void the_table_of_real_files_holds(void **state) {
    (void)state;
    static const expected_sea table[] = {
        {"ww3_netcdf.nc", 0, 1, 0.7413, 13.7075, 6.7588, 9.9313, 209.33, 39.20},
        {"era5_spectra.nc", 0, 26, 2.0952, 11.1655, 8.3927, 10.0357, 22.68, 44.13}, // latitude 2, longitude 5
        {"triaxys_20180131.DIRSPEC", 0, 0, 3.4128, 11.1111, 7.2344, 9.1506, 230.83, 38.88},
        {"triaxys_20180131.NONDIRSPEC", 0, 0, 3.4349, 11.1111, 0, 0, -1, 0},
        {"datawell_20240909T0115Z.spt", 0, 0, 0.8488, 6.25, 4.5687, 5.5965, -1, 0},
        // The buoy's own mean direction and spread: 349.21 and 69.95; Hs as printed 1.62.
        {"spotter_20180214.json", 0, 0, 1.6214, 10.24, 8.1818, 9.9661, 349.21, 69.95},
        {"spotter_20180214.json", 1, 0, 1.6685, 14.63, 7.3055, 9.0167, 355.16, 65.48},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const expected_sea *e = &table[i];
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = load_text(e->file);
        bolan_spectrum_options options = record_number(e->record);
        options.location = e->location;
        const bolan_sea_summary s = summary_with(&texts, &options);
        assert_ratio(s.hs, e->hs, 0.005);
        assert_ratio(s.tp, e->tp, 0.005);
        if (e->tm02 > 0.0) assert_ratio(s.tm02, e->tm02, 0.005);
        if (e->te > 0.0) assert_ratio(s.te, e->te, 0.005);
        if (e->from_deg >= 0.0) {
            assert_near(s.from_deg, e->from_deg, 0.5);
            assert_near(s.spread_deg, e->spread_deg, 0.5);
        }
        free((char *)texts.density.data);
    }
    assert_int_equal(bolan_memory_in_use(), 0);
}

// The header of the file: Hs 85.0 cm, Tz 4.545 s.
static void a_waverider_agrees_with_its_own_header(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("datawell_20240909T0115Z.spt");
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    assert_int_equal(warning_count, 0);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_sea_summary s = bolan_sea_state_summary(&sea_state);
    assert_ratio(s.hs, 0.850, 0.005);
    assert_ratio(s.tm02, 4.545, 0.006);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2024-09-09T01:15Z"); // of the file's name
    bolan_measured_spectrum_destroy(&spectrum);
    free((char *)texts.density.data);
}

// HSig and VMD of each record's header. VMD is the mean weighted by 1/f; cells are printed with five decimals, which
// loses up to 0.7 % of the height.
static void an_octopus_forecast_agrees_with_its_own_header(void **state) {
    (void)state;
    static const double hsig[5] = {1.1023, 0.9505, 2.2096, 2.8375, 2.0204};
    static const double vmd[5] = {239.2, 262.6, 251.0, 247.5, 246.8};
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("octopus_maari_20180311.oct");
    for (uint32_t record = 0; record < 5; record++) {
        bolan_measured_spectrum *spectrum = parse(&texts, record);
        const bolan_sea_state sea_state = sea_of(spectrum);
        assert_ratio(bolan_sea_state_summary(&sea_state).hs, hsig[record], 0.008);
        const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
        double x = 0.0, y = 0.0;
        for (uint32_t i = 0; i < view.frequency_count; i++) {
            const double width =
                0.5 * (view.omega[i + 1 < view.frequency_count ? i + 1 : i] - view.omega[i ? i - 1 : 0]);
            for (uint32_t j = 0; j < view.direction_count; j++) {
                const double e = view.density[i * view.direction_count + j] * width / view.omega[i];
                x += e * cos(view.theta[j]);
                y += e * sin(view.theta[j]);
            }
        }
        assert_near(bolan_math_to_compass_from(atan2(y, x)), vmd[record], 0.1);
        bolan_measured_spectrum_destroy(&spectrum);
    }
    free((char *)texts.density.data);
}

typedef struct moments {
    double density, a1, b1, a2, b2;
} moments;

// The Fourier moments of one band, by the angle that waves go TO, counter-clockwise from the east.
static moments moments_of(const bolan_measured_view *view, double hertz) {
    uint32_t row = 0;
    while (row + 1 < view->frequency_count && fabs(view->omega[row] / (2.0 * BOLAN_PI) - hertz) > 1e-6) row++;
    moments m = {0};
    const double step = 2.0 * BOLAN_PI / view->direction_count;
    for (uint32_t j = 0; j < view->direction_count; j++) {
        const double e = view->density[row * view->direction_count + j] * step, th = view->theta[j];
        m.density += e;
        m.a1 += e * cos(th), m.b1 += e * sin(th);
        m.a2 += e * cos(2.0 * th), m.b2 += e * sin(2.0 * th);
    }
    m.a1 /= m.density, m.b1 /= m.density, m.a2 /= m.density, m.b2 /= m.density;
    m.density *= 2.0 * BOLAN_PI;
    return m;
}

// Maximum entropy keeps all four moments of the buoy; the coefficients are those of the file.
static void the_moments_of_a_spotter_come_back(void **state) {
    (void)state;
    static const struct {
        double hertz, density, a1, b1, a2, b2;
    } bands[] = {{0.05859, 1.252804608, -0.399804, -0.527859, -0.16911, 0.308895},
                 {0.06836, 2.032244736, -0.442815, -0.521017, 0.0, 0.381232},
                 {0.09766, 2.343573504, 0.337243, -0.194526, 0.366569, -0.325513},
                 {0.15625, 0.897970176, 0.041056, -0.193548, -0.217986, -0.195503},
                 {0.22461, 0.115528704, -0.176931, -0.420332, -0.245357, 0.103617}};
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("spotter_20180214.json");
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    for (size_t i = 0; i < sizeof bands / sizeof *bands; i++) {
        const moments m = moments_of(&view, bands[i].hertz);
        assert_ratio(m.density, bands[i].density, 1e-9);
        assert_near(m.a1, bands[i].a1, 1e-5);
        assert_near(m.b1, bands[i].b1, 1e-5);
        assert_near(m.a2, bands[i].a2, 1e-5);
        assert_near(m.b2, bands[i].b2, 1e-5);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    free((char *)texts.density.data);
}

// Direction, spread, skewness and kurtosis of the rows, by their definitions (Kuik et al. 1988) in compass angles.
static void the_moments_of_a_waverider_come_back(void **state) {
    (void)state;
    static const struct {
        double hertz, share, from, spread, skewness, kurtosis;
    } rows[] = {{0.16, 1.0, 220.8, 32.7, 2.59, 6.64},
                {0.17, 0.9802, 213.8, 40.0, 2.40, 5.76},
                {0.21, 0.31192, 208.1, 38.2, 0.92, 4.97},
                {0.28, 0.11648, 227.8, 47.3, -0.34, 2.17},
                {0.30, 0.10753, 215.2, 40.8, -0.29, 3.04}};
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("datawell_20240909T0115Z.spt");
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const moments m = moments_of(&view, rows[i].hertz);
        // An angle TO from the east is 270 - FROM, clockwise: the sine terms change their sign.
        const double to = (270.0 - rows[i].from) * BOLAN_PI / 180.0;
        const double m1 = m.a1 * cos(to) + m.b1 * sin(to), n1 = m.a1 * sin(to) - m.b1 * cos(to);
        const double m2 = m.a2 * cos(2.0 * to) + m.b2 * sin(2.0 * to);
        const double n2 = m.a2 * sin(2.0 * to) - m.b2 * cos(2.0 * to);
        assert_ratio(m.density, rows[i].share * 0.54183, 1e-9);
        assert_near(n1, 0.0, 1e-5); // the direction
        assert_near(sqrt(2.0 * (1.0 - m1)) * 180.0 / BOLAN_PI, rows[i].spread, 1e-3);
        assert_near(-n2 / pow(0.5 * (1.0 - m2), 1.5), rows[i].skewness, 1e-3);
        assert_near((6.0 - 8.0 * m1 + 2.0 * m2) / pow(2.0 * (1.0 - m1), 2.0), rows[i].kurtosis, 1e-3);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    free((char *)texts.density.data);
}

// The densities of a CDIP buoy, which MHKiT publishes with the sea's parameters, as the NetCDF that CDIP serves. MHKiT
// sums over the buoy's band widths, which the trapezoid rule follows to 0.3 %.
static void a_cdip_buoy_has_the_published_parameters(void **state) {
    (void)state;
    static nc_bytes b;
    static const double time[1] = {0};
    const bolan_spectrum_text json = load_text("mhkit_ValData2_CDiP.json");
    double hertz[64], density[64];
    const char *next = strstr(json.data, "\"S\": {") + 5;
    for (int i = 0; i < 64; i++) {
        int used = 0;
        assert_int_equal(sscanf(next, "%*[^\"]\"%lf\": %lf%n", &hertz[i], &density[i], &used), 2);
        next += used;
    }
    const nc_dimension axes[] = {{"waveTime", 1}, {"waveFrequency", 64}};
    const nc_variable variables[] = {
        {"waveTime", 1, {0}, time, "units", "seconds since 2020-01-01 00:00:00 UTC", NULL, NULL, NULL, 0, false},
        {"waveFrequency", 1, {1}, hertz, NULL, NULL, NULL, NULL, NULL, 0, false},
        {"waveEnergyDensity", 2, {0, 1}, density, NULL, NULL, NULL, NULL, NULL, 0, false}};
    nc_write(&b, 1, 0, axes, 2, variables, 3);
    const bolan_spectrum_texts texts = nc_texts(&b);
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.from_deg = 270.0;
    options.spread_s = 10.0;
    const bolan_sea_summary s = summary_with(&texts, &options);
    assert_ratio(s.hs, 3.04809, 0.003);
    assert_ratio(s.te, 8.90335, 0.003);
    assert_ratio(s.tm02, 6.97749, 0.003);
    assert_ratio(s.tp, 11.7647, 1e-5);
    free((char *)json.data);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_of_real_files_holds),
        cmocka_unit_test(a_waverider_agrees_with_its_own_header),
        cmocka_unit_test(an_octopus_forecast_agrees_with_its_own_header),
        cmocka_unit_test(a_cdip_buoy_has_the_published_parameters),
        cmocka_unit_test(the_moments_of_a_spotter_come_back),
        cmocka_unit_test(the_moments_of_a_waverider_come_back),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
