// SPDX-License-Identifier: MIT
// See sea_texels.h: the table of the kernels, one row per instruction set, and the chain of levels.
#include "sea_texels.h"

#include "bolan/base.h"

#define DECLARE(set)                                                                                                  \
    void bolan_texel_pack_##set(size_t, const float *, const float *, const float *, const float *, const float *,    \
                                float *, uint16_t *);                                                                 \
    void bolan_texel_halve_##set(uint32_t, const float *const[TEXEL_PLANES], float *const[TEXEL_PLANES], uint16_t *); \
    void bolan_texel_halve_texels_##set(uint32_t, size_t, const float *, float *, uint16_t *);
#define ROW(set) \
    { bolan_texel_pack_##set, bolan_texel_halve_##set, bolan_texel_halve_texels_##set }
DECLARE(scalar)
DECLARE(generic4)
#ifdef BOLAN_KERNELS_X86
DECLARE(avx2)
DECLARE(avx512)
#endif

const texel_kernels *bolan_texel_kernels_best(void) {
    static const texel_kernels table[] = {
        [BOLAN_CPU_SCALAR] = ROW(scalar),
        [BOLAN_CPU_GENERIC4] = ROW(generic4),
#ifdef BOLAN_KERNELS_X86
        [BOLAN_CPU_AVX2] = ROW(avx2),
        [BOLAN_CPU_AVX512] = ROW(avx512),
#endif
    };
    return &table[bolan_cpu_best()];
}

// The levels below the first have a third of its texels all together.
size_t bolan_texel_scratch_bytes(uint32_t n) { return sizeof(float) * TEXEL_PLANES * ((size_t)n * n / 3 + 16); }

size_t bolan_texel_chain_bytes(uint32_t n) { return sizeof(uint16_t) * 4 * ((size_t)n * n / 3 + 16); }

void bolan_texel_chain(uint32_t n, const float *const planes[TEXEL_PLANES], float *scratch, uint16_t *out) {
    const texel_kernels *kernels = bolan_texel_kernels_best();
    const float *from[TEXEL_PLANES];
    for (int p = 0; p < TEXEL_PLANES; p++) from[p] = planes[p];
    for (; n > 1; n /= 2) {
        const size_t size = (size_t)(n / 2) * (n / 2);
        float *to[TEXEL_PLANES];
        for (int p = 0; p < TEXEL_PLANES; p++) to[p] = scratch + p * size;
        kernels->halve(n, from, to, out);
        for (int p = 0; p < TEXEL_PLANES; p++) from[p] = to[p];
        scratch += TEXEL_PLANES * size;
        out += 4 * size;
    }
}

void bolan_texel_chain_of_texels(uint32_t n, size_t pitch, const float *texels, float *scratch, uint16_t *out) {
    const texel_kernels *kernels = bolan_texel_kernels_best();
    for (; n > 1; n /= 2) {
        const size_t floats = TEXEL_PLANES * (size_t)(n / 2) * (n / 2);
        kernels->halve_texels(n, pitch, texels, scratch, out);
        texels = scratch;
        pitch = n / 2;
        scratch += floats;
        out += floats;
    }
}
