// SPDX-License-Identifier: MIT
// Terrains: life cycle and queries. Immutable after creation, so every read is thread-safe.
#include "ground/ground.h"

#include "ground/noise.h"

#include <string.h>

// Bounds of a desc. Within them every coordinate of the detail's lattices fits 31 bits (the shortest wavelength is a
// metre, and the blend outside the grid is at most 8 steps or a tenth of its size), and no sum of elevations overflows.
#define STEP_MIN 1e-3     // [m]
#define STEP_MAX 1e7      // [m]
#define REACH 1e8         // of the grid's corners from the origin [m]
#define ELEVATION_MAX 1e6 // [m]

bolan_ground_desc bolan_ground_desc_default(void) {
    bolan_ground_desc d = {{0, 0, 0.0, 0.0, 1.0, 1.0, NULL}, 1.0, 1u, -4000.0};
    return d;
}

static bolan_result refuse(bolan_log_id id, const char *field, double value, const char *expected) {
    bolan_log(BOLAN_LOG_ERROR, id, "bolan_ground_desc.%s is %g; expected %s", field, value, expected);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_log_id id_of(double value) { return isfinite(value) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE; }
static bool is_elevation(double z) { return fabs(z) <= ELEVATION_MAX; }

// One axis of the grid: its first node, its step and its last node.
static bolan_result refuse_axis(const char *from_name, double from, const char *step_name, double step,
                                uint32_t count) {
    if (!(step >= STEP_MIN && step <= STEP_MAX)) {
        return refuse(id_of(step), step_name, step, "1e-3 to 1e7 m");
    }
    if (!(fabs(from) <= REACH && fabs(from + (count - 1) * step) <= REACH)) {
        return refuse(id_of(from), from_name, from, "a grid that lies within +-1e8 m of the origin");
    }
    return BOLAN_OK;
}

static bolan_result validate(const bolan_ground_desc *d) {
    const bolan_heightfield *f = &d->field;
    if (f->width < 2 || f->width > 32768) {
        return refuse(BOLAN_LOG_OUT_OF_RANGE, "field.width", f->width, "2..32768");
    }
    if (f->height < 2 || f->height > 32768) {
        return refuse(BOLAN_LOG_OUT_OF_RANGE, "field.height", f->height, "2..32768");
    }
    if (refuse_axis("field.west", f->west, "field.step_x", f->step_x, f->width) ||
        refuse_axis("field.south", f->south, "field.step_y", f->step_y, f->height)) {
        return BOLAN_ERROR_ARGUMENT;
    }
    if (!(d->detail >= 0.0 && d->detail <= 2.0)) {
        return refuse(BOLAN_LOG_OUT_OF_RANGE, "detail", d->detail, "0..2");
    }
    if (!is_elevation(d->edge_elevation)) {
        return refuse(id_of(d->edge_elevation), "edge_elevation", d->edge_elevation, "an elevation within +-1e6 m");
    }
    if (!f->elevation) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_ground_desc.field.elevation is NULL; expected %u values", f->width * f->height);
        return BOLAN_ERROR_ARGUMENT;
    }
    for (size_t n = 0; n < (size_t)f->width * f->height; n++) {
        const double z = (double)f->elevation[n];
        if (!is_elevation(z)) {
            return refuse(id_of(z), "field.elevation[]", z, "elevations within +-1e6 m");
        }
    }
    return BOLAN_OK;
}

static void set_numbers(bolan_ground *t, const bolan_ground_desc *d) {
    const bolan_heightfield *f = &d->field;
    t->west = f->west, t->south = f->south;
    t->east = f->west + (f->width - 1) * f->step_x, t->north = f->south + (f->height - 1) * f->step_y;
    t->step = fmax(f->step_x, f->step_y);
    t->margin = fmax(8.0 * t->step, 0.1 * fmax(t->east - t->west, t->north - t->south));
    t->edge_elevation = (float)d->edge_elevation;
    t->detail = d->detail;
    t->detail_wavelength = 2.0 * t->step;
    t->seed = (uint32_t)(d->seed ^ (d->seed >> 32)) * 0x9e3779b9u + 0x7f4a7c15u;
}

// FNV-1a over 32-bit words (Fowler, Noll & Vo), of the data and of the numbers that shape them.
static uint64_t hash_words(uint64_t h, const void *data, size_t bytes) {
    const unsigned char *p = data;
    for (size_t n = 0; n + 4 <= bytes; n += 4) {
        uint32_t word;
        memcpy(&word, p + n, sizeof word);
        h = (h ^ word) * 0x100000001b3u;
    }
    return h;
}

static uint64_t identify(const bolan_ground *t) {
    const double numbers[6] = {t->west, t->south, t->level[0].step_x, t->level[0].step_y, t->detail, t->edge_elevation};
    uint64_t h = hash_words(0xcbf29ce484222325u, numbers, sizeof numbers);
    h = hash_words(h, &t->seed, sizeof t->seed);
    return hash_words(h, t->level[0].z, (size_t)t->level[0].width * t->level[0].height * sizeof(float));
}

bolan_result bolan_ground_create(const bolan_ground_desc *desc, bolan_ground **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    bolan_result r = validate(desc);
    if (r != BOLAN_OK) {
        return r;
    }
    bolan_ground *t = bolan_allocate(sizeof *t);
    if (t) {
        set_numbers(t, desc);
        r = bolan_heightfield_build(t, &desc->field);
    }
    if (!t || r != BOLAN_OK) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a terrain of %u x %u elevations",
                  desc->field.width, desc->field.height);
        bolan_ground_destroy(&t);
        return BOLAN_ERROR_MEMORY;
    }
    const block_level *top = &t->block[t->block_count - 1];
    t->lowest = top->low[0], t->highest = top->high[0];
    for (uint32_t n = 1; n < top->width * top->height; n++) {
        t->lowest = fminf(t->lowest, top->low[n]);
        t->highest = fmaxf(t->highest, top->high[n]);
    }
    t->id = identify(t);
    *out = t;
    return BOLAN_OK;
}

void bolan_ground_destroy(bolan_ground **terrain) {
    if (terrain && *terrain) {
        bolan_heightfield_free(*terrain);
        bolan_release(*terrain, sizeof **terrain);
        *terrain = NULL;
    }
}

// ---- queries --------------------------------------------------------------------------------------------------------

static float elevation_at(height_cursor *c, double x, double y, double resolution) {
    surface_point p = bolan_height_cursor_at(c, x, y, resolution);
    float inside = bolan_ground_inside(c->terrain, x, y);
    return inside > 0.0f ? bolan_detail_apply(c->terrain, p, x, y, resolution, inside) : p.z;
}

float bolan_ground_elevation(const bolan_ground *terrain, double x, double y, double resolution) {
    BOLAN_ASSERT(terrain);
    height_cursor c;
    bolan_height_cursor_start(&c, terrain);
    return elevation_at(&c, x, y, resolution);
}

typedef struct grid_job {
    const bolan_ground *terrain;
    double west, south, step;
    uint32_t nx;
    float *out;
} grid_job;

static void grid_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const grid_job *g = context;
    (void)worker;
    height_cursor c;
    bolan_height_cursor_start(&c, g->terrain);
    for (uint32_t j = begin; j < end; j++) {
        for (uint32_t i = 0; i < g->nx; i++) {
            g->out[(size_t)j * g->nx + i] = elevation_at(&c, g->west + i * g->step, g->south + j * g->step, g->step);
        }
    }
}

void bolan_ground_elevations(const bolan_ground *terrain, double west, double south, double step, uint32_t nx,
                             uint32_t ny, float *out) {
    BOLAN_ASSERT(terrain && out);
    grid_job g = {terrain, west, south, step, nx, out};
    bolan_parallel(ny, 8, grid_rows, &g);
}

uint64_t bolan_ground_id(const bolan_ground *terrain) {
    BOLAN_ASSERT(terrain);
    return terrain->id;
}

bolan_ground_extent bolan_ground_get_extent(const bolan_ground *terrain) {
    BOLAN_ASSERT(terrain);
    bolan_ground_extent e = {terrain->west,   terrain->south,   terrain->east, terrain->north,
                             terrain->lowest, terrain->highest, terrain->step};
    return e;
}

void bolan_ground_bounds(const bolan_ground *terrain, double west, double south, double size, float *lowest,
                         float *highest) {
    BOLAN_ASSERT(terrain && lowest && highest);
    const bolan_ground *t = terrain;
    // The level on which the square covers few blocks.
    uint32_t n = 0;
    double block_x = t->level[0].step_x * TERRAIN_BLOCK, block_y = t->level[0].step_y * TERRAIN_BLOCK;
    while (n + 1 < t->block_count && size > 4.0 * fmin(block_x, block_y)) {
        block_x *= 2.0, block_y *= 2.0;
        n++;
    }
    const block_level *b = &t->block[n];
    // A cell of slack: low-passed levels draw on their neighbours.
    double slack_x = block_x / TERRAIN_BLOCK, slack_y = block_y / TERRAIN_BLOCK;
    double u0 = (west - slack_x - t->west) / block_x, u1 = (west + size + slack_x - t->west) / block_x;
    double v0 = (south - slack_y - t->south) / block_y, v1 = (south + size + slack_y - t->south) / block_y;
    uint32_t i0 = (uint32_t)fmin(fmax(u0, 0.0), b->width - 1), i1 = (uint32_t)fmin(fmax(u1, 0.0), b->width - 1);
    uint32_t j0 = (uint32_t)fmin(fmax(v0, 0.0), b->height - 1), j1 = (uint32_t)fmin(fmax(v1, 0.0), b->height - 1);
    float lo = INFINITY, hi = -INFINITY;
    for (uint32_t j = j0; j <= j1; j++) {
        for (uint32_t i = i0; i <= i1; i++) {
            lo = fminf(lo, b->low[j * b->width + i]);
            hi = fmaxf(hi, b->high[j * b->width + i]);
        }
    }
    if (west < t->west || south < t->south || west + size > t->east || south + size > t->north) {
        lo = fminf(lo, t->edge_elevation);
        hi = fmaxf(hi, t->edge_elevation);
    }
    float margin = bolan_detail_bound(t);
    *lowest = lo - margin;
    *highest = hi + margin;
}
