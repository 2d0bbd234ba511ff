// SPDX-License-Identifier: MIT
// The phase function of particles in water: Fournier & Forand 1994 in the form of Fournier & Jonasz 1999. Particles of
// relative index n have a hyperbolic distribution of sizes with exponent -m.
#ifndef BOLAN_SHARED_FOURNIER_FORAND
#define BOLAN_SHARED_FOURNIER_FORAND
#include "shared/constants.glsl"
#include "shared/language.glsl"

// The index of particles that have that exponent, 3 < m <= 4: the line on which the measured functions lie (Mobley,
// Sundman & Boss 2002, eq. 14). m = 3.5835 is Petzold's mean, which scatters 0.0183 back.
SHARED real fournier_forand_index(real m) { return 1.01 + 0.1542 * (m - 3.0); }

// delta of the papers; sine2: squared sine of half the scattering angle.
SHARED real fournier_forand_delta(real sine2, real n) { return 4.0 * sine2 / (3.0 * (n - 1.0) * (n - 1.0)); }

// Radiance scattered by a cosine, per unit of scattering [1/sr]; the integral over all directions is 1. The function
// has no finite value at cosine 1.
SHARED real fournier_forand(real cosine, real n, real m) {
    real nu = 0.5 * (3.0 - m), s = max(0.5 - 0.5 * cosine, 1e-7), d = fournier_forand_delta(s, n);
    d = d > 0.999 && d < 1.001 ? 1.001 : d; // a removable singularity
    real back = fournier_forand_delta(1.0, n), p = pow(d, nu), q = pow(back, nu), left = 1.0 - d;
    real forward = (nu * left - (1.0 - p) + (d * (1.0 - p) - nu * left) / s) / (4.0 * PI * left * left * p);
    return forward + (1.0 - q) / (16.0 * PI * (back - 1.0) * q) * (3.0 * cosine * cosine - 1.0);
}

// Share of the light that is scattered by less than the angle of that cosine. The last term of the function above
// integrates to q sin^2 cos / 8.
SHARED real fournier_forand_within(real cosine, real n, real m) {
    real nu = 0.5 * (3.0 - m), s = max(0.5 - 0.5 * cosine, 1e-7), d = fournier_forand_delta(s, n);
    d = d > 0.999 && d < 1.001 ? 1.001 : d;
    real back = fournier_forand_delta(1.0, n), p = pow(d, nu), q = pow(back, nu);
    real within = (1.0 - d * p - (1.0 - p) * s) / ((1.0 - d) * p);
    return within + (1.0 - q) / (8.0 * (back - 1.0) * q) * cosine * (1.0 - cosine * cosine);
}

#endif
