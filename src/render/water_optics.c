// SPDX-License-Identifier: MIT
// What the optics share. See water_optics.h.
#include "water_optics.h"
#include "ripple_texture.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#include <math.h>

// Whether the corners of the quad, whose sides end at the horizon, stand above it by more than half a pixel: they are 1.41 times as far
// away. Where the water is lit at fewer places they are left out when it is laid over the picture.
static bool is_trimmed(const frame *f) {
    if (f->uniforms.view.eye_height < 0.0f) return false;
    const double dip = earth_dip(fmax(f->uniforms.view.eye_height, 0.5), BOLAN_EARTH_RADIUS);
    return f->uniforms.view.shade_columns == 1.0f && 0.2929 * dip > 0.5 * (double)f->uniforms.view.radians_per_pixel;
}

static uint32_t features_of(const water_draw *d) {
    const bool quad = bolan_water_surface(d->f) == BOLAN_SURFACE_QUAD;
    return (quad ? WATER_FEATURE_QUAD : 0) | (quad && is_trimmed(d->f) ? WATER_FEATURE_TRIM : 0) |
           (d->f->shore->present ? WATER_FEATURE_LAND : 0) | (d->mesh->fixed ? WATER_FEATURE_GRID : 0) |
           (d->packed ? WATER_FEATURE_PACKED : 0);
}

const gl_program *bolan_water_program(const water_draw *d, const water_shader *shader, uint32_t own) {
    const uint32_t wave_count = bolan_sea_component_count(d->f->desc->sea);
    const water_variant v = bolan_water_variant_of(shader, own, d->waves, wave_count, features_of(d));
    const gl_program *program = bolan_water_programs_find(d->programs, &v);
    if (program == NULL) return NULL;
    bolan_gl_program_use(program);
    return program;
}

static void set_look(water_block *b, const bolan_look *look) {
    b->look_ambient = (float)look->ambient;
    b->look_diffuse = (float)look->diffuse;
    b->look_specular = (float)look->specular;
    b->look_shininess = (float)look->shininess;
    b->look_distortion = (float)look->distortion;
    b->look_blend = (float)look->blend;
    b->look_by_the_paper = look->paper ? 1.0f : 0.0f;
    b->look_show = (float)look->show;
    b->look_effects = (int)look->effects;
}

void bolan_water_fill(water_block *b, const water_draw *d) {
    *b = (water_block){.cascade_count = 0};
    bolan_sea_gpu_fill(b, d->f, d->waves);
    bolan_water_mesh_fill(d->mesh, b);
    if (d->waves != WATER_CASCADES) bolan_ripple_fill(b, d->f);
    set_look(b, &d->f->scene->look);
}

void bolan_water_draw_forward(const water_draw *d) {
    bolan_gl_target_bind(&d->f->hdr);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
}

bolan_surface_kind bolan_water_surface(const frame *f) {
    // In a trough the eye is below the mean level and still above the water.
    const bool below = f->uniforms.view.eye_under_water > 0.5f && bolan_pass_water_seen_from_below(f->scene);
    return below ? BOLAN_SURFACE_QUAD : f->scene->technique.surface;
}

uint32_t bolan_water_rows(const frame *f, double vertical) {
    const bolan_camera *c = &f->scene->camera;
    if (c->roll_deg != 0.0) return f->desc->height;
    if (bolan_water_surface(f) == BOLAN_SURFACE_QUAD) vertical = 0.0;
    double above = f->uniforms.view.eye_height - vertical;
    if (above <= (vertical > 0.0 ? 1.0 : 0.0)) return f->desc->height; // among the waves: they may stand anywhere
    double top = bolan_radians(c->pitch_deg) + earth_dip_exact(above, BOLAN_EARTH_RADIUS); // over it
    double half = 0.5 * bolan_radians(c->fov_deg);
    double y = -tan(top) / tan(half); // in the middle; the curve of the horizon bends down from there
    double rows = (0.5 + 0.5 * y) * f->desc->height + 3.0;
    return (uint32_t)fmin(fmax(rows, 1.0), f->desc->height);
}
