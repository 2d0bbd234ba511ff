// SPDX-License-Identifier: MIT
// What the optics share. See water_optics.h.
#include "water_optics.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Whether the corners of the quad, whose sides end at the horizon, stand above it by more than half a pixel: they are 1.41 times as far
// away. Where the water is lit at fewer places they are left out when it is laid over the picture.
static bool is_trimmed(const frame *f) {
    const double dip = earth_dip(fmax(f->uniforms.view.eye_height, 0.5), BOLAN_EARTH_RADIUS);
    return f->uniforms.view.shade_columns == 1.0f && 0.2929 * dip > 0.5 * (double)f->uniforms.view.radians_per_pixel;
}

// Bits 0-1 the waves, 2 the quad, 3 land, 4 the static grid, 5 packed cascades, 6-10 the number of exp-cosine waves, 11 the trimmed
// quad, from 12 on the optics' own.
static uint32_t key_of(const water_draw *d, uint32_t extra) {
    uint32_t quad = bolan_water_surface(d->f) == BOLAN_SURFACE_QUAD, land = d->f->shore->present;
    uint32_t fixed = d->mesh->fixed, packed = d->waves == WATER_CASCADES && d->fields->packed;
    uint32_t count = d->waves == WATER_EXP ? bolan_sea_component_count(d->f->desc->sea) : 0;
    uint32_t trim = quad && is_trimmed(d->f);
    return (uint32_t)d->waves | quad << 2 | land << 3 | fixed << 4 | packed << 5 | count << 6 | trim << 11 |
           extra << 12;
}

static const gl_program *make(const water_draw *d, const char *stem, uint32_t key, const char *extra) {
    water_programs *all = d->programs;
    char defines[160], count[24] = "";
    if (d->waves == WATER_EXP) snprintf(count, sizeof count, "WAVE_COUNT %u\n", key >> 6 & 31u);
    snprintf(defines, sizeof defines, "%s%s%s%s%s%s%s%s", bolan_water_waves_define(d->waves), count,
             key & 4 ? "QUAD 1\n" : "", key & 8 ? "LAND 1\n" : "", key & 16 ? "STATIC_GRID 1\n" : "",
             key & 32 ? "PACKED 1\n" : "", key & 1u << 11 ? "TRIM 1\n" : "", extra);
    if (all->count == WATER_PROGRAMS) { // the cache is full: drop every program
        for (uint32_t i = 0; i < all->count; ++i) bolan_gl_program_free(&all->list[i].program);
        all->count = 0;
    }
    gl_program program = {0};
    if (bolan_gl_program_create(stem, defines, &program) != BOLAN_OK) program.id = 0; // kept, so that it is said once
    all->list[all->count].key = key;
    all->list[all->count].stem = stem;
    all->list[all->count].program = program;
    return &all->list[all->count++].program;
}

const gl_program *bolan_water_program(const water_draw *d, const char *stem, uint32_t extra, const char *defines) {
    const uint32_t key = key_of(d, extra);
    const gl_program *program = NULL;
    for (uint32_t i = 0; i < d->programs->count && !program; ++i)
        if (d->programs->list[i].key == key && strcmp(d->programs->list[i].stem, stem) == 0)
            program = &d->programs->list[i].program;
    if (!program) program = make(d, stem, key, defines);
    if (program->id == 0) return NULL;
    bolan_gl_program_use(program);
    bolan_sea_gpu_apply(program, d->f, d->waves);
    bolan_water_mesh_apply(d->mesh, program);
    return program;
}

void bolan_water_look_apply(const gl_program *g, const bolan_look *look) {
    bolan_gl_program_vec4(
        g, "look_light",
        (bolan_vec4){(float)look->ambient, (float)look->diffuse, (float)look->specular, (float)look->shininess});
    bolan_gl_program_vec4(
        g, "look_mix",
        (bolan_vec4){(float)look->distortion, (float)look->blend, look->paper ? 1.0f : 0.0f, (float)look->show});
    bolan_gl_program_int(g, "look_effects", (int)look->effects);
}

void bolan_water_draw_forward(const water_draw *d) {
    bolan_gl_target_bind(&d->f->hdr);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
}

bolan_surface_kind bolan_water_surface(const frame *f) {
    return f->uniforms.view.eye_under_water > 0.5f ? BOLAN_SURFACE_QUAD : f->scene->technique.surface;
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
