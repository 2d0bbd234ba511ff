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
// Radiance over the water for that under it: through the surface, (1 - F) / n^2 = 0.545 at index 1.34 straight up;
// light that is reflected down again and comes back makes up for the larger reflectance of slanting rays.
#define BED_LEAVES 0.54

// Path that attenuates light from the bed [m], water `depth` deep: straight down once, and up along the view. down:
// cosine of the refracted view.
SHARED real bed_path(real depth, real down) { return depth * (1.0 + 1.0 / down); }

#endif
