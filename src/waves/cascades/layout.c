// SPDX-License-Identifier: MIT
// The cascades: how long each tile is, how it lies, and which ring of wave numbers it holds.
//
//     log k ->   |------ cascade 0 ------|------ cascade 1 ------|------ cascade 2 ------| ...
//                0            45 modes of 0            45 modes of 1
//
// Rings end at 0.7 of the Nyquist wave number of 128 samples, 45 modes, where images of a wave are still small
// (spline.h); the next tile is shorter by a ratio that leaves 6 modes below its own first wave. A higher resolution
// changes neither: it samples the same waves more densely, and only the last ring goes on to shorter waves. So all
// resolutions from 128 on show one sea. Lower ones have fewer modes a ring, and tiles of their own.
//
// Along the axes of a tile, and along its diagonals, modes have evenly spaced frequencies: a narrow swell that runs
// there returns to a point after 2 pi / (group speed x spacing), 6 minutes for 14 s. So the first tile is turned by 22
// degrees from there, relative to the mean direction of the waves. Ratios and angles are incommensurate, so that
// repetitions never line up.
//
// Length and angle go in steps: seas that differ a little, one sea an hour later, have the same lattice and so the same
// waves, each a little higher or lower.
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

static const double ratio_of_ratio[BOLAN_MAX_CASCADES - 1] = {0.99713, 0.96189, 0.93407};
static const double angles_deg[BOLAN_MAX_CASCADES] = {22.36, 61.92, 112.71, 147.28};

enum { LAYOUT_N = 128 };   // the resolution whose rings all higher ones share
#define SHORTEST_WAVE 0.02 // [m]: below it, water is viscous roughness
#define CALM_LENGTH 100.0  // [m] of a sea without waves
#define ANGLE_STEP 22.5    // [degrees] half of what lies between an axis and a diagonal
#define LENGTH_STEPS 4.0   // in an octave

static double modes_to_inner_edge(uint32_t n) { return n >= 128 ? 6.0 : n >= 64 ? 5.0 : 4.0; }

// At least extent.longest of the longest waves that matter: those 5 % of the variance is longer than.
static double automatic_length(const sea_radial *radial, const bolan_sea_summary *summary, double depth,
                               cascade_extent extent) {
    const double k_long = bolan_sea_radial_quantile(radial, 0.05);
    if (!(k_long > 0.0) || !(summary->tp > 0.0)) return CALM_LENGTH;
    const double k_peak = bolan_k_from_omega(2.0 * BOLAN_PI / summary->tp, depth);
    const double least = fmax(extent.peaks / k_peak, extent.longest / k_long) * 2.0 * BOLAN_PI;
    const double steps = ceil(LENGTH_STEPS * portable_log(least) / portable_log(2.0));
    return fmin(fmax(extent.open ? portable_pow(2.0, steps / LENGTH_STEPS) : least, 10.0), 1e5);
}

// Ratio of successive lengths: as large as the rings allow, less when the last ring would reach beyond SHORTEST_WAVE.
static double length_ratio(double length, uint32_t n, uint32_t count) {
    const double largest = CASCADE_RING_END * 0.5 * n / modes_to_inner_edge(n);
    if (count < 2) return largest;
    const double last = CASCADE_RING_END * BOLAN_PI * n / length;
    const double enough = portable_pow(2.0 * BOLAN_PI / SHORTEST_WAVE / last, 1.0 / (count - 1));
    return fmin(largest, fmax(enough, 2.0));
}

void bolan_cascades_layout(sea_shared *shared, const sea_radial *radial, cascade_extent extent) {
    bolan_sea_desc *d = &shared->desc;
    cascade_tables *t = shared->tables;
    const uint32_t count = shared->cascades, n = d->resolution < LAYOUT_N ? d->resolution : LAYOUT_N;
    if (d->length == 0.0) d->length = automatic_length(radial, &shared->summary, d->sea_state.depth, extent);
    const double ratio = length_ratio(d->length, n, count);
    const double from = floor(shared->summary.from_deg / ANGLE_STEP + 0.5) * ANGLE_STEP;
    const double along = extent.open ? bolan_compass_from_to_math(from) : 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sea_cascade *c = &t->cascade[i];
        c->n = d->resolution;
        c->length = i == 0 ? d->length : t->cascade[i - 1].length / (ratio * ratio_of_ratio[i - 1]);
        c->angle = extent.open ? along + bolan_radians(angles_deg[i]) : 0.0;
        bolan_sincos(c->angle, &c->sine, &c->cosine);
        c->k_min = i == 0 ? 0.0 : t->cascade[i - 1].k_max;
        c->k_max = CASCADE_RING_END * BOLAN_PI * (i + 1 == count ? c->n : n) / c->length;
        if (i + 1 == count) c->k_max = fmax(fmin(c->k_max, 2.0 * BOLAN_PI / SHORTEST_WAVE), 1.01 * c->k_min);
    }
    if (extent.open) bolan_cascade_lay_fine(t, count);
}
