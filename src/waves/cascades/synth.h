// SPDX-License-Identifier: MIT
// The kernels of a step, one table row per instruction set. All sets give the same bits.
#ifndef BOLAN_WAVES_SYNTH_H
#define BOLAN_WAVES_SYNTH_H

#include "waves/cascades/cascades.h"

// The parameters that all strips of a step share.
typedef struct sea_moment {
    sea_instant at;
    float choppiness;
    uint32_t drift[2]; // of foam, in the cascade: bolan_sea_foam_drift()
    bool stream; // the outputs bypass the cache: each line would be read before it is written, and put out unread
    bool alone;  // the slopes are asked for without the displacement, which would have made the modes at the time
} sea_moment;

typedef struct sea_kernels {
    // Modes of strip `strip` of i at the time -> `middle`, the fields of `half`.
    void (*columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                    const sea_moment *moment, sea_half half, uint32_t strip, float *scratch);
    // `middle` -> SEA_ROWS rows of the fields of `half`, from y = SEA_ROWS `block` on.
    void (*rows)(const cascade_tables *tables, const sea_cascade *cascade, const sea_planes *planes,
                 const sea_moment *moment, sea_half half, uint32_t block, float *scratch);
} sea_kernels;

// Scratch memory of a worker [floats]: n rows for the first pass; the second uses 10 n, and 1008 more.
static inline size_t sea_scratch_floats(uint32_t n) { return (size_t)n * FFT_ROW + 2 * FFT_LANES * FFT_ROW; }

// The kernels of a sea made with `cpu`, of n samples a side: a narrower set where vectors are too wide for so few.
const sea_kernels *bolan_sea_kernels_for(bolan_cpu cpu, uint32_t n);

#endif
