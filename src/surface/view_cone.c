// SPDX-License-Identifier: MIT
#include "surface/view_cone.h"

#include "shared/earth.glsl"

// Sine and cosine of the library, so that the geometry is the same on every machine.
static double tangent_of(double angle) {
    double s, c;
    bolan_sincos(angle, &s, &c);
    return s / c;
}

bolan_dvec3 bolan_surface_view_direction(const bolan_surface_view *v, double sx, double sy) {
    double tangent = tangent_of(0.5 * v->fov_y);
    double x = (sx + v->shift_x) * tangent * v->aspect, y = (sy + v->shift_y) * tangent;
    double sr, cr, sp, cp;
    bolan_sincos(bolan_radians(v->roll_deg), &sr, &cr);
    bolan_sincos(bolan_radians(v->pitch_deg), &sp, &cp);
    double xr = x * cr + y * sr, yr = -x * sr + y * cr;
    double length = sqrt(x * x + y * y + 1.0);
    return bolan_dv3(xr / length, (cp - yr * sp) / length, (sp + yr * cp) / length);
}

bool bolan_surface_sees_nadir(const bolan_surface_view *v) {
    double sr, cr, sp, cp;
    bolan_sincos(bolan_radians(v->roll_deg), &sr, &cr);
    bolan_sincos(bolan_radians(v->pitch_deg), &sp, &cp);
    double forward = -sp, up = -cp; // of (0, 0, -1) in the unrolled camera
    if (forward <= 0.0) return false;
    double x = -up * sr / forward, y = up * cr / forward;
    double tangent = tangent_of(0.5 * v->fov_y), wide = tangent + SURFACE_GUARD_ANGLE;
    x -= v->shift_x * tangent * v->aspect, y -= v->shift_y * tangent;
    return fabs(x) <= wide * v->aspect + SURFACE_GUARD_ANGLE && fabs(y) <= wide;
}

double bolan_surface_horizon_distance(double h, double crest) {
    return earth_horizon(h, BOLAN_EARTH_RADIUS) + earth_horizon(crest, BOLAN_EARTH_RADIUS);
}
