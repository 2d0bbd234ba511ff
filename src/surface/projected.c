// SPDX-License-Identifier: MIT
// The projected grid: vertices at constant angular steps seen from the eye, so that the cost does not depend on how far
// the sea reaches (the idea of Johanson 2004). The projector here is always level and stands at the eye's own vertical:
// columns are azimuths and rows are distances on the round earth. It cannot degenerate when the camera pitches or
// rolls, its rows do not move when the camera turns, and a wave that leans into the picture from outside is covered by
// a guard that widens towards the eye:
//
//        \    far rows: the azimuths of     /         half(r) = half + (pi - half) * min(1, (1.5 H / r)^1.5)
//         \   the picture                  /
//          \__                          __/           H = horizontal bound of the displacement: below 1.5 H the rows
//             \__        eye         __/              close to full circles
//                 (      o        )
#include "surface/view_cone.h"

#include "shared/earth.glsl"
#include "shared/grid.glsl"

#define PROBES 9 // directions tried along each axis of the picture
#define STEEP_UP 1.0 // [rad] of a picture that rises higher, from within the water, the probes miss azimuths

// The visible part of the water in polar coordinates.
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

// Distance [m] at which a ray that sinks by `slope` meets a round earth `height` below; HUGE_VAL where it passes over.
static double meets_water(double slope, double height) {
    const double distance = earth_meets(slope, height, BOLAN_EARTH_RADIUS);
    return distance >= 0.0 ? distance : HUGE_VAL;
}

static polar_bounds find_bounds(const bolan_surface_view *v, double height) {
    polar_bounds b = {.far_distance = bolan_surface_horizon_distance(fmax(fabs(height), 0.5), v->vertical) + 10.0};
    double lowest = 1e9, highest = -1e9; // elevation angles in the picture
    for (int j = 0; j < PROBES; ++j)
        for (int i = 0; i < PROBES; ++i) {
            bolan_dvec3 d = bolan_surface_view_direction(v, 2.0 * i / (PROBES - 1) - 1.0, 2.0 * j / (PROBES - 1) - 1.0);
            b.half = fmax(b.half, fabs(atan2(d.x, d.y)));
            const double elevation = atan2(d.z, hypot(d.x, d.y));
            lowest = fmin(lowest, elevation);
            highest = fmax(highest, elevation);
        }
    b.half += SURFACE_GUARD_ANGLE;
    if (bolan_surface_sees_nadir(v)) {
        b.half = BOLAN_PI;
        lowest = -0.5 * BOLAN_PI;
    }
    if (height < 0.0 && highest > STEEP_UP) b.half = BOLAN_PI; // the surface stands overhead
    b.half = fmin(b.half, BOLAN_PI);
    double above = height - v->vertical; // of the eye over the highest crest
    double dip = above > 0.0 ? earth_dip_exact(above, BOLAN_EARTH_RADIUS) : 0.0;
    b.any = above <= 0.0 || lowest < -dip + 1e-4;
    if (above > 0.0 && lowest < 0.0) b.near_distance = fmax(0.0, above / tan(-lowest) - 1.5 * v->horizontal);
    if (above > 0.0 && lowest >= 0.0) b.near_distance = 0.5 * earth_horizon(above, BOLAN_EARTH_RADIUS);
    // where the whole picture lies below the horizon: to its upper edge, seen down to the deepest trough
    const double edge = highest + SURFACE_GUARD_ANGLE, deep = height + v->vertical;
    if (edge < -0.01 && height > 0.0)
        b.far_distance = fmin(b.far_distance, meets_water(tan(-edge), deep) + 1.5 * v->horizontal + 10.0);
    b.near_distance = fmin(b.near_distance, 0.5 * b.far_distance);
    return b;
}

bolan_surface_projector bolan_surface_projector_of(const bolan_surface_view *view) {
    BOLAN_ASSERT(view != NULL);
    const double above = view->eye.z - view->water_level;
    const polar_bounds b = find_bounds(view, above < 0.0 ? above : fmax(above, 0.5));
    bolan_surface_projector p = {.visible = b.any, .above = above};
    p.height = fmax(fabs(above), 0.5); // the angular steps must not vanish at the surface
    p.near_parameter = grid_parameter(b.near_distance / p.height);
    p.range = grid_parameter(b.far_distance / p.height) - p.near_parameter;
    p.heading = bolan_radians(view->heading_deg);
    p.half = b.half;
    p.guard = 1.5 * view->horizontal;
    return p;
}

// Azimuths stay put when the camera turns.
static double snapped(double heading, double half, uint32_t columns) {
    const double step = 2.0 * half / (columns - 1);
    return floor(heading / step + 0.5) * step;
}

// Columns that are snapped reach up to half a step less far to one side: where that and a pixel are more than the
// guard, so much more [rad].
static double beyond_guard(double step, double pixel) { return fmax(0.5 * step + pixel - SURFACE_GUARD_ANGLE, 0.0); }

// Azimuths at even steps, each turned from the one before: an error of 1e-16 each, and no sine for each vertex.
static void fill_row(bolan_surface_vertex *out, uint32_t columns, double centre, double half, double r, double z,
                     double radial) {
    const double step = 2.0 * half / (columns - 1), c = cos(step), s = sin(step);
    double x = r * sin(centre - half), y = r * cos(centre - half);
    for (uint32_t i = 0; i < columns; ++i) {
        out[i] = (bolan_surface_vertex){
            .x = (float)x, .y = (float)y, .z = (float)z, .spacing = (float)fmax(radial, r * step)};
        const double turned = x * c + y * s;
        y = y * c - x * s;
        x = turned;
    }
}

void bolan_surface_projector_vertices(const bolan_surface_projector *p, bolan_surface_size size,
                                      bolan_surface_vertex *vertices) {
    BOLAN_ASSERT(p != NULL && vertices != NULL && size.columns >= 2 && size.rows >= 2);
    const double centre = snapped(p->heading, p->half, size.columns), step = p->range / (size.rows - 1);
    for (uint32_t j = 0; j < size.rows; ++j) {
        const double x = grid_distance(p->near_parameter + j * step), r = p->height * x;
        const double z = -p->above - earth_drop(r * r, BOLAN_EARTH_RADIUS);
        fill_row(vertices + (size_t)j * size.columns, size.columns, centre, grid_half_angle(p->half, p->guard, r), r, z,
                 p->height * grid_steepness(x) * step);
    }
}

void bolan_surface_projector_uniforms(const bolan_surface_projector *p, bolan_surface_size size, float out[8]) {
    out[0] = (float)p->near_parameter;
    out[1] = (float)p->range;
    out[2] = (float)p->height;
    out[3] = (float)p->above;
    const double centre = snapped(p->heading, p->half, size.columns);
    out[4] = (float)remainder(centre, 2.0 * BOLAN_PI);
    out[5] = (float)p->half;
    out[6] = (float)p->guard;
    out[7] = (float)BOLAN_EARTH_RADIUS;
}

// Vertices for steps of that angle over a range, with a whole number of blocks of cells between them.
static uint32_t vertices_along(double range, double angle, uint32_t block) {
    const uint32_t cells = (uint32_t)ceil(range / angle) + 1;
    return (cells + block - 1) / block * block + 1;
}

bolan_surface_size bolan_surface_projector_size(const bolan_surface_desc *desc, const bolan_surface_view *view,
                                                uint32_t block, bolan_surface_projector *p) {
    BOLAN_ASSERT(desc != NULL && view != NULL && p != NULL && desc->max_vertices >= 1024);
    BOLAN_ASSERT(block >= 1 && block <= BOLAN_SURFACE_MAX_BLOCK);
    if (!p->visible) return (bolan_surface_size){0, 0};
    bolan_surface_size size;
    const double pixel = view->fov_y / view->pixel_height, half = p->half;
    // coarser until it fits: at most a twentieth fewer than may be, or a block
    for (double angle = pixel * desc->pixels_per_vertex;; angle *= 1.02) {
        p->half = fmin(half + beyond_guard(angle, pixel), BOLAN_PI);
        size.rows = vertices_along(p->range, angle, block);
        size.columns = vertices_along(2.0 * p->half, angle, block);
        if ((uint64_t)size.rows * size.columns <= desc->max_vertices) return size;
    }
}

bolan_surface_size bolan_surface_projected(const bolan_surface_desc *desc, const bolan_surface_view *view,
                                           bolan_surface_vertex *vertices) {
    BOLAN_ASSERT(desc != NULL && view != NULL && vertices != NULL && desc->max_vertices >= 1024);
    bolan_surface_projector p = bolan_surface_projector_of(view);
    const bolan_surface_size size = bolan_surface_projector_size(desc, view, 1, &p);
    if (size.rows > 0) bolan_surface_projector_vertices(&p, size, vertices);
    return size;
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
