// SPDX-License-Identifier: MIT
// Fresnel reflectance of a dielectric: shaders/shared/fresnel.glsl.
#include "bolan/optics.h"

#include "shared/fresnel.glsl"

float bolan_fresnel(float cos_incident, float eta) {
    return (float)fresnel(clamp((double)cos_incident, 0.0, 1.0), (double)eta);
}
