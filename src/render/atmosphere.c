// SPDX-License-Identifier: MIT
// Fills the tables of clear air by drawing them, when the sun's height, the haze or the eye's height have changed.
#include "atmosphere.h"

#include <string.h>

static bolan_result create_table(gl_texture *texture, gl_target *target, uint32_t width, uint32_t height) {
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = width, .height = height, .filter = GL_FILTER_LINEAR};
    const bolan_result result = bolan_gl_texture_create(&d, texture);
    if (result != BOLAN_OK) return result;
    const gl_texture *color = texture;
    return bolan_gl_target_create(&color, 1, NULL, -1, 0, target);
}

static bolan_result create_aerial(atmosphere *a) {
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F,
                               .width = SKY_AERIAL_AZIMUTHS,
                               .height = SKY_AERIAL_ELEVATIONS,
                               .depth = SKY_AERIAL_SLICES,
                               .filter = GL_FILTER_LINEAR};
    bolan_result result = bolan_gl_texture_create(&d, &a->aerial);
    const gl_texture *color = &a->aerial;
    for (int i = 0; i < SKY_AERIAL_SLICES && result == BOLAN_OK; i++) {
        result = bolan_gl_target_create(&color, 1, NULL, i, 0, &a->aerial_target[i]);
    }
    return result;
}

void bolan_atmosphere_share(atmosphere *a, const atmosphere *from) {
    a->borrowed = true;
    a->filled = false;
    a->transmittance_program = from->transmittance_program;
    a->multiple_program = from->multiple_program;
    a->view_program = from->view_program;
    a->aerial_program = from->aerial_program;
}

static bolan_result create_programs(atmosphere *a) {
    bolan_result result = bolan_gl_program_create("sky_transmittance", NULL, &a->transmittance_program);
    if (result == BOLAN_OK) result = bolan_gl_program_create("sky_multiple", NULL, &a->multiple_program);
    if (result == BOLAN_OK) result = bolan_gl_program_create("sky_view", NULL, &a->view_program);
    return result == BOLAN_OK ? bolan_gl_program_create("sky_aerial", NULL, &a->aerial_program) : result;
}

bolan_result bolan_atmosphere_create(atmosphere *a, const atmosphere *from) {
    memset(a, 0, sizeof *a);
    if (from != NULL) bolan_atmosphere_share(a, from);
    bolan_result result = from != NULL ? BOLAN_OK : create_programs(a);
    if (result == BOLAN_OK) {
        result = create_table(&a->transmittance, &a->transmittance_target, SKY_TRANSMITTANCE_WIDTH,
                              SKY_TRANSMITTANCE_HEIGHT);
    }
    if (result == BOLAN_OK)
        result = create_table(&a->multiple, &a->multiple_target, SKY_MULTIPLE_WIDTH, SKY_MULTIPLE_HEIGHT);
    if (result == BOLAN_OK) result = create_table(&a->eye_view, &a->eye_view_target, SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT);
    if (result == BOLAN_OK) result = create_table(&a->sea_view, &a->sea_view_target, SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT);
    if (result == BOLAN_OK) result = create_aerial(a);
    if (result != BOLAN_OK) bolan_atmosphere_free(a);
    return result;
}

bolan_result bolan_atmosphere_reload(atmosphere *a) {
    a->filled = false;
    bolan_result result = bolan_gl_program_reload(&a->transmittance_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&a->multiple_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&a->view_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&a->aerial_program);
    return result;
}

static void draw_table(const gl_target *target, const gl_program *program) {
    bolan_gl_target_bind(target);
    bolan_gl_program_use(program);
    bolan_gl_draw_fullscreen();
}

static void draw_air(atmosphere *a) {
    draw_table(&a->transmittance_target, &a->transmittance_program);
    bolan_gl_texture_bind(&a->transmittance, UNIT_TRANSMITTANCE);
    draw_table(&a->multiple_target, &a->multiple_program);
}

static void draw_views(atmosphere *a, float eye_height) {
    bolan_gl_texture_bind(&a->transmittance, UNIT_TRANSMITTANCE);
    bolan_gl_texture_bind(&a->multiple, UNIT_OWN);
    bolan_gl_program_float(&a->view_program, "view_height", eye_height);
    draw_table(&a->eye_view_target, &a->view_program);
    bolan_gl_program_float(&a->view_program, "view_height", 2.0f);
    draw_table(&a->sea_view_target, &a->view_program);
    for (int i = 0; i < SKY_AERIAL_SLICES; i++) {
        bolan_gl_program_float(&a->aerial_program, "slice", (float)i / (float)(SKY_AERIAL_SLICES - 1));
        draw_table(&a->aerial_target[i], &a->aerial_program);
    }
}

static bool air_is_stale(const atmosphere *a, const block_values *u) {
    return !a->filled || u->frame.visibility != a->visibility;
}

static bool views_are_stale(const atmosphere *a, const block_values *u) {
    return u->frame.sun_direction.z != a->sun_height || u->view.eye_height != a->eye_height ||
           u->frame.cloud_cover != a->cover || u->frame.cloud_base != a->cloud_base ||
           u->frame.radiance_unit != a->unit;
}

bool bolan_atmosphere_update(atmosphere *a, const block_values *u) {
    const bool air = air_is_stale(a, u);
    if (!air && !views_are_stale(a, u)) return false;
    const gl_state drawing = {.color_write = true};
    bolan_gl_set_state(&drawing);
    if (air) draw_air(a);
    draw_views(a, u->view.eye_height);
    a->filled = true;
    a->visibility = u->frame.visibility;
    a->cover = u->frame.cloud_cover;
    a->cloud_base = u->frame.cloud_base;
    a->sun_height = u->frame.sun_direction.z;
    a->eye_height = u->view.eye_height;
    a->unit = u->frame.radiance_unit;
    return true;
}

void bolan_atmosphere_bind(const atmosphere *a) {
    bolan_gl_texture_bind(&a->transmittance, UNIT_TRANSMITTANCE);
    bolan_gl_texture_bind(&a->eye_view, UNIT_SKY_VIEW);
    bolan_gl_texture_bind(&a->aerial, UNIT_AERIAL);
}

void bolan_atmosphere_free(atmosphere *a) {
    for (int i = 0; i < SKY_AERIAL_SLICES; i++) bolan_gl_target_free(&a->aerial_target[i]);
    bolan_gl_target_free(&a->transmittance_target);
    bolan_gl_target_free(&a->multiple_target);
    bolan_gl_target_free(&a->eye_view_target);
    bolan_gl_target_free(&a->sea_view_target);
    bolan_gl_texture_free(&a->transmittance);
    bolan_gl_texture_free(&a->multiple);
    bolan_gl_texture_free(&a->eye_view);
    bolan_gl_texture_free(&a->sea_view);
    bolan_gl_texture_free(&a->aerial);
    if (a->borrowed) return;
    bolan_gl_program_free(&a->transmittance_program);
    bolan_gl_program_free(&a->multiple_program);
    bolan_gl_program_free(&a->view_program);
    bolan_gl_program_free(&a->aerial_program);
}
