// SPDX-License-Identifier: MIT
// What the current context can do.
#include "bolan/render.h"
#include "gl_internal.h"
#include <string.h>

bool gl_is_es(void) { return !epoxy_is_desktop_gl(); }

static const char *gl_string(GLenum name) {
    const GLubyte *s = glGetString(name);
    return s ? (const char *)s : "";
}

static bool is_software(const char *renderer) {
    return strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "swrast") ||
           strstr(renderer, "SwiftShader");
}

static bool has_clip_control(void) {
    if (gl_is_es()) return epoxy_has_gl_extension("GL_EXT_clip_control");
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

// Without a context the loader falls back to the system's library, which answers NULL.
static bool has_context(void) { return glGetString(GL_VERSION) != NULL; }

gl_caps gl_get_caps(void) {
    const bool es = gl_is_es();
    gl_caps caps = {.es = es,
                    .software = is_software(gl_string(GL_RENDERER)),
                    .clip_control = has_clip_control(),
                    // llvmpipe's count from when a worker picks the work up, and give nonsense for a pass that draws
                    // nothing.
                    .timers = !es && !is_software(gl_string(GL_RENDERER)),
                    .float_linear = !es || epoxy_has_gl_extension("GL_OES_texture_float_linear"),
                    .color_float =
                        !es || epoxy_gl_version() >= 32 || epoxy_has_gl_extension("GL_EXT_color_buffer_float"),
                    .max_anisotropy = 1.0f};
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") || epoxy_gl_version() >= 46) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &caps.max_anisotropy);
    }
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &caps.max_texture_size);
    return caps;
}

bolan_gl_info bolan_gl_get_info(void) {
    bolan_gl_info info = {"", "", "", "", false, false};
    if (!has_context()) return info;
    info.renderer = gl_string(GL_RENDERER);
    info.vendor = gl_string(GL_VENDOR);
    info.version = gl_string(GL_VERSION);
    info.shading_language = gl_string(GL_SHADING_LANGUAGE_VERSION);
    info.software = is_software(info.renderer);
    info.clip_control = has_clip_control();
    return info;
}
