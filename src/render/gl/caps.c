// SPDX-License-Identifier: MIT
// What the current context can do.
#include "bolan/render.h"
#include "gl_internal.h"
#include <limits.h>
#include <string.h>

static const char *gl_string(GLenum name) {
    const GLubyte *s = glGetString(name);
    return s ? (const char *)s : "";
}

static bool is_software(const char *renderer) {
    return strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "swrast") ||
           strstr(renderer, "SwiftShader");
}

// A loader may lack the function of an extension that the context has.
static bool has_clip_control(void) {
    const gl_functions *f = &bolan_gl_functions;
    if (bolan_gl_is_es()) return bolan_gl_has_extension("GL_EXT_clip_control") && f->ClipControlEXT;
    return (bolan_gl_version() >= 45 || bolan_gl_has_extension("GL_ARB_clip_control")) && f->ClipControl;
}

// OpenGL ES 3.0 in a browser, with less state and stricter rules.
static bool is_webgl(void) { return strstr(gl_string(GL_VERSION), "WebGL") != NULL; }

// Without a context the system's library answers NULL; most other calls would end the process in the loader.
bool bolan_gl_has_context(void) {
    bolan_gl_load();
    return bolan_gl_functions.GetString && glGetString(GL_VERSION) != NULL;
}

bolan_result bolan_gl_check_context(const char *whom) {
    if (!bolan_gl_has_context()) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT, "%s: no OpenGL context is current on this thread", whom);
        return BOLAN_ERROR_GL;
    }
    const int version = bolan_gl_version(), least = bolan_gl_is_es() ? 30 : 33;
    const char *missing = bolan_gl_load();
    if (version >= least && missing) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_LOADER, "%s: the get_proc_address hook does not know %s", whom,
                  missing);
        return BOLAN_ERROR_GL;
    }
    if (version >= least) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_VERSION,
              "%s: the current context is OpenGL%s %d.%d; expected OpenGL 3.3, OpenGL ES 3.0 or later", whom,
              bolan_gl_is_es() ? " ES" : "", version / 10, version % 10);
    return BOLAN_ERROR_GL;
}

// Of ES, which has views of textures by an extension alone.
static bool has_texture_view(void) {
    return (bolan_gl_has_extension("GL_EXT_texture_view") && bolan_gl_functions.TextureViewEXT) ||
           (bolan_gl_has_extension("GL_OES_texture_view") && bolan_gl_functions.TextureViewOES);
}

static bool has_compute(void) {
    const gl_functions *f = &bolan_gl_functions;
    if (!f->DispatchCompute || !f->DispatchComputeIndirect || !f->BindImageTexture || !f->MemoryBarrier ||
        !f->TexStorage3D)
        return false;
    return bolan_gl_is_es() ? bolan_gl_version() >= 31 && has_texture_view()
                            : bolan_gl_version() >= 43 && f->TextureView;
}

static bool has(const char *extension) { return bolan_gl_has_extension(extension); }

static int integer(GLenum name, int most) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value < most ? value : most;
}

static bool is_compatibility(bool es) {
    return !es && (integer(GL_CONTEXT_PROFILE_MASK, INT_MAX) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
}

static bool has_timestamps(bool es) {
    GLint bits = 0;
    if (!es) glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0;
}

// State beyond GL 3.3 and ES 3.0 that a host may have set.
static void find_state(gl_caps *caps) {
    const int version = bolan_gl_version();
    const bool es = caps->es, indexed = has("GL_OES_draw_buffers_indexed") || has("GL_EXT_draw_buffers_indexed");
    caps->debug = version >= (es ? 32 : 43) || has("GL_KHR_debug");
    caps->feedback_pause = es || version >= 40 || has("GL_ARB_transform_feedback2");
    caps->sample_mask = version >= (es ? 31 : 32);
    caps->sample_shading = version >= (es ? 32 : 40) || has(es ? "GL_OES_sample_shading" : "GL_ARB_sample_shading");
    caps->fixed_restart = (es && !is_webgl()) || version >= 43 || has("GL_ARB_ES3_compatibility");
    caps->depth_bounds = has("GL_EXT_depth_bounds_test");
    caps->query_buffer = !es && (version >= 44 || has("GL_ARB_query_buffer_object"));
    caps->buffer_masks = es ? version >= 32 || (version >= 31 && indexed) : true;
    caps->buffer_blends = es ? caps->buffer_masks : version >= 40 || has("GL_ARB_draw_buffers_blend");
    caps->viewport_arrays = !es && (version >= 41 || has("GL_ARB_viewport_array"));
    caps->draw_buffers = caps->buffer_masks ? integer(GL_MAX_DRAW_BUFFERS, GL_SAVED_BUFFERS) : 1;
    caps->viewports = caps->viewport_arrays ? integer(GL_MAX_VIEWPORTS, GL_SAVED_VIEWPORTS) : 1;
    if (!es || has("GL_EXT_clip_cull_distance") || has("GL_APPLE_clip_distance"))
        caps->clip_distances = integer(GL_MAX_CLIP_DISTANCES, GL_SAVED_CLIPS);
}

gl_caps bolan_gl_get_caps(void) {
    const bool es = bolan_gl_is_es(), software = is_software(gl_string(GL_RENDERER)), timestamps = has_timestamps(es);
    gl_caps caps = {.es = es,
                    .compatibility = is_compatibility(es),
                    .software = software,
                    .clip_control = has_clip_control(),
                    .compute = has_compute(),
                    .timestamps = timestamps,
                    // llvmpipe's count from when a worker picks the work up, and give nonsense for a pass that draws
                    // nothing.
                    .timers = timestamps && !software,
                    .bind_units = !es && bolan_gl_version() >= 45 && bolan_gl_functions.BindTextureUnit,
                    .float_linear = !es || has("GL_OES_texture_float_linear"),
                    .color_float = !es || bolan_gl_version() >= 32 || has("GL_EXT_color_buffer_float"),
                    .max_anisotropy = 1.0f};
    if (has("GL_EXT_texture_filter_anisotropic") || bolan_gl_version() >= 46) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &caps.max_anisotropy);
    }
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &caps.max_texture_size);
    find_state(&caps);
    return caps;
}

// Of a texture that is drawn into, each way.
static uint32_t max_picture(void) {
    GLint texture = 0, viewport[2] = {0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const GLint view = viewport[0] < viewport[1] ? viewport[0] : viewport[1];
    return (uint32_t)(texture < view ? texture : view);
}

bolan_gl_info bolan_gl_get_info(void) {
    bolan_gl_info info = {"", "", "", "", false, false, false, 0};
    if (!bolan_gl_has_context()) return info;
    info.renderer = gl_string(GL_RENDERER);
    info.vendor = gl_string(GL_VENDOR);
    info.version = gl_string(GL_VERSION);
    if (bolan_gl_version() >= 20) info.shading_language = gl_string(GL_SHADING_LANGUAGE_VERSION);
    info.software = is_software(info.renderer);
    info.clip_control = has_clip_control();
    info.compute = has_compute();
    info.max_picture = max_picture();
    return info;
}
