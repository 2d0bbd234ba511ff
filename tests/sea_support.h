// SPDX-License-Identifier: MIT
// Seas for tests.
#ifndef BOLAN_TESTS_SEA_SUPPORT_H
#define BOLAN_TESTS_SEA_SUPPORT_H

#include "cascade_twin.h"
#include "support.h"

#include "bolan/ground.h"
#include "bolan/waves.h"

static inline bolan_sea *test_sea(bolan_sea_desc desc) {
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    return sea;
}

/// A plane ground of 10 km, whose elevation [m] goes from @p west to @p east.
static inline bolan_ground *test_plane_ground(float west, float east) {
    const float grid[4] = {west, east, west, east};
    bolan_ground_desc desc = bolan_ground_desc_default();
    desc.field = (bolan_heightfield){2, 2, -5000.0, -5000.0, 10000.0, 10000.0, grid};
    desc.detail = 0.0;
    desc.edge_elevation = (double)west;
    bolan_ground *ground = NULL;
    assert_int_equal(bolan_ground_create(&desc, &ground), BOLAN_OK);
    return ground;
}

/// No wind and no waves, to which a test adds its own.
static inline bolan_sea_desc test_calm_desc(uint32_t n) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_default();
    desc.resolution = n;
    return desc;
}

/// What the spline of the heights is at its samples: @p out has n * n.
static inline void test_nodes(const bolan_cascade_view *v, float *out) {
    const uint32_t n = v->n, mask = n - 1;
    for (uint32_t j = 0; j < n; j++)
        for (uint32_t i = 0; i < n; i++) {
            double sum = 0.0;
            for (uint32_t b = 0; b < 3; b++)
                for (uint32_t a = 0; a < 3; a++)
                    sum += (a == 1 ? 4.0 : 1.0) * (b == 1 ? 4.0 : 1.0) / 36.0 *
                           (double)v->displacement[((j + b - 1) & mask) * v->pitch + ((i + a - 1) & mask)].height;
            out[(size_t)j * n + i] = (float)sum;
        }
}

static inline double test_mean_product(const bolan_cascade_view *v, const float *a, const float *b) {
    double sum = 0.0;
    for (size_t p = 0; p < (size_t)v->n * v->n; p++) sum += (double)a[p] * b[p];
    return sum / ((double)v->n * v->n);
}

#endif
