// SPDX-License-Identifier: MIT
// The standard normal distribution.
#ifndef BOLAN_SHARED_NORMAL
#define BOLAN_SHARED_NORMAL
#include "shared/language.glsl"

SHARED real normal_pdf(real x) { return 0.39894228 * exp(-0.5 * x * x); }

// What lies above x >= 0, over the density there: Mills' ratio, to 6e-3 (Abramowitz & Stegun 26.2.16).
SHARED real normal_mills(real x) {
    real t = 1.0 / (1.0 + 0.33267 * x);
    return t * (0.4361836 + t * (-0.1201676 + t * 0.9372980));
}

// Distribution function to 1.2e-5; for x < 0 the error is also below 6e-3 of the density, which is `pdf`, and from -1.5
// on below 6e-5 of it (Abramowitz & Stegun 26.2.16).
SHARED real normal_below(real x, real pdf) {
    real tail = pdf * normal_mills(max(x, -x));
    return x < 0.0 ? tail : 1.0 - tail;
}

// Fast: to 2e-4, one exponential (the logistic form of tanh(sqrt(2/pi) (x + 0.044715 x^3))).
SHARED real normal_cdf(real x) {
    real t = clamp(x, -9.0, 9.0);
    return 1.0 / (1.0 + exp(-1.59576912 * (t + 0.044715 * t * t * t)));
}

// Fastest: the tangent at 0, cut at 0 and 1; to 0.11. x is a difference over the square root of `variance`.
SHARED real normal_cdf_linear(real difference, real variance) {
    return clamp(0.5 + difference * inversesqrt(6.28318531 * variance), 0.0, 1.0);
}

#endif
