// SPDX-License-Identifier: MIT
// Second pass of a step: rows of the eight fields by four complex transforms along i, and what readers want: texels and
// planes of floats, half texels, foam memory. cascades.h has the plan.
//
// Two real fields A and B share a complex transform: P = A + iB, and since A and B are Hermitian,
// P(-i) = conj(A(i)) + i conj(B(i)).
//
// A row of n points is m = n / 16 rows of 16 lanes: i = 16 a + l. Its transform is one of m points over a in each lane,
// a turn by e^{2 pi i bl / n}, and one of 16 points over l, for which blocks of rows are transposed:
//
//     X[b + m c] = sum_l e^{2 pi i lc / 16} (e^{2 pi i bl / n} sum_a P[16 a + l] e^{2 pi i ab / m})
#include "fft/strip.h"
#include "waves/cascades/synth.h"
#include "waves/cascades/wide_half.h"

#include <string.h>

void KERNEL(bolan_sea_rows)(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                            const sea_moment *moment, sea_half half, uint32_t block, float *scratch);

#define ALWAYS_INLINE inline __attribute__((always_inline))

// ---- a row ----------------------------------------------------------------------------------------------------------

// Scratch memory of a row, a few lines apart: the packed spectrum, two half transformed ones, and four fields.
typedef struct row_scratch {
    float *spectrum, *turned, *field;
    size_t pitch; // from field to field
} row_scratch;

enum { SHIFT = 9 * 16 };

static row_scratch row_scratch_of(uint32_t n, float *scratch) {
    const size_t row = 2 * (size_t)n + SHIFT, rows = 2 * row + (size_t)FFT_LANES * FFT_ROW;
    return (row_scratch){scratch, scratch + row, scratch + row + rows, (size_t)n + FFT_LANES};
}

// Packs two fields that follow each other, from the row's `piece` of the first strip, into `out`, [m][FFT_ROW].
static void pack(const sea_cascade *cascade, const float *piece, float *out) {
    const uint32_t n = cascade->n, m = n / FFT_LANES, half = cascade->strips, open = m >= 8 ? m / 8 * 3 : m / 2;
    for (uint32_t row = half; row < open; row++) {
        memset(out + (size_t)row * FFT_ROW, 0, FFT_ROW * sizeof(float));
        memset(out + (size_t)(m - 1 - row) * FFT_ROW, 0, FFT_ROW * sizeof(float));
    }
    wide next_re = {0}, next_im = {0};
    for (uint32_t at = half * FFT_LANES; at > 0;) { // from the highest wave number, whose neighbour is zero
        at -= WIDE;
        const float *cell = piece + (size_t)(at / FFT_LANES) * SEA_CELL + at % FFT_LANES;
        const pair p = pair_load(cell), q = pair_load(cell + SEA_PIECE);
        pair_store(out + (size_t)(at / FFT_LANES) * FFT_ROW + at % FFT_LANES, (pair){p.re - q.im, p.im + q.re});
        const uint32_t to = n - WIDE - at;
        const wide re = p.re + q.im, im = q.re - p.im;
        pair_store(out + (size_t)(to / FFT_LANES) * FFT_ROW + to % FFT_LANES,
                   (pair){wide_mirror(re, next_re), wide_mirror(im, next_im)});
        next_re = re;
        next_im = im;
    }
}

static inline pair pair_turn_lanes(pair a, const float *w) {
    const pair t = pair_load(w);
    return (pair){a.re * t.re - a.im * t.im, a.re * t.im + a.im * t.re};
}

// The last stage of radix r over a, and the turns.
#define TURN(name, r, butterfly)                                                                            \
    static ALWAYS_INLINE void name(const fft_plan *plan, const float *turns, const float *in, float *out) { \
        const uint32_t apart = plan->n / r;                                                                 \
        for (uint32_t b0 = 0; b0 < apart; b0++) {                                                           \
            const float *rows = in + (size_t)plan->order[b0] * FFT_ROW;                                     \
            for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                       \
                pair a[r], b[r];                                                                            \
                for (uint32_t i = 0; i < r; i++) a[i] = pair_load(rows + lane + (size_t)i * FFT_ROW);       \
                butterfly(a, b);                                                                            \
                for (uint32_t i = 0; i < r; i++) {                                                          \
                    const size_t at = (size_t)(b0 + i * apart) * FFT_ROW + lane;                            \
                    pair_store(out + at, pair_turn_lanes(b[i], turns + at));                                \
                }                                                                                           \
            }                                                                                               \
        }                                                                                                   \
    }
TURN(turn2, 2, butterfly2)
TURN(turn4, 4, butterfly4)
TURN(turn8, 8, butterfly8)
TURN(turn8_open, 8, butterfly8_open)
#undef TURN

// The transform over a, turned: `in` to `out`.
static void transform_rows(const fft_plan *plan, const float *turns, float *in, float *out) {
    if (plan->n == 8) {
        turn8_open(plan, turns, in, out);
        return;
    }
    if (plan->n > 8) stage8_open(in, plan->n, plan->n, plan->twiddle[0]);
    switch (plan->radix[plan->stages - 1]) {
    case 2: turn2(plan, turns, in, out); break;
    case 4: turn4(plan, turns, in, out); break;
    default: turn8(plan, turns, in, out); break;
    }
}

// WIDE rows of 16 lanes as 16 vectors of WIDE lanes.
static ALWAYS_INLINE void load_transposed(const float *rows, wide v[FFT_LANES]) {
#pragma GCC unroll 16
    for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
#pragma GCC unroll 16
        for (uint32_t i = 0; i < WIDE; i++) v[lane + i] = wide_load(rows + (size_t)i * FFT_ROW + lane);
        wide_transpose(v + lane);
    }
}

// Point c of the transforms whose turned rows begin at `row`: to a field at `out`. Where the m rows of a transform are
// less than a vector, it holds the rows of `count` transforms, and nothing behind.
static ALWAYS_INLINE void store_point(float *out, size_t apart, uint32_t m, uint32_t count, wide v) {
    if (m >= WIDE) {
        wide_store(out, v);
    } else {
        const float *lanes = (const float *)&v;
        for (uint32_t t = 0; t < WIDE / m && t < count; t++)
            for (uint32_t i = 0; i < m; i++) out[t * apart + i] = lanes[t * m + i];
    }
}

// The transforms over l of `count` turned transforms, to two fields each.
static ALWAYS_INLINE void transform_lanes(const row_scratch *r, uint32_t m, uint32_t count) {
    for (uint32_t row = 0; row < count * m; row += WIDE) {
        wide re[FFT_LANES], im[FFT_LANES];
        load_transposed(r->turned + (size_t)row * FFT_ROW, re);
        load_transposed(r->turned + (size_t)row * FFT_ROW + FFT_LANES, im);
        pair t[4][4];
        begin16(re, im, t);
        float *out = r->field + (size_t)(row / m * 2) * r->pitch + row % m;
#pragma GCC unroll 4
        for (uint32_t q = 0; q < 4; q++) {
            const pair in[4] = {t[0][q], t[1][q], t[2][q], t[3][q]};
            pair point[4];
            butterfly4(in, point);
#pragma GCC unroll 4
            for (uint32_t i = 0; i < 4; i++) {
                store_point(out + (size_t)(q + 4 * i) * m, 2 * r->pitch, m, count, point[i].re);
                store_point(out + (size_t)(q + 4 * i) * m + r->pitch, 2 * r->pitch, m, count, point[i].im);
            }
        }
    }
}

// A row of 2 `count` fields of `middle`, from `piece` on -> r->field.
static void transform(const cascade_tables *tables, const sea_cascade *cascade, const float *piece, uint32_t count,
                      const row_scratch *r) {
    const uint32_t m = tables->rows.n;
    for (uint32_t t = 0; t < count; t++) {
        pack(cascade, piece + (size_t)t * 2 * SEA_PIECE, r->spectrum);
        transform_rows(&tables->rows, tables->turns, r->spectrum, r->turned + (size_t)t * m * FFT_ROW);
    }
    if (m == FFT_LANES / 2) { // a constant where it matters
        transform_lanes(r, FFT_LANES / 2, count);
    } else {
        transform_lanes(r, m, count);
    }
}

// ---- what readers want ----------------------------------------------------------------------------------------------

static inline void put(bool stream, float *p, wide v) {
    if (stream) {
        wide_stream(p, v);
    } else {
        wide_store(p, v);
    }
}

// Texels of four halfs.
static inline void store_texels(sea_stream stream, uint16_t *out, const wide v[4]) {
    wide words[2];
    wide_interleave(wide_half_pair(v[0], v[1]), wide_half_pair(v[2], v[3]), words);
    put(stream == SEA_STREAM_ALL, (float *)(void *)out, words[0]);
    put(stream == SEA_STREAM_ALL, (float *)(void *)out + WIDE, words[1]);
}

// What is left of the foam of the last tick, or the present pinch where it is more. Both are bounded, so that a memory
// ends (sea.h).
static inline wide foam_of(const float *tick, const sea_moment *moment, wide dxx, wide dyy) {
    const wide present = (dxx + dyy) * -moment->choppiness, none = present - present;
    const wide past = wide_load(tick) * moment->at.keep - moment->at.lose;
    return wide_max(wide_max(past, wide_min(present, none + SEA_MOST_FOAM)), none);
}

static inline void store_foam(const sea_planes *planes, const sea_moment *moment, size_t at, wide dxx, wide dyy) {
    const wide foam = foam_of(planes->foam_tick + at, moment, dxx, dyy);
    wide_store(planes->foam + at, foam);
    wide_half_store(planes->foam_half + at, foam);
}

// Row y of the displacement, and the row after the last that repeats it.
static ALWAYS_INLINE void store_displacement(const row_scratch *r, bolan_sea_texel *texels, sea_stream stream,
                                             uint32_t n, uint32_t y) {
    const uint32_t pitch = n + BOLAN_CASCADE_GUARD;
    for (uint32_t to = y; to < pitch; to += n) {
        bolan_sea_texel *row = texels + (size_t)to * pitch;
        for (uint32_t x = 0; x < n; x += WIDE) {
            wide v[SEA_HALF];
#pragma GCC unroll 4
            for (int f = 0; f < SEA_HALF; f++) v[f] = wide_load(r->field + (size_t)f * r->pitch + x);
            wide_texels(v);
#pragma GCC unroll 4
            for (int f = 0; f < SEA_HALF; f++) put(stream != SEA_STREAM_NONE, &row[x].dx + f * WIDE, v[f]);
        }
        for (uint32_t x = 0; x < BOLAN_CASCADE_GUARD; x++) {
            const float *field = r->field + x;
            row[n + x] = (bolan_sea_texel){field[0], field[r->pitch], field[2 * r->pitch], field[3 * r->pitch]};
        }
    }
}

static ALWAYS_INLINE void store_slopes(const row_scratch *r, float *const plane[SEA_HALF], sea_stream stream,
                                       uint32_t n, uint32_t y) {
    for (int f = 0; f < SEA_HALF; f++) // one after the other, so that streamed lines are written at once
        for (uint32_t x = 0; x < n; x += WIDE)
            put(stream != SEA_STREAM_NONE, plane[f] + (size_t)y * n + x,
                wide_load(r->field + (size_t)f * r->pitch + x));
}

// Row y of the four fields of a half.
static ALWAYS_INLINE void store_row(const row_scratch *r, const sea_planes *planes, const sea_moment *moment,
                                    sea_stream stream, sea_half half, uint32_t n, uint32_t y) {
    uint16_t *texels = half == SEA_SLOPES ? planes->slope_half : planes->displacement_half;
    if (half == SEA_SLOPES) {
        store_slopes(r, planes->slope, stream, n, y);
    } else {
        store_displacement(r, planes->displacement, stream, n, y);
    }
    for (uint32_t x = 0; x < n; x += WIDE) {
        const size_t at = (size_t)y * n + x;
        wide v[SEA_HALF];
#pragma GCC unroll 4
        for (int f = 0; f < SEA_HALF; f++) v[f] = wide_load(r->field + (size_t)f * r->pitch + x);
        store_texels(stream, texels + 4 * at, v);
        if (half == SEA_SLOPES) store_foam(planes, moment, at, v[SEA_DIVERGENCE], v[SEA_DIVERGENCE + 1]);
    }
}

static ALWAYS_INLINE void rows(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                               const sea_moment *moment, sea_stream stream, sea_half half, uint32_t block,
                               const row_scratch *r) {
    const float *piece = planes->middle + (size_t)block * cascade->strips * SEA_CELL;
    for (uint32_t y = block * SEA_ROWS; y < (block + 1) * SEA_ROWS; y++, piece += FFT_ROW) {
        transform(tables, cascade, piece, 2, r);
        store_row(r, planes, moment, stream, half, cascade->n, y);
    }
}

static ALWAYS_INLINE void rows_of_half(const cascade_tables *tables, const sea_cascade *cascade,
                                       const sea_planes *planes, const sea_moment *moment, sea_stream stream,
                                       sea_half half, uint32_t block, const row_scratch *r) {
    if (half == SEA_SLOPES) {
        rows(tables, cascade, planes, moment, stream, SEA_SLOPES, block, r);
    } else {
        rows(tables, cascade, planes, moment, stream, SEA_DISPLACEMENT, block, r);
    }
}

// A tick: div D alone, and the foam memory.
static void tick_rows(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                      const sea_moment *moment, uint32_t block, const row_scratch *r) {
    const float *piece = planes->middle + (size_t)block * cascade->strips * SEA_CELL + SEA_DIVERGENCE * SEA_PIECE;
    for (uint32_t y = block * SEA_ROWS; y < (block + 1) * SEA_ROWS; y++, piece += FFT_ROW) {
        transform(tables, cascade, piece, 1, r);
        for (uint32_t x = 0; x < cascade->n; x += WIDE) {
            float *tick = planes->foam_tick + (size_t)y * cascade->n + x;
            wide_store(tick, foam_of(tick, moment, wide_load(r->field + x), wide_load(r->field + r->pitch + x)));
        }
    }
}

void KERNEL(bolan_sea_rows)(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                            const sea_moment *moment, sea_half half, uint32_t block, float *scratch) {
    const row_scratch r = row_scratch_of(cascade->n, scratch);
    if (moment->at.tick) {
        tick_rows(tables, cascade, planes, moment, block, &r);
        return;
    }
    switch (moment->stream) { // a constant in each case, so that the loops have no branches
    case SEA_STREAM_NONE: rows_of_half(tables, cascade, planes, moment, SEA_STREAM_NONE, half, block, &r); break;
    case SEA_STREAM_PLANES: rows_of_half(tables, cascade, planes, moment, SEA_STREAM_PLANES, half, block, &r); break;
    case SEA_STREAM_ALL: rows_of_half(tables, cascade, planes, moment, SEA_STREAM_ALL, half, block, &r); break;
    }
    wide_stream_end();
}
