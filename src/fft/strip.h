// SPDX-License-Identifier: MIT
// An FFT over the rows of a strip: 16 transforms side by side, one a lane, so that no stage shuffles lanes and the
// order of every sum is the same for all instruction sets. Included by kernels only; plan.h explains the algorithm.
//
//     row k of a strip:  | re 0 .. 15 | im 0 .. 15 |   128 bytes, the next row follows
//
// Rows are contiguous, so the power-of-two strides of a stage stay inside one strip, which fits the first-level cache
// up to n = 256.
#ifndef BOLAN_FFT_STRIP_H
#define BOLAN_FFT_STRIP_H

#include "fft/plan.h"
#include "fft/wide.h"

typedef struct pair {
    wide re, im;
} pair; // complex lanes

static inline pair pair_add(pair a, pair b) { return (pair){a.re + b.re, a.im + b.im}; }
static inline pair pair_sub(pair a, pair b) { return (pair){a.re - b.re, a.im - b.im}; }
static inline pair pair_i(pair a) { return (pair){-a.im, a.re}; }
static inline pair pair_turn(pair a, const float *w) {
    return (pair){a.re * w[0] - a.im * w[1], a.re * w[1] + a.im * w[0]};
}
static inline pair pair_scale(pair a, float f) { return (pair){a.re * f, a.im * f}; }
static inline pair pair_load(const float *row) { return (pair){wide_load(row), wide_load(row + FFT_LANES)}; }
static inline void pair_store(float *row, pair a) {
    wide_store(row, a.re);
    wide_store(row + FFT_LANES, a.im);
}

// out[q] = sum_p a[p] i^{pq}
static inline void butterfly4(const pair a[4], pair out[4]) {
    const pair s02 = pair_add(a[0], a[2]), d02 = pair_sub(a[0], a[2]);
    const pair s13 = pair_add(a[1], a[3]), d13 = pair_i(pair_sub(a[1], a[3]));
    out[0] = pair_add(s02, s13);
    out[1] = pair_add(d02, d13);
    out[2] = pair_sub(s02, s13);
    out[3] = pair_sub(d02, d13);
}

// out[q] = sum_p a[p] e^{2 pi i pq / 8}
static inline void butterfly8(const pair a[8], pair out[8]) {
    const float h = 0.70710678118654752f;
    const pair even_in[4] = {a[0], a[2], a[4], a[6]}, odd_in[4] = {a[1], a[3], a[5], a[7]};
    pair e[4], o[4];
    butterfly4(even_in, e);
    butterfly4(odd_in, o);
    const pair o1 = {(o[1].re - o[1].im) * h, (o[1].re + o[1].im) * h};
    const pair o2 = pair_i(o[2]);
    const pair o3 = {-((o[3].re + o[3].im) * h), (o[3].re - o[3].im) * h};
    out[0] = pair_add(e[0], o[0]);
    out[1] = pair_add(e[1], o1);
    out[2] = pair_add(e[2], o2);
    out[3] = pair_add(e[3], o3);
    out[4] = pair_sub(e[0], o[0]);
    out[5] = pair_sub(e[1], o1);
    out[6] = pair_sub(e[2], o2);
    out[7] = pair_sub(e[3], o3);
}

// One stage of radix r over all blocks of m rows, from `in` to `rows` (which may be the same). `w` is NULL for the last
// stage (m == r). With `factor`, row i of the input counts factor[i] times.
#define FFT_STAGE(r)                                                                                              \
    static inline __attribute__((always_inline)) void stage##r(const float *in, const float *factor, float *rows, \
                                                               uint32_t n, uint32_t m, const float *w) {          \
        const uint32_t q = m / r;                                                                                 \
        for (uint32_t block = 0; block < n; block += m) {                                                         \
            for (uint32_t j = 0; j < q; j++) {                                                                    \
                for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                         \
                    const size_t at = (size_t)(block + j) * FFT_ROW + lane;                                       \
                    pair a[r], b[r];                                                                              \
                    for (uint32_t i = 0; i < r; i++) {                                                            \
                        a[i] = pair_load(in + at + (size_t)i * q * FFT_ROW);                                      \
                        if (factor) a[i] = pair_scale(a[i], factor[block + j + i * q]);                           \
                    }                                                                                             \
                    butterfly##r(a, b);                                                                           \
                    pair_store(rows + at, b[0]);                                                                  \
                    for (uint32_t i = 1; i < r; i++) {                                                            \
                        const pair t = w ? pair_turn(b[i], w + 2 * ((size_t)j * (r - 1) + i - 1)) : b[i];         \
                        pair_store(rows + at + (size_t)i * q * FFT_ROW, t);                                       \
                    }                                                                                             \
                }                                                                                                 \
            }                                                                                                     \
        }                                                                                                         \
    }
FFT_STAGE(4)
FFT_STAGE(8)
#undef FFT_STAGE

static inline void stage_turned(const fft_plan *plan, uint32_t s, uint32_t m, float *rows) {
    if (plan->radix[s] == 4) {
        stage4(rows, NULL, rows, plan->n, m, plan->twiddle[s]);
    } else {
        stage8(rows, NULL, rows, plan->n, m, plan->twiddle[s]);
    }
}

static inline void stage_first(const fft_plan *plan, const float *in, const float *factor, float *rows) {
    if (plan->radix[0] == 4) {
        stage4(in, factor, rows, plan->n, plan->n, plan->twiddle[0]);
    } else {
        stage8(in, factor, rows, plan->n, plan->n, plan->twiddle[0]);
    }
}

// The stages after the first, the last one too if `to_end`.
static inline void fft_strip_rest(const fft_plan *plan, float *rows, bool to_end) {
    uint32_t m = plan->n / plan->radix[0];
    for (uint32_t s = 1; s + 1 < plan->stages; s++) {
        stage_turned(plan, s, m, rows);
        m /= plan->radix[s];
    }
    if (to_end) stage8(rows, NULL, rows, plan->n, 8, NULL);
}

// Transforms `in` to `rows`, which may be the same; row i counts factor[i] times, once where `factor` is NULL.
static inline void fft_strip_of(const fft_plan *plan, const float *in, const float *factor, float *rows) {
    if (factor) {
        stage_first(plan, in, factor, rows);
    } else {
        stage_first(plan, in, NULL, rows);
    }
    fft_strip_rest(plan, rows, true);
}

#endif
