// SPDX-License-Identifier: MIT
// Light between the water's surface and the ground under it.
#ifndef BOLAN_SHARED_BED
#define BOLAN_SHARED_BED
#include "shared/language.glsl"

// Share of the sky's light that enters the water: 1 less the reflectance for light from all sides, 0.068 at index 1.34,
// and for that of a sky brighter at the horizon.
#define SKY_ENTERS 0.93
// The same of sunlight, at all heights of the sun alike: from 25 degrees on it is 0.94 to 0.98.
#define SUN_ENTERS 0.95
// Radiance over the water for that of the bed as if dry: of the light on the water enters the share BED_ENTERS, and
// radiance falls by 1 / n^2 = 0.557 on its way out. The surface takes its reflectance of the view apart.
#define BED_LEAVES 0.54
#define BED_ENTERS 0.97
// Share of the light from the bed, the same in all directions, that the surface reflects down again: 1 - (1 - 0.068) /
// n^2 at index 1.34, most of it totally. Waves leave it as it is (tests/reference).
#define BED_AGAIN 0.48

// What light that goes up and down between surface and bed adds to the radiance of the bed, over what it has without.
// left: share of the light that is left of an even light after the way down.
SHARED real bed_again(real albedo, real left) {
    real once = albedo * BED_AGAIN * left * left;
    return once / (1.0 - once);
}

// Path that attenuates light from the bed [m], water `depth` deep: straight down once, and up along the view. down:
// cosine of the refracted view.
SHARED real bed_path(real depth, real down) { return depth * (1.0 + 1.0 / down); }

#endif
