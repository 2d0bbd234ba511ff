// SPDX-License-Identifier: MIT
// What readings of a tile have in common: places, sums over the levels, and turns to the axes of the world. Private to
// src/flow.
#ifndef BOLAN_FLOW_POINT_H
#define BOLAN_FLOW_POINT_H

#include "flow/tables.h"
#include "shared/cascade.glsl"

static inline double fraction(double x) {
    const double f = x - floor(x);
    return f >= 0.0 && f < 1.0 ? f : 0.0; // 1 by rounding of a tiny negative, or not a number
}

static inline double weigh(const float *weight, const float *field) {
    return (double)((weight[0] * field[0] + weight[1] * field[1]) + (weight[2] * field[2] + weight[3] * field[3]));
}

// A derivative of a field: the stored one at level 0, that of the spline, `per` samples a metre, at the others.
static inline double blend(const float *weight, double per, const float *spline, float stored) {
    const float deep = weight[1] * spline[1] + (weight[2] * spline[2] + weight[3] * spline[3]);
    return per * (double)deep + (double)(weight[0] * stored);
}

// Where a point is in a tile, in samples.
static inline bolan_dvec2 place(const tile_frame *t, double x, double y) {
    return (bolan_dvec2){fraction(along_tile(x, y, t->cosine, t->sine) / t->length) * t->n,
                         fraction(across_tile(x, y, t->cosine, t->sine) / t->length) * t->n};
}

static inline void add_turned(const tile_frame *t, double u, double v, double *x, double *y) {
    *x += u * t->cosine - v * t->sine;
    *y += u * t->sine + v * t->cosine;
}

#endif
