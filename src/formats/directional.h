// SPDX-License-Identifier: MIT
/// @file directional.h
/// Directional distributions from what a buoy reports. Private to src/formats.
#ifndef BOLAN_FORMATS_DIRECTIONAL_H
#define BOLAN_FORMATS_DIRECTIONAL_H

#include <stdint.h>

enum { DIRECTIONAL_BINS = 72 }; ///< 5 degrees: resolves cos-2s up to s = 200

/// The angle of bin @p j, 2 pi j / 72 [rad].
double bolan_directional_angle(uint32_t j);

/// The first four Fourier moments of D(th): r1 at angle a1, r2 at angle a2 (mathematical, TO) [rad].
typedef struct directional_moments {
    double a1, a2, r1, r2;
} directional_moments;

/// D [1/rad] on the bins, never negative, summing to 1 over the circle, with the given moments: the distribution of
/// maximum entropy. Where a buoy's moments fit no distribution on these bins (noise), the Fourier sum
/// (1/pi)(1/2 + r1 cos(th - a1) + r2 cos 2(th - a2)), its negative part clipped, and renormalised.
void bolan_directional_from_moments(directional_moments moments, double density[DIRECTIONAL_BINS]);

/// D = N cos^{2s}((th - mean)/2) on the bins, summing to 1 over the circle.
void bolan_directional_cos2s(double mean, double s, double density[DIRECTIONAL_BINS]);

#endif
