// SPDX-License-Identifier: MIT
// What shallow water leaves of waves. In single precision in C too, so that a query and the vertex that it answers for
// have the same bits.
#ifndef BOLAN_SHARED_ATTENUATION
#define BOLAN_SHARED_ATTENUATION
#include "shared/language.glsl"

#define TANH_WHOLE 4.9f     // from where rational_tanh() is 1
#define BREAKING_LIMIT 0.6f // significant height over depth
#define COAST_DEEP (TANH_WHOLE / BREAKING_LIMIT) // depth in significant heights from where waves keep all

// tanh for x >= 0 by Lambert's continued fraction to seven terms: error below 4e-6 up to 3.4 and below 1.3e-4 up to
// TANH_WHOLE, where it is cut to 1. tanh() itself overflows on some drivers.
SHARED float rational_tanh(float x) {
    float x2 = x * x;
    float p = x * (135135.0f + x2 * (17325.0f + x2 * (378.0f + x2)));
    float q = 135135.0f + x2 * (62370.0f + x2 * (3150.0f + x2 * 28.0f));
    float t = p / q;
    return x > TANH_WHOLE || t > 1.0f ? 1.0f : t;
}

// Share of its deep-water amplitude that a sea of significant height hs [m] keeps in depth [m] of water: the breaking
// limit Hs <= BREAKING_LIMIT depth, in the smooth form tanh(BREAKING_LIMIT depth / hs).
SHARED float coast_attenuation(float depth, float hs) {
    if (!(depth > 0.0f)) return 0.0f;
    if (!(hs > 0.0f)) return 1.0f;
    float x = BREAKING_LIMIT * depth / hs;
    return rational_tanh(x < 10.0f ? x : 10.0f);
}

// Square of the factor on bands that would each keep `local` of their height alone, so that together they keep what one
// sea of their height does. deep: sum of the squares of the bands' heights; local: of what is left of each alone;
// whole: share that one sea keeps.
SHARED float coast_share2(float whole, float deep, float local) { return whole * whole * deep / local; }

#endif
