// SPDX-License-Identifier: MIT
// A progress bar with the remaining time, on a terminal only.
#ifndef BOLAN_CLI_PROGRESS_H
#define BOLAN_CLI_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct progress {
    bool shown;
    uint32_t total;
    double started, drawn; // [s]
    const char *unit;      // behind the numbers; NULL: none
} progress;

// Shows nothing when @p quiet, when stderr is no terminal, or when there is only one step.
progress progress_start(uint32_t total, bool quiet);
void progress_update(progress *p, uint32_t done);
// Erases the bar.
void progress_end(progress *p);

#endif
