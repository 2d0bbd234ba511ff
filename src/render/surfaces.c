// SPDX-License-Identifier: MIT
// See surfaces.h.
#include "surfaces.h"

#include <math.h>

#include "bolan/query.h"
#include "frame.h"
#include "memory.h"

// Land is what the picture shows where its depth is that of the picture, up to the rounding of two programs.
static const float same_depth = 1e-4f;

bolan_result bolan_surface_reader_fit(surface_reader *s, uint32_t width, uint32_t height) {
    bolan_result result = BOLAN_OK;
    if (s->land.id == 0) result = bolan_gl_program_create("surfaces", NULL, &s->land);
    if (result == BOLAN_OK && s->object.id == 0) result = bolan_gl_program_create("surfaces", "OBJECT 1\n", &s->object);
    if (result != BOLAN_OK || (s->target.id && s->color.width == width && s->color.height == height)) return result;
    bolan_gl_target_free(&s->target);
    bolan_gl_texture_free(&s->color);
    bolan_gl_texture_free(&s->depth);
    const gl_texture_desc c = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    const gl_texture_desc d = {.format = GL_FMT_DEPTH32F, .width = width, .height = height};
    const gl_texture *colors[] = {&s->color};
    result = bolan_gl_texture_create(&c, &s->color);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&d, &s->depth);
    return result == BOLAN_OK ? bolan_gl_target_create(colors, 1, &s->depth, -1, 0, &s->target) : result;
}

void bolan_surface_reader_free(surface_reader *s) {
    bolan_gl_program_free(&s->land);
    bolan_gl_program_free(&s->object);
    bolan_gl_target_free(&s->target);
    bolan_gl_texture_free(&s->color);
    bolan_gl_texture_free(&s->depth);
}

// ---- a row of pixels ------------------------------------------------------------------------------------------------

typedef struct row {
    uint32_t count;  // of water
    uint32_t *index; // of the pixel, in the output
    bolan_dvec2 *xy;
    bolan_query_point *surface;
    bolan_surface_motion *motion;
    void *memory;
    size_t bytes;
} row;

static bool begin_row(row *r, uint32_t width) {
    const size_t each = sizeof *r->xy + sizeof *r->surface + sizeof *r->motion + sizeof *r->index;
    *r = (row){.bytes = width * each};
    r->memory = allocate_for("reading surfaces back", r->bytes);
    if (r->memory == NULL) return false;
    r->xy = r->memory;
    r->surface = (bolan_query_point *)(r->xy + width);
    r->motion = (bolan_surface_motion *)(r->surface + width);
    r->index = (uint32_t *)(r->motion + width);
    return true;
}

// The world point of the pixel's middle at that distance along the view axis.
static bolan_dvec2 place_of(const render_view *v, uint32_t x, uint32_t y, double distance) {
    const float *p = v->projection.m, *c = v->view.m; // columns of the view are world axes in the camera's
    const double across = 2.0 * (x + 0.5) / v->width - 1.0, up = 2.0 * (y + 0.5) / v->height - 1.0;
    const double camera[3] = {(across + (double)p[8]) / (double)p[0] * distance,
                              (up + (double)p[9]) / (double)p[5] * distance, -distance};
    bolan_dvec2 at = {v->eye.x, v->eye.y};
    for (int i = 0; i < 3; i++) at.x += (double)c[i] * camera[i], at.y += (double)c[4 + i] * camera[i];
    return at;
}

static void put(const bolan_surfaces *out, uint32_t i, uint32_t label, bolan_vec3 normal, bolan_vec3 motion) {
    if (out->label != NULL) out->label[i] = label;
    if (out->normal != NULL) out->normal[i] = normal;
    if (out->motion != NULL) out->motion[i] = motion;
}

static void sort_pixels(const render_view *v, const surface_pixels *s, const bolan_surfaces *out, uint32_t y, row *r) {
    r->count = 0;
    for (uint32_t x = 0; x < v->width; x++) {
        const size_t at = 4 * ((size_t)y * v->width + x);
        const uint32_t i = (v->height - 1 - y) * v->width + x;
        const float depth = s->depth[at], *land = s->land + at;
        if (depth <= 0.0f) {
            put(out, i, BOLAN_LABEL_SKY, (bolan_vec3){0}, (bolan_vec3){0});
        } else if (land[3] > 0.0f && s->land_depth[at] >= depth * (1.0f - same_depth)) {
            put(out, i, (uint32_t)land[3], (bolan_vec3){land[0], land[1], land[2]}, (bolan_vec3){0});
        } else {
            r->index[r->count] = i;
            r->xy[r->count++] = place_of(v, x, y, v->near_distance / (double)depth);
        }
    }
}

static void fill_water(const render_view *v, const bolan_surfaces *out, row *r) {
    bolan_water water = v->frame->water;
    water.flow = out->flow;
    const double threshold = bolan_sea_foam_threshold(water.sea);
    if (out->normal != NULL || out->label != NULL) bolan_query_surface(&water, r->xy, r->count, r->surface);
    if (out->motion != NULL) bolan_query_motion(&water, NULL, r->xy, r->count, r->motion);
    for (uint32_t k = 0; k < r->count; k++) {
        if (out->normal != NULL) out->normal[r->index[k]] = r->surface[k].normal;
        if (out->motion != NULL) out->motion[r->index[k]] = r->motion[k].velocity;
        if (out->label != NULL)
            out->label[r->index[k]] = (double)r->surface[k].jacobian < threshold ? BOLAN_LABEL_FOAM : BOLAN_LABEL_WATER;
    }
}

bool bolan_surfaces_fill(const render_view *v, const surface_pixels *pixels, const bolan_surfaces *out) {
    row r;
    if (!begin_row(&r, v->width)) return false;
    for (uint32_t y = 0; y < v->height; y++) {
        sort_pixels(v, pixels, out, y, &r);
        fill_water(v, out, &r);
    }
    bolan_release(r.memory, r.bytes);
    return true;
}
