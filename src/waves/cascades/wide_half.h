// SPDX-License-Identifier: MIT
// float -> IEEE half on lanes: by the F16C instructions where the kernel has them, else by integers; the same bits as
// half_from_float(). Included by kernels only.
#ifndef BOLAN_WAVES_WIDE_HALF_H
#define BOLAN_WAVES_WIDE_HALF_H

#include "fft/wide.h"
#include "math/half.h"

// Halfs in the low 16 bits of each lane, the high bits zero.
static inline wide_int wide_half(wide v) {
#if WIDE == 16
    return (wide_int)_mm512_cvtepu16_epi32(_mm512_cvtps_ph((__m512)v, _MM_FROUND_TO_NEAREST_INT));
#elif WIDE == 8
    return (wide_int)_mm256_cvtepu16_epi32(_mm256_cvtps_ph((__m256)v, _MM_FROUND_TO_NEAREST_INT));
#elif WIDE == 4
    const wide_int sign = wide_bits(v) >> 16 & 0x8000, bits = wide_bits(v) & 0x7fffffff;
    const wide_int tiny = wide_bits(wide_from_bits(bits) + 0.5f) - 0x3f000000; // the cases of half_from_float()
    const wide_int usual = (bits + 0xfff + (bits >> 13 & 1) - 0x38000000) >> 13;
    const wide_int huge = ((bits > 0x7f800000) & 0x0200) | 0x7c00;
    const wide_int is_tiny = bits < 0x38800000, is_huge = bits >= 0x47800000;
    return sign | (is_tiny & tiny) | (is_huge & huge) | (~(is_tiny | is_huge) & usual);
#else
    return half_from_float(v);
#endif
}

#if WIDE == 1
typedef uint32_t wide_unsigned;
#else
typedef uint32_t wide_unsigned __attribute__((vector_size(4 * WIDE), may_alias));
#endif

// a in the low half of a lane's bits, b in the high one: shifted unsigned, for the sign bit may be set.
static inline wide wide_half_pair(wide a, wide b) {
    return wide_from_bits(wide_half(a) | (wide_int)((wide_unsigned)wide_half(b) << 16));
}

static inline void wide_half_store(uint16_t *out, wide v) {
#if WIDE == 16
    _mm256_store_si256((__m256i *)(void *)out, _mm512_cvtps_ph((__m512)v, _MM_FROUND_TO_NEAREST_INT));
#elif WIDE == 8
    _mm_store_si128((__m128i *)(void *)out, _mm256_cvtps_ph((__m256)v, _MM_FROUND_TO_NEAREST_INT));
#else
    const wide_int half = wide_half(v);
    int32_t lanes[WIDE];
    memcpy(lanes, &half, sizeof lanes);
    for (int l = 0; l < WIDE; l++) out[l] = (uint16_t)lanes[l];
#endif
}

#endif
