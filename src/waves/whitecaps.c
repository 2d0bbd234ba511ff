// SPDX-License-Identifier: MIT
// Where foam is: the Jacobian below which the covered fraction is Monahan's for the wind, as a quantile of the sea itself.
#include "waves/sea.h"

#include <stdlib.h>

enum { TIMES = 4, SIDE = 256 }; // 262144 samples: the rarest cover that is asked for, 1e-4, is still 26 of them
#define TIMES_APART 97.3        // [s]: no wave of the sea is coherent that long
#define NEVER (-1e30)

static int compare(const void *a, const void *b) {
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
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

bool sea_whitecaps_create(bolan_sea *sea) {
    const double cover = bolan_monahan_cover(sea->desc.sea_state.wind_speed);
    const size_t count = (size_t)TIMES * SIDE * SIDE, rank = (size_t)(cover * (double)count);
    sea->foam_threshold = NEVER;
    if (rank > 0) { // a weaker wind makes no foam
        float *jacobian = sea_borrow(count * sizeof(float));
        if (!jacobian) return false;
        gather(sea, jacobian);
        qsort(jacobian, count, sizeof(float), compare);
        // A flat calm has no crests to put foam on.
        if (jacobian[0] < jacobian[count - 1]) sea->foam_threshold = jacobian[rank < count ? rank : count - 1];
        bolan_release(jacobian, count * sizeof(float));
    }
    sea->foam_holds = false;
    bolan_sea_step(sea, 0.0);
    return true;
}

double bolan_sea_foam_threshold(const bolan_sea *sea) {
    return sea->foam_threshold;
}
