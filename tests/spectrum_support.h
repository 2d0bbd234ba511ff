// SPDX-License-Identifier: MIT
/// @file spectrum_support.h
/// What the tests of the spectra share: closeness, a log that remembers its last message, and files of measured spectra.
#ifndef BOLAN_TESTS_SPECTRUM_SUPPORT_H
#define BOLAN_TESTS_SPECTRUM_SUPPORT_H

#include "bolan/math.h"
#include "bolan/spectrum.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#ifndef BOLAN_SHARED_DATA
#define BOLAN_SHARED_DATA ""
#endif

/// |actual - expected| <= tolerance, shown when not.
#define assert_near(actual, expected, tolerance) \
    assert_near_at((actual), (expected), (tolerance), #actual, __FILE__, __LINE__)
static inline void assert_near_at(double actual, double expected, double tolerance, const char *what, const char *file,
                                  int line) {
    if (fabs(actual - expected) <= tolerance) return;
    print_error("%s is %.10g, expected %.10g +- %g\n", what, actual, expected, tolerance);
    _assert_true(0, what, file, line);
}
/// The same, relative to the expected value.
#define assert_ratio(actual, expected, tolerance) assert_near(actual, expected, (tolerance)*fabs(expected))

static bolan_log_id last_log_id;
static char last_sentence[512];

static inline void remember_log(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    (void)level;
    last_log_id = id;
    snprintf(last_sentence, sizeof last_sentence, "%s", sentence);
}

/// cmocka fixture: messages go to last_log_id and last_sentence.
static inline int capture_log(void **state) {
    (void)state;
    bolan_hooks hooks = {0};
    hooks.log = remember_log;
    bolan_set_hooks(&hooks);
    last_log_id = (bolan_log_id)0;
    last_sentence[0] = '\0';
    return 0;
}

static inline int release_log(void **state) {
    (void)state;
    bolan_set_hooks(NULL);
    return 0;
}

/// A file of the shared data, below the folder that BOLAN_SHARED_DATA names; skips the test when it is not there.
static inline bolan_spectrum_text load_shared(const char *name) {
    const char *folder = getenv("BOLAN_SHARED_DATA");
    char path[1024];
    snprintf(path, sizeof path, "%s/spectra/%s", folder ? folder : BOLAN_SHARED_DATA, name);
    FILE *file = fopen(path, "rb");
    if (!file) {
        print_message("skipped: %s is not there\n", path);
        skip();
    }
    enum { CAPACITY = 1 << 20 };
    char *data = malloc(CAPACITY);
    assert_non_null(data);
    const bolan_spectrum_text text = {name, data, fread(data, 1, CAPACITY, file)};
    fclose(file);
    return text;
}

static inline bolan_spectrum_text literal(const char *name, const char *data) {
    const bolan_spectrum_text text = {name, data, strlen(data)};
    return text;
}

/// Parses or fails the test.
static inline bolan_measured_spectrum *parse(const bolan_spectrum_texts *texts, uint32_t record) {
    bolan_measured_spectrum *spectrum = NULL;
    const bolan_result result = bolan_measured_spectrum_parse(texts, record, &spectrum);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    assert_non_null(spectrum);
    return spectrum;
}

static inline bolan_sea_state sea_of(const bolan_measured_spectrum *spectrum) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    return sea_state;
}

/// The text must be refused with this message id, in a sentence that holds @p part, and leave nothing behind.
static inline void assert_refused(const bolan_spectrum_texts *texts, uint32_t record, bolan_result result,
                                  bolan_log_id id, const char *part) {
    bolan_measured_spectrum *spectrum = (bolan_measured_spectrum *)&last_log_id;
    const size_t before = bolan_memory_in_use();
    last_log_id = (bolan_log_id)0;
    assert_int_equal(bolan_measured_spectrum_parse(texts, record, &spectrum), result);
    if (last_log_id != id || !strstr(last_sentence, part))
        print_error("got %d \"%s\", expected \"%s\"\n", (int)last_log_id, last_sentence, part);
    assert_int_equal(last_log_id, id);
    assert_non_null(strstr(last_sentence, part));
    assert_null(spectrum);
    assert_int_equal(bolan_memory_in_use(), before);
}

/// The variance over all directions and wave numbers k0..k1: the integral of Psi, midpoint rule in ln k and th.
static inline double wavenumber_variance(const bolan_sea_state *sea_state, double k0, double k1, int steps,
                                         int angles) {
    const double dln = log(k1 / k0) / steps, dth = 2.0 * BOLAN_PI / angles;
    double sum = 0.0;
    for (int i = 0; i < steps; i++) {
        const double k = k0 * exp((i + 0.5) * dln);
        for (int j = 0; j < angles; j++)
            sum += bolan_sea_state_wavenumber_density(sea_state, k * cos(j * dth), k * sin(j * dth)) * k * k;
    }
    return sum * dln * dth;
}

#endif
