// SPDX-License-Identifier: MIT
// The plan of an in-place inverse FFT of n = 2 .. 1024 points, by decimation in frequency with radices 8, 4 and 2.
//
//     X[y] = sum_k x[k] e^{+2 pi i k y / n},   not normalised
//
// A stage of radix r cuts each block of m rows into r blocks of m / r. Outputs come in digit-reversed order: X[y]
// stands in row order[y]. The step that transposes or unpacks the result reads it through `order`, so that no pass is
// spent on sorting. Source: Gentleman & Sande 1966.
#ifndef BOLAN_FFT_PLAN_H
#define BOLAN_FFT_PLAN_H

#include "bolan/base.h"

enum {
    FFT_MIN = 32,
    FFT_MAX = 1024,
    FFT_STAGES = 4,
    FFT_LANES = 16,          // transforms done side by side: a strip
    FFT_ROW = 2 * FFT_LANES, // floats in a row of a strip: 16 real parts, then 16 imaginary parts
};

typedef struct fft_plan {
    uint32_t n;
    uint32_t stages;
    uint32_t radix[FFT_STAGES];       // the first is 8 from n = 8 on
    const float *twiddle[FFT_STAGES]; // [m / r][r - 1][2]: e^{2 pi i j q / m} for q = 1 .. r - 1; none for the last
    uint16_t order[FFT_MAX];          // output y is in row order[y]
    float *memory;                    // of the twiddles
    size_t bytes;
} fft_plan;

// Memory of a plan [bytes], beside the struct itself.
size_t bolan_fft_plan_bytes(uint32_t n);
// `n` is a power of two in 2 .. 1024. False when memory is short (logged).
bool bolan_fft_plan_create(uint32_t n, fft_plan *plan);
void bolan_fft_plan_destroy(fft_plan *plan);

#endif
