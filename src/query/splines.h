// SPDX-License-Identifier: MIT
// Cubic splines (waves/cascades/spline.h) in the texels of a cascade at 16 places at once. Included by kernels only.
//
// A place reads 4 rows of 4 texels {dx, dy, height, dxy}. A row is 64 bytes: one vector of 16 floats, or several. The
// rows are blended where they lie, with the weights of the place in all lanes, to one row of values and one of
// derivatives across. Only these two are transposed, so that a vector holds one number of all places, and the rest is
// arithmetic on whole vectors:
//
//     place 0: x0 y0 h0 -  x1 y1 h1 -  ...          dx 0: x0 of all places
//     place 1: x0 y0 h0 -  x1 y1 h1 -  ...    ->    dx 1: x1 of all places      and so for dy and height
//
// For 16 places with 16 lanes that is 64 loads of rows, 224 operations before, 104 shuffles, and 63 operations after.
// The 4 x 4 texels lie in 7 cache lines on average; the texels behind the end of a row or of the tile repeat the first.
#ifndef BOLAN_QUERY_SPLINES_H
#define BOLAN_QUERY_SPLINES_H

#include "fft/wide.h"
#include "query/block.h"

enum { SPLINE_DX, SPLINE_DY, SPLINE_HEIGHT, SPLINE_FIELDS, SPLINE_TEXEL };

// Where places lie among the texels of a cascade: the first of 4 x 4, and fractions of a cell.
typedef struct spots {
    _Alignas(64) int32_t first[QUERY_LANES];
    _Alignas(64) float u[QUERY_LANES], v[QUERY_LANES];
} spots;

// Values and derivatives along and across the tile, by its cells.
typedef struct spline_values {
    _Alignas(64) float value[SPLINE_FIELDS][QUERY_LANES], along[SPLINE_FIELDS][QUERY_LANES];
    _Alignas(64) float across[SPLINE_FIELDS][QUERY_LANES];
} spline_values;

// ---- rows of four texels --------------------------------------------------------------------------------------------

// A row fills ROW_PARTS vectors. Places are taken in groups of four, of which a vector of places has GROUPS.
#if WIDE == 1
enum { ROW_PARTS = 16, GROUP = 1, GROUPS = 1 };
static inline wide load_texels(const float *at) { return *at; }
#else
enum { ROW_PARTS = 16 / WIDE, GROUP = 4, GROUPS = WIDE / 4 };
typedef float wide_texel __attribute__((vector_size(4 * WIDE), aligned(4), may_alias));
static inline wide load_texels(const float *at) { return (wide) * (const wide_texel *)(const void *)at; }
#endif

// A part of the rows of all places, group by group: vector [field][group] has a texel in each four lanes.
typedef struct grouped {
    wide at[SPLINE_FIELDS][GROUPS];
} grouped;

// rows[i]: the part of place i of the group.
static inline void put_group(wide rows[GROUP], int group, grouped *out) {
#if WIDE == 1
    (void)group;
    for (int f = 0; f < SPLINE_FIELDS; f++) out->at[f][0] = rows[0]; // of one field: sample_part() knows which
#else
    wide_transpose4(rows);
    for (int f = 0; f < SPLINE_FIELDS; f++) out->at[f][group] = rows[f];
#endif
}

// sample[field][texel]: the texels of a part, a vector of all places each.
static inline void sample_part(grouped *in, int part, int fields, wide sample[SPLINE_FIELDS][4]) {
#if WIDE == 1
    if (part % SPLINE_TEXEL < fields) sample[part % SPLINE_TEXEL][part / SPLINE_TEXEL] = in->at[0][0];
#else
#pragma GCC unroll 3
    for (int f = 0; f < fields; f++) {
        wide_transpose_groups(in->at[f]);
#pragma GCC unroll 4
        for (int g = 0; g < GROUPS; g++) sample[f][part * GROUPS + g] = in->at[f][g];
    }
#endif
}

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

// The weights of rows, one number a place.
typedef struct row_weights {
    _Alignas(64) float value[4][WIDE], slope[4][WIDE];
} row_weights;

// A part of the four rows of place i: blended, and their derivative across.
static inline void blend_rows(const float *texels, size_t pitch, const row_weights *w, int i, wide *row, wide *rise) {
    wide a[4], b[4];
#pragma GCC unroll 4
    for (int j = 0; j < 4; j++, texels += pitch) {
        const wide texel = load_texels(texels);
        a[j] = texel * w->value[j][i];
        b[j] = texel * w->slope[j][i];
    }
    *row = (a[0] + a[1]) + (a[2] + a[3]);
    *rise = (b[0] + b[1]) + (b[2] + b[3]);
}

// The places first .. first + WIDE - 1.
static inline void read_places(const query_cascade *t, const spots *at, int first, spline_values *out) {
    const size_t pitch = SPLINE_TEXEL * (size_t)t->pitch;
    wide u[4], du[4], v[4], dv[4], value[SPLINE_FIELDS][4], slope[SPLINE_FIELDS][4];
    row_weights w;
    spline_weights(wide_load(at->u + first), u, du);
    spline_weights(wide_load(at->v + first), v, dv);
    for (int j = 0; j < 4; j++) {
        wide_store(w.value[j], v[j]);
        wide_store(w.slope[j], dv[j]);
    }
    const float *texels = t->texels;
    for (int part = 0; part < ROW_PARTS; part++, texels += WIDE) {
        grouped here, across;
#pragma GCC unroll 1 // so that weights are broadcast as they are loaded, not permuted
        for (int g = 0; g < GROUPS; g++) {
            wide rows[GROUP], rises[GROUP];
#pragma GCC unroll 4
            for (int i = 0; i < GROUP; i++)
                blend_rows(texels + SPLINE_TEXEL * (size_t)at->first[first + g * GROUP + i], pitch, &w, g * GROUP + i,
                           &rows[i], &rises[i]);
            put_group(rows, g, &here);
            put_group(rises, g, &across);
        }
        sample_part(&here, part, SPLINE_FIELDS, value);
        sample_part(&across, part, SPLINE_FIELDS, slope);
    }
#pragma GCC unroll 3
    for (int f = 0; f < SPLINE_FIELDS; f++) {
        wide_store(out->value[f] + first, weighted(value[f], u));
        wide_store(out->along[f] + first, weighted(value[f], du));
        wide_store(out->across[f] + first, weighted(slope[f], u));
    }
}

// The middle 2 x 2 texels of a place, those of a row behind those of the row before: a part of them.
static inline wide load_middle(const float *texels, size_t pitch, int part) {
    const float *low = texels + pitch + SPLINE_TEXEL, *high = low + pitch;
#if WIDE == 16
    (void)part;
    const __m512 v = _mm512_castps256_ps512(_mm256_loadu_ps(low));
    return (wide)_mm512_insertf32x8(v, _mm256_loadu_ps(high), 1);
#else
    return load_texels(part < ROW_PARTS / 2 ? low + part * WIDE : high + (part - ROW_PARTS / 2) * WIDE);
#endif
}

// dx and dy at the places, read linearly.
static inline void read_places_linearly(const query_cascade *t, const spots *at, int first, spline_values *out) {
    const size_t pitch = SPLINE_TEXEL * (size_t)t->pitch;
    const wide u = wide_load(at->u + first), v = wide_load(at->v + first);
    wide sample[SPLINE_FIELDS][4]; // two of the lower row, two of the upper
    for (int part = 0; part < ROW_PARTS; part++) {
        grouped middle;
#pragma GCC unroll 4
        for (int g = 0; g < GROUPS; g++) {
            wide rows[GROUP];
#pragma GCC unroll 4
            for (int i = 0; i < GROUP; i++)
                rows[i] = load_middle(t->texels + SPLINE_TEXEL * (size_t)at->first[first + g * GROUP + i], pitch, part);
            put_group(rows, g, &middle);
        }
        sample_part(&middle, part, SPLINE_HEIGHT, sample);
    }
#pragma GCC unroll 2
    for (int f = 0; f < SPLINE_HEIGHT; f++) {
        const wide near_u = sample[f][1] - sample[f][0], far_u = sample[f][3] - sample[f][2];
        const wide low = sample[f][0] + near_u * u, across = (sample[f][2] + far_u * u) - low;
        wide_store(out->value[f] + first, low + across * v);
        wide_store(out->along[f] + first, near_u + (far_u - near_u) * v);
        wide_store(out->across[f] + first, across);
    }
}

static inline void clear_places(int first, spline_values *out) {
    for (int f = 0; f < SPLINE_FIELDS; f++) {
        wide_store(out->value[f] + first, (wide){0});
        wide_store(out->along[f] + first, (wide){0});
        wide_store(out->across[f] + first, (wide){0});
    }
}

// The places of `lanes`, and others beside them.
static inline void read_splines(const query_cascade *t, const spots *at, uint32_t lanes, spline_values *out) {
    for (int first = 0; first < QUERY_LANES; first += WIDE) {
        if (lanes >> first & ((1u << WIDE) - 1)) {
            read_places(t, at, first, out);
        } else {
            clear_places(first, out);
        }
    }
}

// dx and dy at all places, read linearly.
static inline void read_linearly(const query_cascade *t, const spots *at, spline_values *out) {
    for (int first = 0; first < QUERY_LANES; first += WIDE) read_places_linearly(t, at, first, out);
}

#endif
