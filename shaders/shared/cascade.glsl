// SPDX-License-Identifier: MIT
// The placement of the square tile of a cascade, or of another periodic image of the water: its axes are turned by an
// angle, whose cosine and sine are given, from east and north. Divided by the side of the tile, along_tile() and
// across_tile() are coordinates of the image; the first sample stands at the origin.
#ifndef BOLAN_SHARED_CASCADE
#define BOLAN_SHARED_CASCADE
#include "shared/language.glsl"

SHARED real along_tile(real x, real y, real cosine, real sine) { return x * cosine + y * sine; }
SHARED real across_tile(real x, real y, real cosine, real sine) { return y * cosine - x * sine; }

#endif
