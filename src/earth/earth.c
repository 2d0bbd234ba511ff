// SPDX-License-Identifier: MIT
// The public functions of the round earth: shaders/shared/earth.glsl with the radius of the earth. Hot loops of the
// library include that file directly.
#include "bolan/earth.h"

#include "shared/earth.glsl"

#define R BOLAN_EARTH_RADIUS

double bolan_earth_drop(double r) { return earth_drop(r * r, R); }

double bolan_earth_drop_exact(double r) { return earth_drop_exact(min(r * r, R * R), R); }

double bolan_earth_horizon(double h) { return earth_horizon(h, R); }

double bolan_earth_horizon_exact(double h) { return earth_horizon_exact(h, R); }

double bolan_earth_dip(double h) { return earth_dip(h, R); }

double bolan_earth_dip_exact(double h) { return earth_dip_exact(h, R); }

double bolan_earth_meets(double slope, double h) {
    const double distance = earth_meets(slope, h, R);
    return distance >= 0.0 ? distance : HUGE_VAL;
}

static double squared(double x) { return x * x; }

double bolan_earth_distance(double longitude_a, double latitude_a, double longitude_b, double latitude_b) {
    const double half_y = sin(0.5 * bolan_radians(latitude_b - latitude_a));
    const double half_x = sin(0.5 * bolan_radians(longitude_b - longitude_a));
    const double cosines = cos(bolan_radians(latitude_a)) * cos(bolan_radians(latitude_b));
    return 2.0 * R * asin(sqrt(min(squared(half_y) + cosines * squared(half_x), 1.0)));
}
