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
#include "waves/cascades/wide_fields.h"

#include <string.h>

void KERNEL(bolan_sea_rows)(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                            const sea_moment *moment, sea_half half, uint32_t block, float *scratch);

#define ALWAYS_INLINE inline __attribute__((always_inline))

// ---- a row ----------------------------------------------------------------------------------------------------------

// Scratch memory of a row, a few lines apart: the packed spectrum, two half transformed ones, and the outputs.
typedef struct row_scratch {
    float *spectrum, *turned;
    float *row;     // four fields, or texels with those behind the last
    uint16_t *half; // texels
} row_scratch;

enum { SHIFT = 9 * 16 };

static row_scratch row_scratch_of(uint32_t n, float *scratch) {
    float *turned = scratch + 2 * (size_t)n + SHIFT, *row = turned + 4 * (size_t)n + SHIFT;
    return (row_scratch){scratch, turned, row, (uint16_t *)(void *)(row + 4 * (size_t)n + SHIFT)};
}

// ---- the transform over a -------------------------------------------------------------------------------------------

// Two fields that follow each other, from the row's piece of the first strip on. What the next row will read, `ahead`
// floats on, is fetched: strips are pages apart, where no processor foresees it.
typedef struct packing {
    const float *piece;
    ptrdiff_t ahead;
    uint32_t strips, m;
} packing;

static ALWAYS_INLINE void prefetch_pair(const float *row) {
    __builtin_prefetch(row);
    __builtin_prefetch(row + FFT_LANES);
}

// P in row a = `row` of the lower half, WIDE values of i.
static ALWAYS_INLINE pair packed_low(const packing *k, uint32_t row, uint32_t lane) {
    if (row >= k->strips) return (pair){(wide){0}, (wide){0}};
    const float *cell = k->piece + (size_t)row * SEA_CELL + lane;
    const pair a = pair_load(cell), b = pair_load(cell + SEA_PIECE);
    prefetch_pair(cell + k->ahead);
    prefetch_pair(cell + k->ahead + SEA_PIECE);
    return (pair){a.re - b.im, a.im + b.re};
}

// P at minus i from 16 `strip` + `lane` on.
static ALWAYS_INLINE pair packed_minus(const packing *k, uint32_t strip, uint32_t lane) {
    if (strip >= k->strips) return (pair){(wide){0}, (wide){0}};
    const float *cell = k->piece + (size_t)strip * SEA_CELL + lane;
    const pair a = pair_load(cell), b = pair_load(cell + SEA_PIECE);
    return (pair){a.re + b.im, b.re - a.im};
}

// P in row a = `row` of the upper half.
static ALWAYS_INLINE pair packed_high(const packing *k, uint32_t row, uint32_t lane) {
    const uint32_t strip = k->m - 1 - row, from = FFT_LANES - WIDE - lane;
    if (strip >= k->strips) return (pair){(wide){0}, (wide){0}};
    const pair v = packed_minus(k, strip, from);
    const pair next = lane > 0 ? packed_minus(k, strip, from + WIDE) : packed_minus(k, strip + 1, 0);
    return (pair){wide_mirror(v.re, next.re), wide_mirror(v.im, next.im)};
}

static inline pair pair_turn_lanes(pair a, const float *w) {
    const pair t = pair_load(w);
    return (pair){a.re * t.re - a.im * t.im, a.re * t.im + a.im * t.re};
}

// The first stage, of radix r, of which so many blocks of rows of either half may hold modes. Where it is the only one,
// the outputs are turned.
#define FIRST(name, r, blocks, butterfly)                                                                  \
    static ALWAYS_INLINE void name(const fft_plan *plan, const float *turns, const packing *k, uint32_t j, \
                                   float *out) {                                                           \
        const uint32_t q = k->m / r;                                                                       \
        const float *twiddle = plan->twiddle[0] + 2 * (size_t)j * (r - 1);                                 \
        for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                          \
            pair a[r], b[r];                                                                               \
            for (uint32_t i = 0; i < blocks; i++) {                                                        \
                a[i] = packed_low(k, j + i * q, lane);                                                     \
                a[r - 1 - i] = packed_high(k, j + (r - 1 - i) * q, lane);                                  \
            }                                                                                              \
            butterfly(a, b);                                                                               \
            for (uint32_t i = 0; i < r; i++) {                                                             \
                const size_t at = (size_t)(j + i * q) * FFT_ROW + lane;                                    \
                pair_store(out + at, q == 1  ? pair_turn_lanes(b[i], turns + at)                           \
                                     : i > 0 ? pair_turn(b[i], twiddle + 2 * (i - 1))                      \
                                             : b[i]);                                                      \
            }                                                                                              \
        }                                                                                                  \
    }
FIRST(first2, 2, 1, butterfly2)
FIRST(first4, 4, 2, butterfly4)
FIRST(first8_two, 8, 1, butterfly8_two)
FIRST(first8_four, 8, 2, butterfly8_four)
FIRST(first8_open, 8, 3, butterfly8_open)
#undef FIRST

// Row j of each block.
static ALWAYS_INLINE void begin_row(const fft_plan *plan, const float *turns, const packing *k, uint32_t j,
                                    float *out) {
    const uint32_t q = k->m / 8, far = j > q - 1 - j ? q - 1 - j : j; // in the block that is nearest to its modes
    if (k->strips <= q + far) {
        first8_two(plan, turns, k, j, out);
    } else if (k->strips <= 2 * q + far) {
        first8_four(plan, turns, k, j, out);
    } else {
        first8_open(plan, turns, k, j, out);
    }
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
#undef TURN

// The transform over a, turned, of two fields; `between` is scratch memory.
static void transform_rows(const fft_plan *plan, const float *turns, const packing *k, float *between, float *out) {
    switch (plan->n) {
    case 2: first2(plan, turns, k, 0, out); return;
    case 4: first4(plan, turns, k, 0, out); return;
    case 8: begin_row(plan, turns, k, 0, out); return;
    default: break;
    }
    for (uint32_t j = 0; j < plan->n / 8; j++) begin_row(plan, turns, k, j, between);
    switch (plan->radix[plan->stages - 1]) {
    case 2: turn2(plan, turns, between, out); break;
    case 4: turn4(plan, turns, between, out); break;
    default: turn8(plan, turns, between, out); break;
    }
}

// A group of the lanes b of both turned transforms: GROUP rows of the first, and as many of the second `apart` floats
// behind, as 16 vectors.
static ALWAYS_INLINE void load_transposed(const float *rows, size_t apart, wide v[FFT_LANES]) {
#pragma GCC unroll 16
    for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {
#pragma GCC unroll 16
        for (uint32_t i = 0; i < WIDE; i++)
            v[lane + i] = wide_load(rows + i / GROUP * apart + (size_t)(i % GROUP) * FFT_ROW + lane);
        wide_transpose(v + lane);
    }
}

// Where a row goes.
typedef struct row_out {
    float *texels;   // of SEA_DISPLACEMENT
    float *plane[4]; // of SEA_SLOPES, and of a tick
    uint16_t *half;  // texels, too; not of a tick
} row_out;

typedef enum row_kind { ROW_DISPLACEMENT, ROW_SLOPES, ROW_TICK } row_kind;

// GROUP samples of four fields, from x on.
static ALWAYS_INLINE void put_fields(row_kind kind, const row_out *out, uint32_t x, wide_fields f) {
    if (kind != ROW_DISPLACEMENT) wide_fields_store(f, out->plane, x);
    if (kind == ROW_TICK) return;
    wide texels[TEXEL_PARTS];
    wide_fields_texels(f, texels);
    if (kind == ROW_DISPLACEMENT)
#pragma GCC unroll 4
        for (uint32_t part = 0; part < TEXEL_PARTS; part++)
            wide_store(out->texels + 4 * (size_t)x + part * WIDE, texels[part]);
    wide_fields_halves(f, texels, out->half + 4 * (size_t)x);
}

// The transforms over l of two turned transforms, which are the four fields of a row, or two of two.
static ALWAYS_INLINE void transform_lanes(const float *turned, uint32_t m, row_kind kind, const row_out *out) {
    const size_t apart = (size_t)m * FFT_ROW;
    for (uint32_t b = 0; b < m; b += GROUP) {
        pair t[PASSES][4][4];
        for (uint32_t pass = 0; pass < PASSES; pass++) {
            const float *rows = turned + (size_t)b * FFT_ROW + pass * apart;
            wide re[FFT_LANES], im[FFT_LANES];
            load_transposed(rows, apart, re);
            load_transposed(rows + FFT_LANES, apart, im);
            begin16(re, im, t[pass]);
        }
#pragma GCC unroll 4
        for (uint32_t q = 0; q < 4; q++) {
            pair point[PASSES][4];
            for (uint32_t pass = 0; pass < PASSES; pass++) {
                const pair in[4] = {t[pass][0][q], t[pass][1][q], t[pass][2][q], t[pass][3][q]};
                butterfly4(in, point[pass]);
            }
#pragma GCC unroll 4
            for (uint32_t i = 0; i < 4; i++)
                put_fields(kind, out, b + (q + 4 * i) * m, (wide_fields){point[0][i], point[PASSES - 1][i]});
        }
    }
}

// Two transforms, of the pairs of fields at `first` and `second`; `ahead`: packing.
static void begin_transforms(const cascade_tables *tables, const sea_cascade *cascade, const float *first,
                             const float *second, ptrdiff_t ahead, const row_scratch *r) {
    const uint32_t m = tables->rows.n;
    const packing one = {first, ahead, cascade->strips, m}, other = {second, ahead, cascade->strips, m};
    transform_rows(&tables->rows, tables->turns, &one, r->spectrum, r->turned);
    transform_rows(&tables->rows, tables->turns, &other, r->spectrum, r->turned + (size_t)m * FFT_ROW);
}

// ---- what readers want ----------------------------------------------------------------------------------------------

// A row that bypasses the cache is made in scratch memory and copied: lines are streamed whole and one after the other,
// whatever order a transform has.
static void stream_row(void *to, const void *from, size_t bytes) {
    for (size_t at = 0; at < bytes / sizeof(float); at += WIDE)
        wide_stream((float *)to + at, wide_load((const float *)from + at));
}

// What is left of the foam of the last tick, or the present pinch where it is more. Both are bounded, so that a memory
// ends (sea.h).
static inline wide foam_of(wide tick, const sea_moment *moment, wide dxx, wide dyy) {
    const wide present = (dxx + dyy) * -moment->choppiness, none = present - present;
    const wide past = tick * moment->at.keep - moment->at.lose;
    return wide_max(wide_max(past, wide_min(present, none + SEA_MOST_FOAM)), none);
}

static inline wide load_unaligned(const float *p) {
    wide v;
    memcpy(&v, p, sizeof v);
    return v;
}

// How far the foam memory has drifted along an axis: samples, and the part of one.
typedef struct drifted {
    uint32_t samples;
    float part;
} drifted;

static drifted drifted_of(uint32_t drift, uint32_t n) {
    const uint64_t samples = (uint64_t)drift * n;
    return (drifted){(uint32_t)(samples >> 32), (float)(uint32_t)samples * 0x1p-32f};
}

// The foam of the last tick that now lies along row y, in two copies side by side, along which it still has to drift.
static void drift_row(const float *tick, drifted by, uint32_t n, uint32_t y, float *out) {
    const float *low = tick + (size_t)((y - by.samples - 1) & (n - 1)) * n;
    const float *high = tick + (size_t)((y - by.samples) & (n - 1)) * n;
    for (uint32_t x = 0; x < n; x += WIDE) {
        const wide mixed = wide_load(low + x) * by.part + wide_load(high + x) * (1.0f - by.part);
        wide_store(out + x, mixed);
        wide_store(out + n + x, mixed);
    }
}

// scratch: two rows.
static void store_foam(const sea_planes *planes, const sea_moment *moment, uint32_t n, uint32_t y, const float *dxx,
                       const float *dyy, float *scratch) {
    const size_t row = (size_t)y * n;
    const drifted along = drifted_of(moment->drift[0], n);
    drift_row(planes->foam_tick, drifted_of(moment->drift[1], n), n, y, scratch);
    const float *high = scratch + n - along.samples;
    for (uint32_t x = 0; x < n; x += WIDE) {
        const wide tick = load_unaligned(high + x - 1) * along.part + load_unaligned(high + x) * (1.0f - along.part);
        const wide foam = foam_of(tick, moment, wide_load(dxx + x), wide_load(dyy + x));
        wide_store(planes->foam + row + x, foam);
        wide_half_store(planes->foam_half + row + x, foam);
    }
}

// Row y of the displacement: behind it the first texels again, and behind the last row the first ones.
static void displacement_row(const sea_planes *planes, bool stream, uint32_t n, uint32_t m, uint32_t y,
                             const row_scratch *r) {
    const size_t pitch = n + BOLAN_CASCADE_GUARD, bytes = pitch * sizeof(bolan_sea_texel);
    float *row = &planes->displacement[y * pitch].dx;
    uint16_t *half = planes->displacement_half + 4 * (size_t)y * n;
    const row_out out = {.texels = stream ? r->row : row, .half = stream ? r->half : half};
    transform_lanes(r->turned, m, ROW_DISPLACEMENT, &out);
    memcpy(out.texels + 4 * (size_t)n, out.texels, BOLAN_CASCADE_GUARD * sizeof(bolan_sea_texel));
    if (y < BOLAN_CASCADE_GUARD) memcpy(row + 4 * n * pitch, out.texels, bytes);
    if (!stream) return;
    stream_row(row, out.texels, bytes);
    stream_row(half, out.half, 4 * (size_t)n * sizeof *half);
}

static row_out planes_of(const row_scratch *r, uint32_t n) {
    return (row_out){.half = r->half, .plane = {r->row, r->row + n, r->row + 2 * (size_t)n, r->row + 3 * (size_t)n}};
}

static void slopes_row(const sea_planes *planes, const sea_moment *moment, uint32_t n, uint32_t m, uint32_t y,
                       const row_scratch *r) {
    const size_t at = (size_t)y * n;
    row_out out = planes_of(r, n);
    if (!moment->stream) {
        out.half = planes->slope_half + 4 * at;
        for (uint32_t f = 0; f < SEA_HALF; f++) out.plane[f] = planes->slope[f] + at;
    }
    transform_lanes(r->turned, m, ROW_SLOPES, &out);
    store_foam(planes, moment, n, y, out.plane[SEA_DIVERGENCE], out.plane[SEA_DIVERGENCE + 1], r->spectrum);
    if (!moment->stream) return;
    for (uint32_t f = 0; f < SEA_HALF; f++) stream_row(planes->slope[f] + at, out.plane[f], n * sizeof(float));
    stream_row(planes->slope_half + 4 * at, out.half, 4 * (size_t)n * sizeof(uint16_t));
}

// A tick: div D alone, of two rows, and the foam memory.
static void tick_rows(const sea_planes *planes, const sea_moment *moment, uint32_t n, uint32_t m, uint32_t y,
                      const row_scratch *r) {
    const row_out out = planes_of(r, n);
    transform_lanes(r->turned, m, ROW_TICK, &out);
    for (uint32_t row = 0; row < 2; row++)
        for (uint32_t x = 0; x < n; x += WIDE) {
            float *tick = planes->foam_tick + (size_t)(y + row) * n + x;
            const wide dxx = wide_load(out.plane[2 * row] + x), dyy = wide_load(out.plane[2 * row + 1] + x);
            wide_store(tick, foam_of(wide_load(tick), moment, dxx, dyy));
        }
}

void KERNEL(bolan_sea_rows)(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                            const sea_moment *moment, sea_half half, uint32_t block, float *scratch) {
    const uint32_t n = cascade->n, m = tables->rows.n, step = moment->at.tick ? 2 : 1, end = (block + 1) * SEA_ROWS;
    const row_scratch r = row_scratch_of(n, scratch);
    const ptrdiff_t row = (ptrdiff_t)step * FFT_ROW, whole = (ptrdiff_t)cascade->strips * SEA_CELL;
    const float *piece = planes->middle + (ptrdiff_t)block * whole;
    for (uint32_t y = block * SEA_ROWS; y < end; y += step, piece += row) {
        const float *first = moment->at.tick ? piece + SEA_DIVERGENCE * SEA_PIECE : piece;
        const float *second = moment->at.tick ? first + FFT_ROW : piece + 2 * SEA_PIECE;
        const ptrdiff_t ahead = y + step < end ? row : whole - (SEA_ROWS - (ptrdiff_t)step) * FFT_ROW;
        begin_transforms(tables, cascade, first, second, ahead, &r);
        if (moment->at.tick) {
            tick_rows(planes, moment, n, m, y, &r);
        } else if (half == SEA_SLOPES) {
            slopes_row(planes, moment, n, m, y, &r);
        } else {
            displacement_row(planes, moment->stream, n, m, y, &r);
        }
    }
    wide_stream_end();
}
