// SPDX-License-Identifier: MIT
// Any bytes as a file of spectra of any format: a valid sea that comes apart without loss, or one sentence of refusal,
// and never a step outside the bytes; what the file holds, likewise. The last byte picks the record and the location.
#include "bolan/formats.h"

#include <math.h>
#include <stdlib.h>

static unsigned errors;

static void count_errors(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)id;
    errors += level == BOLAN_LOG_ERROR && sentence[0] != '\0';
}

static void read_one(const bolan_spectrum_texts *texts, unsigned choice) {
    bolan_spectrum_options options = bolan_spectrum_options_default();
    bolan_measured_spectrum *spectrum = NULL;
    options.record = choice % 3u;
    options.location = choice / 3u % 3u;
    if (choice & 128u) options.place[0] = options.place[1] = 1.0;
    errors = 0;
    if (bolan_measured_spectrum_parse(texts, &options, &spectrum)) {
        if (errors != 1 || spectrum) abort();
        return;
    }
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
    if (errors || !(summary.m0 >= 0.0 && summary.hs <= 40.01)) abort();
    if (!(bolan_sea_state_wavenumber_density(&sea_state, 0.1, -0.2) >= 0.0)) abort();
    bolan_partition parts[BOLAN_MAX_PARTITIONS];
    uint32_t count = 0;
    if (bolan_sea_state_partition(&sea_state, parts, &count) || count > BOLAN_MAX_PARTITIONS) abort();
    double m0 = 0.0;
    for (uint32_t i = 0; i < count; i++) m0 += parts[i].hs * parts[i].hs / 16.0;
    if (!(fabs(m0 - summary.m0) <= 1e-6 * summary.m0 + 1e-300)) abort();
    bolan_measured_spectrum_destroy(&spectrum);
}

static void list_all(const bolan_spectrum_texts *texts) {
    bolan_spectrum_contents *contents = NULL;
    errors = 0;
    if (bolan_spectrum_contents_parse(texts, &contents)) {
        if (errors != 1 || contents) abort();
        return;
    }
    if (contents->record_count == 0 || !(contents->hs_min >= 0.0 && contents->hs_max <= 40.01)) abort();
    for (uint32_t i = 0; i < contents->place_count; i++)
        if (!isfinite(contents->places[i].x + contents->places[i].y)) abort();
    bolan_spectrum_contents_destroy(&contents);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bolan_set_hooks(&(bolan_hooks){.log = count_errors});
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = (bolan_spectrum_text){"fuzz}2024-09-09T01h15Z.spt", (const char *)data, size};
    read_one(&texts, size ? data[size - 1] : 0);
    list_all(&texts);
    if (bolan_memory_in_use() != 0) abort();
    return 0;
}
