// SPDX-License-Identifier: MIT
// A wave of the warped plane that the tiles of a sea are read over (bolan/waves.h): two parabolas, which look like a
// sine and cost less. Period 1, values -1..1, with a continuous slope.
#ifndef BOLAN_SHARED_WARP
#define BOLAN_SHARED_WARP
#include "shared/language.glsl"

// The largest slope.
#define WARP_STEEPEST 8.0

// `turn`: 0..1.
SHARED real warp_wave(real turn) {
    real x = 2.0 * turn - 1.0;
    return 4.0 * x * (1.0 - max(x, -x));
}

// Its derivative.
SHARED real warp_slope(real turn) {
    real x = 2.0 * turn - 1.0;
    return 8.0 * (1.0 - 2.0 * max(x, -x));
}

#endif
