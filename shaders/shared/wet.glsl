// SPDX-License-Identifier: MIT
// Wet surfaces.
#ifndef BOLAN_SHARED_WET
#define BOLAN_SHARED_WET
#include "shared/language.glsl"

// Albedo of a rough surface under a film of liquid of that index: the film reflects back most of the light that the
// surface scatters, 1 - 1 / index^2, so that it meets the surface again (Angstrom 1925; Lekner & Dorf 1988, eq. 1).
SHARED real wet_albedo(real albedo, real index) { return albedo / (albedo + index * index * (1.0 - albedo)); }

#endif
