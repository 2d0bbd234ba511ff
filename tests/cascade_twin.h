// SPDX-License-Identifier: MIT
// How the planes of a cascade are read, written down once more from the definitions: twin of
// src/waves/cascades/sample.c.
#ifndef BOLAN_TESTS_CASCADE_TWIN_H
#define BOLAN_TESTS_CASCADE_TWIN_H

#include "bolan/waves.h"

#include <math.h>

// A field of a cascade: sample (i, j) is at[j * row + i * step].
typedef struct twin_field {
    const float *at;
    size_t step, row;
} twin_field;

#define TWIN_TEXELS(v, name) ((twin_field){&(v)->displacement->name, 4, 4 * (size_t)(v)->pitch}) // dx, dy, height, dxy
#define TWIN_PLANE(v, name) ((twin_field){(v)->name, 1, (v)->n})                                 // the others

static inline float twin_at(twin_field f, uint32_t i, uint32_t j) { return f.at[j * f.row + i * f.step]; }

// The field without gaps: @p out has n * n.
static inline void twin_copy(const bolan_cascade_view *v, twin_field f, float *out) {
    for (uint32_t j = 0; j < v->n; j++)
        for (uint32_t i = 0; i < v->n; i++) out[(size_t)j * v->n + i] = twin_at(f, i, j);
}

typedef struct twin_place {
    uint32_t n, i, j;
    double u, v; // fractions of the cell
} twin_place;

static inline twin_place twin_place_in(const bolan_cascade_view *v, bolan_dvec2 at) {
    const double c = cos(v->angle), s = sin(v->angle);
    double u = (at.x * c + at.y * s) / v->length, w = (at.y * c - at.x * s) / v->length;
    u = (u - floor(u)) * v->n, w = (w - floor(w)) * v->n;
    return (twin_place){v->n, (uint32_t)u % v->n, (uint32_t)w % v->n, u - floor(u), w - floor(w)};
}

static inline double twin_sample(twin_field field, const twin_place *p, int i, int j) {
    return (double)twin_at(field, (p->i + (uint32_t)i) % p->n, (p->j + (uint32_t)j) % p->n);
}

static inline double twin_linear(twin_field field, const twin_place *p) {
    return (twin_sample(field, p, 0, 0) * (1.0 - p->u) + twin_sample(field, p, 1, 0) * p->u) * (1.0 - p->v) +
           (twin_sample(field, p, 0, 1) * (1.0 - p->u) + twin_sample(field, p, 1, 1) * p->u) * p->v;
}

// The cubic B-spline, of |x| <= 2.
static inline double twin_bump(double x) {
    const double a = fabs(x);
    return a < 1.0 ? 2.0 / 3.0 - a * a + 0.5 * a * a * a : pow(2.0 - fmin(a, 2.0), 3.0) / 6.0;
}

static inline double twin_cubic(twin_field field, const twin_place *p) {
    double sum = 0.0;
    for (int j = -1; j <= 2; j++)
        for (int i = -1; i <= 2; i++) sum += twin_bump(p->u - i) * twin_bump(p->v - j) * twin_sample(field, p, i, j);
    return sum;
}

#endif
