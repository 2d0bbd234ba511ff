// SPDX-License-Identifier: MIT
// See nested_levels.h.
#include "render/papers/nested_levels.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#include <math.h>

enum { CELLS = 32, LEVELS = 6 };

// 6 levels of 32 cells that are fine near the eye and end three pixels below the horizon.
static bolan_nested_desc levels(const bolan_surface_view *view) {
    const double height = fmax(fabs(view->eye.z - view->water_level), 1.0);
    const double dip = earth_dip(height, BOLAN_EARTH_RADIUS), pixels = 3.0 * view->fov_y / view->pixel_height;
    return (bolan_nested_desc){CELLS, LEVELS, height / (dip + pixels) / (CELLS / 2)};
}

static void keep_choice(water_mesh *m, const bolan_surface_view *view) { (void)m, (void)view; }

// Figure 5 shows which vertices get waves: it takes a narrower view for the choice than for the image.
static void narrow_choice(water_mesh *m, const bolan_surface_view *view) {
    bolan_surface_view narrow = *view;
    narrow.fov_y *= 0.5;
    bolan_surface_nested_vertices(&m->placed, &narrow, NULL, NULL, m->cpu_visible);
}

// Normals: means over the triangles round each vertex, as slopes.
static void average_normals(water_mesh *m, uint32_t count) {
    bolan_vec3 *positions = (bolan_vec3 *)(void *)m->cpu_rest,
               *normals = positions + count; // free by now, and large enough
    BOLAN_ASSERT(2 * sizeof(bolan_vec3) * count <= sizeof *m->cpu_rest * m->capacity);
    for (uint32_t i = 0; i < count; ++i)
        positions[i] = bolan_v3(m->cpu_vertices[i].x + m->cpu_waves[i].dx, m->cpu_vertices[i].y + m->cpu_waves[i].dy,
                                m->cpu_vertices[i].z + m->cpu_waves[i].height);
    bolan_surface_nested_normals(&m->placed, positions, normals);
    for (uint32_t i = 0; i < count; ++i) {
        m->cpu_waves[i].slope_x = -normals[i].x / fmaxf(normals[i].z, 0.05f);
        m->cpu_waves[i].slope_y = -normals[i].y / fmaxf(normals[i].z, 0.05f);
    }
}

static const mesh_rules rules = {.levels = levels, .choose = keep_choice, .slopes = average_normals};
static const mesh_rules figure = {.levels = levels, .choose = narrow_choice, .slopes = average_normals};

const mesh_rules *bolan_paper_nested_levels(const bolan_look *look) {
    if (!look->paper) return NULL;
    return look->show == BOLAN_SHOW_MESH ? &figure : &rules;
}
