// SPDX-License-Identifier: MIT
// See progress.h.
#include "progress.h"

#include "interrupt.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 30 };

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

progress progress_start(uint32_t total, bool quiet) {
    progress p = {!quiet && total > 1 && isatty(STDERR_FILENO), total, now(), 0.0, NULL};
    interrupt_bar_is_shown(p.shown);
    progress_update(&p, 0);
    return p;
}

void progress_update(progress *p, uint32_t done) {
    const double t = now();
    if (!p->shown || (t - p->drawn < 0.1 && done < p->total)) return;
    p->drawn = t;
    char bar[WIDTH + 1];
    const uint32_t filled = (uint32_t)((uint64_t)done * WIDTH / p->total);
    for (uint32_t i = 0; i < WIDTH; i++) bar[i] = i < filled ? '#' : '-';
    bar[WIDTH] = '\0';
    fprintf(stderr, "\r[%s] %u/%u%s", bar, (unsigned)done, (unsigned)p->total, p->unit ? p->unit : "");
    if (done > 0) {
        const long left = (long)((t - p->started) / done * (p->total - done) + 0.5);
        fprintf(stderr, ", %ld:%02ld left ", left / 60, left % 60);
    }
    fflush(stderr);
}

void progress_end(progress *p) {
    if (p->shown) fputs("\r\033[K", stderr);
    p->shown = false;
    interrupt_bar_is_shown(false);
}
