// SPDX-License-Identifier: MIT
// Cubic B-splines through texels of 16 floats, compiled once per instruction set. The loops run over the floats of a
// texel, each by itself, so that all sets give the same bits.
#include "flow/tables.h"

#define SPLINE_JOIN2(a, b) a##_##b
#define SPLINE_JOIN(a, b) SPLINE_JOIN2(a, b)
#define KERNEL(name) SPLINE_JOIN(name, BOLAN_KERNEL_SUFFIX)

enum { TAPS = 4 };

void KERNEL(bolan_flow_values)(const float *texels, uint32_t n, double u, double v, float value[FLOW_TEXEL],
                               float along_u[FLOW_TEXEL], float along_v[FLOW_TEXEL]);
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

void KERNEL(bolan_flow_values)(const float *texels, uint32_t n, double u, double v, float value[FLOW_TEXEL],
                               float along_u[FLOW_TEXEL], float along_v[FLOW_TEXEL]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    float sum[FLOW_TEXEL] = {0}, sum_u[FLOW_TEXEL] = {0}, sum_v[FLOW_TEXEL] = {0};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        float here[FLOW_TEXEL] = {0}, here_u[FLOW_TEXEL] = {0};
        for (int i = 0; i < TAPS; i++) {
            const float *texel = row + (size_t)x.at[i] * FLOW_TEXEL;
            for (int c = 0; c < FLOW_TEXEL; c++) {
                here[c] += x.value[i] * texel[c];
                here_u[c] += x.slope[i] * texel[c];
            }
        }
        for (int c = 0; c < FLOW_TEXEL; c++) {
            sum[c] += y.value[j] * here[c];
            sum_u[c] += y.value[j] * here_u[c];
            sum_v[c] += y.slope[j] * here[c];
        }
    }
    for (int c = 0; c < FLOW_TEXEL; c++) {
        value[c] = sum[c];
        along_u[c] = sum_u[c];
        along_v[c] = sum_v[c];
    }
}

void KERNEL(bolan_flow_bends)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    float sum[6][FLOW_BENT] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        float here[FLOW_BENT] = {0}, here_u[FLOW_BENT] = {0}, here_uu[FLOW_BENT] = {0};
        for (int i = 0; i < TAPS; i++) {
            const float *texel = row + (size_t)x.at[i] * FLOW_TEXEL;
            for (int c = 0; c < FLOW_BENT; c++) {
                here[c] += x.value[i] * texel[c];
                here_u[c] += x.slope[i] * texel[c];
                here_uu[c] += x.bend[i] * texel[c];
            }
        }
        for (int c = 0; c < FLOW_BENT; c++) {
            sum[0][c] += y.value[j] * here[c];
            sum[1][c] += y.value[j] * here_u[c];
            sum[2][c] += y.slope[j] * here[c];
            sum[3][c] += y.value[j] * here_uu[c];
            sum[4][c] += y.slope[j] * here_u[c];
            sum[5][c] += y.bend[j] * here[c];
        }
    }
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < FLOW_BENT; c++) out[i][c] = sum[i][c];
}
