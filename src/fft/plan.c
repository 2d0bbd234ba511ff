// SPDX-License-Identifier: MIT
#include "fft/plan.h"

#include "bolan/math.h"

#include <string.h>

// Radix 8 first, which leaves out the zeros in the middle of a band-limited spectrum (strip.h); then 4 until the rest
// is a power of 8.
static void choose_radices(fft_plan *plan) {
    uint32_t bits = 0;
    while ((1u << bits) < plan->n) bits++;
    while (bits > 0) {
        const uint32_t step = bits % 3 == 0 || (plan->stages == 0 && bits > 3) ? 3 : bits == 1 ? 1 : 2;
        plan->radix[plan->stages++] = 1u << step;
        bits -= step;
    }
}

static void fill_stage(float *out, uint32_t m, uint32_t r) {
    for (uint32_t j = 0; j < m / r; j++) {
        for (uint32_t q = 1; q < r; q++) {
            double s, c;
            bolan_sincos(2.0 * BOLAN_PI * (double)(j * q % m) / (double)m, &s, &c);
            *out++ = (float)c;
            *out++ = (float)s;
        }
    }
}

// Position of output y: its least significant digit chooses the block of the first stage, and so on.
static uint32_t reversed(const fft_plan *plan, uint32_t y) {
    uint32_t row = 0, m = plan->n;
    for (uint32_t s = 0; s < plan->stages; s++) {
        const uint32_t r = plan->radix[s];
        m /= r;
        row += y % r * m;
        y /= r;
    }
    return row;
}

// 2 (r - 1) m / r < 2 m floats for each stage, and the blocks shrink at least fourfold before the last one.
size_t bolan_fft_plan_bytes(uint32_t n) { return 4 * (size_t)n * sizeof(float); }

bool bolan_fft_plan_create(uint32_t n, fft_plan *plan) {
    memset(plan, 0, sizeof *plan);
    plan->n = n;
    choose_radices(plan);
    plan->bytes = bolan_fft_plan_bytes(n);
    plan->memory = bolan_allocate(plan->bytes);
    if (!plan->memory) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for the tables of an FFT of %u points", n);
        return false;
    }
    float *next = plan->memory;
    uint32_t m = n;
    for (uint32_t s = 0; s + 1 < plan->stages; s++) {
        const uint32_t r = plan->radix[s];
        plan->twiddle[s] = next;
        fill_stage(next, m, r);
        next += 2 * (r - 1) * (m / r);
        m /= r;
    }
    for (uint32_t y = 0; y < n; y++) plan->order[y] = (uint16_t)reversed(plan, y);
    return true;
}

void bolan_fft_plan_destroy(fft_plan *plan) {
    bolan_release(plan->memory, plan->bytes);
    memset(plan, 0, sizeof *plan);
}
