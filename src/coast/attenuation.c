// SPDX-License-Identifier: MIT
// What shallow water leaves of a wave. Twins of coast_attenuation() and coast_attenuations() in
// shaders/common/shore.glsl.
#include "bolan/coast.h"
#include "bolan/ground.h"

// Lambert's continued fraction of tanh to seven terms: error below 4e-6 up to 3.4 and below 1.3e-4 up to 4.9, where it
// passes 1 and is cut. The shader uses the same rational function, so that the twins agree to rounding.
static float rational_tanh(float x) {
    float x2 = x * x;
    float p = x * (135135.0f + x2 * (17325.0f + x2 * (378.0f + x2)));
    float q = 135135.0f + x2 * (62370.0f + x2 * (3150.0f + x2 * 28.0f));
    float t = p / q;
    return x > 4.9f || t > 1.0f ? 1.0f : t;
}

float bolan_coast_attenuation(float depth, float hs) {
    if (!(depth > 0.0f)) {
        return 0.0f;
    }
    if (!(hs > 0.0f)) {
        return 1.0f;
    }
    return rational_tanh(fminf(0.6f * depth / hs, 10.0f));
}

void bolan_coast_attenuations(float depth, const float *band_hs, uint32_t count, float *out) {
    float deep = 0.0f, local = 0.0f; // Hs squared: asked for, and left if each band were alone
    for (uint32_t i = 0; i < count; i++) {
        out[i] = bolan_coast_attenuation(depth, band_hs[i]);
        deep += band_hs[i] * band_hs[i];
        local += out[i] * out[i] * band_hs[i] * band_hs[i];
    }
    if (!(local > 0.0f)) return;
    const float whole = bolan_coast_attenuation(depth, sqrtf(deep)), share = sqrtf(whole * whole * deep / local);
    for (uint32_t i = 0; i < count; i++) out[i] *= share;
}
