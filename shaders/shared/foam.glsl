// SPDX-License-Identifier: MIT
// The law of the foam cover. The Jacobian of the horizontal displacement is nearly Gaussian; a crest breaks where it is
// below a threshold, whose distance from the mean is the quantile of the share that breaking crests cover (Dupuy &
// Bruneton 2012). Where a pixel averages over the Jacobian, the hidden part is a variance about the visible mean,
// and the cover of the pixel is the normal distribution function again. The same holds for old foam, with the
// foam memory in the place of the Jacobian.
#ifndef BOLAN_SHARED_FOAM
#define BOLAN_SHARED_FOAM
#include "shared/normal.glsl"

// Albedo of fresh foam (Koepke 1984 has 0.22 for the mean over old and fresh foam; thick foam comes to 0.5 to 0.8) and
// the share of it that its densest part covers.
#define FOAM_ALBEDO 0.72
#define FOAM_DENSEST 0.92

// Mean opacity of thin, middling and dense foam of the multi-ramp map.
#define FOAM_THIN 0.22
#define FOAM_MIDDLING 0.5
#define FOAM_DENSE 0.82

#define OLD_FOAM_SHARE 2.0 // decaying foam covers about twice what the breaking crests do
#define OLD_FOAM_MOST 0.3  // share of the sea, whatever the wind
#define OLD_FOAM_EDGE 0.1  // variance that softens the edge of old foam, over that of the memory
#define FOAM_NEVER 1e3     // far above every foam memory and every distance of the Jacobian from 1: nothing foams

// Share of the sea under old foam, where breaking crests cover `fresh`.
SHARED real old_foam_share(real fresh) { return min(OLD_FOAM_SHARE * fresh, OLD_FOAM_MOST); }

// Variance of the Jacobian of waves whose slopes have that variance.
SHARED real jacobian_variance_of(real slope_variance, real choppiness) {
    return max(slope_variance, 0.0) * choppiness * choppiness;
}

// A soft edge widens a Gaussian field by its own variance. The covered share stays when the threshold moves away from
// the mean with the standard deviation. `offset`: of the threshold from the mean.
SHARED real softened_offset(real offset, real variance, real edge) { return offset * sqrt(1.0 + edge / variance); }

// Share of a pixel that is beyond the threshold: `excess`, by how much its mean is; `variance`, hidden and of the edge.
SHARED real foam_cover(real excess, real variance) { return normal_cdf(excess * inversesqrt(variance)); }
// Fast: to 0.11.
SHARED real foam_cover_fast(real excess, real variance) { return normal_cdf_linear(excess, variance); }

#endif
