// SPDX-License-Identifier: MIT
/// @file spectrum_support.h
/// What the tests of the spectra share: closeness, a log that remembers its last message, and files of measured
/// spectra.
#ifndef BOLAN_TESTS_SPECTRUM_SUPPORT_H
#define BOLAN_TESTS_SPECTRUM_SUPPORT_H

#include "bolan/formats.h"
#include "bolan/math.h"
#include "bolan/spectrum.h"

#include "support.h"

#include <string.h>

/// assert_near() with a tolerance relative to the expected value.
#define assert_ratio(actual, expected, tolerance) assert_near(actual, expected, (tolerance)*fabs(expected))

static bolan_log_id last_log_id;
static char last_sentence[512];
static int warning_count; ///< since the last parse() or assert_refused() began

static inline void remember_log(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    warning_count += level == BOLAN_LOG_WARNING;
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

/// A file of tests/data/spectra, in memory that the test frees.
static inline bolan_spectrum_text load_text(const char *name) {
    char path[1024];
    snprintf(path, sizeof path, "%s/tests/data/spectra/%s", BOLAN_SOURCE_DIR, name);
    FILE *file = fopen(path, "rb");
    if (!file) print_error("%s is not there\n", path);
    assert_non_null(file);
    enum { CAPACITY = 1 << 20 };
    char *data = malloc(CAPACITY);
    assert_non_null(data);
    const bolan_spectrum_text text = {name, data, fread(data, 1, CAPACITY, file)};
    fclose(file);
    return text;
}

/// The five tables of NDBC's buoy 41010, for release_texts().
static inline bolan_spectrum_texts buoy_41010(void) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = load_text("ndbc_41010.data_spec");
    texts.swdir = load_text("ndbc_41010.swdir");
    texts.swdir2 = load_text("ndbc_41010.swdir2");
    texts.swr1 = load_text("ndbc_41010.swr1");
    texts.swr2 = load_text("ndbc_41010.swr2");
    return texts;
}

static inline void release_texts(bolan_spectrum_texts *texts) {
    const bolan_spectrum_text all[5] = {texts->density, texts->swdir, texts->swdir2, texts->swr1, texts->swr2};
    for (int i = 0; i < 5; i++) free((char *)all[i].data);
}

static inline bolan_spectrum_text literal(const char *name, const char *data) {
    const bolan_spectrum_text text = {name, data, strlen(data)};
    return text;
}

/// The options that choose record number @p record.
static inline bolan_spectrum_options record_number(uint32_t record) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    options.record = record;
    return options;
}

/// Parses or fails the test.
static inline bolan_measured_spectrum *parse_with(const bolan_spectrum_texts *texts,
                                                  const bolan_spectrum_options *options) {
    bolan_measured_spectrum *spectrum = NULL;
    warning_count = 0;
    const bolan_result result = bolan_measured_spectrum_parse(texts, options, &spectrum);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    assert_non_null(spectrum);
    return spectrum;
}

static inline bolan_measured_spectrum *parse(const bolan_spectrum_texts *texts, uint32_t record) {
    const bolan_spectrum_options options = record_number(record);
    return parse_with(texts, &options);
}

static inline bolan_sea_state sea_of(const bolan_measured_spectrum *spectrum) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    return sea_state;
}

static inline bolan_sea_summary summary_with(const bolan_spectrum_texts *texts, const bolan_spectrum_options *options) {
    bolan_measured_spectrum *spectrum = parse_with(texts, options);
    const bolan_sea_state sea_state = sea_of(spectrum);
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    bolan_measured_spectrum_destroy(&spectrum);
    return summary;
}

/// The last parse() gave exactly one warning, with this id, in a sentence that holds @p part.
static inline void assert_warned(bolan_log_id id, const char *part) {
    if (warning_count != 1 || last_log_id != id || !strstr(last_sentence, part))
        print_error("got %d warnings, %d \"%s\", expected \"%s\"\n", warning_count, (int)last_log_id, last_sentence,
                    part);
    assert_int_equal(warning_count, 1);
    assert_int_equal(last_log_id, id);
    assert_non_null(strstr(last_sentence, part));
}

/// The text must be refused with this message id and no warning, in a sentence that holds @p part, and leave nothing
/// behind.
static inline void assert_refused_with(const bolan_spectrum_texts *texts, const bolan_spectrum_options *options,
                                       bolan_result result, bolan_log_id id, const char *part) {
    bolan_measured_spectrum *spectrum = (bolan_measured_spectrum *)&last_log_id;
    const size_t before = bolan_memory_in_use();
    last_log_id = (bolan_log_id)0;
    warning_count = 0;
    assert_int_equal(bolan_measured_spectrum_parse(texts, options, &spectrum), result);
    if (last_log_id != id || !strstr(last_sentence, part))
        print_error("got %d \"%s\", expected \"%s\"\n", (int)last_log_id, last_sentence, part);
    assert_int_equal(last_log_id, id);
    assert_non_null(strstr(last_sentence, part));
    assert_int_equal(warning_count, 0);
    assert_null(spectrum);
    assert_int_equal(bolan_memory_in_use(), before);
}

static inline void assert_refused(const bolan_spectrum_texts *texts, uint32_t record, bolan_result result,
                                  bolan_log_id id, const char *part) {
    const bolan_spectrum_options options = record_number(record);
    assert_refused_with(texts, &options, result, id, part);
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
