// SPDX-License-Identifier: MIT
// See sky_lattice.h.
#include "sky_lattice.h"

#include <math.h>

static double nearest(double x, double step) { return step * floor(x / step + 0.5); }

bolan_vec3 bolan_sky_lattice_direction(bolan_vec3 d, double step) {
    const double azimuth = nearest(atan2((double)d.y, (double)d.x), step);
    const double elevation = nearest(atan2((double)d.z, hypot((double)d.x, (double)d.y)), step);
    return bolan_v3((float)(cos(azimuth) * cos(elevation)), (float)(sin(azimuth) * cos(elevation)),
                    (float)sin(elevation));
}

double bolan_sky_lattice_height(double height) {
    const double even = 25.0, growth = log(1.02);
    if (height <= even) return nearest(fmax(height, 0.0), 0.5);
    return even * exp(nearest(log(height / even), growth));
}

bolan_dvec3 bolan_sky_lattice_point(bolan_dvec3 p, double step) {
    return bolan_dv3(nearest(p.x, step), nearest(p.y, step), nearest(p.z, step));
}
