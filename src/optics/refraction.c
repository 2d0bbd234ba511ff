// SPDX-License-Identifier: MIT
// Mirrors and raised bottoms: Ma, Zhu & Gong 2006, section 2.2. Twin: shaders/common/refraction.glsl.
#include "bolan/optics.h"

#include <math.h>

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

// Tangent t of the angle in the air: h t + d t / sqrt(n^2 + (n^2 - 1) t^2) = D. The left side is concave, so Newton's steps from
// a start that is too small never overshoot; both bounds of it are such starts.
static double tangent_in_air(double height, double depth, double distance, double index) {
    const double n2 = index * index, m2 = n2 - 1.0;
    double t = fmax(distance / (height + depth / index), (distance - depth / sqrt(m2)) / height);
    for (int i = 0; i < 12; i++) {
        const double q = n2 + m2 * t * t, r = sqrt(q);
        t += (distance - height * t - depth * t / r) / (height + depth * n2 / (q * r));
    }
    return t;
}

double bolan_refraction_crossing(double height, double depth, double distance, double index) {
    BOLAN_ASSERT(height > 0.0 && depth >= 0.0 && distance >= 0.0 && index > 1.0);
    return height * tangent_in_air(height, depth, distance, index);
}

double bolan_apparent_depth(double height, double depth, double distance, double index) {
    BOLAN_ASSERT(height > 0.0 && depth >= 0.0 && distance >= 0.0 && index > 1.0);
    const double t = tangent_in_air(height, depth, distance, index), n2 = index * index;
    return depth / sqrt(n2 + (n2 - 1.0) * t * t); // eq. 7 by the tangent
}
