// SPDX-License-Identifier: MIT
// Linear dispersion of gravity-capillary waves over a flat bottom:  w^2 = (g k + (sigma/rho) k^3) tanh(k h).
// First guess for the inverse: J. Guo, "Simple and explicit solution of wave dispersion equation", Coastal Engineering
// 45 (2002), eq. 13.
#include "bolan/math.h"
#include "bolan/spectrum.h"
#include "spectrum/portable.h"

double bolan_omega_from_k(double k, double depth) {
    const double stiffness = BOLAN_GRAVITY * k + BOLAN_SURFACE_TENSION_SEA * k * k * k;
    return sqrt(stiffness * portable_tanh(k * depth));
}

// d(w^2)/dk
static double squared_slope(double k, double depth) {
    const double tension = BOLAN_SURFACE_TENSION_SEA * k * k, t = portable_tanh(k * depth);
    return (BOLAN_GRAVITY + 3.0 * tension) * t + (BOLAN_GRAVITY + tension) * k * depth * (1.0 - t * t);
}

static double first_guess(double omega, double depth) {
    const double x = omega * sqrt(depth / BOLAN_GRAVITY);
    // The shallow limit kh = x, where the general form would divide by a rounded zero.
    const double kh = x < 1e-3 ? x : x * x * portable_pow(1.0 - portable_exp(-x * x * sqrt(x)), -0.4);
    const double gravity = kh / depth;
    const double capillary = portable_pow(omega * omega / BOLAN_SURFACE_TENSION_SEA, 1.0 / 3.0);
    return gravity < capillary ? gravity : capillary; // either force alone needs a larger k than both together
}

double bolan_k_from_omega(double omega, double depth) {
    if (!(omega > 0.0)) return 0.0;
    double k = first_guess(omega, depth);
    // w^2(k) is convex and increasing, so Newton's steps fall monotonically to the root after at most one step up.
    for (int i = 0; i < 40; i++) {
        const double w = bolan_omega_from_k(k, depth);
        const double step = (w * w - omega * omega) / squared_slope(k, depth);
        k -= step;
        if (fabs(step) < 1e-14 * k) break;
    }
    return k;
}

double bolan_group_speed(double k, double depth) {
    return squared_slope(k, depth) / (2.0 * bolan_omega_from_k(k, depth));
}
