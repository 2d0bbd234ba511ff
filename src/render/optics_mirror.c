// SPDX-License-Identifier: MIT
// See shaders/water_mirror.glsl.
#include "water_optics.h"

static bolan_result create(void *state, bolan_quality quality) {
    (void)state, (void)quality;
    return BOLAN_OK;
}

static void draw(void *state, const water_draw *d) {
    (void)state;
    const gl_program *g = water_program(d, "water_mirror", 0, "");
    if (!g) return;
    water_look_apply(g, &d->f->scene->look);
    water_draw_forward(d);
}

static void free_all(void *state) { (void)state; }

const water_optics optics_mirror = {.size = 1, .create = create, .draw = draw, .free = free_all};
