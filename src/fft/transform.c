// SPDX-License-Identifier: MIT
#include "fft/transform.h"

fft_strip_fn bolan_fft_strip_scalar, bolan_fft_strip_generic4;
#ifdef BOLAN_KERNELS_X86
fft_strip_fn bolan_fft_strip_avx2, bolan_fft_strip_avx512;
#endif

static fft_strip_fn *const table[] = {
    [BOLAN_CPU_SCALAR] = bolan_fft_strip_scalar,
    [BOLAN_CPU_GENERIC4] = bolan_fft_strip_generic4,
#ifdef BOLAN_KERNELS_X86
    [BOLAN_CPU_AVX2] = bolan_fft_strip_avx2,
    [BOLAN_CPU_AVX512] = bolan_fft_strip_avx512,
#endif
};

fft_strip_fn *bolan_fft_strip_for(bolan_cpu cpu) {
    const bolan_cpu best = bolan_cpu_best();
    return table[cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu];
}
