// SPDX-License-Identifier: MIT
// Angles, compass directions, and the reproducible sine and cosine as functions.
#include "bolan/math.h"
#include "math/sincos.h"

double bolan_wrap_degrees(double degrees) {
    double wrapped = fmod(degrees, 360.0); // exact
    if (wrapped < 0.0) wrapped += 360.0;
    return wrapped < 360.0 ? wrapped : 0.0; // -1e-30 + 360 rounds to 360
}

double bolan_compass_from_to_math(double from_degrees) {
    // It goes to FROM + 180, and the mathematical angle is 90 less the compass.
    const double to = bolan_radians(bolan_wrap_degrees(270.0 - from_degrees));
    return to < 2.0 * BOLAN_PI ? to : 0.0;
}

double bolan_math_to_compass_from(double to_radians) { return bolan_wrap_degrees(270.0 - bolan_degrees(to_radians)); }

void bolan_sincos(double x, double *sine, double *cosine) { bolan_sincos_inline(x, sine, cosine); }

void bolan_sincosf(float x, float *sine, float *cosine) { bolan_sincosf_inline(x, sine, cosine); }
