// SPDX-License-Identifier: MIT
// See bounds.h.
#include "bounds.h"

#include <math.h>

enum { RING_BYTES = 1 << 15 };

const char *bolan_bounds_problem(const bolan_dvec2 *corners, uint32_t count) {
    if (count == 0) return NULL;
    if (corners == NULL) return "bounds is NULL";
    if (count < 3 || count > BOUNDS_SIDES) return "bounds_count is not 0 and not 3 to 64";
    for (uint32_t i = 0; i < count; ++i)
        if (!isfinite(corners[i].x) || !isfinite(corners[i].y)) return "a corner of bounds is not finite";
    return NULL;
}

bool bolan_bounds_upload(gl_ring *b, const bolan_dvec2 *corners, uint32_t count, bolan_dvec3 eye) {
    bounds_block block = {.count = (int32_t)count};
    if (b->id == 0 && bolan_gl_ring_create(RING_BYTES, b) != BOLAN_OK) return false;
    for (uint32_t i = 0; i < count; ++i) {
        const bolan_dvec2 a = corners[i], c = corners[(i + 1) % count];
        block.side[i] =
            (bolan_vec4){(float)(a.x - eye.x), (float)(a.y - eye.y), (float)(c.x - eye.x), (float)(c.y - eye.y)};
    }
    const gl_range range = bolan_gl_ring_put(b, &block, sizeof block);
    bolan_gl_range_bind_uniform(&range, BLOCK_BOUNDS);
    return true;
}
