// SPDX-License-Identifier: MIT
// Rows of the projected grid lie at even steps of a parameter s of x = distance / height of the eye:
//
//   s(x) = atan x                      up to x1: even steps of the angle seen from the eye
//          atan x1 + ln(x / x1) / 7    beyond: steps that are a fixed share of the distance, so that crests keep their
//                                      outline near the horizon, where an angular step covers a hundred metres
//
// x1 is where both have the same slope, 1 + x1^2 = 7 x1.
#ifndef BOLAN_SHARED_GRID
#define BOLAN_SHARED_GRID
#include "shared/constants.glsl"
#include "shared/language.glsl"

#define GRID_BLOCK 16 // cells of a block along a side; the grid is drawn as instances of one block
#define GRID_FAR_SHARE 7.0
#define GRID_FAR_FROM 6.854101966249685  // x1 = (7 + sqrt 45) / 2
#define GRID_FAR_ANGLE 1.425920476076873 // atan x1

SHARED real grid_parameter(real x) {
    return x < GRID_FAR_FROM ? atan(x) : GRID_FAR_ANGLE + log(x / GRID_FAR_FROM) / GRID_FAR_SHARE;
}

SHARED real grid_distance(real s) {
    return s < GRID_FAR_ANGLE ? tan(s) : GRID_FAR_FROM * exp(GRID_FAR_SHARE * (s - GRID_FAR_ANGLE));
}

// dx/ds at x.
SHARED real grid_steepness(real x) { return x < GRID_FAR_FROM ? 1.0 + x * x : GRID_FAR_SHARE * x; }

// Half the azimuths of a row at distance r: `half_angle`, and more near the eye, until at `guard` it is a full circle,
// so that a wave that leans into the picture from outside is covered.
SHARED real grid_half_angle(real half_angle, real guard, real r) {
    real share = r > guard ? guard / r : 1.0;
    return half_angle + (PI - half_angle) * share * sqrt(share);
}

// Cells from the centre of a nested level between which the spacing of its vertices rises to twice that of its cells:
// from where its hole has ended for certain to where no border can be nearer (src/surface/nested_vertices.c).
SHARED real nested_rise_from(real cells) { return max(0.25 * cells + 0.5, 0.3 * cells); }
SHARED real nested_rise_to(real cells) { return 0.5 * cells - 1.0; }

#endif
