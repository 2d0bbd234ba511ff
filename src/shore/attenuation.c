// SPDX-License-Identifier: MIT
// What shallow water leaves of a wave. Twin of shore_attenuation() in shaders/common/shore.glsl.
#include "bolan/shore.h"

// Lambert's continued fraction of tanh to seven terms: error below 4e-6 up to 3.4 and below 1.3e-4 up to 4.9, where it
// passes 1 and is cut. The shader uses the same rational function, so that the twins agree to rounding.
static float rational_tanh(float x) {
    float x2 = x * x;
    float p = x * (135135.0f + x2 * (17325.0f + x2 * (378.0f + x2)));
    float q = 135135.0f + x2 * (62370.0f + x2 * (3150.0f + x2 * 28.0f));
    float t = p / q;
    return x > 4.9f || t > 1.0f ? 1.0f : t;
}

float bolan_shore_attenuation(float depth, float band_hs) {
    if (!(depth > 0.0f)) {
        return 0.0f;
    }
    if (!(band_hs > 0.0f)) {
        return 1.0f;
    }
    return rational_tanh(fminf(0.6f * depth / band_hs, 10.0f));
}
