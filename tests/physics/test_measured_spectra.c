// SPDX-License-Identifier: MIT
// Real files: the integral parameters of each, computed independently from the same text (trapezoid rule in frequency,
// rectangle rule in direction), to 0.5 % and 0.5 degrees; and that nothing is lost on the way to wave vectors.
#include "spectrum_support.h"

typedef struct expected_sea {
    double hs, tp, tm02, te, from_deg, spread_deg; // from_deg < 0: the file has no directions
} expected_sea;

static void assert_sea(const bolan_spectrum_texts *texts, uint32_t record, expected_sea expected) {
    bolan_measured_spectrum *spectrum = parse(texts, record);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    assert_ratio(summary.hs, expected.hs, 0.005);
    assert_ratio(summary.tp, expected.tp, 0.005);
    assert_ratio(summary.tm02, expected.tm02, 0.005);
    assert_ratio(summary.te, expected.te, 0.005);
    if (expected.from_deg >= 0.0) {
        assert_near(summary.from_deg, expected.from_deg, 0.5);
        assert_near(summary.spread_deg, expected.spread_deg, 0.5);
    }
    bolan_measured_spectrum_destroy(&spectrum);
    assert_null(spectrum);
}

static bolan_spectrum_texts swan_texts(void) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("swan_maari_lonlat_24f36d.spec");
    return texts;
}

static void a_swan_model_off_taranaki_reads_as_published(void **state) {
    (void)state;
    bolan_spectrum_texts texts = swan_texts();
    assert_sea(&texts, 0, (expected_sea){1.7158, 13.5685, 7.6839, 10.7262, 250.02, 21.06});
    assert_sea(&texts, 4, (expected_sea){4.2587, 13.5685, 7.3809, 10.1755, 254.11, 23.27});
    assert_int_equal(warning_count, 0);
    bolan_measured_spectrum *spectrum = parse(&texts, 4);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_int_equal(view.frequency_count, 24);
    assert_int_equal(view.direction_count, 36);
    assert_int_equal(view.record_count, 5);
    assert_string_equal(view.time, "2016-10-15T00:00:00");
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

static void an_ndbc_history_table_reads_as_published(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("ndbc_44004w2000.txt");
    assert_sea(&texts, 0, (expected_sea){1.2881, 7.6923, 4.5871, 5.6040, -1, 0});
    assert_warned(BOLAN_LOG_SPECTRUM_NO_DIRECTIONS, "270 degrees");
    release_texts(&texts);
}

static void an_ndbc_directional_buoy_reads_as_published(void **state) {
    (void)state;
    bolan_spectrum_texts texts = buoy_41010();
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_int_equal(view.record_count, 149);
    assert_string_equal(view.time, "2020-06-01T00:50Z"); // the last row of the text is the earliest record
    bolan_measured_spectrum_destroy(&spectrum);
    spectrum = parse(&texts, 148);
    assert_string_equal(bolan_measured_spectrum_view(spectrum).time, "2020-06-08T03:50Z"); // the first row, the newest
    bolan_measured_spectrum_destroy(&spectrum);
    assert_sea(&texts, 148, (expected_sea){1.1188, 5.5556, 5.0274, 5.9151, 158.6, 49.6});
    assert_int_equal(warning_count, 0);
    release_texts(&texts);
}

// The first record's values are published with the file's other readers; the last was summed from the same text.
static void a_wavewatch_point_reads_as_published(void **state) {
    (void)state;
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("ww3_44097_50f36d.spec");
    assert_sea(&texts, 0, (expected_sea){1.1573, 13.5685, 8.1275, 11.5393, 113.48, 25.91});
    assert_sea(&texts, 3, (expected_sea){1.0821, 13.5685, 8.5778, 11.6489, 113.08, 23.47});
    assert_int_equal(warning_count, 0);
    bolan_measured_spectrum *spectrum = parse(&texts, 3);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    assert_int_equal(view.record_count, 4);
    assert_int_equal(view.frequency_count, 50);
    assert_int_equal(view.direction_count, 36);
    assert_string_equal(view.time, "2022-09-12T09:00:00");
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

static void no_buoy_record_turns_negative(void **state) {
    (void)state;
    bolan_spectrum_texts texts = buoy_41010();
    for (uint32_t record = 0; record < 149; record += 7) {
        bolan_measured_spectrum *spectrum = parse(&texts, record);
        const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
        for (uint32_t i = 0; i < view.frequency_count * view.direction_count; i++) assert_true(view.density[i] >= 0.0);
        bolan_measured_spectrum_destroy(&spectrum);
    }
    release_texts(&texts);
}

// Bilinear interpolation of the density is the trapezoid rule once integrated, so only the steps of this test's own sum
// remain: 0.5 % is the promise, 0.01 % the steps.
static void wave_vectors_hold_the_variance_of_the_file(void **state) {
    (void)state;
    bolan_spectrum_texts texts = swan_texts();
    for (uint32_t record = 0; record < 5; record++) {
        bolan_measured_spectrum *spectrum = parse(&texts, record);
        bolan_sea_state sea_state = sea_of(spectrum);
        sea_state.depth = record % 2 ? 30.0 : BOLAN_DEEP;
        const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
        const double k0 = bolan_k_from_omega(view.omega[0], sea_state.depth);
        const double k1 = bolan_k_from_omega(view.omega[view.frequency_count - 1], sea_state.depth);
        const double m0 = bolan_sea_state_summary(&sea_state).m0;
        assert_ratio(wavenumber_variance(&sea_state, k0, k1, 2000, 72), m0, 1e-4);
        bolan_measured_spectrum_destroy(&spectrum);
    }
    release_texts(&texts);
}

static void the_short_waves_continue_the_file_as_the_inverse_fifth_power(void **state) {
    (void)state;
    bolan_spectrum_texts texts = swan_texts();
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    const double last = view.omega[view.frequency_count - 1];
    double before = 0.0, after = 0.0, later = 0.0;
    for (int j = 0; j < 36; j++) {
        const double th = j * BOLAN_PI / 18.0, ks[3] = {bolan_k_from_omega(0.999 * last, BOLAN_DEEP),
                                                        bolan_k_from_omega(1.001 * last, BOLAN_DEEP),
                                                        bolan_k_from_omega(3.003 * last, BOLAN_DEEP)};
        double s[3]; // S(w, th) = Psi k / (dw/dk)
        for (int i = 0; i < 3; i++)
            s[i] = bolan_sea_state_wavenumber_density(&sea_state, ks[i] * cos(th), ks[i] * sin(th)) * ks[i] /
                   bolan_group_speed(ks[i], BOLAN_DEEP);
        before += s[0];
        after += s[1];
        later += s[2];
        assert_true(bolan_sea_state_density(&sea_state, 1.001 * last, th) == 0.0); // only synthesis sees the tail
    }
    assert_ratio(after, before, 0.02); // no step in S(w): two samples 0.2 % of w apart
    assert_ratio(later, after * pow(3.0, -5.0), 1e-9);
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

// A single band above the peak can be a few rounded counts: the tail takes the mean directions of the last three.
static void the_short_waves_run_like_the_last_three_bands(void **state) {
    (void)state;
    bolan_spectrum_texts texts = swan_texts();
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    const uint32_t n = view.direction_count, rows = view.frequency_count;
    double expected[36], total = 0.0, actual[36], sum = 0.0;
    const double k = bolan_k_from_omega(2.0 * view.omega[rows - 1], BOLAN_DEEP);
    for (uint32_t j = 0; j < n; j++) {
        expected[j] = 0.0;
        for (uint32_t i = rows - 3; i < rows; i++) expected[j] += view.density[i * n + j] * pow(view.omega[i], 5.0);
        actual[j] = bolan_sea_state_wavenumber_density(&sea_state, k * cos(view.theta[j]), k * sin(view.theta[j]));
        total += expected[j];
        sum += actual[j];
    }
    for (uint32_t j = 0; j < n; j++) assert_near(actual[j] / sum, expected[j] / total, 1e-9);
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

static void a_measured_sea_and_a_swell_add_up(void **state) {
    (void)state;
    bolan_spectrum_texts texts = swan_texts();
    bolan_measured_spectrum *spectrum = parse(&texts, 0);
    bolan_sea_state sea_state = sea_of(spectrum);
    const double m0 = bolan_sea_state_summary(&sea_state).m0;
    assert_int_equal(bolan_sea_state_add_swell(&sea_state, 3.0, 16.0, 200.0, 30.0), BOLAN_OK);
    const bolan_sea_summary both = bolan_sea_state_summary(&sea_state);
    assert_ratio(both.m0, m0 + 9.0 / 16.0, 1e-6);
    assert_ratio(both.tp, 16.0, 0.01);
    bolan_measured_spectrum_destroy(&spectrum);
    release_texts(&texts);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_swan_model_off_taranaki_reads_as_published),
        cmocka_unit_test(an_ndbc_history_table_reads_as_published),
        cmocka_unit_test(an_ndbc_directional_buoy_reads_as_published),
        cmocka_unit_test(a_wavewatch_point_reads_as_published),
        cmocka_unit_test(no_buoy_record_turns_negative),
        cmocka_unit_test(wave_vectors_hold_the_variance_of_the_file),
        cmocka_unit_test(the_short_waves_continue_the_file_as_the_inverse_fifth_power),
        cmocka_unit_test(the_short_waves_run_like_the_last_three_bands),
        cmocka_unit_test(a_measured_sea_and_a_swell_add_up),
    };
    return cmocka_run_group_tests(tests, capture_log, release_log);
}
