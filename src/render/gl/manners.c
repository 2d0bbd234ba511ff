// SPDX-License-Identifier: MIT
// How a call treats the caller's state: asks for all of it and puts it back (saved.c), puts back what the caller has
// declared, or puts back nothing. The last two ask OpenGL for nothing: where the driver has a thread of its own, a
// question waits for all that was called before it.
#include "gl_internal.h"
#include <string.h>

static _Thread_local bool silent;

bool bolan_gl_may_ask(void) { return !silent; }

bolan_gl_state bolan_gl_state_default(void) {
    return (bolan_gl_state){.depth_mask = true,
                            .depth_function = GL_LESS,
                            .depth_clear = 1.0f,
                            .blend_function = {GL_ONE, GL_ZERO, GL_ONE, GL_ZERO},
                            .color_mask = {true, true, true, true},
                            .cull_mode = GL_BACK,
                            .front_face = GL_CCW,
                            .dither = true};
}

// From what is declared to what our calls take for granted; bolan_gl_set_state() sets the rest before each pass.
static void leave_declared(const bolan_gl_state *d, const gl_caps *caps) {
    if (d->scissor_test) glDisable(GL_SCISSOR_TEST);
    if (d->stencil_test) glDisable(GL_STENCIL_TEST);
    if (d->framebuffer_srgb && !caps->es) glDisable(GL_FRAMEBUFFER_SRGB);
    if (d->dither) glDisable(GL_DITHER);
    if (d->cull_mode != GL_BACK) glCullFace(GL_BACK);
    if (d->front_face != GL_CCW) glFrontFace(GL_CCW);
    if (caps->clip_control && (d->clip_upper_left || d->clip_zero_to_one))
        bolan_gl_set_clip(caps, GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    for (GLuint unit = 0; d->samplers && unit < GL_SAVED_UNITS; unit++) glBindSampler(unit, 0);
}

static void put_bindings_back(const bolan_gl_state *d) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, d->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, d->read_framebuffer);
    glUseProgram(d->program);
    glBindVertexArray(d->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, d->array_buffer);
    glBindBuffer(GL_UNIFORM_BUFFER, d->uniform_buffer);
    glActiveTexture(GL_TEXTURE0 + d->active_unit);
}

static void put_tests_back(const bolan_gl_state *d, const gl_caps *caps) {
    bolan_gl_set_enabled(GL_SCISSOR_TEST, d->scissor_test);
    bolan_gl_set_enabled(GL_DEPTH_TEST, d->depth_test);
    bolan_gl_set_enabled(GL_CULL_FACE, d->cull_face);
    if (d->stencil_test) glEnable(GL_STENCIL_TEST);
    if (d->framebuffer_srgb && !caps->es) glEnable(GL_FRAMEBUFFER_SRGB);
    if (d->dither) glEnable(GL_DITHER);
    glDepthMask(d->depth_mask);
    glDepthFunc(d->depth_function);
    if (d->cull_mode != GL_BACK) glCullFace(d->cull_mode);
    if (d->front_face != GL_CCW) glFrontFace(d->front_face);
    if (caps->clip_control)
        bolan_gl_set_clip(caps, d->clip_upper_left ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                          d->clip_zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

static void put_declared_back(const bolan_gl_state *d, const gl_caps *caps) {
    const int32_t *v = d->viewport, *s = d->scissor_box;
    const uint32_t *f = d->blend_function;
    put_bindings_back(d);
    put_tests_back(d, caps);
    if (v[2] != 0) glViewport(v[0], v[1], v[2], v[3]);
    if (s[2] != 0) glScissor(s[0], s[1], s[2], s[3]);
    bolan_gl_set_enabled(GL_BLEND, d->blend);
    glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
    glColorMask(d->color_mask[0], d->color_mask[1], d->color_mask[2], d->color_mask[3]);
    glClearColor(d->color_clear[0], d->color_clear[1], d->color_clear[2], d->color_clear[3]);
    if (caps->es) {
        glClearDepthf(d->depth_clear);
    } else {
        glClearDepth((GLdouble)d->depth_clear);
    }
}

static void enter_silently(gl_saved *s, const gl_caps *caps, bolan_restore restore, const bolan_gl_state *declared,
                           bool debug) {
    memset(s, 0, sizeof *s);
    s->caps = caps;
    s->restore = restore;
    s->declared = declared;
    if (debug && caps->debug) bolan_gl_listen(s);
    if (restore == BOLAN_RESTORE_NONE)
        bolan_gl_set_defaults(caps);
    else
        leave_declared(declared, caps);
}

void bolan_gl_enter(gl_saved *s, const gl_caps *caps, bolan_restore restore, const bolan_gl_state *declared, bool debug,
                    gl_mesh *empty) {
    silent = restore != BOLAN_RESTORE_FULL;
    if (silent)
        enter_silently(s, caps, restore, declared, debug);
    else
        bolan_gl_save(s, caps, debug);
    bolan_gl_track(empty, caps->bind_units);
}

void bolan_gl_leave(const gl_saved *s) {
    silent = false;
    bolan_gl_untrack();
    if (s->restore == BOLAN_RESTORE_FULL) {
        bolan_gl_restore(s);
        return;
    }
    if (s->restore == BOLAN_RESTORE_DECLARED) put_declared_back(s->declared, s->caps);
    if (s->debug.on) bolan_gl_stop_listening(s);
}

void bolan_gl_know(gl_known *k, gl_known_kind kind, uint32_t name) {
    k->entries[k->next].kind = kind;
    k->entries[k->next].name = name;
    k->next = (k->next + 1) % GL_KNOWN_NAMES;
}

bool bolan_gl_knows(const gl_known *k, gl_known_kind kind, uint32_t name) {
    for (uint32_t i = 0; i < GL_KNOWN_NAMES; i++)
        if (k->entries[i].kind == (uint32_t)kind && k->entries[i].name == name) return true;
    return false;
}
