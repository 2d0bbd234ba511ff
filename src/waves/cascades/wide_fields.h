// SPDX-License-Identifier: MIT
// Four fields as the second pass of a step has them: two transforms side by side, in the lower and in the upper lanes.
// The real parts are two fields, the imaginary parts two others, GROUP samples of each:
//
//     re: | field 0, x .. | field 2, x .. |      im: | field 1, x .. | field 3, x .. |
//
// So a texel of all four is near itself, and is made by few shuffles. A vector of one lane holds one field: there the
// transforms follow each other. Included by kernels only.
#ifndef BOLAN_WAVES_WIDE_FIELDS_H
#define BOLAN_WAVES_WIDE_FIELDS_H

#include "fft/strip.h"
#include "waves/cascades/wide_half.h"

#if WIDE == 1
enum { GROUP = 1, PASSES = 2 };
#else
enum { GROUP = WIDE / 2, PASSES = 1 };
#endif
enum { TEXEL_PARTS = 4 * GROUP / WIDE };

typedef struct wide_fields {
    pair first, second; // `second`: of the second pass, where there is one
} wide_fields;

#if WIDE == 16
#define WIDE_TEXELS(x) \
    x, x + 16, x + 8, x + 24, x + 1, x + 17, x + 9, x + 25, x + 2, x + 18, x + 10, x + 26, x + 3, x + 19, x + 11, x + 27
#endif

// GROUP texels of four floats, one behind the other.
static inline void wide_fields_texels(wide_fields f, wide out[TEXEL_PARTS]) {
    const wide re = f.first.re, im = f.first.im;
#if WIDE == 16
    out[0] = WIDE_SHUFFLE(re, im, WIDE_TEXELS(0));
    out[1] = WIDE_SHUFFLE(re, im, WIDE_TEXELS(4));
#elif WIDE == 8
    const wide low = WIDE_SHUFFLE(re, im, 0, 8, 1, 9, 4, 12, 5, 13);
    const wide high = WIDE_SHUFFLE(re, im, 2, 10, 3, 11, 6, 14, 7, 15);
    out[0] = WIDE_SHUFFLE(low, low, 0, 1, 4, 5, 2, 3, 6, 7);
    out[1] = WIDE_SHUFFLE(high, high, 0, 1, 4, 5, 2, 3, 6, 7);
#elif WIDE == 4
    const wide low = WIDE_SHUFFLE(re, im, 0, 4, 1, 5), high = WIDE_SHUFFLE(re, im, 2, 6, 3, 7);
    out[0] = WIDE_SHUFFLE(low, high, 0, 1, 4, 5);
    out[1] = WIDE_SHUFFLE(low, high, 2, 3, 6, 7);
#else
    out[0] = re, out[1] = im;
    out[2] = f.second.re, out[3] = f.second.im;
#endif
}

#if WIDE == 4
typedef double wide_double __attribute__((vector_size(16), may_alias));
#endif

// The lower lanes to one place, the upper ones to another.
static inline void wide_store_halves(float *low, float *high, wide v) {
#if WIDE == 16
    _mm256_store_ps(low, _mm512_castps512_ps256((__m512)v));
    _mm256_store_ps(high, _mm512_extractf32x8_ps((__m512)v, 1));
#elif WIDE == 8
    _mm_store_ps(low, _mm256_castps256_ps128((__m256)v));
    _mm_store_ps(high, _mm256_extractf128_ps((__m256)v, 1));
#elif WIDE == 4
    const double a = ((wide_double)v)[0], b = ((wide_double)v)[1]; // two floats each, never computed with
    memcpy(low, &a, sizeof a);
    memcpy(high, &b, sizeof b);
#else
    (void)low, (void)high, (void)v;
#endif
}

// GROUP samples to each of four planes, from x on.
static inline void wide_fields_store(wide_fields f, float *const plane[4], uint32_t x) {
#if WIDE == 1
    plane[0][x] = f.first.re, plane[1][x] = f.first.im;
    plane[2][x] = f.second.re, plane[3][x] = f.second.im;
#else
    wide_store_halves(plane[0] + x, plane[2] + x, f.first.re);
    wide_store_halves(plane[1] + x, plane[3] + x, f.first.im);
#endif
}

#endif
