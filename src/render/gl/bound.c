// SPDX-License-Identifier: MIT
// What is bound and switched while a call of the renderer runs: nobody else calls OpenGL then, so a call that would
// change nothing is left out. gl_internal.h puts these functions in the place of OpenGL's. Outside of a call nothing is
// known, and every call goes through.
#define BOLAN_GL_UNTRACKED
#include "gl_internal.h"
#include <string.h>

enum { UNITS = 32, SWITCHES = 6 };

static const GLenum switches[SWITCHES] = {GL_DEPTH_TEST,   GL_CULL_FACE,    GL_BLEND,
                                          GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB};

// A number that is not known is UNKNOWN, which is no name, unit or enumerator.
#define UNKNOWN 0xffffffffu

typedef struct bound {
    bool on;
    GLuint unit, program, vertex_array, framebuffer[2]; // for drawing, for reading
    GLenum depth_function, blend_function[4];
    GLuint depth_mask, color_mask[4], switched[SWITCHES];
    struct {
        GLuint target, texture;
    } units[UNITS];
    GLint viewport[4];
    gl_mesh *empty; // see bolan_gl_track()
    bool at_once;   // OpenGL 4.5 binds a texture to a unit in one call
} bound;

static _Thread_local bound now;

// True: it is that already; else it is from now on.
static bool is(GLuint *known, GLuint value) {
    if (now.on && *known == value) return true;
    *known = value;
    return false;
}

void bolan_gl_track(gl_mesh *empty, bool at_once) {
    memset(&now, 0xff, sizeof now);
    memset(now.viewport, 0, sizeof now.viewport); // no viewport of ours is empty
    now.on = true;
    now.empty = empty;
    now.at_once = at_once;
}

void bolan_gl_untrack(void) {
    now.on = false;
    now.empty = NULL;
}

gl_mesh *bolan_gl_empty_mesh(void) { return now.empty; }

void bolan_gl_tracked_active_texture(GLenum unit) {
    if (!is(&now.unit, unit)) glActiveTexture(unit);
}

void bolan_gl_tracked_bind_texture(GLenum target, GLuint texture) {
    const GLuint unit = now.unit - GL_TEXTURE0;
    if (now.on && unit < UNITS) {
        if (now.units[unit].target == target && now.units[unit].texture == texture) return;
        now.units[unit].target = target;
        now.units[unit].texture = texture;
    }
    glBindTexture(target, texture);
}

void bolan_gl_bind_to_unit(GLuint unit, GLenum target, GLuint texture) {
    if (now.on && unit < UNITS && now.units[unit].target == target && now.units[unit].texture == texture) return;
    if (!now.on || !now.at_once || unit >= UNITS) {
        bolan_gl_tracked_active_texture(GL_TEXTURE0 + unit);
        bolan_gl_tracked_bind_texture(target, texture);
        return;
    }
    now.units[unit].target = target;
    now.units[unit].texture = texture;
    glBindTextureUnit(unit, texture);
}

// Names of deleted textures are given to new ones.
void bolan_gl_tracked_delete_textures(GLsizei count, const GLuint *textures) {
    for (GLsizei i = 0; i < count; i++)
        for (int k = 0; k < UNITS; k++)
            if (now.units[k].texture == textures[i]) now.units[k].texture = UNKNOWN;
    glDeleteTextures(count, textures);
}

void bolan_gl_tracked_use_program(GLuint program) {
    if (!is(&now.program, program)) glUseProgram(program);
}

void bolan_gl_tracked_delete_program(GLuint program) {
    if (now.program == program) now.program = UNKNOWN;
    glDeleteProgram(program);
}

void bolan_gl_tracked_bind_vertex_array(GLuint array) {
    if (!is(&now.vertex_array, array)) glBindVertexArray(array);
}

void bolan_gl_tracked_delete_vertex_arrays(GLsizei count, const GLuint *arrays) {
    now.vertex_array = UNKNOWN;
    glDeleteVertexArrays(count, arrays);
}

void bolan_gl_tracked_bind_framebuffer(GLenum target, GLuint framebuffer) {
    const bool draws = target != GL_READ_FRAMEBUFFER, reads = target != GL_DRAW_FRAMEBUFFER;
    const bool known =
        now.on && (!draws || now.framebuffer[0] == framebuffer) && (!reads || now.framebuffer[1] == framebuffer);
    if (known) return;
    if (draws) now.framebuffer[0] = framebuffer;
    if (reads) now.framebuffer[1] = framebuffer;
    glBindFramebuffer(target, framebuffer);
}

void bolan_gl_tracked_delete_framebuffers(GLsizei count, const GLuint *framebuffers) {
    now.framebuffer[0] = now.framebuffer[1] = UNKNOWN;
    glDeleteFramebuffers(count, framebuffers);
}

void bolan_gl_tracked_viewport(GLint x, GLint y, GLsizei width, GLsizei height) {
    const GLint next[4] = {x, y, width, height};
    if (now.on && memcmp(now.viewport, next, sizeof next) == 0) return;
    memcpy(now.viewport, next, sizeof next);
    glViewport(x, y, width, height);
}

static bool is_switched(GLenum name, GLuint to) {
    for (int i = 0; i < SWITCHES; i++)
        if (switches[i] == name) return is(&now.switched[i], to);
    return false;
}

void bolan_gl_tracked_enable(GLenum name) {
    if (!is_switched(name, 1)) glEnable(name);
}

void bolan_gl_tracked_disable(GLenum name) {
    if (!is_switched(name, 0)) glDisable(name);
}

void bolan_gl_tracked_depth_mask(GLboolean mask) {
    if (!is(&now.depth_mask, mask)) glDepthMask(mask);
}

void bolan_gl_tracked_depth_func(GLenum function) {
    if (!is(&now.depth_function, function)) glDepthFunc(function);
}

void bolan_gl_tracked_color_mask(GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
    const GLuint next[4] = {r, g, b, a};
    if (now.on && memcmp(now.color_mask, next, sizeof next) == 0) return;
    memcpy(now.color_mask, next, sizeof next);
    glColorMask(r, g, b, a);
}

void bolan_gl_tracked_blend_func(GLenum source, GLenum destination, GLenum source_alpha, GLenum destination_alpha) {
    const GLenum next[4] = {source, destination, source_alpha, destination_alpha};
    if (now.on && memcmp(now.blend_function, next, sizeof next) == 0) return;
    memcpy(now.blend_function, next, sizeof next);
    glBlendFuncSeparate(source, destination, source_alpha, destination_alpha);
}
