// SPDX-License-Identifier: MIT
// The directions that a view covers, in axes x right of the heading, y along the heading, z up.
#ifndef BOLAN_SURFACE_PICTURE_H
#define BOLAN_SURFACE_PICTURE_H

#include "bolan/earth.h"
#include "bolan/surface.h"

#define SURFACE_GUARD_ANGLE 0.02 // [rad] beyond the picture's edge

// Unit direction through the picture; sx (right) and sy (up) in [-1, 1] reach its edges.
bolan_dvec3 bolan_surface_view_direction(const bolan_surface_view *v, double sx, double sy);
// True when the point straight below lies in the picture (with the guard).
bool bolan_surface_sees_nadir(const bolan_surface_view *v);
// Distance [m] over mean water from the point under an eye at height h to its horizon, where crests of height `crest`
// show behind it.
double bolan_surface_horizon_distance(double h, double crest);

#endif
