// SPDX-License-Identifier: MIT
// Any bytes as an NDBC density table with its four direction tables, which are divided by form feeds.
#include "bolan/formats.h"
#include "bolan/spectrum.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void silent(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id, (void)sentence;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const bolan_hooks hooks = {.log = silent};
    bolan_set_hooks(&hooks);
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    bolan_spectrum_text *parts[5] = {&texts.density, &texts.swdir, &texts.swdir2, &texts.swr1, &texts.swr2};
    const char *next = (const char *)data, *end = next + size;
    for (int i = 0; i < 5 && next < end; i++) {
        const char *cut = memchr(next, '\f', (size_t)(end - next));
        *parts[i] = (bolan_spectrum_text){"fuzz", next, (size_t)((cut ? cut : end) - next)};
        next = cut ? cut + 1 : end;
    }
    bolan_measured_spectrum *spectrum = NULL;
    if (!bolan_measured_spectrum_parse(&texts, NULL, &spectrum)) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        sea_state.measured = spectrum;
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        if (!(summary.m0 >= 0.0 && summary.hs <= 40.01)) abort();
    }
    bolan_measured_spectrum_destroy(&spectrum);
    return bolan_memory_in_use() == 0 ? 0 : (abort(), 0);
}
