// SPDX-License-Identifier: MIT
// Reflectance of a dielectric for unpolarised light.
#ifndef BOLAN_SHARED_FRESNEL
#define BOLAN_SHARED_FRESNEL
#include "shared/language.glsl"

// Exact: Born & Wolf, Principles of Optics, section 1.5.2, equations (32), amplitudes across and in the plane of
// incidence. cos_incident: 0..1; eta: index beyond the surface over the index before it.
SHARED real fresnel(real cos_incident, real eta) {
    real sin2 = (1.0 - cos_incident * cos_incident) / (eta * eta);
    if (sin2 >= 1.0) return 1.0; // total reflection
    real cos_transmitted = sqrt(1.0 - sin2);
    real across = (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    real in_plane = (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    return 0.5 * (across * across + in_plane * in_plane);
}

// At normal incidence.
SHARED real fresnel_normal(real eta) { return (eta - 1.0) * (eta - 1.0) / ((eta + 1.0) * (eta + 1.0)); }

// Fast: Schlick 1994. From air into the sea it is at most 0.059 above the exact value, near 84 degrees, and at most
// 23 % below it, near 51 degrees.
SHARED real fresnel_fast(real cos_incident, real eta) {
    real f0 = fresnel_normal(eta), g = 1.0 - cos_incident, g2 = g * g;
    return f0 + (1.0 - f0) * g2 * g2 * g;
}

// Fast mean over facets whose mean normal is seen at cosine c, their slopes along the view spreading by rms: Schlick's
// curve and its curvature times the variance. Half the second derivative would be 10 g^3; 9 fits the mean over facets
// that facing_fast() of shared/microfacets.glsl describes. For rms slopes of 0.1 to 0.25 it is within 12 % up to 20
// degrees over the horizon, and up to 30 % low at 45 degrees, where Schlick's curve is low.
SHARED real fresnel_mean_fast(real cosine, real rms, real eta) {
    real f0 = fresnel_normal(eta), c = min(cosine, 1.0), g = 1.0 - c, g3 = g * g * g;
    return f0 + (1.0 - f0) * g3 * (g * g + 9.0 * rms * rms * (1.0 - c * c));
}

#endif
