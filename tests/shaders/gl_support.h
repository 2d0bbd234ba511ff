// SPDX-License-Identifier: MIT
// Tests that need a context: one per API, without a window.
#ifndef BOLAN_TESTS_GL_SUPPORT_H
#define BOLAN_TESTS_GL_SUPPORT_H

#include "bolan/render.h"
#include "need_gl.h"

#include <math.h>

static inline int gl_setup(void **state, bolan_gl_api api) {
    bolan_context *context = NULL;
    if (bolan_context_create(api, &context) != BOLAN_OK) {
        print_message("no %s context on this machine\n", api == BOLAN_GL_ES ? "ES 3" : "core");
        // cmocka skips no test from its set-up: where there is no OpenGL at all the whole program is skipped.
        if (!gl_is_required() && bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) exit(77);
        return -1;
    }
    *state = context;
    return 0;
}
static inline int gl_setup_core(void **state) { return gl_setup(state, BOLAN_GL_CORE); }
static inline int gl_setup_es(void **state) { return gl_setup(state, BOLAN_GL_ES); }
static inline int gl_teardown(void **state) {
    bolan_context *context = *state;
    bolan_context_destroy(&context);
    return 0;
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

#endif
