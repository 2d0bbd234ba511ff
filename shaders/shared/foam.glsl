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

#define FOAM_TEXELS 512.0    // along a side of the noise of src/render/foam_texture.h
#define FOAM_BROADEST 64.0   // largest tile of it [m]
#define FOAM_NOISE_MIDDLE 128.0 // of its values, whose mean is 0
#define FOAM_NOISE_RANGE 6.0 // standard deviations over all its 256 values

// Mean opacity of thin, middling and dense foam of the multi-ramp map.
#define FOAM_THIN 0.22
#define FOAM_MIDDLING 0.5
#define FOAM_DENSE 0.82

#define OLD_FOAM_EDGE 0.4  // variance that softens the edge of old foam, over that of the memory
#define FRESH_FOAM_EDGE 0.16 // likewise of fresh foam, over that of the Jacobian
#define FOAM_NEVER 1e3     // far above every foam memory and every distance of the Jacobian from 1: nothing foams

// Share of the rest of the sea under old foam, where breaking crests cover `breaking` and whitecaps of all ages `all`.
SHARED real old_foam_share(real breaking, real all) { return max(all - breaking, 0.0) / (1.0 - breaking); }

// Share of the sea under streaks of foam. Beaufort's words: "begins to be blown in streaks" in force 7, "dense streaks"
// in 9, "takes on a white appearance" in 10, "completely covered with long white patches" in 11, "completely white" in
// 12 (WMO). Holthuijsen, Powell & Pietrzak (2012) see streaks merge into a white-out towards 40 m/s.
#define STREAKS_NONE 13.9 // [m/s]
#define STREAKS_ALL 38.0
#define STREAKS_MOST 0.9
SHARED real streak_share(real wind_speed) {
    real t = clamp((wind_speed - STREAKS_NONE) / (STREAKS_ALL - STREAKS_NONE), 0.0, 1.0);
    return STREAKS_MOST * t * sqrt(t);
}

// Visibility through the spray of a storm [m]: "affected" from force 11 on, "very seriously affected" in 12 (WMO).
#define SPRAY_CLEAR 300e3 // [m] up to SPRAY_BEGINS
#define SPRAY_BEGINS 26.5 // [m/s]
#define SPRAY_THICK 1000.0 // [m] from SPRAY_ALL on
#define SPRAY_ALL 40.0
SHARED real spray_visibility(real wind_speed) {
    real t = clamp((wind_speed - SPRAY_BEGINS) / (SPRAY_ALL - SPRAY_BEGINS), 0.0, 1.0);
    return SPRAY_CLEAR * exp(t * log(SPRAY_THICK / SPRAY_CLEAR));
}

// Distance of the broadest windrows that foam gathers in, between Langmuir's cells [m]: 4.8 s times the wind speed
// (Faller & Woodcock 1964), until the cells reach the bottom of the mixed layer.
#define WINDROW_TIME 4.8   // [s]
#define WINDROW_LEAST 8.0  // [m]
#define WINDROW_MOST 100.0
SHARED real windrow_distance(real wind_speed) { return clamp(WINDROW_TIME * wind_speed, WINDROW_LEAST, WINDROW_MOST); }
// Speed of foam along the wind, over the water below, in wind speeds. Bubbles, small nets and windrows have the drift
// of the surface by wind and waves (Wu 1983). The eddies that gather foam and tear it, as deep as they are wide, are
// slower, since the drift falls off with depth; by how much is by eye: a patch of residual foam lasts for 10 to 60 s.
#define FOAM_DRIFT 0.031
#define EDDY_DRIFT 0.026
#define WINDROWS 16        // of the broadest kind, across a tile of streaks
#define WINDROWS_FINER 9.0 // tiles of the fine streaks across a tile of streaks: a whole number
#define WINDROW_STRETCH 6.0
#define STREAKS_ON_CRESTS 0.6 // deviations of the streaks for one of the Jacobian: crests draw foam together

// The foam memory keeps peaks, so it is skewed: its quantile with OLD_FOAM_EDGE for that of a Gaussian, in standard
// deviations from the mean. Fitted from 1e-3 to .5 to settled seas of 5 to 50 m/s, to 0.05; tests/shaders/
// test_foam_cover.c has what it covers.
SHARED real memory_quantile(real gaussian) { return 0.96 * gaussian + 0.08 * (gaussian * gaussian - 1.0); }

// Variance of the Jacobian of waves whose slopes have that variance.
SHARED real jacobian_variance_of(real slope_variance, real choppiness) {
    return max(slope_variance, 0.0) * choppiness * choppiness;
}

// A soft edge widens a Gaussian field by its own variance. The covered share stays when the threshold moves away from
// the mean with the standard deviation. `offset`: of the threshold from the mean.
SHARED real softened_offset(real offset, real variance, real edge) { return offset * sqrt(1.0 + edge / variance); }

// Share of a pixel that is beyond the threshold: `excess`, by how much its mean is; `variance`, hidden and of the edge.
SHARED real foam_cover(real excess, real variance) { return normal_cdf(excess * inversesqrt(variance)); }
// Mean opacity of foam whose thickness x is Gaussian over the pixel: 1 - exp(-density x) where x > 0. Mean `excess`,
// that variance (> 0). Thin foam lets the water through; the mean over pixels of any size is the same. With z the mean
// in standard deviations and k the density times the deviation, it is P(z) - exp(k^2/2 - k z) P(z - k).
SHARED real foam_opacity(real excess, real variance, real density) {
    real sharp = inversesqrt(variance), z = excess * sharp, k = density / sharp, pdf = normal_pdf(z);
    real beyond = pdf * normal_mills(max(k - z, z - k)), clear = k > z ? beyond : exp(k * (0.5 * k - z)) - beyond;
    return clamp(normal_below(z, pdf) - clear, 0.0, 1.0);
}
// The inverse of normal_cdf(), of shares from 1e-4 to 0.9999: Newton's steps for its cubic.
SHARED real foam_quantile(real share) {
    real s = clamp(share, 0.0001, 0.9999), y = log(s / (1.0 - s)) / 1.59576912, x = y;
    for (int i = 0; i < 4; ++i) x = (y + 2.0 * 0.044715 * x * x * x) / (1.0 + 3.0 * 0.044715 * x * x);
    return x;
}

// Fast: to 0.11.
SHARED real foam_cover_fast(real excess, real variance) { return normal_cdf_linear(excess, variance); }

#endif
