// SPDX-License-Identifier: MIT
// Any bytes as a SWAN spectrum: either a valid sea or a refusal, never a step outside the text. The last byte picks the
// record and the location.
#include "bolan/formats.h"
#include "bolan/spectrum.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void silent(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id, (void)sentence;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const bolan_hooks hooks = {.log = silent};
    bolan_set_hooks(&hooks);
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = (bolan_spectrum_text){"fuzz", (const char *)data, size};
    bolan_spectrum_options options = bolan_spectrum_options_default();
    const unsigned choice = size ? data[size - 1] : 0;
    options.record = choice % 3u;
    options.location = choice / 3u % 3u;
    if (choice & 128u) options.place[0] = options.place[1] = 1.0;
    bolan_measured_spectrum *spectrum = NULL;
    if (!bolan_measured_spectrum_parse(&texts, &options, &spectrum)) {
        bolan_sea_state sea_state = bolan_sea_state_default();
        sea_state.measured = spectrum;
        const bolan_sea_summary summary = bolan_sea_state_summary(&sea_state);
        if (!(summary.m0 >= 0.0 && summary.hs <= 40.01) ||
            !(bolan_sea_state_wavenumber_density(&sea_state, 0.1, -0.2) >= 0.0))
            abort();
    }
    bolan_measured_spectrum_destroy(&spectrum);
    return bolan_memory_in_use() == 0 ? 0 : (abort(), 0);
}
