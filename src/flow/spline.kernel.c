// SPDX-License-Identifier: MIT
// Cubic B-splines through texels of 16 floats, compiled once per instruction set. A texel is two vectors of
// 8 floats, by GCC's vector extension; an operation is that operation on each float, so all sets give the same bits.
#include "flow/tables.h"

#define SPLINE_JOIN2(a, b) a##_##b
#define SPLINE_JOIN(a, b) SPLINE_JOIN2(a, b)
#define KERNEL(name) SPLINE_JOIN(name, BOLAN_KERNEL_SUFFIX)

enum { TAPS = 4 };
_Static_assert(FLOW_BENT == 8 && FLOW_TEXEL == 16, "a texel is two vectors");
typedef float eight __attribute__((vector_size(32), aligned(4), may_alias));

void KERNEL(bolan_flow_whole)(const float *texels, uint32_t n, double u, double v, float bend[6][FLOW_BENT],
                              float rest[3][FLOW_BENT]);
void KERNEL(bolan_flow_bends)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]);

// The taps along one axis: indices, and the weights of value, first and second derivative by cells.
typedef struct taps {
    uint32_t at[TAPS];
    float value[TAPS], slope[TAPS], bend[TAPS];
} taps;

static inline taps taps_of(double x, uint32_t n) {
    const double cell = floor(x);
    const float f = (float)(x - cell), g = 1.0f - f;
    const uint32_t i = (uint32_t)(int32_t)cell + n - 1;
    taps t = {{i & (n - 1), (i + 1) & (n - 1), (i + 2) & (n - 1), (i + 3) & (n - 1)},
              {g * g * g * (1.0f / 6), (4.0f - 3.0f * f * f * (2.0f - f)) * (1.0f / 6),
               (4.0f - 3.0f * g * g * (2.0f - g)) * (1.0f / 6), f * f * f * (1.0f / 6)},
              {-0.5f * g * g, f * (1.5f * f - 2.0f), -g * (1.5f * g - 2.0f), 0.5f * f * f},
              {g, 3.0f * f - 2.0f, 3.0f * g - 2.0f, f}};
    return t;
}

void KERNEL(bolan_flow_whole)(const float *texels, uint32_t n, double u, double v, float bend[6][FLOW_BENT],
                              float rest[3][FLOW_BENT]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    eight sum[6] = {{0}}, other[3] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        eight here = {0}, here_u = {0}, here_uu = {0}, there = {0}, there_u = {0};
        for (int i = 0; i < TAPS; i++) {
            const eight *texel = (const eight *)(const void *)(row + (size_t)x.at[i] * FLOW_TEXEL);
            here += x.value[i] * texel[0];
            here_u += x.slope[i] * texel[0];
            here_uu += x.bend[i] * texel[0];
            there += x.value[i] * texel[1];
            there_u += x.slope[i] * texel[1];
        }
        sum[0] += y.value[j] * here;
        sum[1] += y.value[j] * here_u;
        sum[2] += y.slope[j] * here;
        sum[3] += y.value[j] * here_uu;
        sum[4] += y.slope[j] * here_u;
        sum[5] += y.bend[j] * here;
        other[0] += y.value[j] * there;
        other[1] += y.value[j] * there_u;
        other[2] += y.slope[j] * there;
    }
    for (int i = 0; i < 6; i++) *(eight *)(void *)bend[i] = sum[i];
    for (int i = 0; i < 3; i++) *(eight *)(void *)rest[i] = other[i];
}

void KERNEL(bolan_flow_bends)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    eight sum[6] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        eight here = {0}, here_u = {0}, here_uu = {0};
        for (int i = 0; i < TAPS; i++) {
            const eight texel = *(const eight *)(const void *)(row + (size_t)x.at[i] * FLOW_TEXEL);
            here += x.value[i] * texel;
            here_u += x.slope[i] * texel;
            here_uu += x.bend[i] * texel;
        }
        sum[0] += y.value[j] * here;
        sum[1] += y.value[j] * here_u;
        sum[2] += y.slope[j] * here;
        sum[3] += y.value[j] * here_uu;
        sum[4] += y.slope[j] * here_u;
        sum[5] += y.bend[j] * here;
    }
    for (int i = 0; i < 6; i++) *(eight *)(void *)out[i] = sum[i];
}
