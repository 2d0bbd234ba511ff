// SPDX-License-Identifier: MIT
// Measured spectra from files: one file, or one of NDBC's sets of five, whose names differ in one part:
//
//     real time   41010.data_spec   41010.swdir     41010.swdir2    41010.swr1      41010.swr2
//     history     41004w2018.txt    41004d2018.txt  41004i2018.txt  41004j2018.txt  41004k2018.txt
//
// Each may be packed by gzip, with .gz behind its name.
#include "io/scene_source.h"
#include "io/unpack.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { SPECTRUM_FILE_LIMIT = 64 << 20 };

// The texts of a path, and what they are kept in.
typedef struct spectrum_files {
    bolan_spectrum_texts texts;
    char names[BOLAN_SPECTRUM_COMPANIONS][BOLAN_PATH_MAX];
    file_text density, companions[BOLAN_SPECTRUM_COMPANIONS];
} spectrum_files;

// "builtin:NAME" is scenes/spectra/NAME.spec.
static bolan_result open_builtin(const char *name, spectrum_files *files) {
    char path[BOLAN_PATH_MAX];
    snprintf(path, sizeof path, "spectra/%s.spec", name);
    for (unsigned i = 0; i < bolan_scene_source_count; i++) {
        const bolan_scene_source *source = &bolan_scene_sources[i];
        if (strcmp(source->path, path) != 0) continue;
        files->texts.density = (bolan_spectrum_text){source->path, source->text, strlen(source->text)};
        return BOLAN_OK;
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNKNOWN_NAME, "builtin:%s: there is no such spectrum; expected %s", name,
              "builtin:synthetic-bimodal");
    return BOLAN_ERROR_ARGUMENT;
}

// The name of companion @p i beside the density's, where that is one of a set and the file exists, packed or not.
static bool companion_path(const char *path, uint32_t i, char out[BOLAN_PATH_MAX]) {
    char plain[BOLAN_PATH_MAX];
    size_t length = strlen(path);
    if (length > 3 && strcmp(path + length - 3, ".gz") == 0) length -= 3;
    if (length >= sizeof plain) return false;
    snprintf(plain, sizeof plain, "%.*s", (int)length, path);
    if (!bolan_spectrum_companion(plain, i, out, BOLAN_PATH_MAX)) return false;
    if (access(out, F_OK) == 0) return true;
    length = strlen(out);
    if (length + 4 > BOLAN_PATH_MAX) return false;
    memcpy(out + length, ".gz", 4);
    return access(out, F_OK) == 0;
}

static bolan_result read_unpacked(const char *path, file_text *out, bolan_spectrum_text *text) {
    bolan_result result = bolan_file_read(path, SPECTRUM_FILE_LIMIT, out);
    if (!result) result = bolan_unpack_gzip(path, SPECTRUM_FILE_LIMIT, out);
    if (!result) result = bolan_unpack_netcdf4(path, SPECTRUM_FILE_LIMIT, out);
    *text = (bolan_spectrum_text){path, out->data, out->size};
    return result;
}

// close_files() is due in any case.
static bolan_result open_files(const char *path, spectrum_files *files) {
    *files = (spectrum_files){.texts = bolan_spectrum_texts_default()};
    if (strncmp(path, "builtin:", 8) == 0) return open_builtin(path + 8, files);
    bolan_spectrum_text *const companions[BOLAN_SPECTRUM_COMPANIONS] = {&files->texts.swdir, &files->texts.swdir2,
                                                                        &files->texts.swr1, &files->texts.swr2};
    bolan_result result = read_unpacked(path, &files->density, &files->texts.density);
    for (uint32_t i = 0; i < BOLAN_SPECTRUM_COMPANIONS && !result; i++)
        if (companion_path(path, i, files->names[i]))
            result = read_unpacked(files->names[i], &files->companions[i], companions[i]);
    return result;
}

static void close_files(spectrum_files *files) {
    for (uint32_t i = 0; i < BOLAN_SPECTRUM_COMPANIONS; i++) bolan_file_release(&files->companions[i]);
    bolan_file_release(&files->density);
}

bolan_result bolan_spectrum_load(const char *path, const bolan_spectrum_options *options,
                                 bolan_measured_spectrum **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    spectrum_files files;
    bolan_result result = open_files(path, &files);
    if (!result) result = bolan_measured_spectrum_parse(&files.texts, options, out);
    close_files(&files);
    return result;
}

bolan_result bolan_spectrum_contents_load(const char *path, bolan_spectrum_contents **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    spectrum_files files;
    bolan_result result = open_files(path, &files);
    if (!result) result = bolan_spectrum_contents_parse(&files.texts, out);
    close_files(&files);
    return result;
}
