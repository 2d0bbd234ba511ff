// SPDX-License-Identifier: MIT
// Tests that need a context: one per API, without a window.
#ifndef BOLAN_TESTS_GL_SUPPORT_H
#define BOLAN_TESTS_GL_SUPPORT_H

#include <math.h>
#include <stdlib.h>

#include "../gl_watch.h"
#include "bolan/render.h"
#include "need_gl.h"
#include "render/gl/gl.h"

static inline int gl_setup(void **state, bolan_gl_api api) {
    bolan_context *context = NULL;
    if (bolan_context_create(api, &context) != BOLAN_OK) {
        print_message("no %s context on this machine\n", api == BOLAN_GL_ES ? "ES 3" : "core");
        // cmocka skips no test from its set-up: where there is no OpenGL at all the whole program is skipped.
        if (!gl_is_required() && bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) exit(77);
        return -1;
    }
    watch_begin();
    *state = context;
    return 0;
}
static inline int gl_setup_core(void **state) { return gl_setup(state, BOLAN_GL_CORE); }
static inline int gl_setup_es(void **state) { return gl_setup(state, BOLAN_GL_ES); }
static inline int gl_teardown(void **state) {
    bolan_context *context = *state;
    bolan_context_make_current(context);
    const bool clean = watch_is_clean("at the end of the test");
    bolan_context_destroy(&context);
    return clean ? 0 : -1;
}

// Bytes of a framebuffer, top row first.
static inline void read_bytes(uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgb) {
    uint8_t *scratch = malloc((size_t)width * height * 4);
    bolan_gl_read_rgb8(framebuffer, width, height, scratch, rgb);
    free(scratch);
}

// Depths, bottom row first.
static inline void read_depths(const gl_texture *depth, float *out) {
    const size_t pixels = (size_t)depth->width * depth->height;
    float *rgba = malloc(pixels * 4 * sizeof *rgba);
    gl_depth_reader reader = {0};
    assert_int_equal(bolan_gl_depth_read(&reader, depth, rgba), BOLAN_OK);
    for (size_t i = 0; i < pixels; i++) out[i] = rgba[4 * i];
    bolan_gl_depth_reader_free(&reader);
    free(rgba);
}

// Doubles, and both numbers in the message.
#define assert_near(got, want, tolerance)                                            \
    do {                                                                             \
        const double got_ = (got), want_ = (want), tolerance_ = (tolerance);         \
        if (!(fabs(got_ - want_) <= tolerance_))                                     \
            fail_msg("%s is %.9g, not %.9g +- %.3g", #got, got_, want_, tolerance_); \
    } while (0)

// One test function as two tests: in a desktop core and in an ES 3 context.
#define IN_BOTH_APIS(f) \
    {#f " (core)", f, gl_setup_core, gl_teardown, NULL}, { #f " (es)", f, gl_setup_es, gl_teardown, NULL }

/// Two small cascades, at 3 s.
static inline bolan_sea *small_sea(bolan_sea_state state) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = state;
    desc.resolution = 64;
    desc.fft.cascade_count = 2;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 3.0);
    return sea;
}

#endif
