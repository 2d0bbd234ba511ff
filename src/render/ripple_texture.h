// SPDX-License-Identifier: MIT
// A tile of short waves, for the seas that are sums of few long ones: slopes of a wind sea over five octaves, each with
// as much slope variance as the next, running along +u. Read by shaders/common/ripples.glsl.
#ifndef BOLAN_RIPPLE_TEXTURE_H
#define BOLAN_RIPPLE_TEXTURE_H

#include "sea_gpu.h"

#define RIPPLE_TEXTURE_SIZE 1024
#define RIPPLE_LONGEST 8 // waves along the tile's side: the longest
#define RIPPLE_OCTAVES 5

// Slope along u, along v (together of variance 1), their squared sum, 0: size * size * 4 floats.
void bolan_ripple_texture_fill(float *out);
bolan_result bolan_ripple_texture_create(gl_texture *out);
// Fills what ripples.glsl reads of the block Water. Optics bind the texture to UNIT_RIPPLES; cascades have no use for
// it.
void bolan_ripple_fill(water_block *b, const render_view *view);

#endif
