// SPDX-License-Identifier: MIT
// A context without a window: EGL on Mesa's surfaceless platform, else on the default display.
#include "bolan/render.h"
#include "gl_internal.h"
#include <epoxy/egl.h>
#include <string.h>

struct bolan_context {
    EGLDisplay display;
    EGLContext context;
};

// Displays are shared by everything in the process that uses EGL, so none is ever terminated here.
static EGLDisplay open_display(void) {
    const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EGLDisplay display = EGL_NO_DISPLAY;
    if (client && strstr(client, "EGL_EXT_platform_base") && strstr(client, "EGL_MESA_platform_surfaceless")) {
        display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL)) return display;
    }
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL) ? display : EGL_NO_DISPLAY;
}

static EGLContext ask(EGLDisplay display, EGLConfig config, bolan_gl_api api, int version) {
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION,
                           version / 10,
                           EGL_CONTEXT_MINOR_VERSION,
                           version % 10,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
    const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, version / 10, EGL_CONTEXT_MINOR_VERSION, version % 10, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, api == BOLAN_GL_ES ? es : core);
}

// The version with compute shaders, else the least that will do: some drivers make what they are asked for and no more.
static EGLContext create_egl_context(EGLDisplay display, bolan_gl_api api) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                             api == BOLAN_GL_ES ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
    if (!eglBindAPI(api == BOLAN_GL_ES ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
    const bool es = api == BOLAN_GL_ES;
    const EGLContext context = ask(display, config, api, es ? 31 : 43);
    return context != EGL_NO_CONTEXT ? context : ask(display, config, api, es ? 30 : 33);
}

bolan_result bolan_context_create(bolan_gl_api api, bolan_context **out) {
    BOLAN_ASSERT(out);
    *out = NULL;
    const char *name = api == BOLAN_GL_ES ? "OpenGL ES 3.0" : "OpenGL 3.3 core";
    const EGLDisplay display = open_display();
    if (display == EGL_NO_DISPLAY) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT,
                  "no EGL display can be opened without a window (EGL error 0x%x)", (unsigned)eglGetError());
        return BOLAN_ERROR_GL;
    }
    const EGLContext context = create_egl_context(display, api);
    if (context == EGL_NO_CONTEXT) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_VERSION, "this machine has no %s context (EGL error 0x%x)", name,
                  (unsigned)eglGetError());
        return BOLAN_ERROR_GL;
    }
    bolan_context *c = bolan_allocate(sizeof *c);
    if (!c) {
        eglDestroyContext(display, context);
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a GL context");
        return BOLAN_ERROR_MEMORY;
    }
    *c = (bolan_context){display, context};
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT, "the %s context cannot be made current without a surface",
                  name);
        bolan_context_destroy(&c);
        return BOLAN_ERROR_GL;
    }
    bolan_gl_load();
    *out = c;
    return BOLAN_OK;
}

void bolan_context_make_current(bolan_context *context) {
    if (context) eglMakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE, context->context);
}

void bolan_context_destroy(bolan_context **context) {
    if (!context || !*context) return;
    bolan_context *c = *context;
    if (eglGetCurrentContext() == c->context)
        eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(c->display, c->context);
    bolan_release(c, sizeof *c);
    *context = NULL;
}
