// SPDX-License-Identifier: MIT
// The cascades: how long each tile is, how it lies, and which ring of wave numbers it holds.
//
//     log k ->   |------ cascade 0 ------|------ cascade 1 ------|------ cascade 2 ------| ...
//                0            0.5 Nyquist of 0            0.5 Nyquist of 1
//
// A ring ends at half of its tile's Nyquist wave number: the picture and the queries interpolate linearly between
// samples, which takes 7 % off the height of a sea whose shortest waves have 2.6 samples and 2 % with 4. The next
// tile is shorter by a ratio that leaves at least 10 modes below its own first wave (fewer at low resolution): with 6
// the waves at the edge are too coarse in direction and their variance is off by 4 %. Ratios and angles are
// incommensurate, so that repetitions never line up.
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

static const double ratio_of_ratio[BOLAN_MAX_CASCADES - 1] = {0.99713, 0.96189, 0.93407};
static const double angles_deg[BOLAN_MAX_CASCADES] = {0.0, 37.0817, 71.6183, 113.2631};

#define RING_END 0.5       // of the Nyquist wave number
#define LAST_RING_END 0.9  // nothing shorter is left to take over
#define SHORTEST_WAVE 0.02 // [m]: below it, water is viscous roughness
#define CALM_LENGTH 100.0  // [m] of a sea without waves

static double modes_to_inner_edge(uint32_t n) { return n >= 256 ? 10.0 : n >= 128 ? 9.0 : n >= 64 ? 6.0 : 4.0; }

// At least extent.longest of the longest waves that matter: those 5 % of the variance is longer than.
static double automatic_length(const sea_radial *radial, const bolan_sea_summary *summary, double depth,
                               cascade_extent extent) {
    const double k_long = bolan_sea_radial_quantile(radial, 0.05);
    if (!(k_long > 0.0) || !(summary->tp > 0.0)) return CALM_LENGTH;
    const double k_peak = bolan_k_from_omega(2.0 * BOLAN_PI / summary->tp, depth);
    const double length = fmax(extent.peaks / k_peak, extent.longest / k_long) * 2.0 * BOLAN_PI;
    return fmin(fmax(length, 10.0), 1e5);
}

// Ratio of successive lengths: as large as the rings allow, less when the last ring would reach beyond SHORTEST_WAVE.
static double length_ratio(double length, uint32_t n, uint32_t count) {
    const double largest = RING_END * 0.5 * n / modes_to_inner_edge(n);
    if (count < 2) return largest;
    const double last = LAST_RING_END * BOLAN_PI * n / length;
    const double enough = portable_pow(2.0 * BOLAN_PI / SHORTEST_WAVE / last, 1.0 / (count - 1));
    return fmin(largest, fmax(enough, 2.0));
}

void bolan_cascades_layout(sea_shared *shared, const sea_radial *radial, cascade_extent extent) {
    bolan_sea_desc *d = &shared->desc;
    cascade_tables *t = shared->tables;
    const uint32_t count = shared->cascades;
    if (d->length == 0.0) d->length = automatic_length(radial, &shared->summary, d->sea_state.depth, extent);
    const double ratio = length_ratio(d->length, d->resolution, count);
    for (uint32_t i = 0; i < count; i++) {
        sea_cascade *c = &t->cascade[i];
        c->n = d->resolution;
        c->length = i == 0 ? d->length : t->cascade[i - 1].length / (ratio * ratio_of_ratio[i - 1]);
        c->angle = bolan_radians(angles_deg[i]);
        bolan_sincos(c->angle, &c->sine, &c->cosine);
        const double nyquist = BOLAN_PI * c->n / c->length;
        c->k_min = i == 0 ? 0.0 : t->cascade[i - 1].k_max;
        c->k_max = (i + 1 == count ? LAST_RING_END : RING_END) * nyquist;
    }
}
