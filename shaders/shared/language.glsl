// SPDX-License-Identifier: MIT
// The language of shaders/shared/: the subset that is both C17 and GLSL. Each file there is included by shaders and by
// C sources alike ("shared/fresnel.glsl"), so that a formula or constant stands once.
//
//   real            float in a shader, double in C: the CPU's value is the specification, the shader's its rounding
//   float, 1.0f     single precision in both, where C must round as the shader does
//   SHARED          before each function; STRUCT(name) before each struct
//   constants       macros, since an array size or #if needs them in both languages
//
// Scalars and structs of scalars alone: no vectors, swizzles, overloads, out parameters, or abs() (of integers in C).
// A function may use sqrt exp exp2 log log2 sin cos tan atan pow floor, and what stands below for C.
#ifndef BOLAN_SHARED_LANGUAGE
#define BOLAN_SHARED_LANGUAGE

#ifdef __STDC_VERSION__
#include <math.h>
#include <stdbool.h>

#define SHARED static inline
#define STRUCT(name) typedef struct name name;
typedef double real;

SHARED real min(real a, real b) { return b < a ? b : a; }
SHARED real max(real a, real b) { return a < b ? b : a; }
SHARED real clamp(real x, real low, real high) { return min(max(x, low), high); }
SHARED real mix(real a, real b, real share) { return a * (1.0 - share) + b * share; }
SHARED real fract(real x) { return x - floor(x); }
SHARED real inversesqrt(real x) { return 1.0 / sqrt(x); }
SHARED real smoothstep(real from, real to, real x) {
    real t = clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
#else
#define SHARED
#define STRUCT(name)
#define real float
#endif

#endif
