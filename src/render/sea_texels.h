// SPDX-License-Identifier: MIT
// Texels of the cascades made on the CPU: what pixels need of a cascade in one texel, and mip levels. glGenerateMipmap
// on software GL takes 0.4 ms for 256^2 texels, most of it in conversions; from the float planes on SIMD lanes it is a
// tenth of that.
#ifndef BOLAN_RENDER_WATER_TEXELS_H
#define BOLAN_RENDER_WATER_TEXELS_H

#include <stddef.h>
#include <stdint.h>

enum { TEXEL_PLANES = 4 };

// The kernels of one instruction set; all give the same bits. n is a power of two.
typedef struct texel_kernels {
    // out[i] = (a[i], b[i], c0[i] + c1[i], d[i]) as halfs, and sum[i] = c0[i] + c1[i]; `count` of them, a multiple of
    // 16
    void (*pack)(size_t count, const float *a, const float *b, const float *c0, const float *c1, const float *d,
                 float *sum, uint16_t *out);
    // Means of 2 x 2 texels: planes of n x n in `from` to planes of n/2 x n/2 in `to`, and as texels of halfs in `out`.
    void (*halve)(uint32_t n, const float *const from[TEXEL_PLANES], float *const to[TEXEL_PLANES], uint16_t *out);
    // The same of texels of four floats; `pitch` of them from row to row of `from`.
    void (*halve_texels)(uint32_t n, size_t pitch, const float *from, float *to, uint16_t *out);
} texel_kernels;
const texel_kernels *bolan_texel_kernels_best(void);

// Bytes of scratch floats for bolan_texel_chain(), and of halfs in all levels below the first.
size_t bolan_texel_scratch_bytes(uint32_t n);
size_t bolan_texel_chain_bytes(uint32_t n);
// All levels below the first of n x n texels of those planes, one after the other, into `out`.
void bolan_texel_chain(uint32_t n, const float *const planes[TEXEL_PLANES], float *scratch, uint16_t *out);
// The same of texels of four floats; `pitch` of them from row to row.
void bolan_texel_chain_of_texels(uint32_t n, size_t pitch, const float *texels, float *scratch, uint16_t *out);

#endif
