// SPDX-License-Identifier: MIT
// Moments of the wave exp(s cos th) (Liu & Xie 2010, with an additional sharpness s; the paper has s = 1):
//
//     eta = a (e^{s (cos th - 1)} - e^{-s} I0(s)) 2 / (1 - e^{-2s})                                                 (1)
//
// has zero mean and the range 2a. With e^{s cos th} = I0(s) + 2 sum In(s) cos n th (Abramowitz & Stegun 1964, 9.6.34)
// its moments are
//
//     mean of e^{s cos}                    I0(s)
//     variance                             I0(2s) - I0(s)^2                                                         (2)
//     variance of the slope over k^2       s^2 <sin^2 e^{2s cos}> = s I1(2s) / 2                                    (3)
//     third central moment                 I0(3s) - 3 I0(2s) I0(s) + 2 I0(s)^3                                      (4)
//     steepest, where cos th = (sqrt(1 + 4 s^2) - 1) / (2 s): s sin th e^{s cos th}                                 (5)
//
// and its second harmonic over the first, I2(s)/I1(s), is the k a / 2 of a second-order Stokes wave.
#ifndef BOLAN_WAVES_EXP_COSINE_H
#define BOLAN_WAVES_EXP_COSINE_H

#include "spectrum/portable.h"

#include <math.h>

// In(x) = sum (x/2)^{2m+n} / (m! (m+n)!) (Abramowitz & Stegun 9.6.10); exact to a double's last bits for 0 <= x <= 6.
static inline double exp_cosine_bessel(int n, double x) {
    double term = 1.0, sum = 0.0;
    for (int i = 1; i <= n; i++) term *= 0.5 * x / i;
    for (int m = 0; m < 40; m++) {
        sum += term;
        term *= 0.25 * x * x / ((m + 1.0) * (m + 1.0 + n));
    }
    return sum;
}

// Of e^{s cos th}: no normalisation.
static inline double exp_cosine_mean(double s) { return exp_cosine_bessel(0, s); }

static inline double exp_cosine_variance(double s) { // (2)
    const double mean = exp_cosine_mean(s);
    return exp_cosine_bessel(0, 2.0 * s) - mean * mean;
}

static inline double exp_cosine_slope_variance(double s) { return 0.5 * s * exp_cosine_bessel(1, 2.0 * s); } // (3)

static inline double exp_cosine_skewness(double s) { // (4)
    const double m = exp_cosine_mean(s), v = exp_cosine_variance(s);
    return (exp_cosine_bessel(0, 3.0 * s) - 3.0 * exp_cosine_bessel(0, 2.0 * s) * m + 2.0 * m * m * m) / (v * sqrt(v));
}

static inline double exp_cosine_steepest(double s) { // (5)
    const double c = (sqrt(1.0 + 4.0 * s * s) - 1.0) / (2.0 * s);
    return s * sqrt(1.0 - c * c) * portable_exp(s * c);
}

// k a of the Stokes wave with the same second harmonic.
static inline double exp_cosine_stokes_steepness(double s) {
    return 2.0 * exp_cosine_bessel(2, s) / exp_cosine_bessel(1, s);
}

// The factor 2 e^{-s} / (1 - e^{-2s}) = 1 / sinh s on e^{s cos th} - I0(s) that makes the range 2 (1).
static inline double exp_cosine_scale(double s) { return 2.0 / (portable_exp(s) - portable_exp(-s)); }

#endif
