// SPDX-License-Identifier: MIT
// Tables of the sky and maps of the clouds are kept while the eye and the sun hardly move. They are made for the
// nearest place of a lattice, not for where the eye was when they were made: so a picture depends on its inputs alone.
#ifndef BOLAN_RENDER_SKY_LATTICE_H
#define BOLAN_RENDER_SKY_LATTICE_H

#include "bolan/math.h"

// Unit direction whose azimuth and elevation are the multiples of @p step [rad] nearest to those of @p direction.
bolan_vec3 bolan_sky_lattice_direction(bolan_vec3 direction, double step);
// Height [m] that tables of the air are made for: multiples of half a metre up to 25 m, then steps of 2 %. Below 0: 0.
double bolan_sky_lattice_height(double height);
// Nearest point of a cubic lattice.
bolan_dvec3 bolan_sky_lattice_point(bolan_dvec3 point, double step);

#endif
