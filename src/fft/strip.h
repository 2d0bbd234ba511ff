// SPDX-License-Identifier: MIT
// An FFT over the rows of a strip: 16 transforms side by side, one a lane, so that no stage shuffles lanes and the
// order of every sum is the same for all instruction sets. Included by kernels only; plan.h explains the algorithm.
//
//     row k of a strip:  | re 0 .. 15 | im 0 .. 15 |   128 bytes, the next row follows
//
// Rows are contiguous, so the power-of-two strides of a stage stay inside one strip, which fits the first-level cache
// up to n = 256.
//
// A spectrum that ends at three quarters of the Nyquist wave number has zeros in the middle quarter of its rows, which
// are two of the eight inputs of a first stage of radix 8: butterfly8_open() leaves them out.
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

// out[q] = a[0] + (-1)^q a[1]
static inline void butterfly2(const pair a[2], pair out[2]) {
    out[0] = pair_add(a[0], a[1]);
    out[1] = pair_sub(a[0], a[1]);
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

#define FFT_HALF_ROOT 0.70710678118654752f // sqrt(1/2)

// a e^{2 pi i / 8} and a e^{2 pi i 3 / 8}
static inline pair pair_eighth(pair a) { return (pair){(a.re - a.im) * FFT_HALF_ROOT, (a.re + a.im) * FFT_HALF_ROOT}; }
static inline pair pair_three_eighths(pair a) {
    return (pair){-((a.re + a.im) * FFT_HALF_ROOT), (a.re - a.im) * FFT_HALF_ROOT};
}

// The eight outputs from the transforms of the even and of the odd inputs.
static inline void join8(const pair e[4], const pair o[4], pair out[8]) {
    const pair o1 = pair_eighth(o[1]), o2 = pair_i(o[2]), o3 = pair_three_eighths(o[3]);
    out[0] = pair_add(e[0], o[0]);
    out[1] = pair_add(e[1], o1);
    out[2] = pair_add(e[2], o2);
    out[3] = pair_add(e[3], o3);
    out[4] = pair_sub(e[0], o[0]);
    out[5] = pair_sub(e[1], o1);
    out[6] = pair_sub(e[2], o2);
    out[7] = pair_sub(e[3], o3);
}

// out[q] = sum_p a[p] e^{2 pi i pq / 8}
static inline void butterfly8(const pair a[8], pair out[8]) {
    const pair even_in[4] = {a[0], a[2], a[4], a[6]}, odd_in[4] = {a[1], a[3], a[5], a[7]};
    pair e[4], o[4];
    butterfly4(even_in, e);
    butterfly4(odd_in, o);
    join8(e, o, out);
}

// The same where a[3] and a[4] are zero; they are not read.
static inline void butterfly8_open(const pair a[8], pair out[8]) {
    const pair s26 = pair_add(a[2], a[6]), d26 = pair_i(pair_sub(a[2], a[6]));
    const pair s15 = pair_add(a[1], a[5]), d15 = pair_sub(a[1], a[5]), i7 = pair_i(a[7]);
    const pair e[4] = {pair_add(a[0], s26), pair_add(a[0], d26), pair_sub(a[0], s26), pair_sub(a[0], d26)};
    const pair o[4] = {pair_add(s15, a[7]), pair_sub(d15, i7), pair_sub(s15, a[7]), pair_add(d15, i7)};
    join8(e, o, out);
}

// The same where only a[0], a[1], a[6] and a[7] are not zero.
static inline void butterfly8_four(const pair a[8], pair out[8]) {
    const pair i6 = pair_i(a[6]), i7 = pair_i(a[7]);
    const pair e[4] = {pair_add(a[0], a[6]), pair_sub(a[0], i6), pair_sub(a[0], a[6]), pair_add(a[0], i6)};
    const pair o[4] = {pair_add(a[1], a[7]), pair_sub(a[1], i7), pair_sub(a[1], a[7]), pair_add(a[1], i7)};
    join8(e, o, out);
}

// The same where only a[0] and a[7] are not zero.
static inline void butterfly8_two(const pair a[8], pair out[8]) {
    const pair i7 = pair_i(a[7]), back = {(a[7].re + a[7].im) * FFT_HALF_ROOT, (a[7].im - a[7].re) * FFT_HALF_ROOT};
    const pair forth = pair_i(back);
    out[0] = pair_add(a[0], a[7]);
    out[1] = pair_add(a[0], back);
    out[2] = pair_sub(a[0], i7);
    out[3] = pair_sub(a[0], forth);
    out[4] = pair_sub(a[0], a[7]);
    out[5] = pair_sub(a[0], back);
    out[6] = pair_add(a[0], i7);
    out[7] = pair_add(a[0], forth);
}

// X[q] = sum_p (re[p] + i im[p]) e^{2 pi i pq / 16} in two halves: four transforms of four with their turns to
// t[p % 4][q % 4], then butterfly4() of t[0 .. 3][q] gives X[q], X[q + 4], X[q + 8], X[q + 12].
static inline __attribute__((always_inline)) void begin16(const wide re[16], const wide im[16], pair t[4][4]) {
    static const float w1[2] = {0.92387953251128676f,
                                0.38268343236508977f}; // e^{2 pi i / 16}, its cube, its ninth power
    static const float w3[2] = {0.38268343236508977f, 0.92387953251128676f};
    static const float w9[2] = {-0.92387953251128676f, -0.38268343236508977f};
#pragma GCC unroll 4
    for (int p = 0; p < 4; p++) {
        const pair in[4] = {{re[p], im[p]}, {re[p + 4], im[p + 4]}, {re[p + 8], im[p + 8]}, {re[p + 12], im[p + 12]}};
        butterfly4(in, t[p]);
    }
    t[1][1] = pair_turn(t[1][1], w1);
    t[1][2] = pair_eighth(t[1][2]);
    t[1][3] = pair_turn(t[1][3], w3);
    t[2][1] = pair_eighth(t[2][1]);
    t[2][2] = pair_i(t[2][2]);
    t[2][3] = pair_three_eighths(t[2][3]);
    t[3][1] = pair_turn(t[3][1], w3);
    t[3][2] = pair_three_eighths(t[3][2]);
    t[3][3] = pair_turn(t[3][3], w9);
}

// A stage of radix r over all blocks of m of the n rows, in place. `w` is NULL for the last stage (m == r).
#define FFT_STAGE(name, r, butterfly)                                                                             \
    static inline __attribute__((always_inline)) void name(float *rows, uint32_t n, uint32_t m, const float *w) { \
        const uint32_t q = m / r;                                                                                 \
        for (uint32_t block = 0; block < n; block += m) {                                                         \
            for (uint32_t j = 0; j < q; j++) {                                                                    \
                for (uint32_t lane = 0; lane < FFT_LANES; lane += WIDE) {                                         \
                    float *at = rows + (size_t)(block + j) * FFT_ROW + lane;                                      \
                    pair a[r], b[r];                                                                              \
                    for (uint32_t i = 0; i < r; i++) a[i] = pair_load(at + (size_t)i * q * FFT_ROW);              \
                    butterfly(a, b);                                                                              \
                    pair_store(at, b[0]);                                                                         \
                    for (uint32_t i = 1; i < r; i++) {                                                            \
                        const pair t = w ? pair_turn(b[i], w + 2 * ((size_t)j * (r - 1) + i - 1)) : b[i];         \
                        pair_store(at + (size_t)i * q * FFT_ROW, t);                                              \
                    }                                                                                             \
                }                                                                                                 \
            }                                                                                                     \
        }                                                                                                         \
    }
FFT_STAGE(stage2, 2, butterfly2)
FFT_STAGE(stage4, 4, butterfly4)
FFT_STAGE(stage8, 8, butterfly8)
FFT_STAGE(stage8_open, 8, butterfly8_open)

static inline void fft_stage(const fft_plan *plan, uint32_t s, uint32_t m, float *rows) {
    switch (plan->radix[s]) {
    case 2: stage2(rows, plan->n, m, NULL); break; // a last stage always
    case 4: stage4(rows, plan->n, m, plan->twiddle[s]); break;
    default: stage8(rows, plan->n, m, plan->twiddle[s]); break;
    }
}

// Stages [first, last) of the plan.
static inline void fft_stages(const fft_plan *plan, uint32_t first, uint32_t last, float *rows) {
    uint32_t m = plan->n;
    for (uint32_t s = 0; s < last; s++) {
        if (s >= first) fft_stage(plan, s, m, rows);
        m /= plan->radix[s];
    }
}

#endif
