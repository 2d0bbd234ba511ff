// SPDX-License-Identifier: MIT
// The wide type that the kernels are written in: BOLAN_KERNEL_WIDTH floats, by GCC's vector extension. Included by
// kernels only. An operation on the type is the operation on each lane, rounded once, so all widths give the same bits.
#ifndef BOLAN_FFT_WIDE_H
#define BOLAN_FFT_WIDE_H

#include <stdint.h>
#include <string.h>
#ifdef __SSE2__
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
#else
    const wide_int m = a > b;
    return wide_from_bits((m & wide_bits(a)) | (~m & wide_bits(b)));
#endif
}

// The smaller of each lane; b where they are equal.
static inline wide wide_min(wide a, wide b) {
#if WIDE == 1
    return a < b ? a : b;
#else
    const wide_int m = a < b;
    return wide_from_bits((m & wide_bits(a)) | (~m & wide_bits(b)));
#endif
}

// For planes larger than the cache: the line goes to memory without being read first. `p` is aligned to the vector.
static inline void wide_stream(float *p, wide v) {
#if WIDE == 16
    _mm512_stream_ps(p, (__m512)v);
#elif WIDE == 8
    _mm256_stream_ps(p, (__m256)v);
#elif WIDE == 4
    _mm_stream_ps(p, (__m128)v);
#else
    *p = v;
#endif
}

// Makes streamed lines visible to other threads.
static inline void wide_stream_end(void) {
#if WIDE > 1
    _mm_sfence();
#endif
}

#if WIDE == 16
#define WIDE_LOW 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define WIDE_HIGH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#define WIDE_LEVELS 4
#elif WIDE == 8
#define WIDE_LOW 0, 8, 1, 9, 2, 10, 3, 11
#define WIDE_HIGH 4, 12, 5, 13, 6, 14, 7, 15
#define WIDE_LEVELS 3
#elif WIDE == 4
#define WIDE_LOW 0, 4, 1, 5
#define WIDE_HIGH 2, 6, 3, 7
#define WIDE_LEVELS 2
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

// Transposes the WIDE x WIDE block v: log2(WIDE) rounds of interleaving vector i with vector i + WIDE / 2.
static inline void wide_transpose(wide v[WIDE]) {
#if WIDE > 1
    wide u[WIDE];
#pragma GCC unroll 4
    for (int level = 0; level < WIDE_LEVELS; level++) {
#pragma GCC unroll 16
        for (int i = 0; i < WIDE / 2; i++) {
            u[2 * i] = WIDE_SHUFFLE(v[i], v[i + WIDE / 2], WIDE_LOW);
            u[2 * i + 1] = WIDE_SHUFFLE(v[i], v[i + WIDE / 2], WIDE_HIGH);
        }
#pragma GCC unroll 16
        for (int i = 0; i < WIDE; i++) v[i] = u[i];
    }
#else
    (void)v;
#endif
}

#endif
