// SPDX-License-Identifier: MIT
// Generated grounds for tests.
#ifndef BOLAN_TESTS_CONTENT_SUPPORT_H
#define BOLAN_TESTS_CONTENT_SUPPORT_H

#include "bolan/content.h"

#include <stdio.h>

static inline bolan_ground_generator generator_named(const char *name) {
    bolan_ground_generator generator = bolan_ground_generator_default();
    snprintf(generator.name, sizeof generator.name, "%s", name);
    return generator;
}

#endif
