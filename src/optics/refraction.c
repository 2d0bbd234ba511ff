// SPDX-License-Identifier: MIT
// Reflection and apparent depth: Ma, Zhu & Gong 2006, section 2.2. Path of least time: shaders/shared/refraction.glsl.
#include "bolan/optics.h"

#define REFRACTION_STEPS 12 // to a double's rounding
#include "shared/refraction.glsl"

bolan_vec3 bolan_reflect(bolan_vec3 i, bolan_vec3 n) {
    // eq. 1 is printed 2 N (N.I) + I, which lengthens the vector; with I towards the surface the law is I - 2 N (N.I)
    return bolan_v3_sub(i, bolan_v3_scale(n, 2.0f * bolan_v3_dot(n, i)));
}

double bolan_refraction_k(double theta, double index) {
    const double s = sin(theta);
    return sqrt(fmax(1.0 - s * s, 0.0) / (index * index - s * s)); // eq. 7, its four factors multiplied out
}

double bolan_refraction_k_paper(double theta) {
    return theta <= 0.8 ? 0.75 - 0.16 * theta : 1.26 - 0.8 * theta; // eq. 8
}

double bolan_refraction_crossing(double height, double depth, double distance, double index) {
    BOLAN_ASSERT(height > 0.0 && depth >= 0.0 && distance >= 0.0 && index > 1.0);
    return height * refraction_tangent(height, depth, distance, index);
}

double bolan_apparent_depth(double height, double depth, double distance, double index) {
    BOLAN_ASSERT(height > 0.0 && depth >= 0.0 && distance >= 0.0 && index > 1.0);
    return depth * refraction_k(refraction_tangent(height, depth, distance, index), index);
}
