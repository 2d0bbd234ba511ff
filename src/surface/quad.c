// SPDX-License-Identifier: MIT
// Two triangles for all the water; the waves are shaded in the pixels (Ma, Zhu & Gong 2006, section 2.1).
#include "surface/view_cone.h"

const uint32_t bolan_surface_quad_indices[6] = {0, 1, 2, 2, 1, 3};

void bolan_surface_quad(const bolan_surface_view *view, bolan_surface_vertex vertices[4]) {
    BOLAN_ASSERT(view != NULL && vertices != NULL);
    double above_water = view->eye.z - view->water_level;
    double horizon = bolan_surface_horizon_distance(fmax(fabs(above_water), 0.5), 0.0);
    double half =
        above_water > 0.0 ? 0.5 * horizon : horizon; // where the plane lies as far down as the round earth's horizon
    for (int k = 0; k < 4; ++k)
        vertices[k] = (bolan_surface_vertex){.x = (float)(k & 1 ? half : -half),
                                             .y = (float)(k & 2 ? half : -half),
                                             .z = (float)-above_water,
                                             .spacing = (float)(2.0 * half)};
}
