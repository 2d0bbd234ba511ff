// SPDX-License-Identifier: MIT
// See water_air.h.
#include "water_air.h"

enum { LAYERS = 3, COLUMN = 16, ROW = 4 }; // pixels to one of the small picture: rows are where the horizon is

static const water_shader shader = {.stem = "water_air", .reads = WATER_FEATURE_LAND};

bolan_result bolan_water_air_create(water_air *a, const render_view *v) {
    const gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                                  .width = (v->width + COLUMN - 1) / COLUMN,
                                  .height = (v->height + ROW - 1) / ROW,
                                  .depth = LAYERS,
                                  .array = true,
                                  .filter = GL_FILTER_LINEAR,
                                  .wrap = GL_WRAP_CLAMP};
    const gl_texture *layers[LAYERS] = {&a->map, &a->map, &a->map};
    bolan_result result = bolan_gl_texture_create(&desc, &a->map);
    if (result == BOLAN_OK) result = bolan_gl_target_create(layers, LAYERS, NULL, 0, 0, &a->target);
    if (result != BOLAN_OK) bolan_water_air_free(a);
    return result;
}

void bolan_water_air_list(const water_setup *s, water_programs *all) {
    bolan_water_programs_add(all, s, false, &shader, 0);
}

bool bolan_water_air_draw(const water_air *a, const water_draw *d) {
    const gl_program *g = bolan_water_program(d, &shader, 0);
    if (g == NULL) return false;
    const uint32_t width = a->map.width, height = a->map.height;
    const uint32_t rows = (bolan_water_rows(d->view, d->vertical) + ROW - 1) / ROW + 1;
    bolan_gl_program_vec4(g, "air_size", (bolan_vec4){1.0f / (float)width, 1.0f / (float)height, 0.0f, 0.0f});
    bolan_gl_target_bind_part(&a->target, 0, 0, width, rows < height ? rows : height);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
    return true;
}

void bolan_water_air_free(water_air *a) {
    bolan_gl_target_free(&a->target);
    bolan_gl_texture_free(&a->map);
}
