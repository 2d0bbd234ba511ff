// SPDX-License-Identifier: MIT
// Cubic splines (waves/cascades/spline.h) in the planes of a cascade at 16 places at once. Included by kernels only.
//
// A place reads 4 rows of 4 samples of dx, dy and height. A row is one load of four floats; the rows of four places are
// transposed, so that a vector holds one sample of each place, and the rest is arithmetic on whole vectors:
//
//     place 0: a0 a1 a2 a3          sample 0: a0 b0 c0 d0
//     place 1: b0 b1 b2 b3    ->    sample 1: a1 b1 c1 d1      and so for each 128 bits of the vector
//     place 2: c0 c1 c2 c3          sample 2: a2 b2 c2 d2
//     place 3: d0 d1 d2 d3          sample 3: a3 b3 c3 d3
//
// A cascade takes 12 loads a place, 15 shuffles and inserts and 231 operations for 16 places with 16 lanes. Gathering
// single samples instead takes 48 loads a place.
#ifndef BOLAN_QUERY_SPLINES_H
#define BOLAN_QUERY_SPLINES_H

#include "fft/wide.h"
#include "query/block.h"

enum { SPLINE_DX, SPLINE_DY, SPLINE_HEIGHT, SPLINE_PLANES };

// Where places lie among the samples of a cascade: the first of four columns, the first samples of four rows, and
// fractions of a cell.
typedef struct spots {
    _Alignas(64) int32_t column[QUERY_LANES], first[4][QUERY_LANES];
    _Alignas(64) float u[QUERY_LANES], v[QUERY_LANES];
} spots;

// Values and derivatives along and across the tile, by its cells.
typedef struct spline_values {
    _Alignas(64) float value[SPLINE_PLANES][QUERY_LANES], along[SPLINE_PLANES][QUERY_LANES];
    _Alignas(64) float across[SPLINE_PLANES][QUERY_LANES];
} spline_values;

// The rows of WIDE places: four samples from first[j][i] on in each plane.
typedef struct rows {
    const float *plane[SPLINE_PLANES];
    const int32_t *first[4];
} rows;

// ---- four samples of WIDE places ------------------------------------------------------------------------------------

#if WIDE == 1
static inline void load_row(const float *plane, const int32_t *first, wide sample[4]) {
    for (int i = 0; i < 4; i++) sample[i] = plane[first[0] + i];
}
static inline void load_middle(const float *plane, const int32_t *first, wide sample[2]) {
    for (int i = 0; i < 2; i++) sample[i] = plane[first[0] + 1 + i];
}
#else
typedef float four __attribute__((vector_size(16), aligned(4), may_alias));

// Numbers of lanes of the two operands, the same in each 128 bits: 0..3 of the first, 4..7 of the second.
#define LANE(i, part) ((i) < 4 ? (i) + 4 * (part) : (i)-4 + WIDE + 4 * (part))
#define PART(part, a, b, c, d) LANE(a, part), LANE(b, part), LANE(c, part), LANE(d, part)
#if WIDE == 4
#define PARTS(a, b, c, d) PART(0, a, b, c, d)
#elif WIDE == 8
#define PARTS(a, b, c, d) PART(0, a, b, c, d), PART(1, a, b, c, d)
#else
#define PARTS(a, b, c, d) PART(0, a, b, c, d), PART(1, a, b, c, d), PART(2, a, b, c, d), PART(3, a, b, c, d)
#endif

// The rows at four floats from plane[at[0]], plane[at[4]], ... on, 128 bits each.
static inline wide load_places(const float *plane, const int32_t *at) {
#if WIDE == 16
    __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(plane + at[0]));
    v = _mm512_insertf32x4(v, _mm_loadu_ps(plane + at[4]), 1);
    v = _mm512_insertf32x4(v, _mm_loadu_ps(plane + at[8]), 2);
    return (wide)_mm512_insertf32x4(v, _mm_loadu_ps(plane + at[12]), 3);
#elif WIDE == 8
    const __m256 v = _mm256_castps128_ps256(_mm_loadu_ps(plane + at[0]));
    return (wide)_mm256_insertf128_ps(v, _mm_loadu_ps(plane + at[4]), 1);
#else
    return (wide) * (const four *)(const void *)(plane + at[0]);
#endif
}

static inline void load_row(const float *plane, const int32_t *first, wide sample[4]) {
    const wide a = load_places(plane, first), b = load_places(plane, first + 1);
    const wide c = load_places(plane, first + 2), d = load_places(plane, first + 3);
    const wide low_ab = WIDE_SHUFFLE(a, b, PARTS(0, 4, 1, 5)), low_cd = WIDE_SHUFFLE(c, d, PARTS(0, 4, 1, 5));
    const wide high_ab = WIDE_SHUFFLE(a, b, PARTS(2, 6, 3, 7)), high_cd = WIDE_SHUFFLE(c, d, PARTS(2, 6, 3, 7));
    sample[0] = WIDE_SHUFFLE(low_ab, low_cd, PARTS(0, 1, 4, 5));
    sample[1] = WIDE_SHUFFLE(low_ab, low_cd, PARTS(2, 3, 6, 7));
    sample[2] = WIDE_SHUFFLE(high_ab, high_cd, PARTS(0, 1, 4, 5));
    sample[3] = WIDE_SHUFFLE(high_ab, high_cd, PARTS(2, 3, 6, 7));
}

// Samples 1 and 2 alone.
static inline void load_middle(const float *plane, const int32_t *first, wide sample[2]) {
    wide all[4];
    load_row(plane, first, all);
    sample[0] = all[1];
    sample[1] = all[2];
}
#endif

// ---- splines --------------------------------------------------------------------------------------------------------

// The weights of spline.h at a fraction, and their derivatives.
static inline void spline_weights(wide t, wide w[4], wide d[4]) {
    const wide r = 1.0f - t, t2 = t * t, r2 = r * r, t3 = t2 * t, r3 = r2 * r;
    w[0] = r3 * (1.0f / 6.0f);
    w[1] = (0.5f * t3 - t2) + (2.0f / 3.0f);
    w[2] = (0.5f * r3 - r2) + (2.0f / 3.0f);
    w[3] = t3 * (1.0f / 6.0f);
    d[0] = -0.5f * r2;
    d[1] = 1.5f * t2 - 2.0f * t;
    d[2] = 2.0f * r - 1.5f * r2;
    d[3] = 0.5f * t2;
}

static inline wide weighted(const wide s[4], const wide w[4]) {
    return (s[0] * w[0] + s[1] * w[1]) + (s[2] * w[2] + s[3] * w[3]);
}

// The places first .. first + WIDE - 1.
static inline void read_places(const spots *at, int first, const rows *r, spline_values *out) {
    wide u[4], du[4], v[4], dv[4];
    wide value[SPLINE_PLANES], along[SPLINE_PLANES], across[SPLINE_PLANES];
    for (int p = 0; p < SPLINE_PLANES; p++) value[p] = along[p] = across[p] = (wide){0};
    spline_weights(wide_load(at->u + first), u, du);
    spline_weights(wide_load(at->v + first), v, dv);
#pragma GCC unroll 1
    for (int j = 0; j < 4; j++) {
#pragma GCC unroll 3
        for (int p = 0; p < SPLINE_PLANES; p++) {
            wide sample[4];
            load_row(r->plane[p], r->first[j], sample);
            const wide here = weighted(sample, u);
            value[p] += v[j] * here;
            across[p] += dv[j] * here;
            along[p] += v[j] * weighted(sample, du);
        }
    }
    for (int p = 0; p < SPLINE_PLANES; p++) {
        wide_store(out->value[p] + first, value[p]);
        wide_store(out->along[p] + first, along[p]);
        wide_store(out->across[p] + first, across[p]);
    }
}

// The same of dx and dy, read linearly.
static inline void read_places_linearly(const spots *at, int first, const rows *r, spline_values *out) {
    const wide u = wide_load(at->u + first), v = wide_load(at->v + first);
#pragma GCC unroll 2
    for (int p = 0; p < SPLINE_HEIGHT; p++) {
        wide near[2], far[2];
        load_middle(r->plane[p], r->first[1], near);
        load_middle(r->plane[p], r->first[2], far);
        const wide near_u = near[1] - near[0], far_u = far[1] - far[0];
        const wide low = near[0] + near_u * u, across = (far[0] + far_u * u) - low;
        wide_store(out->value[p] + first, low + across * v);
        wide_store(out->along[p] + first, near_u + (far_u - near_u) * v);
        wide_store(out->across[p] + first, across);
    }
}

static inline void clear_places(int first, spline_values *out) {
    for (int p = 0; p < SPLINE_PLANES; p++) {
        wide_store(out->value[p] + first, (wide){0});
        wide_store(out->along[p] + first, (wide){0});
        wide_store(out->across[p] + first, (wide){0});
    }
}

// Where some of the places go round the end of the tile: their samples, side by side.
typedef struct copied_rows {
    float sample[SPLINE_PLANES][4][WIDE][4];
    int32_t first[4][WIDE];
} copied_rows;

// The middle rows of dx and dy alone where they are read linearly.
static __attribute__((noinline)) void copy_rows(const query_cascade *t, const spots *at, int first, bool linear,
                                                copied_rows *out) {
    const float *const planes[SPLINE_PLANES] = {t->dx, t->dy, t->height};
    const int32_t mask = (int32_t)t->n - 1;
    for (int l = 0; l < WIDE; l++) {
        const int32_t column = at->column[first + l];
        for (int j = linear; j < 4 - linear; j++) {
            const int32_t start = at->first[j][first + l], row = start - column;
            out->first[j][l] = 4 * (j * WIDE + l);
            for (int p = 0; p < SPLINE_PLANES - linear; p++) {
                float *to = out->sample[p][j][l];
                if (column + 3 <= mask) {
                    memcpy(to, planes[p] + start, sizeof out->sample[p][j][l]);
                } else {
                    for (int32_t i = 0; i < 4; i++) to[i] = planes[p][row + ((column + i) & mask)];
                }
            }
        }
    }
}

static inline bool goes_round(const query_cascade *t, const spots *at, int first) {
    const int32_t last = (int32_t)t->n - 4;
    int32_t signs = 0;
    for (int l = 0; l < WIDE; l++) signs |= last - at->column[first + l];
    return signs < 0;
}

// The rows of the places first .. first + WIDE - 1.
static inline rows rows_of(const query_cascade *t, const spots *at, int first, bool linear, copied_rows *copied) {
    rows r = {{t->dx, t->dy, t->height},
              {at->first[0] + first, at->first[1] + first, at->first[2] + first, at->first[3] + first}};
    if (!goes_round(t, at, first)) return r;
    copy_rows(t, at, first, linear, copied);
    for (int p = 0; p < SPLINE_PLANES; p++) r.plane[p] = copied->sample[p][0][0];
    for (int j = 0; j < 4; j++) r.first[j] = copied->first[j];
    return r;
}

// The places of `lanes`, and others beside them.
static inline void read_splines(const query_cascade *t, const spots *at, uint32_t lanes, spline_values *out) {
    for (int first = 0; first < QUERY_LANES; first += WIDE) {
        if (!(lanes >> first & ((1u << WIDE) - 1))) {
            clear_places(first, out);
            continue;
        }
        copied_rows copied;
        const rows r = rows_of(t, at, first, false, &copied);
        read_places(at, first, &r, out);
    }
}

// dx and dy at all places, read linearly.
static inline void read_linearly(const query_cascade *t, const spots *at, spline_values *out) {
    for (int first = 0; first < QUERY_LANES; first += WIDE) {
        copied_rows copied;
        const rows r = rows_of(t, at, first, true, &copied);
        read_places_linearly(at, first, &r, out);
    }
}

#endif
