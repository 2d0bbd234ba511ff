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

// The same as halfs, of which `texels` are the floats: read where that is the shorter way.
static inline void wide_fields_halves(wide_fields f, const wide texels[TEXEL_PARTS], uint16_t *out) {
#if WIDE == 16
    static const _Alignas(64) uint16_t order[32] = {0, 32, 8,  40, 1, 33, 9,  41, 2, 34, 10, 42, 3, 35, 11, 43,
                                                    4, 36, 12, 44, 5, 37, 13, 45, 6, 38, 14, 46, 7, 39, 15, 47};
    (void)texels;
    const __m256i re = _mm512_cvtps_ph((__m512)f.first.re, _MM_FROUND_TO_NEAREST_INT);
    const __m256i im = _mm512_cvtps_ph((__m512)f.first.im, _MM_FROUND_TO_NEAREST_INT);
    _mm512_store_si512(out, _mm512_permutex2var_epi16(_mm512_castsi256_si512(re), _mm512_load_si512(order),
                                                      _mm512_castsi256_si512(im)));
#elif WIDE == 4
    (void)texels;
    const wide pairs = wide_half_pair(f.first.re, f.first.im); // fields 0 and 1, then 2 and 3
    wide_store((float *)(void *)out, WIDE_SHUFFLE(pairs, pairs, 0, 2, 1, 3));
#else
    (void)f;
    for (uint32_t part = 0; part < TEXEL_PARTS; part++) wide_half_store(out + part * WIDE, texels[part]);
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
