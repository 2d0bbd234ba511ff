// SPDX-License-Identifier: MIT
/// @file coast.h
/// Tier 2. Attenuation of waves over a sea bed.
#ifndef BOLAN_COAST_H
#define BOLAN_COAST_H

#include "bolan/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Returns the share of the deep-water amplitude that a sea keeps in shallow water: f = tanh(0.6 depth / hs).
/// It is 1 in deep water and falls to 0 at the waterline; the local height stays below the breaking limit, 0.6 depth.
/// @param depth depth of the water [m]; <= 0 gives 0.
/// @param hs significant wave height of the sea in deep water [m].
/// Thread-safe.
/// Shared source: shaders/shared/attenuation.glsl.
BOLAN_API float bolan_coast_attenuation(float depth, float hs);

/// Computes the shares of @p count bands that together make one sea.
/// The share of a band is its bolan_coast_attenuation() times a factor common to all bands, so low bands keep more.
/// The common factor makes the local height of all bands that of one sea of their total height, below 0.6 depth.
/// @param band_hs significant wave heights of the bands in deep water [m].
/// @param out receives the shares.
/// Thread-safe.
BOLAN_API void bolan_coast_attenuations(float depth, const float *band_hs, uint32_t count, float *out);

#ifdef __cplusplus
}
#endif
#endif
