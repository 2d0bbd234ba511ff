// SPDX-License-Identifier: MIT
// Where foam is: the Jacobian below which the covered fraction is Monahan's for the wind, as a quantile of the sea
// itself.
#include "waves/sum.h"

enum {
    TIMES = 2,
    SIDE = 256,
    SUM_POINTS = 1 << 14
};                       // 131072 samples: the rarest cover that can be seen, 1e-4, is still 13 of them
#define TIMES_APART 97.3 // [s]: no wave of the sea is coherent that long
#define NEVER (-1e30)

static void swap(float *a, float *b) {
    const float t = *a;
    *a = *b;
    *b = t;
}

// The value that would be at `rank` if the values were sorted (Hoare 1961, FIND). Reorders them.
static float select_rank(float *values, size_t count, size_t rank) {
    size_t low = 0, high = count - 1;
    while (low < high) {
        const float pivot = values[low + (high - low) / 2];
        size_t i = low, j = high;
        for (;;) {
            while (values[i] < pivot) i++;
            while (pivot < values[j]) j--;
            if (i >= j) break;
            swap(values + i++, values + j--);
        }
        if (rank <= j) {
            high = j;
        } else {
            low = j + 1;
        }
    }
    return values[rank];
}

static void gather(bolan_sea *sea, float *out) {
    const uint32_t n = sea->desc.resolution, stride = n > SIDE ? n / SIDE : 1;
    for (int t = 0; t < TIMES; t++) {
        bolan_sea_step(sea, TIMES_APART * t);
        for (uint32_t j = 0; j < SIDE; j++) {
            for (uint32_t i = 0; i < SIDE; i++) {
                // Over several tiles when there are fewer nodes than samples, and over one when there are more.
                const sea_node node = sea_nearest_node(sea, i * stride, j * stride);
                *out++ = sea_node_jacobian(sea, &node);
            }
        }
    }
}

// Task: blocks [begin, end) of the places at the present time.
typedef struct sum_gathering {
    const bolan_sea *sea;
    float *out;
} sum_gathering;

static void gather_sum_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const sum_gathering *g = context;
    sea_node node[SUM_LANES];
    for (uint32_t i = begin; i < end; i++) {
        sea_sum_nodes(g->sea, i * SUM_LANES, node);
        for (uint32_t l = 0; l < SUM_LANES; l++) g->out[i * SUM_LANES + l] = sea_node_jacobian(g->sea, &node[l]);
    }
}

static void gather_sum(bolan_sea *sea, float *out) {
    for (int t = 0; t < TIMES; t++) {
        bolan_sea_step(sea, TIMES_APART * t);
        sum_gathering g = {sea, out + (size_t)t * SUM_POINTS};
        bolan_parallel(SUM_POINTS / SUM_LANES, 16, gather_sum_blocks, &g);
    }
}

bool sea_whitecaps_create(bolan_sea *sea) {
    const double cover = bolan_monahan_cover(sea->desc.sea_state.wind_speed);
    const size_t count = (size_t)TIMES * (sea->sum ? SUM_POINTS : SIDE * SIDE), rank = (size_t)(cover * (double)count);
    sea->foam_threshold = NEVER;
    if (rank > 0) { // a weaker wind makes no foam
        float *jacobian = sea_borrow(count * sizeof(float));
        if (!jacobian) return false;
        if (sea->sum) {
            gather_sum(sea, jacobian);
        } else {
            gather(sea, jacobian);
        }
        const float threshold = select_rank(jacobian, count, rank < count ? rank : count - 1);
        if (threshold < 1.0f) sea->foam_threshold = threshold; // a flat calm has no crests to put foam on
        bolan_release(jacobian, count * sizeof(float));
    }
    sea->foam_holds = false;
    bolan_sea_step(sea, 0.0);
    return true;
}

double bolan_sea_foam_threshold(const bolan_sea *sea) { return sea->foam_threshold; }
