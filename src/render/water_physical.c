// SPDX-License-Identifier: MIT
// The physical optics: draws the water's shape into a few numbers per pixel, and shades these over a copy of what lies
// behind. Shaders: shaders/water_shape.glsl, shaders/water_physical.glsl.
#include "foam_statistics.h"
#include "foam_texture.h"
#include "shared/foam.glsl"
#include "water_optics.h"

#include <math.h>

enum { SURFACE_COUNT = 4 };

typedef struct physical {
    bolan_quality quality;
    gl_texture shape_map[SURFACE_COUNT]; // outputs of water_shape.glsl
    gl_target shape_target;              // they, and the frame's depth
    uint32_t depth_id;                   // of that depth
    gl_texture foam_detail;
} physical;

static const water_shader shape_shader = {.stem = "water_shape", .reads = WATER_FEATURE_ALL};
// By quality: texture fetches along a footprint, reflected rays that look for land.
static const water_shader light_shader = {.stem = "water_physical",
                                          .reads = WATER_FEATURE_WAVES | WATER_FEATURE_LAND,
                                          .defines = {[BOLAN_QUALITY_LOW] = "TAPS 1\nRAYS 1\n",
                                                      [BOLAN_QUALITY_MEDIUM] = "TAPS 2\nRAYS 1\n",
                                                      [BOLAN_QUALITY_HIGH] = "TAPS 4\nRAYS 3\n",
                                                      [BOLAN_QUALITY_ULTRA] = "TAPS 8\nRAYS 3\n"}};

static bolan_result create(void *state, bolan_quality quality) {
    physical *p = state;
    p->quality = quality;
    return bolan_foam_texture_create(&p->foam_detail);
}

static void free_shape(physical *p) {
    bolan_gl_target_free(&p->shape_target);
    for (int i = 0; i < SURFACE_COUNT; ++i) bolan_gl_texture_free(&p->shape_map[i]);
    p->depth_id = 0;
}

// Textures of the frame's size, with its depth.
static bolan_result fit_shape(physical *p, const render_view *v) {
    if (p->depth_id == v->hdr_depth->id && p->shape_map[0].width == v->width && p->shape_map[0].height == v->height)
        return BOLAN_OK;
    free_shape(p);
    const gl_texture *colors[SURFACE_COUNT];
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < SURFACE_COUNT && result == BOLAN_OK; ++i) {
        gl_texture_desc desc = {.format = i == 0 ? GL_FMT_RGBA32F : GL_FMT_RGBA16F,
                                .width = v->width,
                                .height = v->height,
                                .filter = GL_FILTER_NEAREST,
                                .wrap = GL_WRAP_CLAMP};
        result = bolan_gl_texture_create(&desc, &p->shape_map[i]);
        colors[i] = &p->shape_map[i];
    }
    if (result == BOLAN_OK)
        result = bolan_gl_target_create(colors, SURFACE_COUNT, v->hdr_depth, -1, 0, &p->shape_target);
    if (result == BOLAN_OK)
        p->depth_id = v->hdr_depth->id;
    else
        free_shape(p);
    return result;
}

static void free_all(void *state) {
    physical *p = state;
    free_shape(p);
    bolan_gl_texture_free(&p->foam_detail);
}

#define FOAM_EDGE 0.12 // how widely the edge of a breaking patch is drawn, in Jacobian

typedef struct physical_block {
#include "shared/physical_block.glsl"
} physical_block;

static physical_block foam_of(const render_view *v) {
    const foam_law law = bolan_foam_law(v->frame->sea, FOAM_EDGE);
    return (physical_block){.breaking_jacobian = (float)(1.0 + law.breaking),
                            .slopes_beyond_cascades = (float)law.slopes_beyond,
                            .fresh_edge = (float)law.edge,
                            .old_edge = (float)OLD_FOAM_EDGE,
                            .old_foam_memory = (float)law.memory,
                            .memory_variance = (float)fmax(law.memory_variance, 1e-9),
                            .jacobian_variance = (float)law.variance};
}

static void draw_shape(physical *p, const water_draw *d) {
    if (!bolan_water_program(d, &shape_shader, 0)) return;
    bolan_gl_target_bind(&p->shape_target);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
}

static void draw_light(physical *p, const water_draw *d) {
    if (!bolan_water_program(d, &light_shader, 1u << p->quality)) return;
    const physical_block block = foam_of(d->view);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    bolan_gl_texture_bind(&p->foam_detail, UNIT_FOAM_DETAIL);
    for (uint32_t i = 0; i < SURFACE_COUNT; ++i) bolan_gl_texture_bind(&p->shape_map[i], UNIT_SURFACE + i);
    bolan_gl_target_bind_part(&d->view->hdr, 0, 0, d->view->hdr.width, bolan_water_rows(d->view, d->vertical));
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
    bolan_gl_target_bind(&d->view->hdr);
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    (void)state;
    bolan_water_programs_add(all, s, false, &shape_shader, 0);
    bolan_water_programs_add(all, s, false, &light_shader, 1u << s->quality);
}

static void draw(void *state, const water_draw *d) {
    physical *p = state;
    if (fit_shape(p, d->view) != BOLAN_OK) return;
    draw_shape(p, d);
    draw_light(p, d);
}

const water_optics bolan_optics_physical = {.kind = BOLAN_OPTICS_PHYSICAL,
                                            .size = sizeof(physical),
                                            .keeps_shape = true,
                                            .columns = {[BOLAN_QUALITY_LOW] = 2},
                                            .create = create,
                                            .list = list,
                                            .draw = draw,
                                            .free = free_all};
