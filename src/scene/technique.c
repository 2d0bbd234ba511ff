// SPDX-License-Identifier: MIT
// The techniques: a wave model, a surface and an optics under one name.
#include "bolan/scene.h"

#include <string.h>

#define OCEAN \
    { "ocean", BOLAN_WAVES_FFT, BOLAN_SURFACE_PROJECTED, BOLAN_OPTICS_PHYSICAL }

const bolan_technique bolan_technique_ocean = OCEAN;

static const bolan_technique techniques[] = {OCEAN};

const bolan_technique *bolan_techniques(uint32_t *count) {
    *count = sizeof techniques / sizeof *techniques;
    return techniques;
}

const bolan_technique *bolan_technique_find(const char *name) {
    for (size_t i = 0; i < sizeof techniques / sizeof *techniques; i++)
        if (strcmp(techniques[i].name, name) == 0) return &techniques[i];
    return NULL;
}
