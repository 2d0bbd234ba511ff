// SPDX-License-Identifier: MIT
// Measured spectra from files: one text, or NDBC's set of five that share a stem.
#include "io/file.h"
#include "io/scene_source.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { SPECTRUM_FILE_LIMIT = 64 << 20, COMPANIONS = 4 };

static const char *const density_suffix = ".data_spec";

// "builtin:NAME" is scenes/spectra/NAME.spec.
static bolan_result load_builtin(const char *name, uint32_t record, bolan_measured_spectrum **out) {
    char path[BOLAN_PATH_MAX];
    snprintf(path, sizeof path, "spectra/%s.spec", name);
    for (unsigned i = 0; i < bolan_scene_source_count; i++) {
        const bolan_scene_source *source = &bolan_scene_sources[i];
        if (strcmp(source->path, path) != 0) continue;
        bolan_spectrum_texts texts = bolan_spectrum_texts_default();
        texts.density = (bolan_spectrum_text){source->path, source->text, strlen(source->text)};
        return bolan_measured_spectrum_parse(&texts, record, out);
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "builtin:%s: there is no such spectrum; expected %s", name,
              "builtin:synthetic-bimodal");
    return BOLAN_ERROR_ARGUMENT;
}

// The path with another suffix, when it ends in .data_spec and that file exists.
static bool companion_path(const char *path, const char *suffix, char out[BOLAN_PATH_MAX]) {
    const size_t length = strlen(path), tail = strlen(density_suffix);
    if (length < tail || strcmp(path + length - tail, density_suffix) != 0) return false;
    return snprintf(out, BOLAN_PATH_MAX, "%.*s%s", (int)(length - tail), path, suffix) < BOLAN_PATH_MAX &&
           access(out, R_OK) == 0;
}

bolan_result bolan_spectrum_load(const char *path, uint32_t record, bolan_measured_spectrum **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    if (strncmp(path, "builtin:", 8) == 0) return load_builtin(path + 8, record, out);
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    static const char *const suffixes[COMPANIONS] = {".swdir", ".swdir2", ".swr1", ".swr2"};
    bolan_spectrum_text *const companions[COMPANIONS] = {&texts.swdir, &texts.swdir2, &texts.swr1, &texts.swr2};
    char names[COMPANIONS][BOLAN_PATH_MAX];
    file_text density, files[COMPANIONS] = {{NULL, 0}};

    bolan_result result = file_read(path, SPECTRUM_FILE_LIMIT, &density);
    texts.density = (bolan_spectrum_text){path, density.data, density.size};
    for (int i = 0; i < COMPANIONS && !result; i++) {
        if (!companion_path(path, suffixes[i], names[i])) continue;
        result = file_read(names[i], SPECTRUM_FILE_LIMIT, &files[i]);
        *companions[i] = (bolan_spectrum_text){names[i], files[i].data, files[i].size};
    }
    if (!result) result = bolan_measured_spectrum_parse(&texts, record, out);
    for (int i = 0; i < COMPANIONS; i++) file_release(&files[i]);
    file_release(&density);
    return result;
}
