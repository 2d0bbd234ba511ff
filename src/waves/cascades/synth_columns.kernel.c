// SPDX-License-Identifier: MIT
// Second pass of a step: eight fields from the eight parts, transforms along j, and what readers want: float planes,
// half texels, foam memory. cascades.h has the plan.
//
// Two real fields A and B share a complex transform: P = A + iB, and since A and B are Hermitian,
// P(-j) = conj(A(j)) + i conj(B(j)).
#include "fft/strip.h"
#include "waves/cascades/synth.h"
#include "waves/cascades/wide_half.h"

#include <string.h>

void KERNEL(bolan_sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                               const sea_moment *moment, uint32_t strip, float *scratch);

#define ALWAYS_INLINE inline __attribute__((always_inline))

static inline pair load_part(const float *cell, int part, uint32_t lane) {
    return pair_load(cell + part * FFT_ROW + lane);
}
static inline pair mix2(pair a, float fa, pair b, float fb) {
    return (pair){a.re * fa + b.re * fb, a.im * fa + b.im * fb};
}
static inline pair mix3(pair a, float fa, pair b, float fb, pair c, float fc) {
    return (pair){(a.re * fa + b.re * fb) + c.re * fc, (a.im * fa + b.im * fb) + c.im * fc};
}

// P at j and at -j, row 0 standing for both.
static inline void pack(float *plus, float *minus, pair a, pair b) {
    pair_store(minus, (pair){a.re + b.im, b.re - a.im});
    pair_store(plus, (pair){a.re - b.im, a.im + b.re});
}

// The factors that turn tile axes into world axes. With D = i k/|k| coth h and G = dD/dx, in tile axes at row j:
// D = (i ku, i kj u), G = -(kku, kj ku, kj^2 u); a rotation R gives R D and R G R^T.
typedef struct turn {
    float c, s, cc, cs, ss;
} turn;

static inline turn turn_of(const sea_cascade *cascade) {
    const float c = (float)cascade->cosine, s = (float)cascade->sine;
    return (turn){c, s, c * c, c * s, s * s};
}

// The factors of row j: its wave number, and one over the divisors.
typedef struct row_factors {
    float k, cubic, linear;
} row_factors;

// Packs (dx, dy) and (height, dxy) for rows j and n - j.
static inline void pack_displacement(const float *cell, turn t, row_factors j, uint32_t lane, float *dxy_plus,
                                     float *dxy_minus, float *eta_plus, float *eta_minus) {
    const pair u = load_part(cell, PART_U, lane), ku = load_part(cell, PART_KU, lane);
    const float q = j.cubic, kq = j.k * j.cubic, l = j.linear;
    const pair dx = pair_i(mix2(ku, t.c * q, u, -(t.s * kq))), dy = pair_i(mix2(ku, t.s * q, u, t.c * kq));
    const pair cross = mix3(load_part(cell, PART_LINEAR_KKU, lane), -t.cs * l, load_part(cell, PART_LINEAR_KU, lane),
                            -((t.cc - t.ss) * (j.k * l)), load_part(cell, PART_LINEAR_U, lane), t.cs * (j.k * j.k * l));
    pack(dxy_plus + lane, dxy_minus + lane, dx, dy);
    pack(eta_plus + lane, eta_minus + lane, pair_scale(load_part(cell, PART_H, lane), q), cross);
}

// Packs (dxx, dyy).
static inline void pack_gradient(const float *cell, turn t, row_factors j, uint32_t lane, float *gradient_plus,
                                 float *gradient_minus) {
    const pair u = load_part(cell, PART_LINEAR_U, lane), ku = load_part(cell, PART_LINEAR_KU, lane),
               kku = load_part(cell, PART_LINEAR_KKU, lane);
    const float l = j.linear, two = 2.0f * t.cs * (j.k * l), kk = j.k * j.k * l;
    const pair dxx = mix3(kku, -t.cc * l, ku, two, u, -(t.ss * kk));
    const pair dyy = mix3(kku, -t.ss * l, ku, -two, u, -(t.cc * kk));
    pack(gradient_plus + lane, gradient_minus + lane, dxx, dyy);
}

// Packs (slope_x, slope_y) and (dxx, dyy).
static inline void pack_slopes(const float *cell, turn t, row_factors j, uint32_t lane, float *slope_plus,
                               float *slope_minus, float *gradient_plus, float *gradient_minus) {
    const pair h = load_part(cell, PART_LINEAR_H, lane), kh = load_part(cell, PART_LINEAR_KH, lane);
    const float l = j.linear, kl = j.k * j.linear;
    const pair sx = pair_i(mix2(kh, t.c * l, h, -(t.s * kl))), sy = pair_i(mix2(kh, t.s * l, h, t.c * kl));
    pack(slope_plus + lane, slope_minus + lane, sx, sy);
    pack_gradient(cell, t, j, lane, gradient_plus, gradient_minus);
}

#define PACK_ROWS(name)                                                                                                \
    static void name##_rows(const sea_cascade *cascade, const float *middle, uint32_t strip, float *first,             \
                            float *second) {                                                                           \
        const uint32_t n = cascade->n, half = cascade->strips * FFT_LANES;                                             \
        const turn t = turn_of(cascade);                                                                               \
        const float *cell = middle + (size_t)strip * half * SEA_CELL;                                                  \
        for (uint32_t j = 0; j < half; j++, cell += SEA_CELL) {                                                        \
            const size_t plus = (size_t)j * FFT_ROW, minus = (size_t)((n - j) & (n - 1)) * FFT_ROW;                    \
            for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE)                                                    \
                name(cell, t, (row_factors){cascade->k[j], cascade->cubic[j], cascade->linear[j]}, lane, first + plus, \
                     first + minus, second + plus, second + minus);                                                    \
        }                                                                                                              \
        const size_t empty = (size_t)(n + 1 - 2 * half) * FFT_ROW * sizeof(float);                                     \
        memset(first + (size_t)half * FFT_ROW, 0, empty);                                                              \
        memset(second + (size_t)half * FFT_ROW, 0, empty);                                                             \
    }
PACK_ROWS(pack_displacement)
PACK_ROWS(pack_slopes)
#undef PACK_ROWS

static inline void put(bool stream, float *p, wide v) {
    if (stream) {
        wide_stream(p, v);
    } else {
        wide_store(p, v);
    }
}

// Texels of four halfs.
static inline void store_texels(sea_stream stream, uint16_t *out, pair ab, pair cd) {
    wide words[2];
    wide_interleave(wide_half_pair(ab.re, ab.im), wide_half_pair(cd.re, cd.im), words);
    put(stream == SEA_STREAM_ALL, (float *)(void *)out, words[0]);
    put(stream == SEA_STREAM_ALL, (float *)(void *)out + WIDE, words[1]);
}

static inline void store_displacement(const sea_planes *planes, sea_stream stream, size_t at, pair d, pair e) {
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_DX] + at, d.re);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_DY] + at, d.im);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_HEIGHT] + at, e.re);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_DXY] + at, e.im);
    store_texels(stream, planes->displacement_half + 4 * at, d, e);
}

static inline void store_slopes(const sea_planes *planes, sea_stream stream, size_t at, pair s, pair g) {
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_SLOPE_X] + at, s.re);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_SLOPE_Y] + at, s.im);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_DXX] + at, g.re);
    put(stream != SEA_STREAM_NONE, planes->field[FIELD_DYY] + at, g.im);
    store_texels(stream, planes->slope_half + 4 * at, s, g);
}

// What is left of the foam of the last tick, or the present pinch where it is more. Both are bounded, so that a memory
// ends (sea.h).
static inline wide foam_of(const float *tick, const sea_moment *moment, pair gradient) {
    const wide present = (gradient.re + gradient.im) * -moment->choppiness, none = present - present;
    const wide past = wide_load(tick) * moment->at.keep - moment->at.lose;
    return wide_max(wide_max(past, wide_min(present, none + SEA_MOST_FOAM)), none);
}

static inline void store_foam(const sea_planes *planes, const sea_moment *moment, size_t at, pair gradient) {
    const wide foam = foam_of(planes->foam_tick + at, moment, gradient);
    wide_store(planes->foam + at, foam);
    wide_half_store(planes->foam_half + at, foam);
}

// The last stage of two transforms, whose outputs go where they belong at once. Its eight outputs lie n / 8 rows apart.
static ALWAYS_INLINE void finish(const fft_plan *plan, const sea_planes *planes, const sea_moment *moment, bool stream,
                                 bool slopes, uint32_t strip, const float *first, const float *second) {
    const uint32_t n = plan->n;
    for (uint32_t y = 0; y < n / 8; y++) {
        const size_t row = (size_t)plan->order[y] * FFT_ROW;
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
            pair a[8], d[8], e[8];
#pragma GCC unroll 8
            for (uint32_t i = 0; i < 8; i++) a[i] = pair_load(first + row + lane + (size_t)i * FFT_ROW);
            butterfly8(a, d);
#pragma GCC unroll 8
            for (uint32_t i = 0; i < 8; i++) a[i] = pair_load(second + row + lane + (size_t)i * FFT_ROW);
            butterfly8(a, e);
#pragma GCC unroll 8
            for (uint32_t i = 0; i < 8; i++) {
                const size_t at = (size_t)(y + i * (n / 8)) * n + strip * FFT_LANES + lane;
                if (slopes) {
                    store_slopes(planes, stream, at, d[i], e[i]);
                    store_foam(planes, moment, at, e[i]);
                } else {
                    store_displacement(planes, stream, at, d[i], e[i]);
                }
            }
        }
    }
}

static ALWAYS_INLINE void columns(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                                  const sea_moment *moment, bool stream, uint32_t strip, float *scratch) {
    float *first = scratch, *second = scratch + sea_scratch_pitch(plan->n);
#pragma GCC unroll 2
    for (int slopes = 0; slopes < 2; slopes++) {
        (slopes ? pack_slopes_rows : pack_displacement_rows)(cascade, planes->middle, strip, first, second);
        stage_first(plan, first, NULL, first);
        fft_strip_rest(plan, first, false);
        stage_first(plan, second, NULL, second);
        fft_strip_rest(plan, second, false);
        finish(plan, planes, moment, stream, slopes, strip, first, second);
    }
}

// A tick: div D alone, and the foam memory.
static void tick_columns(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                         const sea_moment *moment, uint32_t strip, float *work) {
    const uint32_t n = plan->n, half = cascade->strips * FFT_LANES;
    const turn t = turn_of(cascade);
    const float *cell = planes->middle + (size_t)strip * half * SEA_CELL;
    for (uint32_t j = 0; j < half; j++, cell += SEA_CELL) {
        float *plus = work + (size_t)j * FFT_ROW, *minus = work + (size_t)((n - j) & (n - 1)) * FFT_ROW;
        const row_factors factors = {cascade->k[j], cascade->cubic[j], cascade->linear[j]};
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) pack_gradient(cell, t, factors, lane, plus, minus);
    }
    memset(work + (size_t)half * FFT_ROW, 0, (size_t)(n + 1 - 2 * half) * FFT_ROW * sizeof(float));
    stage_first(plan, work, NULL, work);
    fft_strip_rest(plan, work, false);
    for (uint32_t y = 0; y < n / 8; y++) {
        const size_t row = (size_t)plan->order[y] * FFT_ROW;
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
            pair a[8], d[8];
            for (uint32_t i = 0; i < 8; i++) a[i] = pair_load(work + row + lane + (size_t)i * FFT_ROW);
            butterfly8(a, d);
            for (uint32_t i = 0; i < 8; i++) {
                float *tick = planes->foam_tick + (size_t)(y + i * (n / 8)) * n + strip * FFT_LANES + lane;
                wide_store(tick, foam_of(tick, moment, d[i]));
            }
        }
    }
}

void KERNEL(bolan_sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                               const sea_moment *moment, uint32_t strip, float *scratch) {
    if (moment->at.tick) {
        tick_columns(plan, cascade, planes, moment, strip, scratch);
        return;
    }
    switch (moment->stream) { // a constant in each case, so that the loops have no branches
    case SEA_STREAM_NONE: columns(plan, cascade, planes, moment, SEA_STREAM_NONE, strip, scratch); break;
    case SEA_STREAM_PLANES: columns(plan, cascade, planes, moment, SEA_STREAM_PLANES, strip, scratch); break;
    case SEA_STREAM_ALL: columns(plan, cascade, planes, moment, SEA_STREAM_ALL, strip, scratch); break;
    }
    wide_stream_end();
}
