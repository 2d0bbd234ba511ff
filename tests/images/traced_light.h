// SPDX-License-Identifier: MIT
// What tests against a path tracer need: a copy of the shaders without gusts, and the share of light that the air lets
// through.
#ifndef BOLAN_TESTS_TRACED_LIGHT_H
#define BOLAN_TESTS_TRACED_LIGHT_H

#include "picture.h"

#include <dirent.h>

// ---- shaders without gusts -----------------------------------------------------------------------------------------

static inline void link_folder(const char *from, const char *to, const char *but) {
    DIR *folder = opendir(from);
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        const size_t length = strlen(entry->d_name);
        if (length < 5 || strcmp(entry->d_name + length - 5, ".glsl") != 0 || strcmp(entry->d_name, but) == 0) continue;
        char target[1024], path[1024];
        snprintf(target, sizeof target, "%s/%s", from, entry->d_name);
        snprintf(path, sizeof path, "%s/%s", to, entry->d_name);
        assert_int_equal(symlink(target, path), 0);
    }
    closedir(folder);
}

static inline void empty_folder(const char *path) {
    DIR *folder = opendir(path);
    for (struct dirent *entry; folder != NULL && (entry = readdir(folder)) != NULL;) {
        char file[1024];
        snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
        unlink(file);
    }
    if (folder != NULL) closedir(folder);
    rmdir(path);
}

static inline void make_shaders(char *folder) {
    char common[512];
    assert_non_null(mkdtemp(folder));
    snprintf(common, sizeof common, "%s/common", folder);
    assert_int_equal(mkdir(common, 0777), 0);
    link_folder(BOLAN_SOURCE_DIR "/shaders", folder, "");
    static const char *const whole[] = {"shared", "papers", "include"};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; ++i) {
        char target[512], path[512];
        snprintf(target, sizeof target, "%s/shaders/%s", BOLAN_SOURCE_DIR, whole[i]);
        snprintf(path, sizeof path, "%s/%s", folder, whole[i]);
        assert_int_equal(symlink(target, path), 0);
    }
    link_folder(BOLAN_SOURCE_DIR "/shaders/common", common, "gusts.glsl");
    snprintf(common, sizeof common, "%s/common/gusts.glsl", folder);
    FILE *file = fopen(common, "w");
    assert_non_null(file);
    fputs("float gustiness(vec2 p, float width) { return 1.0; }\n", file);
    fclose(file);
}

static inline void remove_shaders(const char *folder) {
    char common[512];
    snprintf(common, sizeof common, "%s/common", folder);
    empty_folder(common);
    empty_folder(folder);
}

// ---- air -----------------------------------------------------------------------------------------------------------

// Share of the light that the air lets through, at 650, 550 and 450 nm: Rayleigh's optical depths over the scale
// height, and what haze is left at a visibility of 300 km. The eye is so low that the density is the sea's.
static inline double through_air(int channel, double distance) {
    const double rayleigh[3] = {0.049184 / 8000, 0.097070 / 8000, 0.221110 / 8000}, haze[3] = {1.78e-6, 2e-6, 2.3e-6};
    return exp(-(rayleigh[channel] + haze[channel]) * distance);
}

#endif
