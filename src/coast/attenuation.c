// SPDX-License-Identifier: MIT
// Attenuation of waves by shallow water: shaders/shared/attenuation.glsl. The shader twin for four bands is
// coast_attenuations() in shaders/common/shore.glsl.
#include "shared/attenuation.glsl"
#include "bolan/coast.h"
#include "bolan/ground.h"

float bolan_coast_attenuation(float depth, float hs) { return coast_attenuation(depth, hs); }

void bolan_coast_attenuations(float depth, const float *band_hs, uint32_t count, float *out) {
    float deep = 0.0f, local = 0.0f; // Hs squared: in deep water; attenuated, each band alone
    for (uint32_t i = 0; i < count; i++) {
        out[i] = coast_attenuation(depth, band_hs[i]);
        deep += band_hs[i] * band_hs[i];
        local += out[i] * out[i] * band_hs[i] * band_hs[i];
    }
    if (!(local > 0.0f)) return;
    const float whole = coast_attenuation(depth, sqrtf(deep)), share = sqrtf(coast_share2(whole, deep, local));
    for (uint32_t i = 0; i < count; i++) out[i] *= share;
}
