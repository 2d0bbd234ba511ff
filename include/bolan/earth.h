// SPDX-License-Identifier: MIT
/// @file earth.h
/// Tier 0. The round earth: a sphere of mean water.
/// Every function is pure and thread-safe.
/// Lengths are in metres; angles are in radians unless a comment says otherwise.
///
/// @code
///      eye                        h     height of the eye over mean water
///       |.` - _  dip              dip   how far the horizon lies below level
///     h |   ` .   ` - _           r     level distance in the plane that touches the water below the eye
///  -----+-------`-.-----------    drop  how far mean water lies below that plane at r
///       `  - _      `  . | drop
///               ` - _    |`.      horizon
/// @endcode
/// Bolan draws and queries the water on the parabola r^2 / 2R, which needs no square root and keeps its digits in
/// single precision. The functions named `_exact` have the sphere. The parabola lies r^4 / 8R^3 above the sphere: 0.4
/// mm at 30 km, 3 cm at 90 km, 8 m at 357 km (the horizon of an eye 10 km up).
#ifndef BOLAN_EARTH_H
#define BOLAN_EARTH_H

#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Mean radius R of the earth [m].
#define BOLAN_EARTH_RADIUS 6371000.0

/// Returns the depth of mean water below the tangent plane at level distance @p r, by the parabola r^2 / 2R.
BOLAN_API double bolan_earth_drop(double r);
/// Like bolan_earth_drop(), by the sphere: R - sqrt(R^2 - r^2).
/// |r| beyond R counts as R.
BOLAN_API double bolan_earth_drop_exact(double r);

/// Returns the level distance to the horizon of the parabola from height @p h >= 0: sqrt(2 R h).
BOLAN_API double bolan_earth_horizon(double h);
/// Returns the straight distance from height @p h >= 0 to the horizon of the sphere: sqrt(h (2 R + h)).
BOLAN_API double bolan_earth_horizon_exact(double h);

/// Returns the dip of the parabola's horizon seen from height @p h >= 0, as a tangent: sqrt(2 h / R).
BOLAN_API double bolan_earth_dip(double h);
/// Returns the dip of the sphere's horizon seen from height @p h >= 0, as an angle: acos(R / (R + h)).
BOLAN_API double bolan_earth_dip_exact(double h);

/// Returns the level distance at which a ray from height @p h >= 0 meets the parabola.
/// Returns HUGE_VAL where the ray passes over the horizon.
/// @param slope tangent of the angle of the ray below level.
BOLAN_API double bolan_earth_meets(double slope, double h);

/// Returns the distance along the great circle between two places on the sphere, by the haversine formula.
/// Longitudes and latitudes are in degrees.
BOLAN_API double bolan_earth_distance(double longitude_a, double latitude_a, double longitude_b, double latitude_b);

#ifdef __cplusplus
}
#endif
#endif
