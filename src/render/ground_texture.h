// SPDX-License-Identifier: MIT
// The tiled noise that gives the ground its grain.
#ifndef BOLAN_RENDER_TERRAIN_TEXTURE_H
#define BOLAN_RENDER_TERRAIN_TEXTURE_H

#include "bolan/base.h"

#define TERRAIN_TEXTURE_SIZE 256

// RGBA8, periodic: r billows (tree crowns; turned over: cracked rock), gb their gradient + 0.5, a smooth patches.
bolan_result bolan_ground_texture_fill(uint8_t *rgba);

#endif
