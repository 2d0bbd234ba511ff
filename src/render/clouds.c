// SPDX-License-Identifier: MIT
// Keeps the cloud panorama and the shadow map.
#include "clouds.h"

#include <math.h>
#include <string.h>

enum { PANORAMA_WIDTH = 2048, PANORAMA_HEIGHT = 512 };

bolan_result clouds_create(clouds *c) {
    memset(c, 0, sizeof *c);
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = PANORAMA_WIDTH, .height = PANORAMA_HEIGHT, .depth = 2,
                               .array = true, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_REPEAT_CLAMP};
    const gl_texture *color = &c->map;
    bolan_result result = gl_texture_create(&d, &c->map);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 0, 0, &c->panorama_target);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 1, 0, &c->shadow_target);
    if (result != BOLAN_OK) clouds_free(c);
    return result;
}

bolan_result clouds_reload(clouds *c) {
    c->filled = false;
    return BOLAN_OK;
}

bool clouds_place(clouds *c, const frame *f, frame_uniforms *u) {
    (void)f;
    u->haze.z = 0.0f;
    return !c->filled;
}

void clouds_march(clouds *c, const frame *f) {
    (void)f;
    gl_target_bind(&c->panorama_target);
    gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    gl_target_bind(&c->shadow_target);
    gl_target_clear_color(1.0f, 1.0f, 1.0f, 1.0f);
    c->filled = true;
}

void clouds_free(clouds *c) {
    gl_target_free(&c->panorama_target);
    gl_target_free(&c->shadow_target);
    gl_texture_free(&c->map);
    gl_texture_free(&c->noise);
    gl_program_free(&c->noise_program);
    gl_program_free(&c->panorama_program);
    gl_program_free(&c->shadow_program);
}
