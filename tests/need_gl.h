// SPDX-License-Identifier: MIT
/// @file need_gl.h
/// What a test does where no OpenGL context can be made: it skips, or with BOLAN_REQUIRE_GL=1 in the environment it
/// fails, so that continuous integration cannot lose every picture test unnoticed.
#ifndef BOLAN_TESTS_NEED_GL_H
#define BOLAN_TESTS_NEED_GL_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

static inline int gl_is_required(void) {
    const char *required = getenv("BOLAN_REQUIRE_GL");
    return required && required[0] == '1';
}

/// In a test.
static inline void skip_without_gl(void) {
    if (gl_is_required()) fail_msg("there is no OpenGL here, and BOLAN_REQUIRE_GL is 1");
    print_message("skipped: there is no OpenGL on this machine\n");
    skip();
}

#endif
