// SPDX-License-Identifier: MIT
// Measured spectra from files: one text, or one of NDBC's sets of five, whose names differ in one part:
//
//     real time   41010.data_spec   41010.swdir     41010.swdir2    41010.swr1      41010.swr2
//     history     41004w2018.txt    41004d2018.txt  41004i2018.txt  41004j2018.txt  41004k2018.txt
#include "io/file.h"
#include "io/scene_source.h"
#include "spectrum/measured.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { SPECTRUM_FILE_LIMIT = 64 << 20 };

// "builtin:NAME" is scenes/spectra/NAME.spec.
static bolan_result load_builtin(const char *name, const bolan_spectrum_options *options,
                                 bolan_measured_spectrum **out) {
    char path[BOLAN_PATH_MAX];
    snprintf(path, sizeof path, "spectra/%s.spec", name);
    for (unsigned i = 0; i < bolan_scene_source_count; i++) {
        const bolan_scene_source *source = &bolan_scene_sources[i];
        if (strcmp(source->path, path) != 0) continue;
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){source->path, source->text, strlen(source->text)};
        return bolan_measured_spectrum_parse(&texts, options, out);
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "builtin:%s: there is no such spectrum; expected %s", name,
              "builtin:synthetic-bimodal");
    return BOLAN_ERROR_ARGUMENT;
}

// The name of companion @p i beside the density's, where that is one of a set and the file exists.
static bool companion_path(const char *path, uint32_t i, char out[BOLAN_PATH_MAX]) {
    return bolan_spectrum_companion(path, i, out, BOLAN_PATH_MAX) && access(out, F_OK) == 0;
}

bolan_result bolan_spectrum_load(const char *path, const bolan_spectrum_options *options,
                                 bolan_measured_spectrum **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    if (strncmp(path, "builtin:", 8) == 0) return load_builtin(path + 8, options, out);
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    bolan_spectrum_text *const companions[BOLAN_SPECTRUM_COMPANIONS] = {&texts.swdir, &texts.swdir2, &texts.swr1,
                                                                        &texts.swr2};
    char names[BOLAN_SPECTRUM_COMPANIONS][BOLAN_PATH_MAX];
    file_text density, files[BOLAN_SPECTRUM_COMPANIONS] = {{NULL, 0}};

    bolan_result result = bolan_file_read(path, SPECTRUM_FILE_LIMIT, &density);
    texts.density = (bolan_spectrum_text){path, density.data, density.size};
    for (uint32_t i = 0; i < BOLAN_SPECTRUM_COMPANIONS && !result; i++) {
        if (!companion_path(path, i, names[i])) continue;
        result = bolan_file_read(names[i], SPECTRUM_FILE_LIMIT, &files[i]);
        *companions[i] = (bolan_spectrum_text){names[i], files[i].data, files[i].size};
    }
    if (!result) result = bolan_measured_spectrum_parse(&texts, options, out);
    for (uint32_t i = 0; i < BOLAN_SPECTRUM_COMPANIONS; i++) bolan_file_release(&files[i]);
    bolan_file_release(&density);
    return result;
}
