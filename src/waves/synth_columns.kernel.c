// SPDX-License-Identifier: MIT
// Second pass of a step: eight fields from the five parts, transforms along j, and what readers want: float planes, half
// texels, foam memory. sea.h has the plan.
//
// Two real fields A and B share a complex transform: P = A + iB, and since A and B are Hermitian,
// P(-j) = conj(A(j)) + i conj(B(j)).
#include "fft/strip.h"
#include "waves/synth.h"
#include "waves/wide_half.h"

#include <string.h>

void KERNEL(sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_moment *moment, uint32_t strip,
                         float *scratch);

typedef struct parts { pair h, kh, u, ku, kku; } parts;

static inline parts load_parts(const float *cell) {
    return (parts){pair_load(cell), pair_load(cell + FFT_ROW), pair_load(cell + 2 * FFT_ROW), pair_load(cell + 3 * FFT_ROW),
                   pair_load(cell + 4 * FFT_ROW)};
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
typedef struct turn { float c, s, cc, cs, ss; } turn;

static inline turn turn_of(const sea_cascade *cascade) {
    const float c = (float)cascade->cosine, s = (float)cascade->sine;
    return (turn){c, s, c * c, c * s, s * s};
}

// Packs (dx, dy) and (height, dxy) for rows j and n - j.
static inline void pack_displacement(const float *cell, turn t, float k, uint32_t lane, float *dxy_plus, float *dxy_minus,
                                     float *eta_plus, float *eta_minus) {
    const parts p = load_parts(cell + lane);
    const pair dx = pair_i(mix2(p.ku, t.c, p.u, -(t.s * k))), dy = pair_i(mix2(p.ku, t.s, p.u, t.c * k));
    const pair cross = mix3(p.kku, -t.cs, p.ku, -((t.cc - t.ss) * k), p.u, t.cs * (k * k));
    pack(dxy_plus + lane, dxy_minus + lane, dx, dy);
    pack(eta_plus + lane, eta_minus + lane, p.h, cross);
}

// Packs (slope_x, slope_y) and (dxx, dyy).
static inline void pack_slopes(const float *cell, turn t, float k, uint32_t lane, float *slope_plus, float *slope_minus,
                               float *gradient_plus, float *gradient_minus) {
    const parts p = load_parts(cell + lane);
    const pair sx = pair_i(mix2(p.kh, t.c, p.h, -(t.s * k))), sy = pair_i(mix2(p.kh, t.s, p.h, t.c * k));
    const float two = 2.0f * t.cs * k;
    const pair dxx = mix3(p.kku, -t.cc, p.ku, two, p.u, -(t.ss * (k * k)));
    const pair dyy = mix3(p.kku, -t.ss, p.ku, -two, p.u, -(t.cc * (k * k)));
    pack(slope_plus + lane, slope_minus + lane, sx, sy);
    pack(gradient_plus + lane, gradient_minus + lane, dxx, dyy);
}

#define PACK_ROWS(name)                                                                                                \
    static void name##_rows(const sea_cascade *cascade, uint32_t strip, float *first, float *second) {                 \
        const uint32_t n = cascade->n, half = cascade->strips * FFT_LANES;                                             \
        const turn t = turn_of(cascade);                                                                               \
        const float *cell = cascade->middle + (size_t)strip * half * SEA_CELL;                                         \
        for (uint32_t j = 0; j < half; j++, cell += SEA_CELL) {                                                        \
            const size_t plus = (size_t)j * FFT_ROW, minus = (size_t)((n - j) & (n - 1)) * FFT_ROW;                    \
            for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE)                                                    \
                name(cell, t, cascade->k[j], lane, first + plus, first + minus, second + plus, second + minus);        \
        }                                                                                                              \
        const size_t empty = (size_t)(n + 1 - 2 * half) * FFT_ROW * sizeof(float);                                     \
        memset(first + (size_t)half * FFT_ROW, 0, empty);                                                              \
        memset(second + (size_t)half * FFT_ROW, 0, empty);                                                             \
    }
PACK_ROWS(pack_displacement)
PACK_ROWS(pack_slopes)
#undef PACK_ROWS

// Texels of four halfs.
static inline void store_texels(uint16_t *out, pair ab, pair cd) {
    wide words[2];
    wide_interleave(wide_half_pair(ab.re, ab.im), wide_half_pair(cd.re, cd.im), words);
    memcpy(out, words, sizeof words);
}

static void store_displacement(const fft_plan *plan, const sea_cascade *cascade, uint32_t strip, const float *first,
                               const float *second) {
    for (uint32_t y = 0; y < plan->n; y++) {
        const size_t row = (size_t)plan->order[y] * FFT_ROW;
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
            const size_t at = (size_t)y * plan->n + strip * FFT_LANES + lane;
            const pair d = pair_load(first + row + lane), e = pair_load(second + row + lane);
            wide_store(cascade->field[FIELD_DX] + at, d.re);
            wide_store(cascade->field[FIELD_DY] + at, d.im);
            wide_store(cascade->field[FIELD_HEIGHT] + at, e.re);
            wide_store(cascade->field[FIELD_DXY] + at, e.im);
            store_texels(cascade->displacement_half + 4 * at, d, e);
        }
    }
}

static inline void store_foam(const sea_cascade *cascade, const sea_moment *moment, size_t at, pair gradient) {
    const wide present = (gradient.re + gradient.im) * -moment->choppiness;
    // The little that is taken away keeps a decaying memory out of the denormal numbers.
    const wide past = wide_load(cascade->foam + at) * moment->decay - 1e-9f;
    const wide foam = wide_max(wide_max(past, present), present - present);
    wide_store(cascade->foam + at, foam);
    wide_half_store(cascade->foam_half + at, foam);
}

static void store_slopes(const fft_plan *plan, const sea_cascade *cascade, const sea_moment *moment, uint32_t strip,
                         const float *first, const float *second) {
    for (uint32_t y = 0; y < plan->n; y++) {
        const size_t row = (size_t)plan->order[y] * FFT_ROW;
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
            const size_t at = (size_t)y * plan->n + strip * FFT_LANES + lane;
            const pair s = pair_load(first + row + lane), g = pair_load(second + row + lane);
            wide_store(cascade->field[FIELD_SLOPE_X] + at, s.re);
            wide_store(cascade->field[FIELD_SLOPE_Y] + at, s.im);
            wide_store(cascade->field[FIELD_DXX] + at, g.re);
            wide_store(cascade->field[FIELD_DYY] + at, g.im);
            store_texels(cascade->slope_half + 4 * at, s, g);
            store_foam(cascade, moment, at, g);
        }
    }
}

void KERNEL(sea_columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_moment *moment, uint32_t strip,
                         float *scratch) {
    float *first = scratch, *second = scratch + (size_t)plan->n * FFT_ROW;
    pack_displacement_rows(cascade, strip, first, second);
    fft_strip_of(plan, first, NULL, first);
    fft_strip_of(plan, second, NULL, second);
    store_displacement(plan, cascade, strip, first, second);
    pack_slopes_rows(cascade, strip, first, second);
    fft_strip_of(plan, first, NULL, first);
    fft_strip_of(plan, second, NULL, second);
    store_slopes(plan, cascade, moment, strip, first, second);
}
