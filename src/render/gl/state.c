// SPDX-License-Identifier: MIT
// The state that the passes set while they draw. The caller's: see saved.c.
#include "gl_internal.h"

void bolan_gl_set_enabled(GLenum name, bool on) {
    if (on) {
        glEnable(name);
    } else {
        glDisable(name);
    }
}

void bolan_gl_set_state(const gl_state *s) {
    // Writing depth without testing it needs the test switched on with ALWAYS.
    bolan_gl_set_enabled(GL_DEPTH_TEST, s->depth_test || s->depth_write);
    glDepthFunc(!s->depth_test ? GL_ALWAYS : s->depth_equal ? GL_EQUAL : s->depth_less ? GL_LEQUAL : GL_GEQUAL);
    glDepthMask(s->depth_write);
    bolan_gl_set_enabled(GL_CULL_FACE, s->cull_back);
    glColorMask(s->color_write, s->color_write, s->color_write, s->color_write);
    bolan_gl_set_enabled(GL_BLEND, s->blend != GL_BLEND_NONE);
    switch (s->blend) {
    case GL_BLEND_NONE: break;
    case GL_BLEND_ALPHA:
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        break;
    case GL_BLEND_ADD: glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE); break;
    case GL_BLEND_MULTIPLY: glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_DST_COLOR, GL_ZERO); break;
    case GL_BLEND_PREMULTIPLIED:
        glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        break;
    }
}

void bolan_gl_set_clip_zero_to_one(bool on) {
    const GLenum depth = on ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE;
    if (bolan_gl_is_es()) {
        glClipControlEXT(GL_LOWER_LEFT, depth);
    } else {
        glClipControl(GL_LOWER_LEFT, depth);
    }
}

void bolan_gl_set_framebuffer_srgb(bool on) {
    if (!bolan_gl_is_es()) bolan_gl_set_enabled(GL_FRAMEBUFFER_SRGB, on);
}
