// SPDX-License-Identifier: MIT
// The FFT of one strip as a function, for tests and tools; the synthesis inlines it.
#ifndef BOLAN_FFT_TRANSFORM_H
#define BOLAN_FFT_TRANSFORM_H

#include "fft/plan.h"

typedef void fft_strip_fn(const fft_plan *plan, float *rows);

// Transforms 16 columns of n rows in place (strip.h). The kernel of `cpu`, or the widest where this machine lacks it.
fft_strip_fn *bolan_fft_strip_for(bolan_cpu cpu);

#endif
