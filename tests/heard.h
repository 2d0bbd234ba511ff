// SPDX-License-Identifier: MIT
// A log that a test listens to: it counts the errors and keeps the first, since later ones may follow from it.
#ifndef BOLAN_TESTS_HEARD_H
#define BOLAN_TESTS_HEARD_H

#include "bolan/base.h"

#include <stdio.h>

/// Set errors to 0 to listen anew.
static struct {
    int errors;
    bolan_log_id id;
    char sentence[512];
} heard;

/// For bolan_hooks.log.
static void hear(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    if (level != BOLAN_LOG_ERROR || heard.errors++ > 0) return;
    heard.id = id;
    snprintf(heard.sentence, sizeof heard.sentence, "%s", sentence);
}

#endif
