// SPDX-License-Identifier: MIT
// The table of the kernels of a step, one row per instruction set.
#include "waves/cascades/synth.h"

#define SEA_DECLARE(set)                                                                                           \
    void bolan_sea_columns_##set(const fft_plan *, const sea_cascade *, const sea_planes *, const sea_moment *,    \
                                 sea_half, uint32_t, float *);                                                     \
    void bolan_sea_rows_##set(const cascade_tables *, const sea_cascade *, const sea_planes *, const sea_moment *, \
                              sea_half, uint32_t, float *);

SEA_DECLARE(scalar)
SEA_DECLARE(generic4)
#ifdef BOLAN_KERNELS_X86
SEA_DECLARE(avx2)
SEA_DECLARE(avx512)
#endif

static const sea_kernels table[] = {
    [BOLAN_CPU_SCALAR] = {bolan_sea_columns_scalar, bolan_sea_rows_scalar},
    [BOLAN_CPU_GENERIC4] = {bolan_sea_columns_generic4, bolan_sea_rows_generic4},
#ifdef BOLAN_KERNELS_X86
    [BOLAN_CPU_AVX2] = {bolan_sea_columns_avx2, bolan_sea_rows_avx2},
    [BOLAN_CPU_AVX512] = {bolan_sea_columns_avx512, bolan_sea_rows_avx512},
#endif
};

// The lanes of a vector are halves of two transforms of n / 16 points (wide_fields.h).
static bool is_too_wide(bolan_cpu cpu, uint32_t n) {
    return (cpu == BOLAN_CPU_AVX512 && n < 128) || (cpu == BOLAN_CPU_AVX2 && n < 64);
}

const sea_kernels *bolan_sea_kernels_for(bolan_cpu cpu, uint32_t n) {
    const bolan_cpu best = bolan_cpu_best();
    bolan_cpu set = cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu;
    while (is_too_wide(set, n)) set--;
    return &table[set];
}
