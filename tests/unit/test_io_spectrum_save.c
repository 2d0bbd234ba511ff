// SPDX-License-Identifier: MIT
// Spectra as files: SWAN text that reads back equal, a table that holds the variance, a plot that shows the sea.
#include "io_support.h"

#include "bolan/io.h"

#include <math.h>
#include <stdlib.h>

static bolan_sea_state mixed_sea(void) {
    bolan_sea_state sea_state = bolan_sea_state_from_wind(10.0, 240.0, 100e3);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 1.5, 14.0, 150.0, 40.0), BOLAN_OK);
    return sea_state;
}

static void assert_reads_back(const bolan_sea_state *sea_state, const char *path) {
    bolan_measured_spectrum *asked = NULL, *read = NULL;
    assert_int_equal(bolan_measured_spectrum_sample(sea_state, &asked), BOLAN_OK);
    assert_int_equal(bolan_spectrum_save(path, sea_state, "a sea"), BOLAN_OK);
    assert_int_equal(bolan_spectrum_load(path, NULL, &read), BOLAN_OK);
    const bolan_measured_view a = bolan_measured_spectrum_view(asked), b = bolan_measured_spectrum_view(read);
    assert_int_equal(a.frequency_count, b.frequency_count);
    assert_int_equal(a.direction_count, b.direction_count);
    double largest = 0.0;
    for (uint32_t k = 0; k < a.frequency_count * a.direction_count; k++) largest = fmax(largest, a.density[k]);
    for (uint32_t i = 0; i < a.frequency_count; i++) assert_near(a.omega[i], b.omega[i], 1e-11 * a.omega[i]);
    for (uint32_t j = 0; j < a.direction_count; j++) {
        uint32_t same = 0; // the direction of both grids, which may begin at different ones
        while (same < b.direction_count && fabs(remainder(a.theta[j] - b.theta[same], 2.0 * BOLAN_PI)) > 1e-9) same++;
        assert_true(same < b.direction_count);
        for (uint32_t i = 0; i < a.frequency_count; i++)
            assert_near(a.density[i * a.direction_count + j], b.density[i * b.direction_count + same],
                        5.1e-8 * largest);
    }
    bolan_measured_spectrum_destroy(&asked);
    bolan_measured_spectrum_destroy(&read);
    remove(path);
}

static void swan_text_reads_back_equal(void **state) {
    (void)state;
    const bolan_sea_state sea_state = mixed_sea(), calm = bolan_sea_state_default();
    assert_reads_back(&sea_state, "save_a.spec");
    assert_reads_back(&calm, "save_a.spec");
    char path[1024];
    bolan_measured_spectrum *spectrum = NULL, *read = NULL;
    assert_int_equal(
        bolan_spectrum_load(test_data("spectra/spotter_20180214.json", path, sizeof path), NULL, &spectrum), BOLAN_OK);
    bolan_sea_state measured = bolan_sea_state_default();
    measured.measured = spectrum;
    assert_reads_back(&measured, "save_a.spec");
    // The time comes back, too.
    assert_int_equal(bolan_spectrum_save("save_a.spec", &measured, ""), BOLAN_OK);
    assert_int_equal(bolan_spectrum_load("save_a.spec", NULL, &read), BOLAN_OK);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2018-02-14T00:27Z");
    assert_string_equal(bolan_measured_spectrum_view(read).time, "2018-02-14T00:27:00");
    bolan_measured_spectrum_destroy(&spectrum);
    bolan_measured_spectrum_destroy(&read);
    remove("save_a.spec");
}

// Trapezoid rule in frequency, rectangle rule in direction, over the printed numbers.
static void the_table_holds_the_variance(void **state) {
    (void)state;
    const bolan_sea_state sea_state = mixed_sea();
    assert_int_equal(bolan_spectrum_save("save_b.csv", &sea_state, ""), BOLAN_OK);
    FILE *file = fopen("save_b.csv", "r");
    char head[256];
    assert_non_null(fgets(head, sizeof head, file));
    assert_string_equal(head, "frequency_hz,direction_from_deg,density_m2_per_hz_per_deg\n");
    double hertz, from, density, rows[96] = {0}, f[96], x = 0.0, y = 0.0;
    int count = 0;
    while (fscanf(file, "%lf,%lf,%lf", &hertz, &from, &density) == 3) {
        f[count / 72] = hertz;
        rows[count / 72] += density * 5.0;
        x += density * cos(from * BOLAN_PI / 180.0) * hertz; // a geometric row: df is f
        y += density * sin(from * BOLAN_PI / 180.0) * hertz;
        count++;
    }
    fclose(file);
    assert_int_equal(count, 96 * 72);
    double m0 = 0.0;
    for (int i = 0; i < 95; i++) m0 += 0.5 * (rows[i] + rows[i + 1]) * (f[i + 1] - f[i]);
    const bolan_sea_summary s = bolan_sea_state_summary(&sea_state);
    assert_near(m0, s.m0, 0.01 * s.m0);
    assert_near(atan2(y, x) * 180.0 / BOLAN_PI + 360.0, s.from_deg, 1.0);
    remove("save_b.csv");
}

// The darkest part of the disc lies where the swell comes from: south-east of the centre, at 1/14 Hz.
static void the_plot_shows_the_peak_where_it_is(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 3.0, 8.0, 135.0, 40.0), BOLAN_OK);
    assert_int_equal(bolan_spectrum_save("save_c.png", &sea_state, "swell"), BOLAN_OK);
    uint32_t width = 0, height = 0;
    uint8_t *rgb = NULL;
    assert_int_equal(bolan_image_read("save_c.png", &width, &height, &rgb), BOLAN_OK);
    assert_int_equal(width, 960);
    assert_int_equal(height, 720);
    double x = 0.0, y = 0.0, weight = 0.0, ink = 0.0;
    for (int j = 0; j < 720; j++)
        for (int i = 0; i < 960; i++) {
            const uint8_t *p = rgb + 3 * (j * 960 + i);
            const bool blue = p[2] > p[0] + 60; // the upper half of the scale
            if (i > 640) ink += p[0] < 60 && !blue;
            if (i > 640 || !blue) continue;
            x += i, y += j, weight += 1.0;
        }
    assert_true(weight > 100.0);
    assert_true(x / weight > 330.0 + 20.0 && y / weight > 385.0 + 20.0);
    assert_near(x / weight - 330.0, y / weight - 385.0, 12.0); // on the spoke to the south-east
    assert_true(ink > 200.0);                                  // and the system is named
    bolan_release(rgb, (size_t)width * height * 3);
    remove("save_c.png");
}

// Frequency grows outwards: of two swells, the shorter lies farther from the centre.
static void shorter_waves_lie_farther_out(void **state) {
    (void)state;
    bolan_sea_state sea_state = bolan_sea_state_default();
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 2.0, 12.0, 90.0, 40.0), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 2.8, 6.0, 270.0, 40.0), BOLAN_OK);
    assert_int_equal(bolan_spectrum_save("save_e.png", &sea_state, "swells"), BOLAN_OK);
    uint32_t width = 0, height = 0;
    uint8_t *rgb = NULL;
    assert_int_equal(bolan_image_read("save_e.png", &width, &height, &rgb), BOLAN_OK);
    double sum[2] = {0.0}, count[2] = {0.0}; // of distances to the west and to the east
    for (int i = 0; i < 640; i++) {
        const uint8_t *p = rgb + 3 * (385 * 960 + i);
        if (p[2] <= p[0] + 60) continue;
        sum[i > 330] += abs(i - 330);
        count[i > 330] += 1.0;
    }
    assert_true(count[0] > 3.0 && count[1] > 3.0);
    assert_near(sum[0] / count[0] / (sum[1] / count[1]), 2.0, 0.25);
    bolan_release(rgb, (size_t)width * height * 3);
    remove("save_e.png");
}

static void another_suffix_or_folder_is_refused(void **state) {
    (void)state;
    const bolan_sea_state sea_state = mixed_sea();
    assert_refusal(bolan_spectrum_save("save_d.txt", &sea_state, ""), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "save_d.txt: the suffix names no form of a spectrum; expected .png, .csv or .spec");
    assert_refusal(bolan_spectrum_save("save_none/a.csv", &sea_state, ""), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "save_none/a.csv");
    assert_refusal(bolan_spectrum_save("save_none/a.png", &sea_state, ""), BOLAN_ERROR_IO, BOLAN_LOG_FILE_WRITE,
                   "save_none/a.png");
    assert_int_equal(bolan_memory_in_use(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(swan_text_reads_back_equal),          cmocka_unit_test(the_table_holds_the_variance),
        cmocka_unit_test(the_plot_shows_the_peak_where_it_is), cmocka_unit_test(shorter_waves_lie_farther_out),
        cmocka_unit_test(another_suffix_or_folder_is_refused),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
