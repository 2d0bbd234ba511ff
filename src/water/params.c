// SPDX-License-Identifier: MIT
// The parameters of wave layers.
#include "bolan/water.h"
#include "params/rows.h"

#define TRAIN_REACH 1e7 // [m]: everywhere

#define STRUCT bolan_wave_train_desc
static const bolan_param train_rows[] = {
    HEADING(from_deg, .key = "from", .help = "where the waves come from, compass degrees"),
    NUMBER(length, .key = "length", .low = 0.5, .high = 2000, .unit = "m", .fallback = 100,
           .help = "from crest to crest"),
    NUMBER(period, .key = "period", .low = 0.1, .high = 1000, .unit = "s", .rules = BOLAN_PARAM_OR_ZERO,
           .otherwise = "by dispersion", .help = "time from crest to crest"),
    NUMBER(height, .key = "height", .low = 0, .high = 40, .unit = "m", .fallback = 1, .help = "from trough to crest"),
    NUMBER(phase_deg, .key = "phase", .low = -360, .high = 360, .unit = "degrees",
           .help = "phase at the centre at time 0; 0 is a crest"),
    NUMBER(centre.x, .key = "centre", .low = -TRAIN_REACH, .high = TRAIN_REACH, .unit = "m",
           .help = "middle of the area, east and north"),
    NUMBER(centre.y, .key = "centre", .low = -TRAIN_REACH, .high = TRAIN_REACH, .unit = "m"),
    NUMBER(half_length, .key = "half_length", .low = 1, .high = TRAIN_REACH, .unit = "m", .fallback = TRAIN_REACH,
           .help = "half the area along the direction of travel"),
    NUMBER(half_width, .key = "half_width", .low = 1, .high = TRAIN_REACH, .unit = "m", .fallback = TRAIN_REACH,
           .help = "half the area across it"),
    NUMBER(edge, .key = "edge", .low = 0.01, .high = 1, .fallback = 0.5,
           .help = "share of each half over which the edge falls"),
    NUMBER(depth, .key = "depth", .low = 0.1, .high = BOLAN_DEEP, .unit = "m", .fallback = BOLAN_DEEP,
           .help = "depth for dispersion and the steepest wave"),
};
#undef STRUCT
const bolan_param_table bolan_wave_train_params = TABLE("bolan_wave_train_desc", train_rows);

bolan_wave_train_desc bolan_wave_train_desc_default(void) {
    bolan_wave_train_desc desc = {.from_deg = 0.0};
    bolan_params_default(&bolan_wave_train_params, &desc);
    return desc;
}
