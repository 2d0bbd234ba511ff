// SPDX-License-Identifier: MIT
// The kernels of a step, one table row per instruction set. All sets give the same bits.
#ifndef BOLAN_WAVES_SYNTH_H
#define BOLAN_WAVES_SYNTH_H

#include "waves/sea.h"

// What all strips of a step share.
typedef struct sea_moment {
    double time;      // [s], reduced by the loop period
    float decay;      // factor on the foam memory; 0 restarts it
    float choppiness;
} sea_moment;

typedef struct sea_kernels {
    // Modes of strip `strip` at the time -> `middle`. `scratch`: 3 n rows.
    void (*rows)(const fft_plan *plan, const sea_cascade *cascade, const sea_moment *moment, uint32_t strip, float *scratch);
    // `middle` -> fields for x in strip `strip`. `scratch`: 2 n rows.
    void (*columns)(const fft_plan *plan, const sea_cascade *cascade, const sea_moment *moment, uint32_t strip,
                    float *scratch);
} sea_kernels;

enum { SEA_SCRATCH_ROWS = 3 };

const sea_kernels *sea_kernels_for(bolan_cpu cpu);

#endif
