// SPDX-License-Identifier: MIT
/// @file portable.h
/// Elementary functions from IEEE additions, products, quotients and roots alone, so that a sea state gives the same
/// bits on every machine: the system's libm picks fused kernels by processor. Relative error below 4e-16 * (1 +
/// |result's conditioning|), about as fast as libm, and inlined. Private to the library.
#ifndef BOLAN_SPECTRUM_PORTABLE_H
#define BOLAN_SPECTRUM_PORTABLE_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define PORTABLE_LN2 0.69314718055994530942
#define PORTABLE_LN10 2.30258509299404568402
#define PORTABLE_LN2_HIGH 6.93147180369123816490e-01 // ln 2 in 33 bits, so that n * high is exact
#define PORTABLE_LN2_LOW 1.90821492927058770002e-10

/// e^x; 0 below -708, capped at e^709.
static inline double portable_exp(double x) {
    if (!(x > -708.0)) return 0.0;
    if (x > 709.0) x = 709.0;
    const int n = (int)(x * 1.44269504088896340736 + (x < 0.0 ? -0.5 : 0.5));
    const double r = (x - n * PORTABLE_LN2_HIGH) - n * PORTABLE_LN2_LOW;
    // Taylor's series on |r| <= ln 2 / 2: the first term left out is 4e-18.
    double p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    const uint64_t bits = (uint64_t)(n + 1023) << 52;
    double scale;
    memcpy(&scale, &bits, sizeof scale);
    return p * scale;
}

/// ln x of a positive normal number.
static inline double portable_log(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    int e = (int)(bits >> 52) - 1023;
    bits = (bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL;
    double m;
    memcpy(&m, &bits, sizeof m);
    if (m > 1.41421356237309504880) {
        m *= 0.5;
        e += 1;
    }
    const double s = (m - 1.0) / (m + 1.0), z = s * s; // ln m = 2 atanh s, z <= 0.0295
    double p = 1.0 / 21.0;
    p = p * z + 1.0 / 19.0;
    p = p * z + 1.0 / 17.0;
    p = p * z + 1.0 / 15.0;
    p = p * z + 1.0 / 13.0;
    p = p * z + 1.0 / 11.0;
    p = p * z + 1.0 / 9.0;
    p = p * z + 1.0 / 7.0;
    p = p * z + 1.0 / 5.0;
    p = p * z + 1.0 / 3.0;
    p = p * z + 1.0;
    return e * PORTABLE_LN2_HIGH + (2.0 * s * p + e * PORTABLE_LN2_LOW);
}

/// x^y for x > 0.
static inline double portable_pow(double x, double y) { return portable_exp(y * portable_log(x)); }

/// tanh x for x >= 0, also to full relative precision near 0.
static inline double portable_tanh(double x) {
    if (x > 20.0) return 1.0;
    if (x < 0.5) { // Lambert's continued fraction
        const double z = x * x;
        return x / (1.0 + z / (3.0 + z / (5.0 + z / (7.0 + z / (9.0 + z / (11.0 + z / 13.0))))));
    }
    const double e = portable_exp(-2.0 * x);
    return (1.0 - e) / (1.0 + e);
}

/// The angle of (x, y) in [0, 2 pi); 0 at the origin.
static inline double portable_angle(double y, double x) {
    const double ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y;
    const double small = ax < ay ? ax : ay, large = ax < ay ? ay : ax;
    if (!(large > 0.0)) return 0.0;
    double t = small / large, angle = 0.0;
    if (t > 0.41421356237309504880) { // atan t = pi/4 + atan((t - 1) / (t + 1))
        t = (t - 1.0) / (t + 1.0);
        angle = 0.78539816339744830962;
    }
    const double z = t * t; // <= 0.1716
    static const double odd[10][2] = {
        {1.0 / 37, 1.0 / 39}, {1.0 / 33, 1.0 / 35}, {1.0 / 29, 1.0 / 31}, {1.0 / 25, 1.0 / 27}, {1.0 / 21, 1.0 / 23},
        {1.0 / 17, 1.0 / 19}, {1.0 / 13, 1.0 / 15}, {1.0 / 9, 1.0 / 11},  {1.0 / 5, 1.0 / 7},   {1.0 / 1, 1.0 / 3}};
    double p = 0.0;
    for (int i = 0; i < 10; i++) p = (p * z - odd[i][1]) * z + odd[i][0];
    angle += t * p;
    if (ay > ax) angle = 1.57079632679489661923 - angle;
    if (x < 0.0) angle = 3.14159265358979323846 - angle;
    if (y < 0.0) angle = 6.28318530717958647693 - angle;
    return angle < 6.28318530717958647693 ? angle : 0.0;
}

#endif
