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

void KERNEL(bolan_flow_bends)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                              float out[FLOW_SUMS]);
void KERNEL(bolan_flow_whole)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                              float out[FLOW_SUMS]);
void KERNEL(bolan_flow_full)(const float *texels, uint32_t n, double u, double v, float out[12][FLOW_BENT]);
void KERNEL(bolan_flow_slopes)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]);

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

// Lanes through one row: value, first and second derivative along it. PART is eight or sixteen lanes, those of half a
// texel or of all of it; the bits of a lane are the same.
#define SPLINE_OF(part, name)                                                                                         \
    typedef struct name##_along {                                                                                     \
        part value, slope, bend;                                                                                      \
    } name##_along;                                                                                                   \
    static inline __attribute__((always_inline)) void name##_row(const float *row, const taps *x, name##_along *a) {  \
        const part first = *(const part *)(const void *)(row + (size_t)x->at[0] * FLOW_TEXEL);                        \
        a->value = x->value[0] * first;                                                                               \
        a->slope = x->slope[0] * first;                                                                               \
        a->bend = x->bend[0] * first;                                                                                 \
        for (int i = 1; i < TAPS; i++) {                                                                              \
            const part texel = *(const part *)(const void *)(row + (size_t)x->at[i] * FLOW_TEXEL);                    \
            a->value += x->value[i] * texel;                                                                          \
            a->slope += x->slope[i] * texel;                                                                          \
            a->bend += x->bend[i] * texel;                                                                            \
        }                                                                                                             \
    }                                                                                                                 \
    /* Adds row j to value and first derivatives, and to the second derivatives behind them. */                       \
    static inline                                                                                                     \
        __attribute__((always_inline)) void name##_slopes(part sum[3], const taps *y, int j, const name##_along *a) { \
        sum[0] += y->value[j] * a->value;                                                                             \
        sum[1] += y->value[j] * a->slope;                                                                             \
        sum[2] += y->slope[j] * a->value;                                                                             \
    }                                                                                                                 \
    static inline                                                                                                     \
        __attribute__((always_inline)) void name##_bends(part sum[3], const taps *y, int j, const name##_along *a) {  \
        sum[0] += y->value[j] * a->bend;                                                                              \
        sum[1] += y->slope[j] * a->slope;                                                                             \
        sum[2] += y->bend[j] * a->value;                                                                              \
    }
SPLINE_OF(eight, half)
#ifdef __AVX512F__
typedef float sixteen __attribute__((vector_size(64), aligned(4), may_alias));
SPLINE_OF(sixteen, texel)
#endif

// Value, gradient and second derivatives of the first half of a texel, value and gradient of the second.
static inline __attribute__((always_inline)) void spline_both(const float *texels, uint32_t n, double u, double v,
                                                              eight first[6], eight second[3]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
#ifdef __AVX512F__
    sixteen sum[6] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        texel_along here;
        texel_row(texels + (size_t)y.at[j] * n * FLOW_TEXEL, &x, &here);
        texel_slopes(sum, &y, j, &here);
        texel_bends(sum + 3, &y, j, &here);
    }
    for (int i = 0; i < 6; i++) first[i] = ((const eight *)(const void *)&sum[i])[0];
    for (int i = 0; i < 3; i++) second[i] = ((const eight *)(const void *)&sum[i])[1];
#else
    for (int i = 0; i < 6; i++) first[i] = (eight){0};
    for (int i = 0; i < 3; i++) second[i] = (eight){0};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        half_along here, there;
        half_row(row, &x, &here);
        half_row(row + FLOW_BENT, &x, &there);
        half_slopes(first, &y, j, &here);
        half_bends(first + 3, &y, j, &here);
        half_slopes(second, &y, j, &there);
    }
#endif
}

// ---- sums over the levels -------------------------------------------------------------------------------------------

#if defined __clang__ || __GNUC__ >= 12
#define SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
typedef int32_t eight_int __attribute__((vector_size(32)));
#define SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (eight_int){__VA_ARGS__})
#endif

// Macros: without AVX a function must not return such a vector.
#define LOAD(p) (*(const eight *)(const void *)(p))
#define LEVEL0(top, lane) LOAD((top) + FLOW_ZERO - (lane))
#define PAIRS(a, b) (SHUFFLE(a, b, 0, 2, 8, 10, 4, 6, 12, 14) + SHUFFLE(a, b, 1, 3, 9, 11, 5, 7, 13, 15))

// The sum of the lanes of each of eight vectors.
static inline __attribute__((always_inline)) void sum_lanes(const eight v[8], float *out) {
    eight four[4], two[2];
    for (int i = 0; i < 4; i++) four[i] = PAIRS(v[2 * i], v[2 * i + 1]);
    for (int i = 0; i < 2; i++) two[i] = PAIRS(four[2 * i], four[2 * i + 1]);
    *(eight *)(void *)out =
        SHUFFLE(two[0], two[1], 0, 1, 2, 3, 8, 9, 10, 11) + SHUFFLE(two[0], two[1], 4, 5, 6, 7, 12, 13, 14, 15);
}

// FLOW_SUM_U .. FLOW_SUM_SLOPE_V from the first half of a texel: value, gradient, second derivatives. A derivative is
// the stored field at level 0, and that of the spline, `per` samples a metre, at the others.
static inline __attribute__((always_inline)) void sum_bends(const eight s[6], const flow_weights *w, float per,
                                                            bool all, float *out) {
    const eight deep = LOAD(w->across_deep + FLOW_LOW) * per;
    const eight u = LEVEL0(w->across_top, FLOW_DRIFT), v = LEVEL0(w->across_top, FLOW_DRIFT + 1);
    eight sum[8] = {s[1] * deep + s[0] * u, s[2] * deep + s[0] * v, (s[3] * deep + s[1] * u) * per,
                    (s[4] * deep + s[2] * u) * per, (s[5] * deep + s[2] * v) * per};
    if (all) {
        const eight up = LOAD(w->up_deep + FLOW_LOW) * per;
        sum[5] = s[0] * LOAD(w->up_row + FLOW_LOW);
        sum[6] = s[1] * up + s[0] * LEVEL0(w->up_top, FLOW_DRIFT);
        sum[7] = s[2] * up + s[0] * LEVEL0(w->up_top, FLOW_DRIFT + 1);
    }
    sum_lanes(sum, out);
}

// The others, `r` value and gradient of the second half.
static inline __attribute__((always_inline)) void sum_motions(const eight s[6], const eight r[3], const flow_weights *w,
                                                              float per, float *out) {
    const eight across = LOAD(w->across_row + FLOW_LOW) * per, deep = LOAD(w->across_deep + FLOW_HIGH) * per;
    const eight sum[8] = {r[1] * across,
                          r[2] * across,
                          r[0] * LOAD(w->up_row + FLOW_LOW),
                          r[1] * deep + s[0] * LEVEL0(w->across_top, FLOW_PUSH),
                          r[2] * deep + s[0] * LEVEL0(w->across_top, FLOW_PUSH + 1),
                          r[0] * LOAD(w->up_row + FLOW_HIGH),
                          r[0] * LOAD(w->across_row + FLOW_HIGH)};
    sum_lanes(sum, out);
}

void KERNEL(bolan_flow_bends)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                              float out[FLOW_SUMS]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    eight sum[6] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        half_along here;
        half_row(texels + (size_t)y.at[j] * n * FLOW_TEXEL, &x, &here);
        half_slopes(sum, &y, j, &here);
        half_bends(sum + 3, &y, j, &here);
    }
    sum_bends(sum, w, per, false, out);
}

void KERNEL(bolan_flow_whole)(const float *texels, uint32_t n, double u, double v, const flow_weights *w, float per,
                              float out[FLOW_SUMS]) {
    eight sum[6], other[3];
    spline_both(texels, n, u, v, sum, other);
    sum_bends(sum, w, per, true, out);
    sum_motions(sum, other, w, per, out + FLOW_SUM_VELOCITY);
}

// ---- order 2 --------------------------------------------------------------------------------------------------------

void KERNEL(bolan_flow_full)(const float *texels, uint32_t n, double u, double v, float out[12][FLOW_BENT]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    eight sum[12] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        for (int half = 0; half < 2; half++) {
            half_along here;
            half_row(row + half * FLOW_BENT, &x, &here);
            half_slopes(sum + 6 * half, &y, j, &here);
            half_bends(sum + 6 * half + 3, &y, j, &here);
        }
    }
    for (int i = 0; i < 12; i++) *(eight *)(void *)out[i] = sum[i];
}

void KERNEL(bolan_flow_slopes)(const float *texels, uint32_t n, double u, double v, float out[6][FLOW_BENT]) {
    const taps x = taps_of(u, n), y = taps_of(v, n);
    eight sum[6] = {{0}};
    for (int j = 0; j < TAPS; j++) {
        const float *row = texels + (size_t)y.at[j] * n * FLOW_TEXEL;
        for (int half = 0; half < 2; half++) {
            half_along here;
            half_row(row + half * FLOW_BENT, &x, &here);
            half_slopes(sum + 3 * half, &y, j, &here);
        }
    }
    for (int i = 0; i < 6; i++) *(eight *)(void *)out[i] = sum[i];
}
