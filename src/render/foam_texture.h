// SPDX-License-Identifier: MIT
// The tiled structure of foam, 4 channels whose values are uniformly distributed over [0, 255], so that the share of
// texels above 255 (1 - c) is c: a coarse and a fine net of bubbles, and two smooth noises. Read by
// shaders/common/foam.glsl.
#ifndef BOLAN_FOAM_TEXTURE_H
#define BOLAN_FOAM_TEXTURE_H

#include "gl/gl.h"

#define FOAM_TEXTURE_SIZE 512

// Fills size * size * 4 bytes. MEMORY when the scratch cannot be had.
bolan_result bolan_foam_texture_fill(uint8_t *out);
// The same as a texture with mip maps, for UNIT_FOAM_DETAIL.
bolan_result bolan_foam_texture_create(gl_texture *out);

// Noise of the physical optics: 4 channels whose values have the standard normal distribution, times
// 255 / FOAM_NOISE_RANGE about FOAM_NOISE_MIDDLE: patches, nets of walls, bubbles, windrows (windrows.h).
// Errors as above.
bolan_result bolan_foam_noise_fill(uint8_t *out);
bolan_result bolan_foam_noise_create(gl_texture *out);

#endif
