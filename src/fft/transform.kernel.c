// SPDX-License-Identifier: MIT
#include "fft/strip.h"
#include "fft/transform.h"

fft_strip_fn KERNEL(fft_strip);

void KERNEL(fft_strip)(const fft_plan *plan, float *rows) {
    fft_strip_of(plan, rows, NULL, rows);
}
