// SPDX-License-Identifier: MIT
// The round earth: a sphere of mean water. All lengths [m], angles [rad]. An eye of height h stands over the point
// where the tangent plane touches; `radius` is the sphere's.
//
// The geometry of the water uses the parabola r^2 / 2R in place of the circle. At a level distance r the parabola lies
// r^4 / 8R^3 higher: 0.4 mm at 30 km, 3 cm at 90 km (the horizon of an eye 630 m up), 8 m at 357 km (10 km up).
#ifndef BOLAN_SHARED_EARTH
#define BOLAN_SHARED_EARTH
#include "shared/language.glsl"

// How far mean water lies below the tangent plane at a level distance whose square is given: the parabola.
SHARED real earth_drop(real distance2, real radius) { return distance2 / (2.0 * radius); }

// Like above, by the circle, R - sqrt(R^2 - r^2), written without cancellation; distance2 <= radius^2.
SHARED real earth_drop_exact(real distance2, real radius) {
    return distance2 / (radius + sqrt(max(radius * radius - distance2, 0.0)));
}

// Height over mean water of a point z above the eye's tangent plane, at a level distance whose square is given, to an
// eye h over the water.
SHARED real earth_height(real z, real h, real distance2, real radius) { return z + h + earth_drop(distance2, radius); }

// Level distance to the horizon of the parabola.
SHARED real earth_horizon(real h, real radius) { return sqrt(2.0 * radius * h); }

// Square of the radius at height h less that at height `shell`, as a product: in single precision the radius has an ulp
// of half a metre.
SHARED real earth_shell(real h, real shell, real radius) { return (h - shell) * (2.0 * radius + h + shell); }

// Straight distance from the eye to the horizon of the sphere.
SHARED real earth_horizon_exact(real h, real radius) { return sqrt(earth_shell(h, 0.0, radius)); }

// Height over the sphere after a straight way d from height h, along a direction whose cosine with the vertical is mu.
SHARED real earth_height_along(real h, real mu, real d, real radius) {
    real q = earth_shell(h, 0.0, radius) + d * (d + 2.0 * (radius + h) * mu);
    return q / (radius + sqrt(max(radius * radius + q, 0.0)));
}

// Straight distance at which that direction first meets the sphere; < 0: it passes over.
SHARED real earth_meets_exact(real h, real mu, real radius) {
    real b = (radius + h) * mu, c = earth_shell(h, 0.0, radius), q = b * b - c;
    return mu < 0.0 && q >= 0.0 ? c / (sqrt(q) - b) : -1.0;
}

// Tangent of the angle by which the horizon of the parabola lies below level.
SHARED real earth_dip(real h, real radius) { return sqrt(2.0 * h / radius); }

// Angle by which the horizon of the sphere lies below level: acos(R / (R + h)), well-conditioned.
SHARED real earth_dip_exact(real h, real radius) { return atan(earth_horizon_exact(h, radius) / radius); }

// Level distance at which a ray that sinks by `slope` for each metre meets the parabola; < 0: it passes over.
SHARED real earth_meets(real slope, real h, real radius) {
    real under = slope * slope - 2.0 * h / radius;
    return slope > 0.0 && under > 0.0 ? 2.0 * h / (slope + sqrt(under)) : -1.0;
}

#endif
