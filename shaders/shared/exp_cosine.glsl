// SPDX-License-Identifier: MIT
// The wave exp(s (cos th - 1)) of Liu & Xie 2010 by the sine and cosine of half its phase: cos th - 1 = -2 sin^2(th /
// 2), so that nothing cancels at the crest. src/waves/sum/exp_cosine.h has its moments, and the factor that makes its
// range 2.
#ifndef BOLAN_SHARED_EXP_COSINE
#define BOLAN_SHARED_EXP_COSINE
#include "shared/language.glsl"

SHARED real within_half_a_turn(real turns) { return turns - floor(turns + 0.5); }

// Sine and cosine of half of a phase of x turns, |x| <= 1/2, to 4e-6: Taylor's series of pi x, the last coefficient
// moved towards the next term.
SHARED real half_sine(real x) {
    real x2 = x * x;
    return x * (3.14159265 + x2 * (-5.16771278 + x2 * (2.55016404 + x2 * (-0.59926453 + x2 * 0.08041384))));
}
SHARED real half_cosine(real x) {
    real x2 = x * x;
    return 1.0 + x2 * (-4.93480220 + x2 * (4.05871213 + x2 * (-1.33526277 + x2 * 0.22931763)));
}

// exp(s (cos th - 1)) 2^faded, `sine` being sin(th / 2).
SHARED real exp_cosine(real sharpness, real sine, real faded) {
    return exp2(sharpness * -2.88539008 * sine * sine + faded); // 2 / ln 2
}

// Its derivative by th: -s sin th times it.
SHARED real exp_cosine_slope(real sharpness, real sine, real cosine, real faded) {
    return -2.0 * sharpness * sine * cosine * exp_cosine(sharpness, sine, faded);
}

#endif
