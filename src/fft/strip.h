// SPDX-License-Identifier: MIT
// An FFT over the rows of a strip: 16 transforms side by side, one a lane, so that no stage shuffles lanes and the order
// of every sum is the same for all instruction sets. Included by kernels only; plan.h explains the algorithm.
//
//     row k of a strip:  | re 0 .. 15 | im 0 .. 15 |   128 bytes, the next row follows
//
// Rows are contiguous, so the power-of-two strides of a stage stay inside one strip, which fits the first-level cache up to
// n = 256.
#ifndef BOLAN_FFT_STRIP_H
#define BOLAN_FFT_STRIP_H

#include "fft/plan.h"
#include "fft/wide.h"

typedef struct pair { wide re, im; } pair; // complex lanes

static inline pair pair_add(pair a, pair b) { return (pair){a.re + b.re, a.im + b.im}; }
static inline pair pair_sub(pair a, pair b) { return (pair){a.re - b.re, a.im - b.im}; }
static inline pair pair_i(pair a) { return (pair){-a.im, a.re}; }
static inline pair pair_turn(pair a, const float *w) {
    return (pair){a.re * w[0] - a.im * w[1], a.re * w[1] + a.im * w[0]};
}
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

// One stage of radix r over all blocks of m rows, in place. `w` is NULL for the last stage (m == r).
#define FFT_STAGE(r)                                                                                                   \
    static inline void stage##r(float *rows, uint32_t n, uint32_t m, const float *w) {                                 \
        const uint32_t q = m / r;                                                                                      \
        for (uint32_t block = 0; block < n; block += m) {                                                              \
            for (uint32_t j = 0; j < q; j++) {                                                                         \
                for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                              \
                    float *p = rows + (size_t)(block + j) * FFT_ROW + lane;                                            \
                    pair a[r], b[r];                                                                                   \
                    for (uint32_t i = 0; i < r; i++) a[i] = pair_load(p + (size_t)i * q * FFT_ROW);                    \
                    butterfly##r(a, b);                                                                                \
                    pair_store(p, b[0]);                                                                               \
                    for (uint32_t i = 1; i < r; i++) {                                                                 \
                        const pair t = w ? pair_turn(b[i], w + 2 * ((size_t)j * (r - 1) + i - 1)) : b[i];              \
                        pair_store(p + (size_t)i * q * FFT_ROW, t);                                                    \
                    }                                                                                                  \
                }                                                                                                      \
            }                                                                                                          \
        }                                                                                                              \
    }
FFT_STAGE(4)
FFT_STAGE(8)
#undef FFT_STAGE

// All stages from `first` on.
static inline void fft_strip_from(const fft_plan *plan, uint32_t first, float *rows) {
    uint32_t m = plan->n;
    for (uint32_t s = 0; s < plan->stages; s++) {
        if (s >= first && plan->radix[s] == 4) stage4(rows, plan->n, m, plan->twiddle[s]);
        if (s >= first && plan->radix[s] == 8) stage8(rows, plan->n, m, plan->twiddle[s]);
        m /= plan->radix[s];
    }
}

#endif
