// SPDX-License-Identifier: MIT
// The uniform block Bounds of shaders/common/bounds.glsl: the polygon in which a water lies.
#ifndef BOLAN_RENDER_BOUNDS_H
#define BOLAN_RENDER_BOUNDS_H

#include "bolan/math.h"
#include "gl/gl.h"

enum { BOUNDS_SIDES = 64, BLOCK_BOUNDS = 4 }; // most sides; its uniform slot

typedef struct bounds_block {
    bolan_vec4 side[BOUNDS_SIDES];
    int32_t count, padding[3];
} bounds_block;

// What is wrong with a polygon, as the end of a sentence; NULL: nothing. No corner at all is no polygon, and right.
const char *bolan_bounds_problem(const bolan_dvec2 *corners, uint32_t count);
// Uploads the polygon round this eye, and binds it. The ring is made at the first call; false: it cannot be had.
bool bolan_bounds_upload(gl_ring *b, const bolan_dvec2 *corners, uint32_t count, bolan_dvec3 eye);

#endif
