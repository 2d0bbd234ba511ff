// SPDX-License-Identifier: MIT
// Fresnel reflectance of a dielectric. The shader twin is shaders/common/fresnel.glsl.
#include "bolan/optics.h"

// Born & Wolf, Principles of Optics, section 1.5.2, equations (32): amplitudes across and in the plane of incidence,
// for the relative index n = n_t / n_i. Unpolarised light is half of each.
float bolan_fresnel(float cos_incident, float eta) {
    const double n = (double)eta, ci = fmin(fmax((double)cos_incident, 0.0), 1.0);
    const double sin2_transmitted = (1.0 - ci * ci) / (n * n);
    if (sin2_transmitted >= 1.0) return 1.0f; // total reflection
    const double ct = sqrt(1.0 - sin2_transmitted);
    const double across = (ci - n * ct) / (ci + n * ct), in_plane = (n * ci - ct) / (n * ci + ct);
    return (float)(0.5 * (across * across + in_plane * in_plane));
}
