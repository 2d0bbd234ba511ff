// SPDX-License-Identifier: MIT
// The kernels of a step, one table row per instruction set. All sets give the same bits.
#ifndef BOLAN_WAVES_SYNTH_H
#define BOLAN_WAVES_SYNTH_H

#include "waves/cascades/cascades.h"

// The outputs that bypass the cache, because they are larger than the cache.
typedef enum sea_stream {
    SEA_STREAM_NONE,
    SEA_STREAM_PLANES, // the float planes, which are read sparsely; halfs are uploaded soon after
    SEA_STREAM_ALL,
} sea_stream;

// The parameters that all strips of a step share.
typedef struct sea_moment {
    sea_instant at;
    float choppiness;
    sea_stream stream;
} sea_moment;

typedef struct sea_kernels {
    // Modes of strip `strip` at the time -> `middle`.
    void (*rows)(const fft_plan *plan, const sea_cascade *cascade, float *middle, const sea_moment *moment,
                 uint32_t strip, float *scratch);
    // `middle` -> fields for x in strip `strip`.
    void (*columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_planes *planes,
                    const sea_moment *moment, uint32_t strip, float *scratch);
} sea_kernels;

// Scratch memory of a worker: three buffers of n rows, a few lines apart, so that the same row of two of them does
// not fall on one set of the cache.
enum { SEA_SCRATCH_BUFFERS = 3, SEA_SCRATCH_SHIFT = 9 * 16 };
static inline size_t sea_scratch_pitch(uint32_t n) {
    return (size_t)n * FFT_ROW + SEA_SCRATCH_SHIFT; // floats
}

const sea_kernels *bolan_sea_kernels_for(bolan_cpu cpu);

#endif
