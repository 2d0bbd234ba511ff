// SPDX-License-Identifier: MIT
// First pass of a step: modes at time t, and their transforms along i. cascades.h has the plan.
#include "fft/strip.h"
#include "waves/cascades/synth.h"

#include <string.h>

void KERNEL(bolan_sea_rows)(const fft_plan *plan, const sea_cascade *cascade, float *middle, const sea_moment *moment,
                            uint32_t strip, float *scratch);

// Sine and cosine of 2 pi x for |x| <= 1/2 turn. The quarter turn is taken off exactly; the polynomials are those of
// math/sincos.h, on |angle| <= pi/4.
static inline void sincos_turns(wide x, wide *sine, wide *cosine) {
    const float magic = 12582912.0f;
    const wide n = (x * 4.0f + magic) - magic;
    const wide r = (x - n * 0.25f) * 6.28318530717958648f;
    const wide z = r * r;
    const wide p = (-0x1.98d6b8p-13f * z + 0x1.1105a8p-7f) * z + -0x1.555554p-3f;
    const wide q = (0x1.99ff42p-16f * z + -0x1.6c0c82p-10f) * z + 0x1.55554ap-5f;
    const wide_int s = wide_bits(r + r * z * p);
    const wide_int c = wide_bits((1.0f - 0.5f * z) + z * z * q);
    const wide_int quadrant = wide_to_int(n);
    const wide_int odd = -(quadrant & 1); // all ones where sine and cosine change places
    // The second bit of the quadrant, spread and cut to the sign bit (a left shift into it is undefined).
    const wide_int sign_s = -((quadrant >> 1) & 1) & INT32_MIN, sign_c = -(((quadrant + 1) >> 1) & 1) & INT32_MIN;
    *sine = wide_from_bits(((odd & c) | (~odd & s)) ^ sign_s);
    *cosine = wide_from_bits(((odd & s) | (~odd & c)) ^ sign_c);
}

// Phases in turns, reduced to |x| <= 1/2 in double, so that they stay accurate after days.
static inline void reduce_turns(const double *turns, double time, float *out) {
    const double magic = 6755399441055744.0;
    for (int l = 0; l < FFT_LANES; l++) {
        const double y = turns[l] * time;
        out[l] = (float)(y - ((y + magic) - magic));
    }
}

// h(k, t) of one row of modes into `h`, and u = h coth(kh)/k into `u`.
static inline void evolve_row(const sea_cascade *cascade, size_t row, double time, float *h, float *u) {
    float phase[FFT_LANES] __attribute__((aligned(64)));
    reduce_turns(cascade->turns + row * FFT_LANES, time, phase);
    const float *a = cascade->amplitude + row * 4 * FFT_LANES;
    const float *inverse_k = cascade->inverse_k + row * FFT_LANES;
    for (int l = 0; l < FFT_LANES; l += WIDE) {
        wide s, c;
        sincos_turns(wide_load(phase + l), &s, &c);
        const wide re = wide_load(a + l) * c + wide_load(a + FFT_LANES + l) * s;
        const wide im = wide_load(a + 2 * FFT_LANES + l) * c + wide_load(a + 3 * FFT_LANES + l) * s;
        const wide g = wide_load(inverse_k + l);
        pair_store(h + l, (pair){re, im});
        pair_store(u + l, (pair){re * g, im * g});
    }
}

static void evolve(const sea_cascade *cascade, double time, uint32_t strip, float *h, float *u) {
    const uint32_t n = cascade->n, reach = cascade->reach[strip];
    for (uint32_t i = 0; i < n; i++) {
        const bool empty = i >= reach && i <= n - reach;
        if (empty) {
            memset(h + (size_t)i * FFT_ROW, 0, FFT_ROW * sizeof(float));
            memset(u + (size_t)i * FFT_ROW, 0, FFT_ROW * sizeof(float));
        } else {
            evolve_row(cascade, (size_t)strip * n + i, time, h + (size_t)i * FFT_ROW, u + (size_t)i * FFT_ROW);
        }
    }
}

// The transform in `rows` (lanes j) to `middle` (lanes x), part `part`.
static void transpose_out(const fft_plan *plan, const sea_cascade *cascade, float *middle, uint32_t strip,
                          uint32_t part, const float *rows) {
    const uint32_t n = plan->n, half = cascade->strips * FFT_LANES;
    for (uint32_t x = 0; x < n; x += WIDE) {
        for (uint32_t lane = 0; lane < FFT_ROW; lane += WIDE) {
            wide v[WIDE];
            for (uint32_t i = 0; i < WIDE; i++) v[i] = wide_load(rows + (size_t)plan->order[x + i] * FFT_ROW + lane);
            wide_transpose(v);
            const uint32_t imaginary = lane / FFT_LANES, j = strip * FFT_LANES + lane % FFT_LANES;
            float *out = middle + ((size_t)(x / FFT_LANES) * half + j) * SEA_CELL + (size_t)part * FFT_ROW +
                         (size_t)imaginary * FFT_LANES + x % FFT_LANES;
            for (uint32_t i = 0; i < WIDE; i++) wide_store(out + (size_t)i * SEA_CELL, v[i]);
        }
    }
}

void KERNEL(bolan_sea_rows)(const fft_plan *plan, const sea_cascade *cascade, float *middle, const sea_moment *moment,
                            uint32_t strip, float *scratch) {
    const size_t pitch = sea_scratch_pitch(plan->n);
    float *h = scratch, *u = scratch + pitch, *work = scratch + 2 * pitch;
    evolve(cascade, moment->at.shown, strip, h, u);
    for (uint32_t part = moment->at.tick ? SEA_PARTS - SEA_TICK_PARTS : 0; part < SEA_PARTS; part++) {
        const bool displaces = part == PART_U || part == PART_KU || part >= PART_LINEAR_U;
        fft_strip_of(plan, displaces ? u : h, cascade->part[part], work);
        transpose_out(plan, cascade, middle, strip, part, work);
    }
}
