// SPDX-License-Identifier: MIT
// The instruction sets that this machine runs. cmake/BolanKernels.cmake defines the sets.
#include "bolan/base.h"

#ifdef BOLAN_KERNELS_X86
#include <cpuid.h>
#include <stdatomic.h>

// Half-float conversion, which __builtin_cpu_supports() of older compilers does not know by name.
static bool has_f16c(void) {
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) && (c & bit_F16C);
}

static bolan_cpu find_best(void) {
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2") || !has_f16c()) return BOLAN_CPU_GENERIC4;
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
    return avx512 ? BOLAN_CPU_AVX512 : BOLAN_CPU_AVX2;
}

// Found once: on a virtual machine a question to the processor costs tens of thousands of cycles.
bolan_cpu bolan_cpu_best(void) {
    static atomic_int known; // AUTO: not yet
    int best = atomic_load_explicit(&known, memory_order_relaxed);
    if (best == BOLAN_CPU_AUTO) {
        best = (int)find_best();
        atomic_store_explicit(&known, best, memory_order_relaxed);
    }
    return (bolan_cpu)best;
}
#else
bolan_cpu bolan_cpu_best(void) { return BOLAN_CPU_GENERIC4; }
#endif
