// SPDX-License-Identifier: MIT
// The wide type that the kernels are written in: BOLAN_KERNEL_WIDTH floats, by GCC's vector extension. Included by
// kernels only. An operation on the type is the operation on each lane, rounded once, so all widths give the same bits.
#ifndef BOLAN_FFT_WIDE_H
#define BOLAN_FFT_WIDE_H

#include <stdint.h>
#include <string.h>
#if BOLAN_KERNEL_WIDTH > 4
#include <immintrin.h>
#endif

#define WIDE BOLAN_KERNEL_WIDTH
#define WIDE_JOIN2(a, b) a##_##b
#define WIDE_JOIN(a, b) WIDE_JOIN2(a, b)
#define KERNEL(name) WIDE_JOIN(name, BOLAN_KERNEL_SUFFIX)

#if WIDE == 1
typedef float wide;
typedef int32_t wide_int;
#else
typedef float wide __attribute__((vector_size(4 * WIDE), may_alias));
typedef int32_t wide_int __attribute__((vector_size(4 * WIDE), may_alias));
#endif

static inline wide wide_load(const float *p) { return *(const wide *)p; }
static inline void wide_store(float *p, wide v) { *(wide *)p = v; }

static inline wide_int wide_bits(wide v) {
    union {
        wide f;
        wide_int i;
    } u = {.f = v};
    return u.i;
}
static inline wide wide_from_bits(wide_int v) {
    union {
        wide_int i;
        wide f;
    } u = {.i = v};
    return u.f;
}
static inline wide_int wide_to_int(wide v) {
#if WIDE == 1
    return (int32_t)v;
#else
    return __builtin_convertvector(v, wide_int);
#endif
}

// The larger of each lane; b where they are equal.
static inline wide wide_max(wide a, wide b) {
#if WIDE == 1
    return a > b ? a : b;
#elif WIDE == 16
    return (wide)_mm512_max_ps((__m512)a, (__m512)b);
#elif WIDE == 8
    return (wide)_mm256_max_ps((__m256)a, (__m256)b);
#else
    const wide_int m = a > b;
    return wide_from_bits((m & wide_bits(a)) | (~m & wide_bits(b)));
#endif
}

// The smaller of each lane; b where they are equal.
static inline wide wide_min(wide a, wide b) {
#if WIDE == 1
    return a < b ? a : b;
#elif WIDE == 16
    return (wide)_mm512_min_ps((__m512)a, (__m512)b);
#elif WIDE == 8
    return (wide)_mm256_min_ps((__m256)a, (__m256)b);
#else
    const wide_int m = a < b;
    return wide_from_bits((m & wide_bits(a)) | (~m & wide_bits(b)));
#endif
}

// For planes larger than the cache: the line goes to memory without being read first. `p` is aligned to the vector, and
// the stores of a line have to follow each other: a line in two parts is written at a fifth of the speed. Where a line
// is four vectors, it goes through the cache.
static inline void wide_stream(float *p, wide v) {
#if WIDE == 16
    _mm512_stream_ps(p, (__m512)v);
#elif WIDE == 8
    _mm256_stream_ps(p, (__m256)v);
#else
    wide_store(p, v);
#endif
}

// Makes streamed lines visible to other threads.
static inline void wide_stream_end(void) {
#if WIDE > 4
    _mm_sfence();
#endif
}

#if WIDE == 16
#define WIDE_LOW 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define WIDE_HIGH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#elif WIDE == 8
#define WIDE_LOW 0, 8, 1, 9, 2, 10, 3, 11
#define WIDE_HIGH 4, 12, 5, 13, 6, 14, 7, 15
#elif WIDE == 4
#define WIDE_LOW 0, 4, 1, 5
#define WIDE_HIGH 2, 6, 3, 7
#endif

// Lanes of a and b by number; the built-in function differs between compilers.
#ifdef __clang__
#define WIDE_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define WIDE_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (wide_int){__VA_ARGS__})
#endif

// a and b lane by lane in turn: 2 WIDE numbers.
static inline void wide_interleave(wide a, wide b, wide out[2]) {
#if WIDE > 1
    out[0] = WIDE_SHUFFLE(a, b, WIDE_LOW);
    out[1] = WIDE_SHUFFLE(a, b, WIDE_HIGH);
#else
    out[0] = a;
    out[1] = b;
#endif
}

// Transposes the 4 x 4 blocks within the groups of four lanes of v[0 .. 3].
#if WIDE == 16
#define WIDE_GROUPS(a, b, c, d) \
    a, b, c, d, a + 4, b + 4, c + 4, d + 4, a + 8, b + 8, c + 8, d + 8, a + 12, b + 12, c + 12, d + 12
#elif WIDE == 8
#define WIDE_GROUPS(a, b, c, d) a, b, c, d, a + 4, b + 4, c + 4, d + 4
#elif WIDE == 4
#define WIDE_GROUPS(a, b, c, d) a, b, c, d
#endif
#if WIDE > 1
static inline void wide_transpose4(wide v[4]) {
    const wide a = WIDE_SHUFFLE(v[0], v[1], WIDE_GROUPS(0, WIDE, 1, WIDE + 1));
    const wide b = WIDE_SHUFFLE(v[0], v[1], WIDE_GROUPS(2, WIDE + 2, 3, WIDE + 3));
    const wide c = WIDE_SHUFFLE(v[2], v[3], WIDE_GROUPS(0, WIDE, 1, WIDE + 1));
    const wide d = WIDE_SHUFFLE(v[2], v[3], WIDE_GROUPS(2, WIDE + 2, 3, WIDE + 3));
    v[0] = WIDE_SHUFFLE(a, c, WIDE_GROUPS(0, 1, WIDE, WIDE + 1));
    v[1] = WIDE_SHUFFLE(a, c, WIDE_GROUPS(2, 3, WIDE + 2, WIDE + 3));
    v[2] = WIDE_SHUFFLE(b, d, WIDE_GROUPS(0, 1, WIDE, WIDE + 1));
    v[3] = WIDE_SHUFFLE(b, d, WIDE_GROUPS(2, 3, WIDE + 2, WIDE + 3));
}
#endif

// Transposes the groups of four lanes of v, as many vectors as a vector has groups.
#if WIDE > 1
static inline void wide_transpose_groups(wide v[WIDE / 4]) {
#if WIDE == 16
    const wide a = WIDE_SHUFFLE(v[0], v[1], 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    const wide b = WIDE_SHUFFLE(v[0], v[1], 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    const wide c = WIDE_SHUFFLE(v[2], v[3], 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    const wide d = WIDE_SHUFFLE(v[2], v[3], 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    v[0] = WIDE_SHUFFLE(a, c, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27);
    v[1] = WIDE_SHUFFLE(a, c, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31);
    v[2] = WIDE_SHUFFLE(b, d, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27);
    v[3] = WIDE_SHUFFLE(b, d, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31);
#elif WIDE == 8
    const wide a = v[0], b = v[1];
    v[0] = WIDE_SHUFFLE(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    v[1] = WIDE_SHUFFLE(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
#else
    (void)v;
#endif
}
#endif

// Transposes the WIDE x WIDE block v: within groups of four lanes, which no processor is slow at, then the groups.
static inline void wide_transpose(wide v[WIDE]) {
#if WIDE > 1
#pragma GCC unroll 4
    for (int g = 0; g < WIDE / 4; g++) wide_transpose4(v + 4 * g);
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++) {
        wide column[WIDE / 4];
#pragma GCC unroll 4
        for (int g = 0; g < WIDE / 4; g++) column[g] = v[4 * g + k];
        wide_transpose_groups(column);
#pragma GCC unroll 4
        for (int g = 0; g < WIDE / 4; g++) v[4 * g + k] = column[g];
    }
#else
    (void)v;
#endif
}

// Lane 0 of `next`, then the last lane of v, the one before, ... lane 1: what a spectrum has at -i where v has it at i.
#if WIDE == 16
#define WIDE_MIRROR 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1
#elif WIDE == 8
#define WIDE_MIRROR 8, 7, 6, 5, 4, 3, 2, 1
#elif WIDE == 4
#define WIDE_MIRROR 4, 3, 2, 1
#endif
static inline wide wide_mirror(wide v, wide next) {
#if WIDE > 1
    return WIDE_SHUFFLE(v, next, WIDE_MIRROR);
#else
    (void)v;
    return next;
#endif
}

#endif
