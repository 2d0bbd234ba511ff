// SPDX-License-Identifier: MIT
// The foam thresholds: the Jacobians below which the covered fractions are those observed for the wind, as quantiles of
// the Jacobian of the sea.
#include "waves/model.h"

enum { TIMES = 2, COUNT = TIMES * SEA_MEASURED }; // the rarest cover that can be seen, 1e-4, is still 13 of them
#define TIMES_APART 97.3                          // [s]: no wave of the sea is coherent that long
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

// Task: blocks [begin, end) of the places at the present time.
typedef struct gathering {
    const bolan_sea *sea;
    float *out;
} gathering;

static void gather_blocks(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const gathering *g = context;
    bolan_sea_sample sample[SEA_PLACES];
    for (uint32_t i = begin; i < end; i++) {
        bolan_sea_sample_places(g->sea, i * SEA_PLACES, sample);
        for (uint32_t p = 0; p < SEA_PLACES; p++) g->out[i * SEA_PLACES + p] = sample[p].jacobian;
    }
}

static void gather(bolan_sea *sea, float *out) {
    for (int t = 0; t < TIMES; t++) {
        bolan_sea_step(sea, TIMES_APART * t);
        bolan_sea_fields(sea);
        gathering g = {sea, out + (size_t)t * SEA_MEASURED};
        bolan_parallel(SEA_MEASURED / SEA_PLACES, 4, gather_blocks, &g);
    }
}

// False in a calm, and for waves without horizontal displacement: their Jacobian is the same everywhere.
static bool has_crests(const float *jacobian, size_t count) {
    float lowest = jacobian[0], highest = jacobian[0];
    for (size_t i = 1; i < count; i++) {
        lowest = jacobian[i] < lowest ? jacobian[i] : lowest;
        highest = jacobian[i] > highest ? jacobian[i] : highest;
    }
    return highest - lowest > 1e-5f;
}

// The Jacobian below which that share of them is. Reorders them.
static double quantile(float *jacobian, double share) {
    const size_t rank = (size_t)(share * COUNT);
    return rank > 0 ? (double)select_rank(jacobian, COUNT, rank) : NEVER;
}

bool bolan_sea_whitecaps_create(bolan_sea *sea) {
    sea_shared *shared = sea->shared;
    const double wind = shared->desc.sea_state.wind_speed, cover = bolan_monahan_cover(wind);
    shared->foam_threshold = shared->breaker_threshold = NEVER;
    if (cover * COUNT >= 1.0) { // a weaker wind makes no foam
        float *jacobian = bolan_sea_borrow(COUNT * sizeof(float));
        if (!jacobian) return false;
        gather(sea, jacobian);
        // From 32 m/s on more than half of the sea is covered, and the threshold lies above the median, about 1.
        if (has_crests(jacobian, COUNT)) {
            shared->foam_threshold = quantile(jacobian, cover);
            shared->breaker_threshold =
                quantile(jacobian, shared->model->remembers ? bolan_breaker_cover(wind) : bolan_callaghan_cover(wind));
        }
        bolan_release(jacobian, COUNT * sizeof(float));
    }
    sea->stepped = false;
    bolan_sea_step(sea, 0.0);
    return true;
}

double bolan_sea_foam_threshold(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->foam_threshold;
}

double bolan_sea_breaker_threshold(const bolan_sea *sea) {
    BOLAN_ASSERT(sea);
    return sea->shared->breaker_threshold;
}
