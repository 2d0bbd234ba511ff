// SPDX-License-Identifier: MIT
// See shaders/water_crest.glsl.
#include "water_optics.h"

static bolan_result create(void *state, bolan_quality quality) {
    (void)state, (void)quality;
    return BOLAN_OK;
}

static void draw(void *state, const water_draw *d) {
    (void)state;
    const gl_program *g = water_program(d, "water_crest", 0, "");
    if (!g) return;
    water_look_apply(g, &d->f->scene->look);
    water_draw_forward(d);
}

static void free_all(void *state) { (void)state; }

const water_optics optics_crest = {.size = 1, .static_grid = true, .packed = true, .create = create, .draw = draw, .free = free_all};
