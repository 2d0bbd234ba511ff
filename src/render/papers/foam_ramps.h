// SPDX-License-Identifier: MIT
// The foam of the multi-ramp map (Ni, Zhang & Tan): a tiled texture of three densities, and the ramps that mix them.
// Read by shaders/papers/crest.glsl.
#ifndef BOLAN_FOAM_RAMPS_H
#define BOLAN_FOAM_RAMPS_H

#include "bolan/base.h"
#include "render/foam_texture.h"

#define FOAM_RAMP_SIZE 128
#define FOAM_RAMP_ROWS 4 // swash, surf, open sea, open sea

// Opacity of thin, middling and dense foam, whose means are FOAM_THIN, _MIDDLING and _DENSE, and bubbles: size * size *
// 4 bytes, size FOAM_TEXTURE_SIZE. MEMORY when the scratch cannot be had.
bolan_result bolan_foam_densities_fill(uint8_t *out);
// FOAM_RAMP_ROWS rows of shares of the three densities and of foam without holes by intensity, which in the row of the
// open sea is the mean opacity: 4 bytes each.
void bolan_foam_ramps_fill(uint8_t out[FOAM_RAMP_ROWS][FOAM_RAMP_SIZE][4]);

#endif
