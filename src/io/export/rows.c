// SPDX-License-Identifier: MIT
// See rows.h.
#include "io/export/rows.h"

#include <math.h>
#include <string.h>

enum { LEAST_BATCH = 16384, MOST_SIDE = 65536, GROUND_GRAIN = 256 };
static const uint64_t MOST_POINTS = 1u << 28;
static const double FAR = 8192.0; // [m] where neighbouring floats are a millimetre apart

// ---- checks ---------------------------------------------------------------------------------------------------------

static bool is_corner(bolan_dvec2 p) { return fabs(p.x) <= 1e7 && fabs(p.y) <= 1e7; }

static double points_along(double from, double to, double spacing) { return floor((to - from) / spacing + 1e-6) + 1.0; }

void bolan_export_grid_size(const bolan_export_grid *grid, uint32_t *columns, uint32_t *rows) {
    BOLAN_ASSERT(grid && columns && rows);
    *columns = *rows = 0;
    if (!is_corner(grid->from) || !is_corner(grid->to) || !(grid->spacing >= 1e-3 && grid->spacing <= 1e5)) return;
    const double x = points_along(grid->from.x, grid->to.x, grid->spacing);
    const double y = points_along(grid->from.y, grid->to.y, grid->spacing);
    if (!(x >= 2.0 && x <= MOST_SIDE && y >= 2.0 && y <= MOST_SIDE && x * y <= (double)MOST_POINTS)) return;
    *columns = (uint32_t)x;
    *rows = (uint32_t)y;
}

static bolan_result refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "%s: %s", path, what);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result check(const bolan_world *world, const bolan_export_mesh_desc *d, const char *path) {
    const bool view = d->vertices == BOLAN_EXPORT_VIEW;
    uint32_t columns, rows;
    bolan_export_grid_size(&d->grid, &columns, &rows);
    if (!view && d->vertices != BOLAN_EXPORT_RECTANGLE)
        return refuse(path, "vertices are neither a view nor a rectangle");
    if (!view && columns == 0)
        return refuse(path, "the rectangle or its spacing is out of range; expected corners within 1e7 m, south-west "
                            "first, a spacing of 0.001 to 1e5 m, and 2 to 65536 points along a side, at most 2^28 in "
                            "all");
    if (view && (d->width < 16 || d->width > MOST_SIDE || d->height < 16 || d->height > MOST_SIDE))
        return refuse(path, "the picture of the view is out of range; expected 16 to 65536 pixels each way");
    if (view && (d->most_vertices < 1024 || d->most_vertices > 10000000))
        return refuse(path, "most_vertices is out of range; expected 1024 to 10000000");
    if (!(fabs(d->origin.x) <= 1e7 && fabs(d->origin.y) <= 1e7 && fabs(d->origin.z) <= 1e7))
        return refuse(path, "the origin is out of range; expected +-1e7 m");
    if (d->frames.count < 1 || d->frames.count > 100000 || !(d->frames.fps >= 1e-3 && d->frames.fps <= 1e3))
        return refuse(path, "the frames are out of range; expected 1 to 100000 of them, 0.001 to 1000 a second");
    if (d->ground && !bolan_world_water(world)->ground) return refuse(path, "the scene has no ground to export");
    return BOLAN_OK;
}

// ---- life -----------------------------------------------------------------------------------------------------------

static bolan_result no_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the vertices", path);
    return BOLAN_ERROR_MEMORY;
}

static bolan_surface_view view_of(const bolan_world *world, const bolan_export_mesh_desc *d) {
    const bolan_scene *scene = bolan_world_scene(world);
    const bolan_camera *c = &scene->camera;
    bolan_surface_view view = {.eye = bolan_world_clear_eye(world, c->position),
                               .heading_deg = c->heading_deg,
                               .pitch_deg = c->pitch_deg,
                               .roll_deg = c->roll_deg,
                               .fov_y = bolan_radians(c->fov_deg),
                               .aspect = (double)d->width / d->height,
                               .pixel_height = d->height,
                               .water_level = bolan_world_water(world)->level};
    bolan_water_bounds(bolan_world_water(world), &view.vertical, &view.horizontal);
    return view;
}

static bolan_result make_grid(mesh_rows *r, const char *path) {
    const bolan_surface_view view = view_of(r->world, r->desc);
    bolan_surface_desc desc = bolan_surface_desc_default();
    desc.max_vertices = r->desc->most_vertices;
    r->grid_bytes = desc.max_vertices * sizeof *r->grid;
    r->grid = bolan_allocate(r->grid_bytes);
    if (!r->grid) return no_memory(path);
    const bolan_surface_size size = bolan_surface_projected(&desc, &view, r->grid);
    if (size.columns < 2 || size.rows < 2)
        return refuse(path, "no water is in view of the camera; expected a camera that sees some, or a rectangle");
    r->eye = view.eye;
    r->columns = size.columns;
    r->rows = size.rows;
    if (bolan_world_scene(r->world)->technique.surface != BOLAN_SURFACE_PROJECTED)
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_EXPORT_LEFT_OUT,
                  "%s: the technique draws another surface; the projected grid stands in for it", path);
    return BOLAN_OK;
}

static bool allocate_batch(mesh_rows *r) {
    const size_t n = r->capacity;
    const bolan_surface_size strip = {r->columns, 2};
    r->rest = bolan_allocate(n * sizeof *r->rest);
    r->place = bolan_allocate(n * sizeof *r->place);
    r->base = bolan_allocate(n * sizeof *r->base);
    r->spacing = bolan_allocate(n * sizeof *r->spacing);
    r->parcels = bolan_allocate(n * sizeof *r->parcels);
    r->samples = bolan_allocate(n * sizeof *r->samples);
    r->motion = bolan_allocate(n * sizeof *r->motion);
    r->vertices = bolan_allocate(n * sizeof *r->vertices);
    r->strip = bolan_allocate(6 * (size_t)(r->columns - 1) * sizeof *r->strip);
    if (!r->rest || !r->place || !r->base || !r->spacing || !r->parcels || !r->samples || !r->motion || !r->vertices ||
        !r->strip)
        return false;
    bolan_surface_grid_indices(strip, r->strip);
    return true;
}

// The farthest of the corners from the origin, roughly; views reach to the horizon and say nothing.
static void warn_of_precision(const mesh_rows *r, const char *path) {
    const bolan_export_grid *g = &r->desc->grid;
    const bolan_dvec3 o = r->desc->origin;
    const double x = fmax(fabs(g->from.x - o.x), fabs(g->to.x - o.x));
    const double y = fmax(fabs(g->from.y - o.y), fabs(g->to.y - o.y));
    if (r->grid || fmax(x, y) <= FAR) return;
    bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_EXPORT_PRECISION,
              "%s: positions up to %.0f m from the origin are rounded to more than half a millimetre; give an origin "
              "near the rectangle",
              path, fmax(x, y));
}

bolan_result bolan_mesh_rows_open(bolan_world *world, const bolan_export_mesh_desc *desc, const char *path,
                                  mesh_rows *out) {
    *out = (mesh_rows){.world = world, .desc = desc, .moves = true, .water = *bolan_world_water(world)};
    mesh_rows *r = out;
    if (check(world, desc, path)) return BOLAN_ERROR_ARGUMENT;
    bolan_export_grid_size(&desc->grid, &r->columns, &r->rows);
    bolan_result result = desc->vertices == BOLAN_EXPORT_VIEW ? make_grid(r, path) : BOLAN_OK;
    if (result) return result;
    r->batch = LEAST_BATCH / r->columns > 0 ? LEAST_BATCH / r->columns : 1;
    if (r->batch > r->rows) r->batch = r->rows;
    r->capacity = r->batch * r->columns;
    if (!allocate_batch(r)) return no_memory(path);
    warn_of_precision(r, path);
    result = bolan_flow_create(r->water.sea, &r->flow);
    r->water.flow = r->flow;
    return result;
}

void bolan_mesh_rows_close(mesh_rows *r) {
    const size_t n = r->capacity;
    bolan_flow_destroy(&r->flow);
    bolan_release(r->grid, r->grid_bytes);
    bolan_release(r->rest, n * sizeof *r->rest);
    bolan_release(r->place, n * sizeof *r->place);
    bolan_release(r->base, n * sizeof *r->base);
    bolan_release(r->spacing, n * sizeof *r->spacing);
    bolan_release(r->parcels, n * sizeof *r->parcels);
    bolan_release(r->samples, n * sizeof *r->samples);
    bolan_release(r->motion, n * sizeof *r->motion);
    bolan_release(r->vertices, n * sizeof *r->vertices);
    if (r->strip) bolan_release(r->strip, 6 * (size_t)(r->columns - 1) * sizeof *r->strip);
    *r = (mesh_rows){.world = NULL};
}

void bolan_mesh_rows_step(mesh_rows *r, double start, uint32_t frame) {
    const double time = start + frame / r->desc->frames.fps;
    if (r->desc->frames.count > 1 && frame == 0) bolan_world_settle(r->world, time);
    if (r->desc->frames.count > 1 && frame > 0) bolan_world_step(r->world, time);
    if (r->moves) bolan_flow_step(r->flow, r->water.sea);
}

// ---- rows -----------------------------------------------------------------------------------------------------------

static void place_view(mesh_rows *r, uint32_t first, uint32_t count) {
    const bolan_surface_vertex *v = r->grid + (size_t)first * r->columns;
    for (uint32_t i = 0; i < count; i++) {
        r->rest[i] = (bolan_dvec2){r->eye.x + (double)v[i].x, r->eye.y + (double)v[i].y};
        r->base[i] = r->eye.z + (double)v[i].z;
        r->spacing[i] = v[i].spacing;
    }
}

static void place_rectangle(mesh_rows *r, uint32_t first, uint32_t count) {
    const bolan_export_grid *g = &r->desc->grid;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t column = i % r->columns, row = first + i / r->columns;
        r->rest[i] = (bolan_dvec2){g->from.x + column * g->spacing, g->from.y + row * g->spacing};
        r->base[i] = r->water.level;
        r->spacing[i] = (float)g->spacing;
    }
}

static void set_position(const mesh_rows *r, mesh_vertex *v, double x, double y, double z) {
    v->position[0] = (float)(x - r->desc->origin.x);
    v->position[1] = (float)(y - r->desc->origin.y);
    v->position[2] = (float)(z - r->desc->origin.z);
}

static void set_vector(float out[3], bolan_vec3 v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

static void make_water(mesh_rows *r, uint32_t count) {
    const float *spacing = r->grid ? r->spacing : NULL; // a rectangle has every wave
    bolan_query_parcels(&r->water, r->rest, spacing, count, r->parcels);
    bolan_sea_sample_grid(r->water.sea, r->rest, spacing, count, r->samples);
    for (uint32_t i = 0; i < count; i++) {
        r->place[i].x = r->rest[i].x + (double)r->parcels[i].displacement.x;
        r->place[i].y = r->rest[i].y + (double)r->parcels[i].displacement.y;
    }
    if (r->moves) bolan_query_motion(&r->water, NULL, r->place, count, r->motion);
    for (uint32_t i = 0; i < count; i++) {
        mesh_vertex *v = &r->vertices[i];
        set_position(r, v, r->place[i].x, r->place[i].y, r->base[i] + (double)r->parcels[i].displacement.z);
        set_vector(v->normal, r->parcels[i].normal);
        v->foam = r->samples[i].foam;
        set_vector(v->velocity, r->moves ? r->motion[i].velocity : (bolan_vec3){0.0f, 0.0f, 0.0f});
    }
}

// Task: vertices [begin, end) of the ground; the normal is that of differences of half a spacing to either side.
static void make_ground(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    mesh_rows *r = context;
    const bolan_ground *ground = r->water.ground;
    for (uint32_t i = begin; i < end; i++) {
        const double x = r->rest[i].x, y = r->rest[i].y, wide = (double)r->spacing[i], half = 0.5 * wide;
        const float east = bolan_ground_elevation(ground, x + half, y, wide);
        const float west = bolan_ground_elevation(ground, x - half, y, wide);
        const float north = bolan_ground_elevation(ground, x, y + half, wide);
        const float south = bolan_ground_elevation(ground, x, y - half, wide);
        const bolan_vec3 normal = {(west - east) / (float)wide, (south - north) / (float)wide, 1.0f};
        mesh_vertex *v = &r->vertices[i];
        *v = (mesh_vertex){.foam = 0.0f};
        const double drop = r->water.level - r->base[i]; // of the round earth, in a view
        set_position(r, v, x, y, (double)bolan_ground_elevation(ground, x, y, wide) - drop);
        set_vector(v->normal, bolan_v3_normalize(normal));
    }
}

uint32_t bolan_mesh_rows_make(mesh_rows *r, mesh_part part, uint32_t first) {
    if (first >= r->rows) return 0;
    const uint32_t rows = r->rows - first < r->batch ? r->rows - first : r->batch, count = rows * r->columns;
    if (r->grid) {
        place_view(r, first, count);
    } else {
        place_rectangle(r, first, count);
    }
    if (part == MESH_GROUND) {
        bolan_parallel(count, GROUND_GRAIN, make_ground, r);
    } else {
        make_water(r, count);
    }
    return count;
}
