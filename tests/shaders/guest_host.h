// SPDX-License-Identifier: MIT
// A renderer with a small scene, and a host that sets every piece of state apart from what a context starts with.
#ifndef BOLAN_TESTS_GUEST_HOST_H
#define BOLAN_TESTS_GUEST_HOST_H

#include "guest_state.h"

#include "bolan/io.h"

enum { WIDTH = 64, HEIGHT = 48, PIXELS = WIDTH * HEIGHT };

// ---- a small scene --------------------------------------------------------------------------------------------------

typedef struct rig {
    bolan_scene scene;
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
    bolan_view view;
} rig;

static inline void open_rig_of(rig *r, const bolan_renderer_desc *desc, const char *scene) {
    memset(r, 0, sizeof *r);
    assert_int_equal(bolan_scene_load(scene, &r->scene), BOLAN_OK);
    r->scene.sea.resolution = 64;
    r->scene.sea.fft.cascade_count = 2;
    assert_int_equal(bolan_world_load_scene(&r->scene, &r->world), BOLAN_OK);
    bolan_world_step(r->world, 3.0);
    assert_int_equal(bolan_renderer_create(desc, &r->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    r->view = bolan_view_from_camera(&r->scene.camera, WIDTH, HEIGHT);
    r->view.framebuffer = bolan_target_framebuffer(r->target);
}

static inline void open_rig(rig *r, const bolan_renderer_desc *desc) { open_rig_of(r, desc, "open-sea"); }

static inline bolan_renderer_desc low_quality(void) {
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    return desc;
}

static inline void open_low(rig *r) {
    const bolan_renderer_desc desc = low_quality();
    open_rig(r, &desc);
}

static inline void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    bolan_renderer_destroy(&r->renderer);
    bolan_world_destroy(&r->world);
}

static inline void draw_rig(rig *r) { bolan_renderer_draw_world(r->renderer, r->world, &r->view); }

typedef struct shot {
    uint8_t rgb[PIXELS * 3];
    float linear[PIXELS * 3], distance[PIXELS];
} shot;

static inline void take_shot(rig *r, shot *s) {
    memset(s, 0, sizeof *s);
    draw_rig(r);
    bolan_renderer_read_rgb8(r->renderer, r->view.framebuffer, WIDTH, HEIGHT, s->rgb);
    bolan_renderer_read_linear(r->renderer, s->linear, s->distance);
}

// ---- a host that has set everything ---------------------------------------------------------------------------------

enum { HOST_UNITS = 29 }; // all that the library binds, and its scratch unit

typedef struct host {
    GLuint textures[3 * HOST_UNITS], samplers[HOST_UNITS], buffers[6], vertex_array, framebuffer, color, program;
} host;

static inline GLuint build_program(void) {
    const GLchar *vertex = is_es() ? "#version 300 es\nout float v;\nvoid main() { v = 7.0; gl_Position = vec4(0.0); }"
                                   : "#version 330\nout float v;\nvoid main() { v = 7.0; gl_Position = vec4(0.0); }";
    const GLchar *fragment = is_es()
                                 ? "#version 300 es\nprecision highp float;\nout vec4 c;\nvoid main() { c = vec4(1); }"
                                 : "#version 330\nout vec4 c;\nvoid main() { c = vec4(1); }";
    const GLchar *varying = "v";
    const GLuint program = glCreateProgram(), v = glCreateShader(GL_VERTEX_SHADER),
                 f = glCreateShader(GL_FRAGMENT_SHADER);
    GLint linked = GL_FALSE;
    glShaderSource(v, 1, &vertex, NULL);
    glShaderSource(f, 1, &fragment, NULL);
    glCompileShader(v);
    glCompileShader(f);
    glAttachShader(program, v);
    glAttachShader(program, f);
    glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    assert_int_equal(linked, GL_TRUE);
    glDeleteShader(v);
    glDeleteShader(f);
    return program;
}

static inline void open_host(host *h) {
    memset(h, 0, sizeof *h);
    glGenTextures(3 * HOST_UNITS, h->textures);
    glGenSamplers(HOST_UNITS, h->samplers);
    glGenBuffers(6, h->buffers);
    glGenVertexArrays(1, &h->vertex_array);
    h->program = build_program();
    glGenTextures(1, &h->color);
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, HEIGHT, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, h->color, 0);
}

static inline void bind_everything(const host *h) {
    static const GLenum kinds[] = {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY};
    for (GLuint unit = 0; unit < HOST_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (GLuint k = 0; k < 3; k++) glBindTexture(kinds[k], h->textures[3 * unit + k]);
        glBindSampler(unit, h->samplers[unit]);
        glSamplerParameteri(h->samplers[unit], GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    }
    glActiveTexture(GL_TEXTURE5);
    glBindVertexArray(h->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, h->buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, h->buffers[1]);
    glBindBuffer(GL_UNIFORM_BUFFER, h->buffers[2]);
    glBufferData(GL_UNIFORM_BUFFER, 1024, NULL, GL_STATIC_DRAW);
    glBindBufferRange(GL_UNIFORM_BUFFER, 0, h->buffers[2], 256, 512);
    for (GLuint slot = 1; slot < 5; slot++) glBindBufferBase(GL_UNIFORM_BUFFER, slot, h->buffers[2 + slot % 2]);
    glBindBuffer(GL_UNIFORM_BUFFER, h->buffers[3]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, h->buffers[4]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, h->buffers[5]);
    glUseProgram(h->program);
}

static inline void enable_all(const named *list, size_t count) {
    for (size_t i = 0; i < count; i++) glEnable(list[i].value);
}

static inline void set_pixels_apart(void) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8), glPixelStorei(GL_UNPACK_ROW_LENGTH, 999),
        glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5), glPixelStorei(GL_UNPACK_SKIP_IMAGES, 2);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 777), glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glPixelStorei(GL_PACK_ROW_LENGTH, 88), glPixelStorei(GL_PACK_SKIP_ROWS, 1), glPixelStorei(GL_PACK_SKIP_PIXELS, 2);
    if (is_es()) return;
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 1), glPixelStorei(GL_UNPACK_LSB_FIRST, 1), glPixelStorei(GL_PACK_SWAP_BYTES, 1);
    glPixelStorei(GL_PACK_LSB_FIRST, 1), glPixelStorei(GL_PACK_IMAGE_HEIGHT, 9), glPixelStorei(GL_PACK_SKIP_IMAGES, 1);
    glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
}

static inline void set_buffers_apart(void) {
    for (GLuint i = 0; i < 8; i++) {
        if (i % 2 == 0) glEnablei(GL_BLEND, i);
        glColorMaski(i, i & 1, i & 2, i & 4, i % 3 == 0);
        glBlendFuncSeparatei(i, GL_DST_COLOR, i % 2 ? GL_ONE : GL_ZERO, GL_ZERO, GL_SRC_ALPHA);
        glBlendEquationSeparatei(i, i % 2 ? GL_MAX : GL_FUNC_SUBTRACT, GL_MIN);
    }
}

static inline void set_viewports_apart(void) {
    glViewport(1, 2, 3, 4), glScissor(5, 6, 7, 8), glEnable(GL_SCISSOR_TEST), glDepthRangef(0.75f, 0.25f);
    if (is_es()) return;
    for (GLuint i = 0; i < 16; i++) {
        glViewportIndexedf(i, 0.5f + (float)i, 1.25f, 10.0f + (float)i, 20.5f);
        glScissorIndexed(i, (GLint)i, 1, 2 + (GLsizei)i, 3);
        glDepthRangeIndexed(i, 0.1 + 0.01 * i, 0.3);
        if (i % 3 == 1) glDisablei(GL_SCISSOR_TEST, i);
    }
}

static inline void set_fixed_functions_apart(void) {
    static const GLubyte no_pixel[32 * 8] = {0}; // rows end at the alignment that was set
    enable_all(compatibility_switches, COUNT(compatibility_switches));
    glAlphaFunc(GL_NEVER, 0.5f);
    glPolygonMode(GL_FRONT, GL_POINT);
    glPolygonMode(GL_BACK, GL_LINE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glPixelTransferf(GL_RED_SCALE, 0.25f), glPixelTransferf(GL_RED_BIAS, 0.5f), glPixelTransferf(GL_GREEN_SCALE, 3.0f);
    glPixelTransferf(GL_BLUE_BIAS, -0.5f), glPixelTransferf(GL_ALPHA_SCALE, 0.5f), glPixelTransferi(GL_MAP_COLOR, 1);
    glPixelTransferf(GL_DEPTH_SCALE, 0.5f), glPixelTransferf(GL_DEPTH_BIAS, 0.125f);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0); // the stipple is read from memory
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0), glPixelStorei(GL_UNPACK_SKIP_ROWS, 0),
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPolygonStipple(no_pixel);
}

// Everything unusual at once. Each by itself would spoil the picture, or be lost.
static inline void set_apart(const host *h) {
    bind_everything(h);
    enable_all(switches, COUNT(switches));
    glCullFace(GL_FRONT_AND_BACK), glFrontFace(GL_CW), glDepthFunc(GL_NEVER), glDepthMask(GL_FALSE);
    glClearDepthf(0.25f), glClearColor(0.1f, 0.2f, 0.3f, 0.4f), glStencilFunc(GL_NEVER, 1, 1);
    glPolygonOffset(50.0f, 1e6f), glSampleCoverage(0.0f, GL_FALSE), glSampleMaski(0, 0), glLineWidth(1.0f);
    set_buffers_apart();
    set_viewports_apart();
    set_pixels_apart();
    if (is_es()) return;
    enable_all(desktop_switches, COUNT(desktop_switches));
    glLogicOp(GL_NOOP), glPrimitiveRestartIndex(0), glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glClearDepth(0.1); // no float
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glBindBuffer(GL_QUERY_BUFFER, h->buffers[0]);
    if (is_compatibility()) {
        set_fixed_functions_apart();
    } else {
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    }
    glLineWidth(2.0f);
}

// Not this host's: back to what a context starts with.
static inline void close_host(host *h) {
    glDeleteTextures(3 * HOST_UNITS, h->textures);
    glDeleteTextures(1, &h->color);
    glDeleteSamplers(HOST_UNITS, h->samplers);
    glDeleteBuffers(6, h->buffers);
    glDeleteVertexArrays(1, &h->vertex_array);
    glDeleteFramebuffers(1, &h->framebuffer);
    glUseProgram(0);
    glDeleteProgram(h->program);
}

#endif
