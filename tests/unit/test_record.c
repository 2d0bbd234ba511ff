// SPDX-License-Identifier: MIT
// Records of sines and of few waves, whose statistics and spectra are known.
#include "support.h"

#include "bolan/record.h"

enum { COUNT = 4096 };
static float heave[COUNT], east[COUNT], north[COUNT];

// z = mean + a cos(k.x - w t + phase) at x = 0 of a wave that comes from `from`, and its displacement -sin.
static void add_wave(double a, double frequency, double from_deg, double phase, double rate) {
    const double to = bolan_compass_from_to_math(from_deg);
    for (int i = 0; i < COUNT; i++) {
        const double th = phase - 2.0 * BOLAN_PI * frequency * i / rate;
        heave[i] += (float)(a * cos(th));
        east[i] -= (float)(a * cos(to) * sin(th));
        north[i] -= (float)(a * sin(to) * sin(th));
    }
}

static void clear(void) {
    for (int i = 0; i < COUNT; i++) heave[i] = east[i] = north[i] = 0.0f;
}

static void a_sine_has_the_statistics_of_a_sine(void **state) {
    (void)state;
    clear();
    add_wave(1.5, 0.1, 0.0, 0.3, 4.0);
    for (int i = 0; i < COUNT; i++) heave[i] += 7.0f;
    bolan_record_statistics s;
    assert_int_equal(bolan_record_measure(heave, COUNT, 4.0, &s), BOLAN_OK);
    assert_near(s.mean, 7.0, 0.01);
    assert_near(s.hm0, 4.0 * 1.5 / sqrt(2.0), 0.01);
    assert_near(s.kurtosis, 1.5, 0.01);
    assert_near(s.skewness, 0.0, 0.01);
    assert_int_equal(s.waves, 101); // of 102.4
    assert_near(s.h_third, 3.0, 0.01);
    assert_near(s.h_tenth, 3.0, 0.01);
    assert_near(s.h_max, 3.0, 0.01);
    assert_near(s.crest_max, 1.5, 0.01);
    assert_near(s.tz, 10.0, 1e-3);
    assert_near(s.t_third, 10.0, 0.02);
}

// Square pulses: heights 1 .. 30, each of 10 samples.
static void the_highest_third_and_tenth_are_what_they_say(void **state) {
    (void)state;
    float x[310];
    for (int i = 0; i < 310; i++) x[i] = (float)((i % 10 < 5 ? 0.5 : -0.5) * (1 + (i / 10 * 7) % 31 % 30));
    bolan_record_wave w[40];
    const uint32_t count = bolan_record_waves(x, 310, 10.0, 40, w);
    assert_true(count >= 29 && count <= 31);
    bolan_record_statistics s;
    assert_int_equal(bolan_record_measure(x, 310, 10.0, &s), BOLAN_OK);
    assert_int_equal(s.waves, count);
    double heights[40], sum = 0.0;
    for (uint32_t i = 0; i < count; i++) heights[i] = w[i].height, sum += w[i].height;
    for (uint32_t i = 0; i < count; i++) // the plainest of sorts
        for (uint32_t j = i + 1; j < count; j++)
            if (heights[j] > heights[i]) {
                const double t = heights[i];
                heights[i] = heights[j], heights[j] = t;
            }
    double third = 0.0, tenth = 0.0;
    for (uint32_t i = 0; i < (count + 2) / 3; i++) third += heights[i] / ((count + 2) / 3);
    for (uint32_t i = 0; i < (count + 9) / 10; i++) tenth += heights[i] / ((count + 9) / 10);
    assert_near(s.h_mean, sum / count, 1e-9);
    assert_near(s.h_third, third, 1e-9);
    assert_near(s.h_tenth, tenth, 1e-9);
    assert_near(s.h_max, heights[0], 1e-9);
    assert_near(s.tz, 1.0, 0.05);
    uint32_t higher = 0;
    for (uint32_t i = 0; i < count; i++) higher += heights[i] > 15.0;
    assert_near(bolan_record_exceedance(w, count, 15.0), (double)higher / count, 1e-12);
    assert_near(bolan_record_exceedance(w, count, 1000.0), 0.0, 0.0);
}

static void a_spectrum_has_the_variance_and_direction_of_its_waves(void **state) {
    (void)state;
    enum { SEGMENT = 256, BANDS = SEGMENT / 2 - 1 };
    static bolan_record_band b[BANDS];
    clear();
    add_wave(1.0, 10.0 * 2.0 / SEGMENT, 250.0, 0.4, 2.0); // in the middle of bands
    add_wave(0.3, 40.0 * 2.0 / SEGMENT, 20.0, 1.9, 2.0);
    assert_int_equal(bolan_record_spectrum(heave, east, north, COUNT, 2.0, SEGMENT, b), BOLAN_OK);
    double m0 = 0.0, low = 0.0;
    for (int i = 0; i < BANDS; i++) {
        assert_near(b[i].frequency, (i + 1) * 2.0 / SEGMENT, 1e-12);
        m0 += b[i].density * 2.0 / SEGMENT;
        if (i < 25) low += b[i].density * 2.0 / SEGMENT;
    }
    assert_near(low, 0.5, 0.001);
    assert_near(m0 - low, 0.045, 0.0001);
    assert_near(b[9].direction_from, 250.0, 0.01);
    assert_near(b[39].direction_from, 20.0, 0.01);
    assert_near(b[9].spread, 0.0, 0.5);
    assert_near(b[9].a2, cos(2.0 * bolan_compass_from_to_math(250.0)), 1e-4);
    assert_near(b[9].b2, sin(2.0 * bolan_compass_from_to_math(250.0)), 1e-4);
    // Two waves of one band at right angles: a circular spread of sqrt(2 (1 - cos 45)).
    clear();
    add_wave(1.0, 20.0 * 2.0 / SEGMENT, 0.0, 0.0, 2.0);
    add_wave(1.0, 20.0 * 2.0 / SEGMENT, 90.0, BOLAN_PI / 2.0, 2.0);
    assert_int_equal(bolan_record_spectrum(heave, east, north, COUNT, 2.0, SEGMENT, b), BOLAN_OK);
    assert_near(b[19].direction_from, 45.0, 0.1);
    assert_near(b[19].a1, -0.5, 0.01);
    assert_int_equal(bolan_record_spectrum(heave, NULL, NULL, COUNT, 2.0, SEGMENT, b), BOLAN_OK);
    assert_true(b[19].density > 0.0 && b[19].spread == 0.0 && b[19].a1 == 0.0);
}

static bolan_log_id said;
static void keep_id(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)sentence;
    said = id;
}

static void what_is_no_record_is_refused(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = keep_id});
    bolan_record_statistics s;
    bolan_record_band b[8];
    assert_int_equal(bolan_record_measure(heave, 1, 2.0, &s), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_record_measure(heave, 10, 0.0, &s), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_record_spectrum(heave, NULL, NULL, 15, 2.0, 16, b), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_record_spectrum(heave, NULL, NULL, 40, 2.0, 18, b), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_record_measure(heave, 10, (double)INFINITY, &s), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_record_spectrum(heave, NULL, NULL, 40, (double)INFINITY, 16, b), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(said, BOLAN_LOG_BAD_ARGUMENT);
    // A gap, in any channel and place.
    clear();
    static float *const channels[3] = {heave, east, north};
    for (int c = 0; c < 3; c++) {
        channels[c][39] = c ? INFINITY : NAN, said = 0;
        if (c == 0) assert_int_equal(bolan_record_measure(heave, 40, 2.0, &s), BOLAN_ERROR_ARGUMENT);
        assert_int_equal(bolan_record_spectrum(heave, east, north, 40, 2.0, 16, b), BOLAN_ERROR_ARGUMENT);
        assert_int_equal(said, BOLAN_LOG_NOT_FINITE);
        clear();
        assert_int_equal(bolan_record_spectrum(heave, east, north, 40, 2.0, 16, b), BOLAN_OK);
    }
    assert_int_equal(bolan_record_measure(heave, 100, 2.0, &s), BOLAN_OK); // a calm
    assert_true(s.waves == 0 && s.hm0 == 0.0 && s.h_max == 0.0 && s.kurtosis == 3.0);
    assert_int_equal(bolan_memory_in_use(), 0);
    bolan_set_hooks(NULL);
}

RUN_TESTS(cmocka_unit_test(a_sine_has_the_statistics_of_a_sine),
          cmocka_unit_test(the_highest_third_and_tenth_are_what_they_say),
          cmocka_unit_test(a_spectrum_has_the_variance_and_direction_of_its_waves),
          cmocka_unit_test(what_is_no_record_is_refused))
