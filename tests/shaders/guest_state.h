// SPDX-License-Identifier: MIT
// All the state of GL that a host may look at, as a list of named numbers that can be compared.
#ifndef BOLAN_TESTS_GUEST_STATE_H
#define BOLAN_TESTS_GUEST_STATE_H

#include "gl_support.h"

#include <stdio.h>
#include <string.h>

enum { MOST_ENTRIES = 4096 };

typedef struct entry {
    char name[48];
    double value;
} entry;
typedef struct snapshot {
    entry entries[MOST_ENTRIES];
    int count;
} snapshot;

static void put(snapshot *s, const char *name, int index, int part, double value) {
    assert_true(s->count < MOST_ENTRIES);
    entry *e = &s->entries[s->count++];
    snprintf(e->name, sizeof e->name, "%s[%d].%d", name, index, part);
    e->value = value;
}

#define NAMED(x) \
    { #x, x }
typedef struct named {
    const char *name;
    GLenum value;
} named;

static bool is_es(void) { return !epoxy_is_desktop_gl(); }

static bool is_compatibility(void) {
    GLint mask = 0;
    if (!is_es()) glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    return (mask & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
}

static const named switches[] = {
    NAMED(GL_DEPTH_TEST),      NAMED(GL_CULL_FACE),
    NAMED(GL_STENCIL_TEST),    NAMED(GL_POLYGON_OFFSET_FILL),
    NAMED(GL_DITHER),          NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
    NAMED(GL_SAMPLE_COVERAGE), NAMED(GL_RASTERIZER_DISCARD),
    NAMED(GL_SAMPLE_MASK),     NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
    NAMED(GL_DEBUG_OUTPUT),    NAMED(GL_DEBUG_OUTPUT_SYNCHRONOUS),
};
static const named desktop_switches[] = {
    NAMED(GL_PRIMITIVE_RESTART),   NAMED(GL_FRAMEBUFFER_SRGB),     NAMED(GL_DEPTH_CLAMP),
    NAMED(GL_COLOR_LOGIC_OP),      NAMED(GL_LINE_SMOOTH),          NAMED(GL_POLYGON_SMOOTH),
    NAMED(GL_PROGRAM_POINT_SIZE),  NAMED(GL_SAMPLE_ALPHA_TO_ONE),  NAMED(GL_SAMPLE_SHADING),
    NAMED(GL_CLIP_DISTANCE0),      NAMED(GL_CLIP_DISTANCE3),       NAMED(GL_CLIP_DISTANCE7),
    NAMED(GL_POLYGON_OFFSET_LINE), NAMED(GL_POLYGON_OFFSET_POINT),
};
static const named compatibility_switches[] = {NAMED(GL_ALPHA_TEST), NAMED(GL_POLYGON_STIPPLE), NAMED(GL_LINE_STIPPLE)};

static const struct {
    const char *name;
    GLenum value;
    int parts;
} numbers[] =
    {
#define NUMBER(x, parts) \
    { #x, x, parts }
        NUMBER(GL_DRAW_FRAMEBUFFER_BINDING, 1),
        NUMBER(GL_READ_FRAMEBUFFER_BINDING, 1),
        NUMBER(GL_CURRENT_PROGRAM, 1),
        NUMBER(GL_VERTEX_ARRAY_BINDING, 1),
        NUMBER(GL_ARRAY_BUFFER_BINDING, 1),
        NUMBER(GL_UNIFORM_BUFFER_BINDING, 1),
        NUMBER(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1),
        NUMBER(GL_PIXEL_PACK_BUFFER_BINDING, 1),
        NUMBER(GL_PIXEL_UNPACK_BUFFER_BINDING, 1),
        NUMBER(GL_RENDERBUFFER_BINDING, 1),
        NUMBER(GL_ACTIVE_TEXTURE, 1),
        NUMBER(GL_CULL_FACE_MODE, 1),
        NUMBER(GL_FRONT_FACE, 1),
        NUMBER(GL_DEPTH_FUNC, 1),
        NUMBER(GL_DEPTH_WRITEMASK, 1),
        NUMBER(GL_DEPTH_CLEAR_VALUE, 1),
        NUMBER(GL_COLOR_CLEAR_VALUE, 4),
        NUMBER(GL_DEPTH_RANGE, 2),
        NUMBER(GL_LINE_WIDTH, 1),
        NUMBER(GL_POLYGON_OFFSET_FACTOR, 1),
        NUMBER(GL_POLYGON_OFFSET_UNITS, 1),
        NUMBER(GL_SAMPLE_COVERAGE_VALUE, 1),
        NUMBER(GL_STENCIL_FUNC, 1),
        NUMBER(GL_STENCIL_WRITEMASK, 1),
        NUMBER(GL_STENCIL_CLEAR_VALUE, 1),
        NUMBER(GL_VIEWPORT, 4),
        NUMBER(GL_SCISSOR_BOX, 4),
        NUMBER(GL_BLEND_COLOR, 4),
        NUMBER(GL_UNPACK_ALIGNMENT, 1),
        NUMBER(GL_UNPACK_ROW_LENGTH, 1),
        NUMBER(GL_UNPACK_SKIP_ROWS, 1),
        NUMBER(GL_UNPACK_SKIP_PIXELS, 1),
        NUMBER(GL_UNPACK_SKIP_IMAGES, 1),
        NUMBER(GL_UNPACK_IMAGE_HEIGHT, 1),
        NUMBER(GL_PACK_ALIGNMENT, 1),
        NUMBER(GL_PACK_ROW_LENGTH, 1),
        NUMBER(GL_PACK_SKIP_ROWS, 1),
        NUMBER(GL_PACK_SKIP_PIXELS, 1),
        NUMBER(GL_TRANSFORM_FEEDBACK_ACTIVE, 1),
        NUMBER(GL_TRANSFORM_FEEDBACK_PAUSED, 1),
        NUMBER(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1),
},
  desktop_numbers[] =
      {
          NUMBER(GL_CLIP_ORIGIN, 1),      NUMBER(GL_CLIP_DEPTH_MODE, 1),
          NUMBER(GL_POLYGON_MODE, 2),     NUMBER(GL_CLAMP_READ_COLOR, 1),
          NUMBER(GL_LOGIC_OP_MODE, 1),    NUMBER(GL_UNPACK_SWAP_BYTES, 1),
          NUMBER(GL_UNPACK_LSB_FIRST, 1), NUMBER(GL_PACK_SWAP_BYTES, 1),
          NUMBER(GL_PACK_LSB_FIRST, 1),   NUMBER(GL_PACK_IMAGE_HEIGHT, 1),
          NUMBER(GL_PACK_SKIP_IMAGES, 1), NUMBER(GL_PRIMITIVE_RESTART_INDEX, 1),
          NUMBER(GL_PROVOKING_VERTEX, 1), NUMBER(GL_QUERY_BUFFER_BINDING, 1),
          NUMBER(GL_POINT_SIZE, 1),       NUMBER(GL_MIN_SAMPLE_SHADING_VALUE, 1),
},
  compatibility_numbers[] = {
      NUMBER(GL_CLAMP_FRAGMENT_COLOR, 1),
      NUMBER(GL_CLAMP_VERTEX_COLOR, 1),
      NUMBER(GL_RED_SCALE, 1),
      NUMBER(GL_RED_BIAS, 1),
      NUMBER(GL_GREEN_SCALE, 1),
      NUMBER(GL_BLUE_BIAS, 1),
      NUMBER(GL_ALPHA_SCALE, 1),
      NUMBER(GL_MAP_COLOR, 1),
      NUMBER(GL_DEPTH_SCALE, 1),
      NUMBER(GL_DEPTH_BIAS, 1),
      NUMBER(GL_ALPHA_TEST_FUNC, 1),
      NUMBER(GL_ALPHA_TEST_REF, 1),
#undef NUMBER
};
#define COUNT(a) (sizeof(a) / sizeof *(a))

static void get(GLenum name, int parts, double out[4]) {
    GLfloat floats[4] = {0};
    if (is_es()) {
        glGetFloatv(name, floats);
        for (int i = 0; i < parts; i++) out[i] = (double)floats[i];
    } else {
        glGetDoublev(name, out);
    }
}

static void put_number(snapshot *s, const char *name, GLenum value, int parts) {
    double v[4] = {0};
    get(value, parts, v);
    for (int i = 0; i < parts; i++) put(s, name, 0, i, v[i]);
}

static void put_textures(snapshot *s) {
    static const named bindings[] = {NAMED(GL_TEXTURE_BINDING_2D), NAMED(GL_TEXTURE_BINDING_3D),
                                     NAMED(GL_TEXTURE_BINDING_2D_ARRAY), NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
                                     NAMED(GL_SAMPLER_BINDING)};
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int unit = 0; unit < 32; unit++) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        for (size_t k = 0; k < COUNT(bindings); k++) {
            GLint name = 0;
            glGetIntegerv(bindings[k].value, &name);
            put(s, bindings[k].name, unit, 0, name);
        }
    }
    glActiveTexture((GLenum)active);
}

static void put_buffers(snapshot *s) {
    static const named blends[] = {NAMED(GL_BLEND_SRC_RGB),      NAMED(GL_BLEND_DST_RGB),
                                   NAMED(GL_BLEND_SRC_ALPHA),    NAMED(GL_BLEND_DST_ALPHA),
                                   NAMED(GL_BLEND_EQUATION_RGB), NAMED(GL_BLEND_EQUATION_ALPHA)};
    for (GLuint i = 0; i < 8; i++) {
        GLboolean mask[4] = {0};
        put(s, "GL_BLEND", (int)i, 0, glIsEnabledi(GL_BLEND, i));
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
        for (int c = 0; c < 4; c++) put(s, "GL_COLOR_WRITEMASK", (int)i, c, mask[c]);
        for (size_t k = 0; k < COUNT(blends); k++) {
            GLint v = 0;
            glGetIntegeri_v(blends[k].value, i, &v);
            put(s, blends[k].name, (int)i, 0, v);
        }
    }
    for (GLuint i = 0; i < 5; i++) {
        GLint name = 0;
        GLint64 start = 0, size = 0;
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &name);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, i, &start);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, i, &size);
        put(s, "GL_UNIFORM_BUFFER", (int)i, 0, name);
        put(s, "GL_UNIFORM_BUFFER", (int)i, 1, (double)start);
        put(s, "GL_UNIFORM_BUFFER", (int)i, 2, (double)size);
    }
}

static void put_viewports(snapshot *s) {
    for (GLuint i = 0; i < 16; i++) {
        GLfloat rectangle[4];
        GLint box[4];
        GLdouble range[2];
        glGetFloati_v(GL_VIEWPORT, i, rectangle);
        glGetIntegeri_v(GL_SCISSOR_BOX, i, box);
        glGetDoublei_v(GL_DEPTH_RANGE, i, range);
        put(s, "GL_SCISSOR_TEST", (int)i, 0, glIsEnabledi(GL_SCISSOR_TEST, i));
        for (int c = 0; c < 4; c++) put(s, "GL_VIEWPORT", (int)i, c, (double)rectangle[c]);
        for (int c = 0; c < 4; c++) put(s, "GL_SCISSOR_BOX", (int)i, c, box[c]);
        for (int c = 0; c < 2; c++) put(s, "GL_DEPTH_RANGE", (int)i, c, range[c]);
    }
}

static void take(snapshot *s) {
    void *callback = NULL, *user = NULL;
    s->count = 0;
    for (size_t i = 0; i < COUNT(switches); i++) put(s, switches[i].name, 0, 0, glIsEnabled(switches[i].value));
    for (size_t i = 0; i < COUNT(numbers); i++) put_number(s, numbers[i].name, numbers[i].value, numbers[i].parts);
    put_textures(s);
    put_buffers(s);
    glGetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &callback);
    glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &user);
    put(s, "callback", 0, 0, (double)(uintptr_t)callback);
    put(s, "callback", 0, 1, (double)(uintptr_t)user);
    if (is_es()) return;
    put_viewports(s);
    for (size_t i = 0; i < COUNT(desktop_switches); i++)
        put(s, desktop_switches[i].name, 0, 0, glIsEnabled(desktop_switches[i].value));
    for (size_t i = 0; i < COUNT(desktop_numbers); i++)
        put_number(s, desktop_numbers[i].name, desktop_numbers[i].value, desktop_numbers[i].parts);
    if (!is_compatibility()) return;
    for (size_t i = 0; i < COUNT(compatibility_switches); i++)
        put(s, compatibility_switches[i].name, 0, 0, glIsEnabled(compatibility_switches[i].value));
    for (size_t i = 0; i < COUNT(compatibility_numbers); i++)
        put_number(s, compatibility_numbers[i].name, compatibility_numbers[i].value, compatibility_numbers[i].parts);
}

// `left`: what need not be the same; NULL: all is.
static void assert_same_but(const snapshot *before, const char *after_what, bool (*left)(const char *name)) {
    static snapshot now;
    take(&now);
    assert_int_equal(now.count, before->count);
    int differences = 0;
    for (int i = 0; i < now.count; i++)
        if (now.entries[i].value != before->entries[i].value && (left == NULL || !left(now.entries[i].name))) {
            differences++;
            print_error("%s: %s was %.17g, is %.17g\n", after_what, now.entries[i].name, before->entries[i].value,
                        now.entries[i].value);
        }
    assert_int_equal(differences, 0);
    assert_true(watch_is_clean(after_what));
}

static inline void assert_same(const snapshot *before, const char *after_what) {
    assert_same_but(before, after_what, NULL);
}

#endif
