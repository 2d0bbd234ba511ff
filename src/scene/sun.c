// SPDX-License-Identifier: MIT
// The position of the sun. Astronomical Almanac, "Low precision formulas for the Sun's coordinates", as in Michalsky,
// "The Astronomical Almanac's algorithm for approximate solar position (1950-2050)", Solar Energy 40 (1988) 227-235.
#include "bolan/scene.h"

void bolan_sun_position(double unix_time, double latitude, double longitude, double *azimuth, double *elevation) {
    const double days = unix_time / 86400.0 - 10957.5; // since J2000.0, noon of 2000-01-01
    const double mean_longitude = bolan_wrap_degrees(280.460 + 0.9856474 * days);
    const double anomaly = bolan_radians(bolan_wrap_degrees(357.528 + 0.9856003 * days));
    const double ecliptic_longitude = bolan_radians(mean_longitude + 1.915 * sin(anomaly) + 0.020 * sin(2.0 * anomaly));
    const double obliquity = bolan_radians(23.439 - 0.0000004 * days);

    const double right_ascension = atan2(cos(obliquity) * sin(ecliptic_longitude), cos(ecliptic_longitude));
    const double declination = asin(sin(obliquity) * sin(ecliptic_longitude));
    // Greenwich mean sidereal time: the almanac's 6.697375 h + 0.0657098242 h a day + the hour, in degrees.
    const double sidereal = bolan_wrap_degrees(280.46062 + 360.98564737 * days);
    const double hour_angle = bolan_radians(sidereal + longitude) - right_ascension;

    const double phi = bolan_radians(latitude);
    const double up = sin(phi) * sin(declination) + cos(phi) * cos(declination) * cos(hour_angle);
    const double east = -cos(declination) * sin(hour_angle);
    const double north = cos(phi) * sin(declination) - sin(phi) * cos(declination) * cos(hour_angle);
    *elevation = bolan_degrees(asin(fmin(fmax(up, -1.0), 1.0)));
    *azimuth = bolan_wrap_degrees(bolan_degrees(atan2(east, north)));
}
