// SPDX-License-Identifier: MIT
// The projected grid: vertices at constant angular steps seen from the eye, so that the cost does not depend on how far the
// sea reaches (the idea of Johanson 2004). The projector here is always level and stands at the eye's own vertical: columns
// are azimuths and rows are distances on the round earth. It cannot degenerate when the camera pitches or rolls, its rows
// do not move when the camera turns, and a wave that leans into the picture from outside is covered by a guard that widens
// towards the eye:
//
//        \    far rows: the azimuths of     /         half(r) = half + (pi - half) * min(1, (1.5 H / r)^1.5)
//         \   the picture                  /
//          \__                          __/           H = horizontal bound of the displacement: below 1.5 H the rows
//             \__        eye         __/              close to full circles
//                 (      o        )
#include "surface/picture.h"

#define PROBES 9 // directions tried along each axis of the picture

// What the picture can see of the water, in polar terms.
typedef struct polar_bounds {
    bool any;
    double half;          // azimuths are heading +- half [rad]
    double near_distance; // [m]
    double far_distance;  // [m]
} polar_bounds;

const char *const bolan_surface_kind_names[BOLAN_SURFACE_KINDS + 1] = {"projected", "nested", "quad", NULL};

bolan_surface_desc bolan_surface_desc_default(void) {
    return (bolan_surface_desc){.kind = BOLAN_SURFACE_PROJECTED, .pixels_per_vertex = 3.0, .max_vertices = 200000};
}

static polar_bounds find_bounds(const bolan_surface_view *v, double height) {
    double radius = BOLAN_EARTH_RADIUS;
    polar_bounds b = {.far_distance = surface_horizon_distance(fmax(height, 0.0), v->vertical) + 10.0};
    double lowest = 1e9;
    for (int j = 0; j < PROBES; ++j)
        for (int i = 0; i < PROBES; ++i) {
            bolan_dvec3 d = surface_picture_direction(v, 2.0 * i / (PROBES - 1) - 1.0, 2.0 * j / (PROBES - 1) - 1.0);
            b.half = fmax(b.half, fabs(atan2(d.x, d.y)));
            lowest = fmin(lowest, atan2(d.z, hypot(d.x, d.y)));
        }
    b.half += SURFACE_GUARD_ANGLE;
    if (surface_sees_nadir(v)) {
        b.half = BOLAN_PI;
        lowest = -0.5 * BOLAN_PI;
    }
    b.half = fmin(b.half, BOLAN_PI);
    double above = height - v->vertical; // of the eye over the highest crest
    double dip = above > 0.0 ? acos(radius / (radius + above)) : 0.0;
    b.any = above <= 0.0 || lowest < -dip + 1e-4;
    if (above > 0.0 && lowest < 0.0) b.near_distance = fmax(0.0, above / tan(-lowest) - 1.5 * v->horizontal);
    if (above > 0.0 && lowest >= 0.0) b.near_distance = sqrt(2.0 * radius * above) * 0.5;
    b.near_distance = fmin(b.near_distance, 0.5 * b.far_distance);
    return b;
}

// Radial step at distance r: one vertex per `angle` as seen from the eye, but never longer than a fixed share of the
// distance, so that crests keep their outline near the horizon where an angular step covers a hundred metres.
static double radial_step(double r, double height, double angle) {
    double seen = angle * (height * height + r * r) / height;
    return fmin(seen, fmax(7.0 * angle * r, angle * height));
}

static uint32_t count_rows(const polar_bounds *b, double height, double angle) {
    uint32_t rows = 1;
    for (double r = b->near_distance; r < b->far_distance && rows < 100000; ++rows) r += radial_step(r, height, angle);
    return rows;
}

static double half_at(const polar_bounds *b, double r, double horizontal) {
    double share = r > 1.5 * horizontal ? pow(1.5 * horizontal / r, 1.5) : 1.0;
    return b->half + (BOLAN_PI - b->half) * share;
}

static void fill_row(bolan_surface_vertex *out, uint32_t columns, double centre, double half, double r, double z,
                     double radial) {
    for (uint32_t i = 0; i < columns; ++i) {
        double azimuth = centre + half * (2.0 * i / (columns - 1) - 1.0);
        out[i].x = (float)(r * sin(azimuth));
        out[i].y = (float)(r * cos(azimuth));
        out[i].z = (float)z;
        out[i].spacing = (float)fmax(radial, r * 2.0 * half / (columns - 1));
        out[i].stitch_x = out[i].stitch_y = 0.0f;
    }
}

bolan_surface_size bolan_surface_projected(const bolan_surface_desc *desc, const bolan_surface_view *view,
                                           bolan_surface_vertex *vertices) {
    BOLAN_ASSERT(desc != NULL && view != NULL && vertices != NULL && desc->max_vertices >= 1024);
    double above_water = view->eye.z - view->water_level;
    double height = fmax(fabs(above_water), 0.5); // the angular steps must not vanish at the surface
    polar_bounds b = find_bounds(view, fmax(above_water, 0.5));
    if (!b.any) return (bolan_surface_size){0, 0};
    double angle = view->fov_y / view->pixel_height * desc->pixels_per_vertex;
    uint32_t rows, columns;
    for (;; angle *= 1.15) { // coarser until it fits
        rows = count_rows(&b, height, angle);
        columns = (uint32_t)ceil(2.0 * b.half / angle) + 2;
        if ((uint64_t)rows * columns <= desc->max_vertices) break;
    }
    double step = 2.0 * b.half / (columns - 1);
    double heading = bolan_radians(view->heading_deg);
    double centre = floor(heading / step + 0.5) * step; // azimuths stay put when the camera turns
    double r = b.near_distance;
    for (uint32_t j = 0; j < rows; ++j) {
        double radial = radial_step(r, height, angle);
        double z = -above_water - r * r / (2.0 * BOLAN_EARTH_RADIUS);
        fill_row(vertices + (size_t)j * columns, columns, centre, half_at(&b, r, view->horizontal), r, z, radial);
        r = fmin(r + radial, b.far_distance);
    }
    return (bolan_surface_size){columns, rows};
}

uint32_t bolan_surface_grid_indices(bolan_surface_size size, uint32_t *out) {
    if (size.columns < 2 || size.rows < 2) return 0;
    uint32_t n = 0;
    for (uint32_t j = 0; j + 1 < size.rows; ++j)
        for (uint32_t i = 0; i + 1 < size.columns; ++i, n += 6) {
            if (out == NULL) continue;
            uint32_t a = j * size.columns + i, b = a + size.columns; // a is nearer than b; +1 is clockwise
            out[n] = a, out[n + 1] = a + 1, out[n + 2] = b;
            out[n + 3] = b, out[n + 4] = a + 1, out[n + 5] = b + 1;
        }
    return n;
}
