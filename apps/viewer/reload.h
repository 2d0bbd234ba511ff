// SPDX-License-Identifier: MIT
// Notices changed shader files.
#ifndef VIEWER_RELOAD_H
#define VIEWER_RELOAD_H

#include <stdbool.h>
#include <stdint.h>

typedef struct reload_watch {
    const char *directory; // NULL: nothing to watch
    uint64_t stamp;        // digest of names, sizes and times of the files
    double next_look;      // [s]
} reload_watch;

void reload_start(reload_watch *w, const char *directory, double now);
// True once after a file was changed, added or removed. Looks a few times a second.
bool reload_due(reload_watch *w, double now);

#endif
