// SPDX-License-Identifier: MIT
// What the benchmarks measure: passes, the rate of copies, and the yardstick.
#include "renderer.h"

#include <time.h>

void bolan_renderer_measure_passes(bolan_renderer *r, bool on) { r->measure = on; }

bolan_frame_statistics bolan_renderer_statistics(const bolan_renderer *r) { return r->statistics; }

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

enum { COPIED_BYTES = 64 << 20 };

static double time_copies(gl_buffer *from, gl_buffer *to, uint32_t repeats) {
    bolan_gl_buffer_copy(from, 0, to, 0, COPIED_BYTES); // the first may pay for the memory
    bolan_gl_finish();
    const double start = now_ms();
    for (uint32_t i = 0; i < repeats; ++i) bolan_gl_buffer_copy(from, 0, to, 0, COPIED_BYTES);
    bolan_gl_finish();
    return (now_ms() - start) / (repeats > 0 ? repeats : 1);
}

double bolan_renderer_memory_rate(bolan_renderer *r, uint32_t repeats) {
    BOLAN_ASSERT(r != NULL);
    if (r == NULL || !bolan_renderer_has_context(r, CALL_MEMORY_RATE, "memory_rate")) return 0.0;
    bolan_renderer_accept(r, CALL_MEMORY_RATE);
    bolan_renderer_enter(r);
    gl_buffer from = {0}, to = {0};
    double ms = 0.0;
    bolan_result result = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, COPIED_BYTES, NULL, &from);
    if (result == BOLAN_OK) result = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, COPIED_BYTES, NULL, &to);
    if (result == BOLAN_OK) ms = time_copies(&from, &to, repeats);
    bolan_gl_buffer_free(&from);
    bolan_gl_buffer_free(&to);
    bolan_renderer_leave(r);
    return ms > 0.0 ? 2.0 * COPIED_BYTES / (ms * 1e-3) : 0.0;
}

static double run_yardstick(bolan_renderer *r, const gl_texture *image, uint32_t repeats) {
    bolan_gl_target_bind(&r->targets.hdr);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_texture_bind(image, UNIT_OWN);
    bolan_gl_program_use(&r->yardstick);
    bolan_gl_program_int(&r->yardstick, "image", UNIT_OWN);
    bolan_gl_draw_fullscreen(); // the first pays for compilation
    bolan_gl_finish();
    const double start = now_ms();
    for (uint32_t i = 0; i < repeats; ++i) {
        bolan_gl_draw_fullscreen();
        bolan_gl_finish();
    }
    return (now_ms() - start) / (repeats > 0 ? repeats : 1);
}

double bolan_renderer_yardstick(bolan_renderer *r, uint32_t width, uint32_t height, uint32_t repeats) {
    BOLAN_ASSERT(r != NULL);
    if (r == NULL || !bolan_renderer_has_context(r, CALL_YARDSTICK, "yardstick")) return 0.0;
    if (!bolan_is_picture_size(width) || !bolan_is_picture_size(height)) {
        bolan_renderer_refuse(r, CALL_YARDSTICK, BOLAN_LOG_OUT_OF_RANGE,
                              "yardstick: %u x %u pixels; expected 1 to %d each way", width, height, MOST_PIXELS);
        return 0.0;
    }
    bolan_renderer_accept(r, CALL_YARDSTICK);
    bolan_renderer_enter(r);
    double elapsed = 0.0;
    gl_texture image = {0};
    gl_texture_desc desc = {
        .format = GL_FMT_RGBA16F, .width = 256, .height = 256, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_REPEAT};
    bolan_result result = r->yardstick.id != 0 ? BOLAN_OK : bolan_gl_program_create("yardstick", NULL, &r->yardstick);
    if (result == BOLAN_OK) result = bolan_renderer_resize(r, width, height);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, &image);
    if (result == BOLAN_OK) elapsed = run_yardstick(r, &image, repeats);
    bolan_gl_texture_free(&image);
    bolan_renderer_leave(r);
    return elapsed;
}
