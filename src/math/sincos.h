// SPDX-License-Identifier: MIT
// Sine and cosine with the same bits everywhere: only +, -, * and integer operations on IEEE numbers, each rounded
// once. No libm, whose results differ between systems; no fused multiply-add (-ffp-contract=off). The functions are
// branch-free and inline, so that a loop over lanes is vectorised and kernels of all instruction sets give the same
// bits.
//
// x is reduced to r = x - n pi/2 with |r| <= pi/4, pi/2 being split in three parts (Cody & Waite 1980, Software Manual
// for the Elementary Functions, ch. 8) whose first two have few enough bits that n times them is exact. Then
// sin r = r + r^3 P(r^2) and cos r = 1 - r^2/2 + r^4 Q(r^2), P and Q minimax for the absolute error of the result
// (Remez).
#ifndef BOLAN_MATH_SINCOS_H
#define BOLAN_MATH_SINCOS_H

#include <stdint.h>

// Adding and taking away 1.5 * 2^(mantissa bits) rounds to the nearest integer, exactly, on every instruction set.
#define BOLAN_ROUND_MAGIC_F 12582912.0f
#define BOLAN_ROUND_MAGIC 6755399441055744.0

/// Sine and cosine of the reduced |r| <= pi/4 with z = r r. They are expressions, so that vector types can use them.
#define BOLAN_SINF_REDUCED(r, z) /* |error| 1.8e-9 */ \
    ((r) + (r) * (z) * ((-0x1.98d6b8p-13f * (z) + 0x1.1105a8p-7f) * (z) + -0x1.555554p-3f))
#define BOLAN_COSF_REDUCED(z) /* |error| 9.6e-11 */ \
    ((1.0f - 0.5f * (z)) + (z) * (z) * ((0x1.99ff42p-16f * (z) + -0x1.6c0c82p-10f) * (z) + 0x1.55554ap-5f))

/// |x| <= 8192 (n < 2^13, and the first two parts have 11 bits: 13 + 11 = 24, a float's mantissa).
static inline void bolan_sincosf_inline(float x, float *sine, float *cosine) {
    const float n = (x * 0x1.45f306p-1f + BOLAN_ROUND_MAGIC_F) - BOLAN_ROUND_MAGIC_F;
    const float r = ((x - n * 0x1.92p+0f) - n * 0x1.fb4p-12f) - n * 0x1.4442d2p-24f;
    const float z = r * r;
    const float s = BOLAN_SINF_REDUCED(r, z);
    const float c = BOLAN_COSF_REDUCED(z);
    const int32_t quadrant = (int32_t)n;
    const float a = quadrant & 1 ? c : s;
    const float b = quadrant & 1 ? s : c;
    *sine = quadrant & 2 ? -a : a;
    *cosine = (quadrant + 1) & 2 ? -b : b;
}

/// |x| < 1e6 (n < 2^20, and the first two parts have 33 bits: 20 + 33 = 53, a double's mantissa).
static inline void bolan_sincos_inline(double x, double *sine, double *cosine) {
    const double n = (x * 0x1.45f306dc9c883p-1 + BOLAN_ROUND_MAGIC) - BOLAN_ROUND_MAGIC;
    const double r = ((x - n * 0x1.921fb544p+0) - n * 0x1.0b4611a6p-34) - n * 0x1.3198a2e037073p-69;
    const double z = r * r;
    double p = 0x1.5d62e094a5029p-33; // |error| 1.6e-18
    p = p * z + -0x1.ae5dadb278448p-26;
    p = p * z + 0x1.71de346c6039bp-19;
    p = p * z + -0x1.a01a019aa99e8p-13;
    p = p * z + 0x1.111111110eabdp-7;
    p = p * z + -0x1.555555555553dp-3;
    double q = -0x1.8facd141474cfp-37; // |error| 4.7e-20
    q = q * z + 0x1.1ee9e89098018p-29;
    q = q * z + -0x1.27e4f80533a75p-22;
    q = q * z + 0x1.a01a019cab744p-16;
    q = q * z + -0x1.6c16c16c15140p-10;
    q = q * z + 0x1.555555555554cp-5;
    const double s = r + r * z * p;
    const double c = (1.0 - 0.5 * z) + z * z * q;
    const int32_t quadrant = (int32_t)n;
    const double a = quadrant & 1 ? c : s;
    const double b = quadrant & 1 ? s : c;
    *sine = quadrant & 2 ? -a : a;
    *cosine = (quadrant + 1) & 2 ? -b : b;
}

#endif
