// SPDX-License-Identifier: MIT
// The parameters of the generated island.
#include "bolan/ground.h"
#include "params/rows.h"

#define STRUCT bolan_island_desc
static const bolan_param island_rows[] = {
    WHOLE(seed, .key = "seed", .high = SEED_MAX, .fallback = 7, .help = "which island"),
    NUMBER(radius, .key = "radius", .low = 200, .high = 20000, .fallback = 2200, .unit = "m", .help = "of the land"),
    NUMBER(peak, .key = "peak", .low = 10, .high = 3000, .fallback = 620, .unit = "m", .help = "height of the summit"),
    NUMBER(sea_floor, .key = "sea_floor", .low = -11000, .high = -20, .fallback = -900, .unit = "m",
           .help = "elevation of the sea bed far out"),
    HEADING(lagoon_from_deg, .key = "lagoon_from", .fallback = 225, .help = "compass side of the sandy shallows"),
};
#undef STRUCT
const bolan_param_table bolan_island_params = TABLE("bolan_island_desc", island_rows);
