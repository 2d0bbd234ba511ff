// SPDX-License-Identifier: MIT
// The caller's state: written down before a frame, given back after it. Between the two everything that could change
// what our own calls mean (bound samplers, pixel store, stencil, ...) stands at GL's defaults.
#include "gl_internal.h"
#include <string.h>

enum { SAVED_UNITS = SCRATCH_UNIT + 1, TEXTURE_KINDS = 3, MAX_TOGGLES = 16 };

static const GLenum texture_targets[TEXTURE_KINDS] = {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY};
static const GLenum texture_bindings[TEXTURE_KINDS] = {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
                                                       GL_TEXTURE_BINDING_2D_ARRAY};

// Switches, and what they are while we draw. The first five are what gl_set_state() moves.
typedef struct toggle {
    GLenum name;
    bool desktop_only;
} toggle;
static const toggle toggles[] = {
    {GL_DEPTH_TEST, false},
    {GL_CULL_FACE, false},
    {GL_BLEND, false},
    {GL_SCISSOR_TEST, false},
    {GL_STENCIL_TEST, false},
    {GL_POLYGON_OFFSET_FILL, false},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, false},
    {GL_SAMPLE_COVERAGE, false},
    {GL_RASTERIZER_DISCARD, false},
    {GL_DITHER, false},
    {GL_PRIMITIVE_RESTART, true},
    {GL_FRAMEBUFFER_SRGB, true},
    {GL_DEPTH_CLAMP, true},
    {GL_COLOR_LOGIC_OP, true},
    {GL_PROGRAM_POINT_SIZE, true},
};
enum { TOGGLE_COUNT = sizeof toggles / sizeof toggles[0] };

static const GLenum unpack_names[] = {
    GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_IMAGES, GL_PACK_ALIGNMENT,    GL_PACK_ROW_LENGTH,  GL_PACK_SKIP_ROWS,     GL_PACK_SKIP_PIXELS};
static const GLint unpack_defaults[] = {4, 0, 0, 0, 0, 0, 4, 0, 0, 0};
enum { PIXEL_STORE_COUNT = sizeof unpack_names / sizeof unpack_names[0] };

struct gl_saved {
    GLint draw_framebuffer, read_framebuffer, viewport[4], scissor[4];
    GLint program, vertex_array, array_buffer, uniform_buffer, uniform_slot, pixel_pack, pixel_unpack;
    GLint64 uniform_offset, uniform_size;
    GLint active_unit, textures[SAVED_UNITS][TEXTURE_KINDS], samplers[SAVED_UNITS];
    GLboolean toggles[MAX_TOGGLES];
    GLint blend_rgb[2], blend_alpha[2], blend_equation[2], cull_mode, front_face, depth_function, polygon_mode[2];
    GLint clip_origin, clip_depth;
    GLboolean depth_mask, color_mask[4];
    GLfloat depth_range[2], depth_clear, color_clear[4];
    GLint pixel_store[PIXEL_STORE_COUNT];
};

size_t gl_saved_size(void) { return sizeof(gl_saved); }

static bool has_clip_control(void) { return gl_get_caps().clip_control; }

static void set_enabled(GLenum name, bool on) {
    if (on) {
        glEnable(name);
    } else {
        glDisable(name);
    }
}

static void clip_control(GLint origin, GLint depth) {
    if (gl_is_es()) {
        glClipControlEXT((GLenum)origin, (GLenum)depth);
    } else {
        glClipControl((GLenum)origin, (GLenum)depth);
    }
}

// ---- save ---------------------------------------------------------------------------------------------------------

static void save_bindings(gl_saved *s) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &s->draw_framebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &s->read_framebuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &s->program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &s->vertex_array);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &s->array_buffer);
    glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &s->uniform_buffer);
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &s->uniform_slot);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, 0, &s->uniform_offset);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, 0, &s->uniform_size);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &s->pixel_pack);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &s->pixel_unpack);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &s->active_unit);
    for (GLuint unit = 0; unit < SAVED_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (int k = 0; k < TEXTURE_KINDS; k++) glGetIntegerv(texture_bindings[k], &s->textures[unit][k]);
        glGetIntegerv(GL_SAMPLER_BINDING, &s->samplers[unit]);
    }
}

static void save_blend_and_depth(gl_saved *s) {
    glGetIntegerv(GL_BLEND_SRC_RGB, &s->blend_rgb[0]);
    glGetIntegerv(GL_BLEND_DST_RGB, &s->blend_rgb[1]);
    glGetIntegerv(GL_BLEND_SRC_ALPHA, &s->blend_alpha[0]);
    glGetIntegerv(GL_BLEND_DST_ALPHA, &s->blend_alpha[1]);
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &s->blend_equation[0]);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &s->blend_equation[1]);
    glGetIntegerv(GL_CULL_FACE_MODE, &s->cull_mode);
    glGetIntegerv(GL_FRONT_FACE, &s->front_face);
    glGetIntegerv(GL_DEPTH_FUNC, &s->depth_function);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &s->depth_mask);
    glGetBooleanv(GL_COLOR_WRITEMASK, s->color_mask);
    glGetFloatv(GL_DEPTH_RANGE, s->depth_range);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &s->depth_clear);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, s->color_clear);
}

static void save_rest(gl_saved *s) {
    glGetIntegerv(GL_VIEWPORT, s->viewport);
    glGetIntegerv(GL_SCISSOR_BOX, s->scissor);
    for (int i = 0; i < TOGGLE_COUNT; i++) {
        s->toggles[i] = toggles[i].desktop_only && gl_is_es() ? GL_FALSE : glIsEnabled(toggles[i].name);
    }
    for (int i = 0; i < PIXEL_STORE_COUNT; i++) glGetIntegerv(unpack_names[i], &s->pixel_store[i]);
    if (has_clip_control()) {
        glGetIntegerv(GL_CLIP_ORIGIN, &s->clip_origin);
        glGetIntegerv(GL_CLIP_DEPTH_MODE, &s->clip_depth);
    }
    if (!gl_is_es()) glGetIntegerv(GL_POLYGON_MODE, s->polygon_mode);
}

// What our calls take for granted.
static void set_defaults(void) {
    for (int i = 0; i < TOGGLE_COUNT; i++) {
        if (!(toggles[i].desktop_only && gl_is_es())) glDisable(toggles[i].name);
    }
    for (int i = 0; i < PIXEL_STORE_COUNT; i++) glPixelStorei(unpack_names[i], unpack_defaults[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (GLuint unit = 0; unit < SAVED_UNITS; unit++) glBindSampler(unit, 0);
    glBlendEquation(GL_FUNC_ADD);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthRangef(0.0f, 1.0f);
    if (!gl_is_es()) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void gl_save(gl_saved *s) {
    memset(s, 0, sizeof *s);
    save_bindings(s);
    save_blend_and_depth(s);
    save_rest(s);
    set_defaults();
}

// ---- restore ------------------------------------------------------------------------------------------------------

static void restore_uniform_slot(const gl_saved *s) {
    if (s->uniform_slot != 0 && s->uniform_size > 0) {
        glBindBufferRange(GL_UNIFORM_BUFFER, 0, (GLuint)s->uniform_slot, (GLintptr)s->uniform_offset,
                          (GLsizeiptr)s->uniform_size);
    } else {
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, (GLuint)s->uniform_slot);
    }
    glBindBuffer(GL_UNIFORM_BUFFER, (GLuint)s->uniform_buffer);
}

static void restore_bindings(const gl_saved *s) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)s->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)s->read_framebuffer);
    glUseProgram((GLuint)s->program);
    glBindVertexArray((GLuint)s->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, (GLuint)s->array_buffer);
    restore_uniform_slot(s);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)s->pixel_pack);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)s->pixel_unpack);
    for (GLuint unit = 0; unit < SAVED_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (int k = 0; k < TEXTURE_KINDS; k++) glBindTexture(texture_targets[k], (GLuint)s->textures[unit][k]);
        glBindSampler(unit, (GLuint)s->samplers[unit]);
    }
    glActiveTexture((GLenum)s->active_unit);
}

static void restore_blend_and_depth(const gl_saved *s) {
    glBlendFuncSeparate((GLenum)s->blend_rgb[0], (GLenum)s->blend_rgb[1], (GLenum)s->blend_alpha[0],
                        (GLenum)s->blend_alpha[1]);
    glBlendEquationSeparate((GLenum)s->blend_equation[0], (GLenum)s->blend_equation[1]);
    glCullFace((GLenum)s->cull_mode);
    glFrontFace((GLenum)s->front_face);
    glDepthFunc((GLenum)s->depth_function);
    glDepthMask(s->depth_mask);
    glColorMask(s->color_mask[0], s->color_mask[1], s->color_mask[2], s->color_mask[3]);
    glDepthRangef(s->depth_range[0], s->depth_range[1]);
    glClearDepthf(s->depth_clear);
    glClearColor(s->color_clear[0], s->color_clear[1], s->color_clear[2], s->color_clear[3]);
}

void gl_restore(const gl_saved *s) {
    restore_bindings(s);
    restore_blend_and_depth(s);
    glViewport(s->viewport[0], s->viewport[1], s->viewport[2], s->viewport[3]);
    glScissor(s->scissor[0], s->scissor[1], s->scissor[2], s->scissor[3]);
    for (int i = 0; i < TOGGLE_COUNT; i++) {
        if (!(toggles[i].desktop_only && gl_is_es())) set_enabled(toggles[i].name, s->toggles[i]);
    }
    for (int i = 0; i < PIXEL_STORE_COUNT; i++) glPixelStorei(unpack_names[i], s->pixel_store[i]);
    if (has_clip_control()) clip_control(s->clip_origin, s->clip_depth);
    if (!gl_is_es()) glPolygonMode(GL_FRONT_AND_BACK, (GLenum)s->polygon_mode[0]);
}

// ---- our own ------------------------------------------------------------------------------------------------------

void gl_set_state(const gl_state *s) {
    // Writing depth without testing it needs the test switched on with ALWAYS.
    set_enabled(GL_DEPTH_TEST, s->depth_test || s->depth_write);
    glDepthFunc(!s->depth_test ? GL_ALWAYS : s->depth_equal ? GL_EQUAL : GL_GEQUAL);
    glDepthMask(s->depth_write);
    set_enabled(GL_CULL_FACE, s->cull_back);
    glColorMask(s->color_write, s->color_write, s->color_write, s->color_write);
    set_enabled(GL_BLEND, s->blend != GL_BLEND_NONE);
    switch (s->blend) {
    case GL_BLEND_NONE: break;
    case GL_BLEND_ALPHA:
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        break;
    case GL_BLEND_ADD: glBlendFunc(GL_ONE, GL_ONE); break;
    case GL_BLEND_PREMULTIPLIED: glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    }
}

void gl_set_clip_zero_to_one(bool on) {
    if (has_clip_control()) clip_control(GL_LOWER_LEFT, on ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

void gl_set_framebuffer_srgb(bool on) {
    if (!gl_is_es()) set_enabled(GL_FRAMEBUFFER_SRGB, on);
}

bool gl_check_errors(const char *where) {
    bool clean = true;
    for (GLenum error; (error = glGetError()) != GL_NO_ERROR;) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_DEBUG, "GL error 0x%x at %s", error, where);
        clean = false;
    }
    return clean;
}

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                const GLchar *message, const void *user) {
    (void)source, (void)id, (void)length, (void)user;
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    const bolan_log_level level = type == GL_DEBUG_TYPE_ERROR ? BOLAN_LOG_ERROR : BOLAN_LOG_WARNING;
    bolan_log(level, BOLAN_LOG_GL_DEBUG, "the driver says: %s", message);
}

void gl_debug_log(bool on) {
    const bool available = gl_is_es() ? epoxy_gl_version() >= 32 || epoxy_has_gl_extension("GL_KHR_debug")
                                      : epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
    if (!available) return;
    set_enabled(GL_DEBUG_OUTPUT, on);
    set_enabled(GL_DEBUG_OUTPUT_SYNCHRONOUS, on);
    if (gl_is_es() && epoxy_gl_version() < 32) {
        glDebugMessageCallbackKHR(on ? on_message : NULL, NULL);
    } else {
        glDebugMessageCallback(on ? on_message : NULL, NULL);
    }
}
