// SPDX-License-Identifier: MIT
// See half_rate.h.
#include "half_rate.h"

#include <math.h>

#define STEEPEST_DEG \
    35.0            // of the picture's middle below the horizontal: further down, pixels are as wide as they are long
#define SMALLEST 64 // columns of a picture: below, there is nothing to save

// Over the shape that the optics keeps, and over the mesh. Bit 0: something opaque is in the picture.
static const water_shader shape_resolve = {.stem = "half_rate_resolve", .defines = {"OPAQUE 1\n", "KEPT 1\n"}};
static const water_shader mesh_resolve = {.stem = "half_rate_resolve", .reads = WATER_FEATURE_ALL};
enum { OPAQUE = 1, KEPT = 2 };

bool bolan_half_rate_prepare(half_rate *s, const water_setup *setup, bool keeps_shape, water_programs *all) {
    bool listed = keeps_shape ? bolan_water_programs_add(all, setup, false, &shape_resolve, KEPT)
                              : bolan_water_programs_add(all, setup, false, &mesh_resolve, 0);
    if (keeps_shape && setup->land)
        listed = bolan_water_programs_add(all, setup, false, &shape_resolve, KEPT | OPAQUE) && listed;
    if (keeps_shape || !setup->land || s->farthest.stem[0] != '\0') return listed; // made, or tried once
    return bolan_gl_program_create("half_rate_depth", NULL, &s->farthest) == BOLAN_OK && listed;
}

uint32_t bolan_half_rate_columns(const render_view *v, uint32_t most) {
    const bolan_look *look = &v->frame->lighting.look;
    if (look->show != BOLAN_SHOW_PICTURE || v->width < SMALLEST) return 1;
    if (v->medium == EYE_IN_WATER) return most; // which sees nothing sharply
    if (v->block.eye_under_water > 0.5f || v->lens.pitch_deg < -STEEPEST_DEG) return 1;
    // Where the camera rolls, a row runs partly along the view, and there every pixel shows other water.
    const double along = fabs(sin(bolan_radians(v->lens.roll_deg)));
    uint32_t columns = most > 1 ? most : 1;
    while (columns > 1 && columns * along > 1.0) columns /= 2;
    return columns;
}

static void free_targets(half_rate_targets *t) {
    bolan_gl_target_free(&t->target);
    bolan_gl_texture_free(&t->color);
    bolan_gl_texture_free(&t->depth);
}

static bolan_result create_targets(half_rate_targets *t, uint32_t width, uint32_t height, bool storage) {
    gl_texture_desc color = {.format = GL_FMT_RGBA16F,
                             .width = width,
                             .height = height,
                             .storage = storage,
                             .filter = GL_FILTER_LINEAR,
                             .wrap = GL_WRAP_CLAMP};
    gl_texture_desc depth = {.format = GL_FMT_DEPTH32F, .width = width, .height = height, .filter = GL_FILTER_NEAREST};
    const gl_texture *colors[] = {&t->color};
    bolan_result result = bolan_gl_texture_create(&color, &t->color);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&depth, &t->depth);
    return result == BOLAN_OK ? bolan_gl_target_create(colors, 1, &t->depth, -1, 0, &t->target) : result;
}

static bool fit(half_rate *s, uint32_t width, uint32_t height, bool storage) {
    bool fresh;
    uint32_t over;
    const uint32_t slot = bolan_kept_sizes_use(&s->kept, width, height, &fresh);
    half_rate_targets *t = &s->sizes[slot];
    if (fresh) free_targets(t);
    while (bolan_kept_sizes_over(&s->kept, &over)) free_targets(&s->sizes[over]);
    if (fresh && create_targets(t, width, height, storage) != BOLAN_OK) {
        free_targets(t);
        bolan_kept_sizes_forget(&s->kept, slot);
        return false;
    }
    s->now = *t;
    return true;
}

// Of the pixels that a sample serves, the farthest: whatever shows water is lit.
static bool fill_depth(half_rate *s, const render_view *v, uint32_t columns) {
    if (s->farthest.id == 0) return false;
    bolan_gl_texture_bind(v->hdr_depth, UNIT_HALF_RATE);
    bolan_gl_program_use(&s->farthest);
    bolan_gl_program_int(&s->farthest, "columns", (int)columns);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true});
    bolan_gl_draw_fullscreen();
    return true;
}

render_view bolan_half_rate_begin(half_rate *s, const render_view *v, uint32_t columns, bool keeps_shape, bool opaque) {
    const uint32_t width = (v->width + columns - 1) / columns, height = v->height;
    render_view sparse = *v;
    if (columns == 1 || !fit(s, width, height, v->frame->compute_pixels)) return sparse;
    bolan_gl_target_bind(&s->now.target);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    if (!keeps_shape) {
        bolan_gl_target_clear_depth(0.0f);
        if (opaque && !fill_depth(s, v, columns)) return sparse;
        sparse.width = width;
        sparse.hdr_depth = &s->now.depth;
    }
    sparse.hdr = s->now.target;
    sparse.shade_columns = (float)columns;
    return sparse;
}

// A shape is lit at the pixels' middles, half a pixel off the samples' own, in the same columns of a picture whether it
// is drawn whole or in tiles.
static bolan_vec4 places(const half_rate *s, const render_view *v, bool keeps_shape) {
    const uint32_t width = v->width, columns = (width + s->now.target.width - 1) / s->now.target.width;
    const float scale = keeps_shape ? 1.0f / (float)columns : (float)s->now.target.width / (float)width;
    const float shift = keeps_shape ? fmodf(v->tile_corner.x, (float)columns) : 0.0f;
    const float origin = keeps_shape ? (shift - 0.5f) * scale - 0.5f : -0.5f;
    return (bolan_vec4){scale, origin, (float)(s->now.target.width - 1), shift};
}

static bool begin_laying(const half_rate *s, const water_draw *d, bool keeps_shape, const water_shader *shader,
                         uint32_t own) {
    const gl_program *g = bolan_water_program(d, shader, own);
    if (g == NULL) return false;
    bolan_gl_program_vec4(g, "places", places(s, d->view, keeps_shape));
    bolan_gl_texture_bind(&s->now.color, UNIT_HALF_RATE);
    return true;
}

void bolan_half_rate_lay_mesh(const half_rate *s, const water_draw *d) {
    if (begin_laying(s, d, false, &mesh_resolve, 0)) bolan_water_draw_forward(d);
}

void bolan_half_rate_lay_shape(const half_rate *s, const water_draw *d, bool opaque, uint32_t rows) {
    if (!begin_laying(s, d, true, &shape_resolve, opaque ? KEPT | OPAQUE : KEPT)) return;
    bolan_gl_target_bind_part(&d->view->hdr, 0, 0, d->view->hdr.width, rows);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
}

bolan_result bolan_half_rate_reload(half_rate *s) {
    return s->farthest.id == 0 ? BOLAN_OK : bolan_gl_program_reload(&s->farthest);
}

void bolan_half_rate_free(half_rate *s) {
    for (int i = 0; i < KEPT_SIZES; ++i) free_targets(&s->sizes[i]);
    bolan_gl_program_free(&s->farthest);
}
