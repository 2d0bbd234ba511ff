// SPDX-License-Identifier: MIT
// The caller's state: written down when the library is entered, given back when it is left. Between the two everything
// that could change what our own calls mean (samplers, pixel store, stencil, clip distances) stands at GL's defaults.
//
// No error flag is read here or anywhere else in this folder: an error that the caller has not yet asked for is the
// caller's to find.
#include "gl_internal.h"
#include <string.h>

enum { TEXTURE_KINDS = 3 };

static const GLenum texture_targets[TEXTURE_KINDS] = {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY};
static const GLenum texture_bindings[TEXTURE_KINDS] = {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
                                                       GL_TEXTURE_BINDING_2D_ARRAY};

// Where a piece of state exists.
typedef enum where { ANYWHERE, DESKTOP, COMPATIBILITY, SAMPLE_MASK, SAMPLE_SHADING, FIXED_RESTART, DEPTH_BOUNDS } where;

static bool exists(const gl_caps *caps, where w) {
    switch (w) {
    case ANYWHERE: return true;
    case DESKTOP: return !caps->es;
    case COMPATIBILITY: return caps->compatibility;
    case SAMPLE_MASK: return caps->sample_mask;
    case SAMPLE_SHADING: return caps->sample_shading;
    case FIXED_RESTART: return caps->fixed_restart;
    case DEPTH_BOUNDS: return caps->depth_bounds;
    }
    return false;
}

// Switches, all off while we draw but for those that bolan_gl_set_state() moves. Blend and scissor: see buffers,
// viewports.
static const struct {
    GLenum name;
    where where;
} toggles[] = {
    {GL_DEPTH_TEST, ANYWHERE},
    {GL_CULL_FACE, ANYWHERE},
    {GL_STENCIL_TEST, ANYWHERE},
    {GL_POLYGON_OFFSET_FILL, ANYWHERE},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, ANYWHERE},
    {GL_SAMPLE_COVERAGE, ANYWHERE},
    {GL_RASTERIZER_DISCARD, ANYWHERE},
    {GL_DITHER, ANYWHERE},
    {GL_POLYGON_OFFSET_LINE, DESKTOP},
    {GL_POLYGON_OFFSET_POINT, DESKTOP},
    {GL_PRIMITIVE_RESTART, DESKTOP},
    {GL_FRAMEBUFFER_SRGB, DESKTOP},
    {GL_DEPTH_CLAMP, DESKTOP},
    {GL_COLOR_LOGIC_OP, DESKTOP},
    {GL_PROGRAM_POINT_SIZE, DESKTOP},
    {GL_LINE_SMOOTH, DESKTOP},
    {GL_POLYGON_SMOOTH, DESKTOP},
    {GL_SAMPLE_ALPHA_TO_ONE, DESKTOP},
    {GL_SAMPLE_MASK, SAMPLE_MASK},
    {GL_SAMPLE_SHADING, SAMPLE_SHADING},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, FIXED_RESTART},
    {GL_DEPTH_BOUNDS_TEST_EXT, DEPTH_BOUNDS},
    {GL_ALPHA_TEST, COMPATIBILITY},
    {GL_POLYGON_STIPPLE, COMPATIBILITY},
    {GL_LINE_STIPPLE, COMPATIBILITY},
};
enum { TOGGLE_COUNT = sizeof toggles / sizeof toggles[0] };

// Pixel store, and what it is while we draw.
static const struct {
    GLenum name;
    where where;
    GLint ours;
} pixel_store[] = {
    {GL_UNPACK_ALIGNMENT, ANYWHERE, 4},   {GL_UNPACK_ROW_LENGTH, ANYWHERE, 0},  {GL_UNPACK_SKIP_ROWS, ANYWHERE, 0},
    {GL_UNPACK_SKIP_PIXELS, ANYWHERE, 0}, {GL_UNPACK_SKIP_IMAGES, ANYWHERE, 0}, {GL_UNPACK_IMAGE_HEIGHT, ANYWHERE, 0},
    {GL_PACK_ALIGNMENT, ANYWHERE, 4},     {GL_PACK_ROW_LENGTH, ANYWHERE, 0},    {GL_PACK_SKIP_ROWS, ANYWHERE, 0},
    {GL_PACK_SKIP_PIXELS, ANYWHERE, 0},   {GL_UNPACK_SWAP_BYTES, DESKTOP, 0},   {GL_UNPACK_LSB_FIRST, DESKTOP, 0},
    {GL_PACK_SWAP_BYTES, DESKTOP, 0},     {GL_PACK_LSB_FIRST, DESKTOP, 0},      {GL_PACK_IMAGE_HEIGHT, DESKTOP, 0},
    {GL_PACK_SKIP_IMAGES, DESKTOP, 0},
};
enum { PIXEL_STORE_COUNT = sizeof pixel_store / sizeof pixel_store[0] };

// What the compatibility profile does to pixels on their way to textures and back.
static const struct {
    GLenum name;
    GLfloat ours;
} transfer[] = {
    {GL_MAP_COLOR, 0},  {GL_RED_SCALE, 1},   {GL_RED_BIAS, 0},   {GL_GREEN_SCALE, 1},
    {GL_GREEN_BIAS, 0}, {GL_BLUE_SCALE, 1},  {GL_BLUE_BIAS, 0},  {GL_ALPHA_SCALE, 1},
    {GL_ALPHA_BIAS, 0}, {GL_DEPTH_SCALE, 1}, {GL_DEPTH_BIAS, 0},
};
enum { TRANSFER_COUNT = sizeof transfer / sizeof transfer[0] };

// Clamping of what shaders write and of what is read back.
static const struct {
    GLenum name;
    where where;
} clamps[] = {
    {GL_CLAMP_READ_COLOR, DESKTOP}, {GL_CLAMP_VERTEX_COLOR, COMPATIBILITY}, {GL_CLAMP_FRAGMENT_COLOR, COMPATIBILITY}};
enum { CLAMP_COUNT = sizeof clamps / sizeof clamps[0] };

_Static_assert((int)TOGGLE_COUNT <= (int)GL_SAVED_SLOTS && (int)PIXEL_STORE_COUNT <= (int)GL_SAVED_SLOTS &&
                   (int)TRANSFER_COUNT <= (int)GL_SAVED_SLOTS,
               "gl_saved has a slot for each");
_Static_assert((int)GL_SAVED_UNITS == (int)SCRATCH_UNIT + 1, "every unit that is bound is saved");

void bolan_gl_set_clip(const gl_caps *caps, GLenum origin, GLenum depth) {
    if (caps->es) {
        glClipControlEXT(origin, depth);
    } else {
        glClipControl(origin, depth);
    }
}

static void set_enabled_at(GLenum name, GLuint index, bool on) {
    if (on) {
        glEnablei(name, index);
    } else {
        glDisablei(name, index);
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
    for (GLuint i = 0; i < GL_UNIFORM_SLOTS; i++) {
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &s->uniform_slot[i]);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, i, &s->uniform_offset[i]);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, i, &s->uniform_size[i]);
    }
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &s->pixel_pack);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &s->pixel_unpack);
    if (s->caps->query_buffer) glGetIntegerv(GL_QUERY_BUFFER_BINDING, &s->query_buffer);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &s->active_unit);
    for (GLuint unit = 0; unit < GL_SAVED_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (int k = 0; k < TEXTURE_KINDS; k++) glGetIntegerv(texture_bindings[k], &s->textures[unit][k]);
        glGetIntegerv(GL_SAMPLER_BINDING, &s->samplers[unit]);
    }
}

static void save_buffer(gl_saved *s, GLuint i) {
    static const GLenum factors[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA};
    static const GLenum equations[] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
    if (s->caps->buffer_masks) {
        s->buffers[i].blend = glIsEnabledi(GL_BLEND, i);
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, s->buffers[i].mask);
    } else {
        s->buffers[i].blend = glIsEnabled(GL_BLEND);
        glGetBooleanv(GL_COLOR_WRITEMASK, s->buffers[i].mask);
    }
    for (int k = 0; k < 4; k++) {
        if (s->caps->buffer_blends) {
            glGetIntegeri_v(factors[k], i, &s->buffers[i].factors[k]);
        } else {
            glGetIntegerv(factors[k], &s->buffers[i].factors[k]);
        }
    }
    for (int k = 0; k < 2; k++) {
        if (s->caps->buffer_blends) {
            glGetIntegeri_v(equations[k], i, &s->buffers[i].equations[k]);
        } else {
            glGetIntegerv(equations[k], &s->buffers[i].equations[k]);
        }
    }
}

static void get_doubles(const gl_caps *caps, GLenum name, double *out, int count) {
    GLfloat floats[2] = {0};
    if (!caps->es) {
        glGetDoublev(name, out);
        return;
    }
    glGetFloatv(name, floats);
    for (int i = 0; i < count; i++) out[i] = (double)floats[i];
}

static void save_viewports(gl_saved *s) {
    if (!s->caps->viewport_arrays) {
        s->viewports[0].scissor = glIsEnabled(GL_SCISSOR_TEST);
        glGetFloatv(GL_VIEWPORT, s->viewports[0].rectangle);
        glGetIntegerv(GL_SCISSOR_BOX, s->viewports[0].box);
        get_doubles(s->caps, GL_DEPTH_RANGE, s->viewports[0].depth, 2);
        return;
    }
    for (GLuint i = 0; i < (GLuint)s->caps->viewports; i++) {
        s->viewports[i].scissor = glIsEnabledi(GL_SCISSOR_TEST, i);
        glGetFloati_v(GL_VIEWPORT, i, s->viewports[i].rectangle);
        glGetIntegeri_v(GL_SCISSOR_BOX, i, s->viewports[i].box);
        glGetDoublei_v(GL_DEPTH_RANGE, i, s->viewports[i].depth);
    }
}

static void save_pixels(gl_saved *s) {
    for (int i = 0; i < PIXEL_STORE_COUNT; i++)
        if (exists(s->caps, pixel_store[i].where)) glGetIntegerv(pixel_store[i].name, &s->pixel_store[i]);
    for (int i = 0; i < CLAMP_COUNT; i++)
        if (exists(s->caps, clamps[i].where)) glGetIntegerv(clamps[i].name, &s->clamp[i]);
    for (int i = 0; i < TRANSFER_COUNT && s->caps->compatibility; i++) glGetFloatv(transfer[i].name, &s->transfer[i]);
}

static void save_rest(gl_saved *s) {
    for (int i = 0; i < TOGGLE_COUNT; i++)
        if (exists(s->caps, toggles[i].where)) s->toggles[i] = glIsEnabled(toggles[i].name);
    for (int i = 0; i < s->caps->clip_distances; i++) s->clips[i] = glIsEnabled(GL_CLIP_DISTANCE0 + (GLenum)i);
    glGetIntegerv(GL_CULL_FACE_MODE, &s->cull_mode);
    glGetIntegerv(GL_FRONT_FACE, &s->front_face);
    glGetIntegerv(GL_DEPTH_FUNC, &s->depth_function);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &s->depth_mask);
    get_doubles(s->caps, GL_DEPTH_CLEAR_VALUE, &s->depth_clear, 1);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, s->color_clear);
    glGetFloatv(GL_LINE_WIDTH, &s->line_width);
    if (s->caps->clip_control) {
        glGetIntegerv(GL_CLIP_ORIGIN, &s->clip_origin);
        glGetIntegerv(GL_CLIP_DEPTH_MODE, &s->clip_depth);
    }
    if (s->caps->es) return;
    glGetIntegerv(GL_POLYGON_MODE, s->polygon_mode);
    glGetIntegerv(GL_PROVOKING_VERTEX, &s->provoking);
}

// A program may be changed only while the caller's transform feedback rests.
static void pause_feedback(gl_saved *s) {
    if (!s->caps->feedback_pause) return;
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    glGetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    s->feedback = active && !paused;
    if (s->feedback) glPauseTransformFeedback();
}

void bolan_gl_set_defaults(const gl_caps *caps) {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    for (int i = 0; i < TOGGLE_COUNT; i++)
        if (exists(caps, toggles[i].where)) glDisable(toggles[i].name);
    for (int i = 0; i < caps->clip_distances; i++) glDisable(GL_CLIP_DISTANCE0 + (GLenum)i);
    for (int i = 0; i < PIXEL_STORE_COUNT; i++)
        if (exists(caps, pixel_store[i].where)) glPixelStorei(pixel_store[i].name, pixel_store[i].ours);
    for (int i = 0; i < CLAMP_COUNT; i++)
        if (exists(caps, clamps[i].where)) glClampColor(clamps[i].name, GL_FALSE);
    for (int i = 0; i < TRANSFER_COUNT && caps->compatibility; i++)
        glPixelTransferf(transfer[i].name, transfer[i].ours);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (caps->query_buffer) glBindBuffer(GL_QUERY_BUFFER, 0);
    for (GLuint unit = 0; unit < GL_SAVED_UNITS; unit++) glBindSampler(unit, 0);
    glBlendEquation(GL_FUNC_ADD);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthRangef(0.0f, 1.0f);
    glLineWidth(1.0f);
    if (caps->clip_control) bolan_gl_set_clip(caps, GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (caps->es) return;
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
}

void bolan_gl_save(gl_saved *s, const gl_caps *caps, bool debug) {
    memset(s, 0, sizeof *s);
    s->caps = caps;
    if (debug && caps->debug) bolan_gl_listen(s);
    pause_feedback(s);
    save_bindings(s);
    for (GLuint i = 0; i < (GLuint)caps->draw_buffers; i++) save_buffer(s, i);
    save_viewports(s);
    save_pixels(s);
    save_rest(s);
    bolan_gl_set_defaults(caps);
}

// ---- restore ------------------------------------------------------------------------------------------------------

static void restore_uniform_slots(const gl_saved *s) {
    for (GLuint i = 0; i < GL_UNIFORM_SLOTS; i++) {
        if (s->uniform_slot[i] != 0 && s->uniform_size[i] > 0) {
            glBindBufferRange(GL_UNIFORM_BUFFER, i, (GLuint)s->uniform_slot[i], (GLintptr)s->uniform_offset[i],
                              (GLsizeiptr)s->uniform_size[i]);
        } else {
            glBindBufferBase(GL_UNIFORM_BUFFER, i, (GLuint)s->uniform_slot[i]);
        }
    }
    glBindBuffer(GL_UNIFORM_BUFFER, (GLuint)s->uniform_buffer);
}

static void restore_bindings(const gl_saved *s) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)s->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)s->read_framebuffer);
    // A program that the caller had deleted while it was in use went when ours was put in its place.
    glUseProgram(s->program != 0 && glIsProgram((GLuint)s->program) ? (GLuint)s->program : 0);
    glBindVertexArray((GLuint)s->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, (GLuint)s->array_buffer);
    restore_uniform_slots(s);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)s->pixel_pack);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)s->pixel_unpack);
    if (s->caps->query_buffer) glBindBuffer(GL_QUERY_BUFFER, (GLuint)s->query_buffer);
    for (GLuint unit = 0; unit < GL_SAVED_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (int k = 0; k < TEXTURE_KINDS; k++) glBindTexture(texture_targets[k], (GLuint)s->textures[unit][k]);
        glBindSampler(unit, (GLuint)s->samplers[unit]);
    }
    glActiveTexture((GLenum)s->active_unit);
}

static void restore_buffer(const gl_saved *s, GLuint i) {
    const uint8_t *m = s->buffers[i].mask;
    const int32_t *f = s->buffers[i].factors, *e = s->buffers[i].equations;
    if (s->caps->buffer_masks) {
        set_enabled_at(GL_BLEND, i, s->buffers[i].blend);
        glColorMaski(i, m[0], m[1], m[2], m[3]);
    } else {
        bolan_gl_set_enabled(GL_BLEND, s->buffers[i].blend);
        glColorMask(m[0], m[1], m[2], m[3]);
    }
    // The equations of KHR_blend_equation_advanced are for colour and alpha at once.
    if (s->caps->buffer_blends) {
        glBlendFuncSeparatei(i, (GLenum)f[0], (GLenum)f[1], (GLenum)f[2], (GLenum)f[3]);
        if (e[0] == e[1]) {
            glBlendEquationi(i, (GLenum)e[0]);
        } else {
            glBlendEquationSeparatei(i, (GLenum)e[0], (GLenum)e[1]);
        }
    } else if (i == 0) {
        glBlendFuncSeparate((GLenum)f[0], (GLenum)f[1], (GLenum)f[2], (GLenum)f[3]);
        if (e[0] == e[1]) {
            glBlendEquation((GLenum)e[0]);
        } else {
            glBlendEquationSeparate((GLenum)e[0], (GLenum)e[1]);
        }
    }
}

static void restore_viewports(const gl_saved *s) {
    if (!s->caps->viewport_arrays) {
        const float *r = s->viewports[0].rectangle;
        const int32_t *b = s->viewports[0].box;
        const double *d = s->viewports[0].depth;
        bolan_gl_set_enabled(GL_SCISSOR_TEST, s->viewports[0].scissor);
        glViewport((GLint)r[0], (GLint)r[1], (GLsizei)r[2], (GLsizei)r[3]);
        glScissor(b[0], b[1], b[2], b[3]);
        if (s->caps->es) {
            glDepthRangef((GLfloat)d[0], (GLfloat)d[1]);
        } else {
            glDepthRange(d[0], d[1]);
        }
        return;
    }
    for (GLuint i = 0; i < (GLuint)s->caps->viewports; i++) {
        set_enabled_at(GL_SCISSOR_TEST, i, s->viewports[i].scissor);
        glViewportIndexedfv(i, s->viewports[i].rectangle);
        glScissorIndexedv(i, s->viewports[i].box);
        glDepthRangeIndexed(i, s->viewports[i].depth[0], s->viewports[i].depth[1]);
    }
}

static void restore_pixels(const gl_saved *s) {
    for (int i = 0; i < PIXEL_STORE_COUNT; i++)
        if (exists(s->caps, pixel_store[i].where)) glPixelStorei(pixel_store[i].name, s->pixel_store[i]);
    for (int i = 0; i < CLAMP_COUNT; i++)
        if (exists(s->caps, clamps[i].where)) glClampColor(clamps[i].name, (GLenum)s->clamp[i]);
    for (int i = 0; i < TRANSFER_COUNT && s->caps->compatibility; i++)
        glPixelTransferf(transfer[i].name, s->transfer[i]);
}

static void restore_polygons(const gl_saved *s) {
    if (s->caps->es) return;
    glProvokingVertex((GLenum)s->provoking);
    if (s->caps->compatibility) {
        glPolygonMode(GL_FRONT, (GLenum)s->polygon_mode[0]);
        glPolygonMode(GL_BACK, (GLenum)s->polygon_mode[1]);
    } else {
        glPolygonMode(GL_FRONT_AND_BACK, (GLenum)s->polygon_mode[0]); // the core profile knows no other
    }
}

static void restore_rest(const gl_saved *s) {
    for (int i = 0; i < TOGGLE_COUNT; i++)
        if (exists(s->caps, toggles[i].where)) bolan_gl_set_enabled(toggles[i].name, s->toggles[i]);
    for (int i = 0; i < s->caps->clip_distances; i++) bolan_gl_set_enabled(GL_CLIP_DISTANCE0 + (GLenum)i, s->clips[i]);
    glCullFace((GLenum)s->cull_mode);
    glFrontFace((GLenum)s->front_face);
    glDepthFunc((GLenum)s->depth_function);
    glDepthMask(s->depth_mask);
    if (s->caps->es) {
        glClearDepthf((GLfloat)s->depth_clear);
    } else {
        glClearDepth(s->depth_clear);
    }
    glClearColor(s->color_clear[0], s->color_clear[1], s->color_clear[2], s->color_clear[3]);
    glLineWidth(s->line_width);
    if (s->caps->clip_control) bolan_gl_set_clip(s->caps, (GLenum)s->clip_origin, (GLenum)s->clip_depth);
    restore_polygons(s);
}

void bolan_gl_restore(const gl_saved *s) {
    restore_bindings(s);
    for (GLuint i = 0; i < (GLuint)s->caps->draw_buffers; i++) restore_buffer(s, i);
    restore_viewports(s);
    restore_pixels(s);
    restore_rest(s);
    if (s->feedback) glResumeTransformFeedback();
    if (s->debug.on) bolan_gl_stop_listening(s);
}
