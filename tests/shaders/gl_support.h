// SPDX-License-Identifier: MIT
// Tests that need a context: one per API, without a window.
#ifndef BOLAN_TESTS_GL_SUPPORT_H
#define BOLAN_TESTS_GL_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "bolan/render.h"

static inline int gl_setup(void **state, bolan_gl_api api) {
    bolan_context *context = NULL;
    if (bolan_context_create(api, &context) != BOLAN_OK) {
        print_message("[  SKIP  ] no %s context on this machine\n", api == BOLAN_GL_ES ? "ES 3" : "core");
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
