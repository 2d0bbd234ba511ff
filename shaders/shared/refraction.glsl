// SPDX-License-Identifier: MIT
// Apparent positions through a flat water surface: Ma, Zhu & Gong 2006, section 2.2.3, with Fermat's path for each
// point in place of a single angle.
#ifndef BOLAN_SHARED_REFRACTION
#define BOLAN_SHARED_REFRACTION
#include "shared/language.glsl"

// Newton's steps of refraction_tangent(): four keep the apparent depth within 0.4 % in single precision, twelve
// converge to a double's rounding.
#ifndef REFRACTION_STEPS
#define REFRACTION_STEPS 4
#endif

// Tangent t of the angle in the air of the path between a point `air` above the water and a point `water` below it,
// `aside` apart [m], air > 0: air t + water t / sqrt(n^2 + (n^2 - 1) t^2) = aside. The left side is concave in t, so
// Newton's steps from a start that is too small never overshoot; both bounds are such starts.
SHARED real refraction_tangent(real air, real water, real aside, real index) {
    real n2 = index * index, m2 = n2 - 1.0;
    real t = max(aside / (air + water / index), (aside - water * inversesqrt(m2)) / air);
    for (int i = 0; i < REFRACTION_STEPS; ++i) {
        real q = n2 + m2 * t * t, r = inversesqrt(q);
        t += (aside - air * t - water * t * r) / (air + water * n2 * r * r * r);
    }
    return t;
}

// Apparent depth over depth at that tangent: eq. 7.
SHARED real refraction_k(real tangent, real index) {
    real n2 = index * index;
    return inversesqrt(n2 + (n2 - 1.0) * tangent * tangent);
}

// Height over the water [m], < 0 below, at which a point of height z and horizontal distance `aside` seems to stand to
// an eye of height `eye_z` on the other side of the surface.
SHARED real apparent_height(real eye_z, real z, real aside, real index) {
    real least = 1e-3; // of the height in the air, which the tangent is divided by [m]
    if (eye_z > 0.0) return z * refraction_k(refraction_tangent(max(eye_z, least), max(-z, 0.0), aside, index), index);
    real over = max(z, least); // from below, what stands above the water seems taller
    return over / refraction_k(refraction_tangent(over, -eye_z, aside, index), index) + min(z, 0.0);
}

// Cosine from the vertical, in the water, of a ray whose cosine in the air is `up`: Snell's law at a level surface.
// Never 0, since paths are divided by it.
SHARED real refracted_cosine(real up, real index) { return sqrt(max(1.0 - (1.0 - up * up) / (index * index), 1e-4)); }

#endif
