// SPDX-License-Identifier: MIT
// See pixels.h.
#include "pixels.h"

static uint32_t groups(uint32_t pixels) { return (pixels + PIXEL_GROUP - 1) / PIXEL_GROUP; }

static void dispatch(const gl_program *program, const gl_target *t, uint32_t from, uint32_t to) {
    gl_compute_saved saved;
    bolan_gl_compute_begin(&saved);
    bolan_gl_image_bind(&t->color, 0, 0);
    bolan_gl_program_vec4(program, "region", (bolan_vec4){0.0f, (float)from, (float)t->width, (float)to});
    bolan_gl_dispatch(groups(t->width), groups(to - from), 1);
    bolan_gl_wait_for(GL_BARRIER_ALL);
    bolan_gl_compute_end(&saved);
}

void bolan_pixels_draw(const gl_program *program, const gl_target *target, uint32_t from, uint32_t to) {
    if (program->compute) {
        dispatch(program, target, from, to);
        return;
    }
    bolan_gl_target_bind_part(target, 0, from, target->width, to - from);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
}
