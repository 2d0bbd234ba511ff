// SPDX-License-Identifier: MIT
// A wave train: height / 2 * edge(along) * edge(across) * cos(2 pi turns). `u` is the distance from the centre over the
// half extent, along or across the direction of travel; `edge` the share of the half extent over which it falls.
#ifndef BOLAN_SHARED_WAVE_TRAIN
#define BOLAN_SHARED_WAVE_TRAIN
#include "shared/constants.glsl"
#include "shared/language.glsl"

// 1 in the middle, 0 from u = +-1 on, and a smooth step between, so that the slope has no jump.
SHARED real train_edge(real u, real edge) {
    real t = clamp((1.0 - (u < 0.0 ? -u : u)) / edge, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// d train_edge / d u.
SHARED real train_edge_slope(real u, real edge) {
    real t = clamp((1.0 - (u < 0.0 ? -u : u)) / edge, 0.0, 1.0);
    return (u < 0.0 ? 6.0 : -6.0) * t * (1.0 - t) / edge;
}

// Share of the amplitude that a grid of that spacing keeps: all from 4 spacings a wave on, none from 2 down, like the
// waves of a sum.
SHARED real train_on_grid(real wave_length, real spacing) { return clamp(0.5 * wave_length / spacing - 1.0, 0.0, 1.0); }

// Share of the amplitude that a Gaussian footprint of standard deviation `sigma` along the wave leaves; k in rad/m.
SHARED real train_under(real sigma, real k) { return exp(-0.5 * sigma * sigma * k * k); }

#endif
