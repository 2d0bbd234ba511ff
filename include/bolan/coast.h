// SPDX-License-Identifier: MIT
/// @file coast.h
/// Tier 2. What a sea bed does to the waves over it.
#ifndef BOLAN_COAST_H
#define BOLAN_COAST_H

#include "bolan/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How much of its deep-water amplitude a sea of significant height @p hs [m] keeps in @p depth [m] of water: 1 in deep
/// water, falling to 0 at the waterline so that the local height stays below the breaking limit, 0.6 of the depth.
/// tanh form: f = tanh(0.6 depth / hs), 0 for depth <= 0. Shared source: shaders/shared/attenuation.glsl. Thread-safe.
float bolan_coast_attenuation(float depth, float hs);
/// The same for @p count bands of the significant heights @p band_hs [m] that make one sea, in @p out. Each band keeps
/// more the lower it is, bolan_coast_attenuation(), times a factor common to all, by which the local height of all
/// bands together is that of one sea of their total height: it stays below 0.6 of the depth. Thread-safe.
void bolan_coast_attenuations(float depth, const float *band_hs, uint32_t count, float *out);

#ifdef __cplusplus
}
#endif
#endif
