// SPDX-License-Identifier: MIT
// Broken water near the shore: bores that run in over the shallows, each a steep front with foam that thins out behind
// it, and swash at the edge. Shares are 0 to 1. The optics choose density and width.
#ifndef BOLAN_SHARED_SURF
#define BOLAN_SHARED_SURF
#include "shared/constants.glsl"
#include "shared/language.glsl"

#define BORE_DEPTH 0.9  // up a slope, depth from front to front over the significant height
#define BORE_FRONT 0.06 // length of the front itself, over that from front to front
#define BORE_DECAY 3.0  // by e^-3 foam thins out from a front to the next
#define BORE_MEAN 0.3   // mean of bore_foam(), where a pixel is wider than the fronts are apart

// The choices of an optics.
STRUCT(surf_look)
struct surf_look {
    real zone_full; // depth in significant heights from which on all is broken
    real zone_none; // and beyond which nothing is
    real between;   // cover between the fronts
    real edge_full; // depth of water at the edge [m] below which the swash is whole
    real edge_none; // and beyond which there is none
    real edge_mean; // cover by swash
    real edge_pulse; // amplitude of its variation
};

// 1 in water shallower than `full`, 0 in water deeper than `none`.
SHARED real shallows(real depth, real full, real none) { return 1.0 - smoothstep(full, none, depth); }

// Place between two fronts: 0 at a front, growing to 1 at the one that follows. along: in cycles over flats.
SHARED real between_fronts(real depth, real height, real along) { return fract(depth / (BORE_DEPTH * height) + along); }

// Cover by foam behind a front.
SHARED real bore_foam(real behind) { return smoothstep(0.0, BORE_FRONT, behind) * exp(-BORE_DECAY * behind); }

// Cover in the zone of bores, water `depth` significant heights deep, where bore_foam() is `foam`.
SHARED real surf_cover(real depth, real foam, surf_look look) {
    return shallows(depth, look.zone_full, look.zone_none) * mix(look.between, 1.0, foam);
}

// Varies once a cycle.
SHARED real surge(real mean, real pulse, real cycles) { return mean + pulse * sin(2.0 * PI * cycles); }

// Cover by swash where the water is `depth` deep [m].
SHARED real swash_cover(real depth, real cycles, surf_look look) {
    return shallows(depth, look.edge_full, look.edge_none) * surge(look.edge_mean, look.edge_pulse, cycles);
}

#endif
