// SPDX-License-Identifier: MIT
#include "fft/transform.h"
#include "fft/strip.h"

fft_strip_fn KERNEL(bolan_fft_strip);

void KERNEL(bolan_fft_strip)(const fft_plan *plan, float *rows) { fft_stages(plan, 0, plan->stages, rows); }
