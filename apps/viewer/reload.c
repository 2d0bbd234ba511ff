// SPDX-License-Identifier: MIT
// Notices changed shader files by their times: works on every file system, and the folder is small.
#include "reload.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define LOOK_EVERY 0.4 // [s]

static uint64_t mix(uint64_t h, uint64_t x) {
    h ^= x + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2);
    return h * 0xff51afd7ed558ccdu;
}

static uint64_t file_stamp(const char *path, const struct stat *s) {
    uint64_t h = mix((uint64_t)s->st_size, (uint64_t)s->st_mtim.tv_sec);
    h = mix(h, (uint64_t)s->st_mtim.tv_nsec);
    for (; *path != '\0'; ++path) h = mix(h, (unsigned char)*path);
    return h;
}

// A sum over the files, so that the order of the listing does not matter.
static uint64_t folder_stamp(const char *folder, int depth) {
    DIR *d = opendir(folder);
    if (d == NULL) return 0;
    uint64_t sum = 0;
    for (const struct dirent *entry; (entry = readdir(d)) != NULL;) {
        if (entry->d_name[0] == '.') continue;
        char path[2048];
        struct stat s;
        int length = snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (length < 0 || (size_t)length >= sizeof path || stat(path, &s) != 0) continue;
        if (S_ISDIR(s.st_mode) && depth > 0)
            sum += folder_stamp(path, depth - 1);
        else if (strstr(entry->d_name, ".glsl") != NULL)
            sum += file_stamp(path, &s);
    }
    closedir(d);
    return sum;
}

void reload_start(reload_watch *w, const char *directory, double now) {
    *w = (reload_watch){.directory = directory, .next_look = now + LOOK_EVERY};
    if (directory != NULL) w->stamp = folder_stamp(directory, 2);
}

bool reload_due(reload_watch *w, double now) {
    if (w->directory == NULL || now < w->next_look) return false;
    w->next_look = now + LOOK_EVERY;
    uint64_t stamp = folder_stamp(w->directory, 2);
    if (stamp == w->stamp) return false;
    w->stamp = stamp;
    return true;
}
