// SPDX-License-Identifier: MIT
// The shore map: elevations round the eye in nested levels, for the water.
#ifndef BOLAN_RENDER_TERRAIN_SHORE_H
#define BOLAN_RENDER_TERRAIN_SHORE_H

#include "frame.h"

typedef struct shore_builder {
    shore_map map;
    const bolan_ground *terrain; // of the elevations; NULL: nothing is valid
    uint64_t terrain_id;
    float water_level;
    struct {
        bool valid;
        double west, south, texel; // [m]
        float *elevation;          // SHORE_SIZE^2
    } level[SHORE_LEVELS];
    float *scratch; // SHORE_SIZE^2
    uint16_t *halfs;
} shore_builder;

bolan_result bolan_shore_builder_create(shore_builder *b);
void bolan_shore_builder_free(shore_builder *b);
// Moves the levels with the eye and uploads what changed.
void bolan_shore_builder_update(shore_builder *b, const render_view *v);

#endif
