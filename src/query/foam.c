// SPDX-License-Identifier: MIT
// The foam of the parcel at a place.
#include "bolan/query.h"

#include <math.h>
#include <string.h>

enum { BLOCK = 128, STEPS = 8 };

// The rest point by the plain fixed point.
static void answer_block(const bolan_sea *sea, const bolan_dvec2 *xy, uint32_t count, float *foam) {
    bolan_dvec2 rest[BLOCK];
    bolan_sea_sample parcel[BLOCK];
    memcpy(rest, xy, count * sizeof *rest);
    for (int step = 0; step <= STEPS; step++) {
        bolan_sea_sample_rest(sea, rest, count, parcel);
        for (uint32_t i = 0; i < count && step < STEPS; i++) {
            rest[i].x = xy[i].x - (double)parcel[i].dx;
            rest[i].y = xy[i].y - (double)parcel[i].dy;
        }
    }
    for (uint32_t i = 0; i < count; i++) foam[i] = parcel[i].foam;
}

void bolan_query_foam(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *foam) {
    BOLAN_ASSERT(water != NULL && water->sea != NULL && (count == 0 || (xy != NULL && foam != NULL)));
    for (uint32_t at = 0; at < count; at += BLOCK)
        answer_block(water->sea, xy + at, count - at < BLOCK ? count - at : BLOCK, foam + at);
}
