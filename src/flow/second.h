// SPDX-License-Identifier: MIT
// The potential of second order that belongs to the bound waves of a cascade. Private to src/flow.
//
// With phi1, eta1 the flow and the surface of first order at the mean level, the potential phi2 of second order has
//
//     d2phi2/dt2 + g dphi2/dz = Q,   Q = -d/dt |grad phi1|^2 - eta1 d/dz (g dphi1/dz + d2phi1/dt2)   at z = 0,     (1)
//
// and cosh K(H + z) below (Longuet-Higgins 1963, eq. 2.9; Sharma & Dean 1981). A pair of waves makes the sum and the
// difference of its frequencies, W, and of its wave vectors, K, so that
//
//     phi2 = Q / (g K tanh KH - W^2).                                                                              (2)
//
// Q is exact: with each field as a complex one, Z = sum of a e^{i psi}, products with a conjugate have the differences
// and products without have the sums. W is not a function of K. So (2) becomes a gain, a function of K alone, one each
// for the horizontal and the vertical part of Q, of sums and of differences: the least squares fit to (2) over pairs of
// the cascade, with the weight of their amplitudes (gains.c). As 1 - W^2 / (g K tanh KH) is nearly one value for the
// pairs of one K that count, the fit leaves some percent of phi2.
//
// A step makes, for each cascade, on a grid whatever the resolution of the sea:
//
//     fields       12 complex FFTs: velocity and surface, and their derivatives by time
//     products     Q and dQ/dt of sums and differences; 4 complex FFTs
//     potentials   (2); phi2 and dphi2/dt at four depths for each half of the range of K: 8 complex FFTs -> texels
//
//     | phi2, long K, 4 levels | phi2, short K, 4 levels | dphi2/dt, long K, 4 levels | dphi2/dt, short K, 4 levels |
//
// Sums of two waves of a ring reach 90 modes from the origin, and products up to a third of the samples a side have no
// aliases. So the longest cascade, which has the peak, has 256 samples a side and all of its pairs: those beyond 42
// have 5 % of the acceleration of first order at Hs 3 m, Tp 8 s in 12 m of water, 2.5 % in deep water. The others have
// 128, for a fourth of the cost.
//
// Pairs of waves of two cascades have no grid: short waves are carried by long ones (ride.c).
#ifndef BOLAN_FLOW_SECOND_H
#define BOLAN_FLOW_SECOND_H

#include "flow/tables.h"

enum {
    SECOND_COARSE = 128, // samples a side
    SECOND_FINE = 256,
    SECOND_FIELDS = 12,
    SECOND_PACKS = 4,
    SECOND_HALVES = 2,
    SECOND_LEVELS = SECOND_HALVES * FLOW_LEVELS,
    SECOND_PLANES = SECOND_FIELDS + SECOND_PACKS,
};

// A wave that travels one way. With A = amplitude e^{-i w t} its velocity at z = 0 is w A (across, -i) and
// g d2phi/dz2 + d3phi/dt2dz is -i w^3 bed A; `bed` is 0 in deep water.
typedef struct second_wave {
    double turns;           // w / 2 pi [1/s]
    float re, im;           // amplitude: twice that of its mode [m]
    float omega, across[2]; // [rad/s]; coth(kH) k / |k| along the tile's axes
    float bed;              // (k^2 - R^2) / R^2, R = k tanh kH
    int16_t i, j;           // of the wave vector
} second_wave;

// What becomes of the products at |i|, |j|.
typedef struct second_cell {
    float gain[4];              // phi2 by Q: horizontal, vertical part of differences; of sums [s2]
    float level[SECOND_LEVELS]; // of phi2, (2) of tables.h, over the transfer of the spline
} second_cell;

struct flow_second {
    uint32_t band;
    tile_frame frame; // of SECOND_COARSE or SECOND_FINE samples
    int32_t reach;    // of indices of waves and of pairs
    flow_levels half[SECOND_HALVES];
    uint32_t wave_count;
    second_wave *waves;
    float (*evolved)[2]; // A of the waves
    second_cell *cells;  // [reach + 1][reach + 1]
    float *texels;       // [frame.n][frame.n][FLOW_TEXEL]
    double head;         // mean that keeps the level, (1/2)(u^2 - w^2) at z = 0 [m2/s2]
};

// Sets gain and level of the cells, and the levels of both halves, from the waves. `keep` is a factor on phi2.
void bolan_flow_second_gains(flow_second *s, double sea_depth, double keep);

#endif
