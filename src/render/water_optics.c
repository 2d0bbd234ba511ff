// SPDX-License-Identifier: MIT
// What the optics share. See water_optics.h.
#include "water_optics.h"
#include "ripple_texture.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#include <math.h>

// Whether the corners of the quad, which are 1.41 times as far away as its sides, stand above the horizon by more than
// half a pixel. With half-rate shading the resolve leaves them out.
static bool is_trimmed(const render_view *v) {
    if (v->block.eye_height < 0.0f) return false;
    const double dip = earth_dip(fmax(v->block.eye_height, 0.5), BOLAN_EARTH_RADIUS);
    return v->block.shade_columns == 1.0f && 0.2929 * dip > 0.5 * (double)v->block.radians_per_pixel;
}

static uint32_t features_of(const water_draw *d) {
    const bool quad = bolan_water_surface(d->view) == BOLAN_SURFACE_QUAD;
    return (quad ? WATER_FEATURE_QUAD : 0) | (quad && is_trimmed(d->view) ? WATER_FEATURE_TRIM : 0) |
           (d->view->frame->behind ? WATER_FEATURE_LAND : 0) |
           (d->mesh->fixed ? bolan_water_grid_feature(d->mesh->kind) : 0) | (d->packed ? WATER_FEATURE_PACKED : 0) |
           (d->view->frame->bounds_count > 0 ? WATER_FEATURE_BOUNDS : 0) |
           (d->view->frame->water.layer_count > 0 ? WATER_FEATURE_LAYERS : 0) |
           (bolan_sea_get_desc(d->view->frame->sea)->order > 1 ? WATER_FEATURE_BOUND : 0);
}

const gl_program *bolan_water_find_program(const water_draw *d, const water_shader *shader, uint32_t own) {
    const uint32_t wave_count = bolan_sea_component_count(d->view->frame->sea);
    const water_variant v =
        bolan_water_variant_of(shader, own, d->waves, wave_count, features_of(d), d->view->frame->compute_pixels);
    return bolan_water_programs_find(d->programs, &v);
}

const gl_program *bolan_water_program(const water_draw *d, const water_shader *shader, uint32_t own) {
    const gl_program *program = bolan_water_find_program(d, shader, own);
    if (program != NULL) bolan_gl_program_use(program);
    return program;
}

static void set_look(water_block *b, const bolan_look *look) {
    b->look_ambient = (float)look->ambient;
    b->look_diffuse = (float)look->diffuse;
    b->look_specular = (float)look->specular;
    b->look_shininess = (float)look->shininess;
    b->look_distortion = (float)look->distortion;
    b->look_blend = (float)look->blend;
    b->look_show = (float)look->show;
    b->look_effects = (int)look->effects;
}

void bolan_water_fill(water_block *b, const water_draw *d) {
    *b = (water_block){.cascade_count = 0};
    bolan_sea_gpu_fill(b, d->view, d->waves);
    bolan_water_mesh_fill(d->mesh, b);
    if (d->waves != WATER_CASCADES) bolan_ripple_fill(b, d->view);
    set_look(b, &d->view->frame->lighting.look);
}

void bolan_water_draw_forward(const water_draw *d) {
    bolan_gl_target_bind(&d->view->hdr);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
}

bolan_surface_kind bolan_water_surface(const render_view *v) {
    return v->under ? BOLAN_SURFACE_QUAD : v->frame->lighting.technique.surface;
}

uint32_t bolan_water_rows(const render_view *v, double vertical) {
    if (fabs(v->lens.roll_deg) > LEVEL_ROLL) return v->height;
    if (bolan_water_surface(v) == BOLAN_SURFACE_QUAD) vertical = 0.0;
    double above = v->block.eye_height - vertical;
    if (above <= (vertical > 0.0 ? 1.0 : 0.0)) return v->height; // among the waves: they may stand anywhere
    double top = bolan_radians(v->lens.pitch_deg) + earth_dip_exact(above, BOLAN_EARTH_RADIUS); // over it
    const double rows = bolan_view_row(v, -tan(top)) + 3.0; // in the middle; the horizon curves down from there
    return (uint32_t)fmin(fmax(rows, 1.0), v->height);
}

uint32_t bolan_water_rows_steeper(const render_view *v, double sine, uint32_t rows) {
    if (sine >= 1.0) return 0;                                         // even straight below
    const double down = bolan_radians(v->lens.pitch_deg) + asin(sine); // from the middle of the picture
    if (fabs(down) > 1.5) return down > 0.0 ? 0 : rows;
    return (uint32_t)fmin(fmax(bolan_view_row(v, -tan(down)) + 2.0, 0.0), rows);
}
