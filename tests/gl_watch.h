// SPDX-License-Identifier: MIT
// An eye on the driver: an error that it reports to the debug callback, or that glGetError() has at the end, fails the
// test.
#ifndef BOLAN_TESTS_GL_WATCH_H
#define BOLAN_TESTS_GL_WATCH_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>

static struct {
    int errors;
    char first[512];
} watched;

static inline void APIENTRY watch_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                          const GLchar *message, const void *user) {
    (void)id, (void)severity, (void)length, (void)user;
    if (source != GL_DEBUG_SOURCE_API || type != GL_DEBUG_TYPE_ERROR) return; // a shader that does not compile is none
    if (watched.errors++ == 0) snprintf(watched.first, sizeof watched.first, "%s", message);
}

// Set where a test runs for the sanitizers' sake, which a few of its many cases serve as well.
static inline bool test_is_short(void) { return getenv("BOLAN_TEST_SHORT") != NULL; }

// From now on in the current context. Can be called again.
static inline void watch_begin(void) {
    const int core = epoxy_is_desktop_gl() ? 43 : 32;
    if (epoxy_gl_version() < core && !(epoxy_is_desktop_gl() && epoxy_has_gl_extension("GL_KHR_debug"))) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(watch_message, NULL);
}

// Whether nothing was wrong since the last time; says what was.
static inline bool watch_is_clean(const char *where) {
    const GLenum error = glGetError();
    const bool clean = error == GL_NO_ERROR && watched.errors == 0;
    if (!clean)
        print_error("%s: glGetError() is 0x%x, the driver reported %d errors%s%s\n", where, error, watched.errors,
                    watched.errors > 0 ? ", the first: " : "", watched.first);
    while (glGetError() != GL_NO_ERROR) {}
    watched.errors = 0;
    watched.first[0] = '\0';
    return clean;
}

#endif
