// SPDX-License-Identifier: MIT
// The table of the query kernels, one row per instruction set.
#include "query/block.h"

#define QUERY_DECLARE(set)                                                                   \
    void bolan_query_locate_##set(const query_sea *sea, query_block *block);                 \
    void bolan_query_approach_##set(const query_sea *, query_block *, uint32_t, uint32_t *); \
    void bolan_query_surface_##set(const query_sea *sea, query_block *block);                \
    void bolan_query_evaluate_##set(const query_sea *sea, uint32_t lanes, query_block *block);
#define QUERY_ROW(set) \
    { bolan_query_locate_##set, bolan_query_approach_##set, bolan_query_surface_##set, bolan_query_evaluate_##set }

QUERY_DECLARE(scalar)
QUERY_DECLARE(generic4)
#ifdef BOLAN_KERNELS_X86
QUERY_DECLARE(avx2)
QUERY_DECLARE(avx512)
#endif

static const query_kernels table[] = {
    [BOLAN_CPU_SCALAR] = QUERY_ROW(scalar),
    [BOLAN_CPU_GENERIC4] = QUERY_ROW(generic4),
#ifdef BOLAN_KERNELS_X86
    [BOLAN_CPU_AVX2] = QUERY_ROW(avx2),
    [BOLAN_CPU_AVX512] = QUERY_ROW(avx512),
#endif
};

const query_kernels *bolan_query_kernels_for(bolan_cpu cpu) {
    const bolan_cpu best = bolan_cpu_best();
    return &table[cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu];
}
