// SPDX-License-Identifier: MIT
// The driver's messages: they go to the log while the library is inside, and to the caller's own callback too.
#include "gl_internal.h"
#include <string.h>

// What GL has as one function on the desktop and in ES 3.2 is another in older ES.
static bool debug_is_khr(const gl_caps *caps) { return caps->es && bolan_gl_version() < 32; }

static void set_callback(const gl_caps *caps, GLDEBUGPROC callback, const void *user) {
    if (debug_is_khr(caps)) {
        glDebugMessageCallbackKHR(callback, user);
    } else {
        glDebugMessageCallback(callback, user);
    }
}

static void *get_pointer(const gl_caps *caps, GLenum name) {
    void *pointer = NULL;
    if (debug_is_khr(caps)) {
        glGetPointervKHR(name, &pointer);
    } else {
        glGetPointerv(name, &pointer);
    }
    return pointer;
}

// A pointer to a function comes out of GL as a pointer to an object; C has no cast between the two.
static GLDEBUGPROC callback_of(const gl_saved *s) {
    GLDEBUGPROC callback;
    memcpy(&callback, &s->debug.callback, sizeof callback);
    return callback;
}

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                const GLchar *message, const void *user) {
    const gl_saved *s = user;
    if (severity != GL_DEBUG_SEVERITY_NOTIFICATION) {
        const bolan_log_level level = type == GL_DEBUG_TYPE_ERROR ? BOLAN_LOG_ERROR : BOLAN_LOG_WARNING;
        bolan_log(level, BOLAN_LOG_GL_DEBUG, "the driver says: %s", message);
    }
    const GLDEBUGPROC callers = callback_of(s);
    if (callers && s->debug.output) callers(source, type, id, severity, length, message, s->debug.user);
}

void bolan_gl_listen(gl_saved *s) {
    s->debug.on = true;
    s->debug.output = glIsEnabled(GL_DEBUG_OUTPUT);
    s->debug.synchronous = glIsEnabled(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    s->debug.callback = get_pointer(s->caps, GL_DEBUG_CALLBACK_FUNCTION);
    s->debug.user = get_pointer(s->caps, GL_DEBUG_CALLBACK_USER_PARAM);
    set_callback(s->caps, on_message, s);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}

void bolan_gl_stop_listening(const gl_saved *s) {
    set_callback(s->caps, callback_of(s), s->debug.user);
    bolan_gl_set_enabled(GL_DEBUG_OUTPUT, s->debug.output);
    bolan_gl_set_enabled(GL_DEBUG_OUTPUT_SYNCHRONOUS, s->debug.synchronous);
}
