// SPDX-License-Identifier: MIT
// A target for callers without one.
#include "renderer.h"

#include "memory.h"

struct bolan_target {
    gl_caps caps;
    gl_texture color;
    gl_target target;
    const char *refusal; // of bolan_target_show(), said once
};

static bolan_result make_target(bolan_target *t, uint32_t width, uint32_t height) {
    const gl_texture_desc desc = {
        .format = GL_FMT_RGBA8, .width = width, .height = height, .filter = GL_FILTER_NEAREST, .wrap = GL_WRAP_CLAMP};
    const gl_texture *colors[] = {&t->color};
    gl_saved saved;
    t->caps = bolan_gl_get_caps();
    bolan_gl_save(&saved, &t->caps, false);
    bolan_result result = bolan_gl_texture_create(&desc, &t->color);
    if (result == BOLAN_OK) result = bolan_gl_target_create(colors, 1, NULL, -1, 0, &t->target);
    bolan_gl_restore(&saved);
    return result;
}

bolan_result bolan_target_create(uint32_t width, uint32_t height, bolan_target **out) {
    BOLAN_ASSERT(out != NULL);
    if (out == NULL) return BOLAN_ERROR_ARGUMENT;
    *out = NULL;
    if (!bolan_is_picture_size(width) || !bolan_is_picture_size(height)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "target: %u x %u pixels; expected 1 to %d each way", width,
                  height, MOST_PIXELS);
        return BOLAN_ERROR_ARGUMENT;
    }
    bolan_result result = bolan_gl_check_context("target");
    if (result != BOLAN_OK) return result;
    bolan_target *t = allocate_for("a target", sizeof *t);
    if (t == NULL) return BOLAN_ERROR_MEMORY;
    result = make_target(t, width, height);
    if (result != BOLAN_OK) {
        bolan_target_destroy(&t);
        return result;
    }
    *out = t;
    return BOLAN_OK;
}

uint32_t bolan_target_framebuffer(const bolan_target *target) { return target->target.id; }

// Why the target cannot be shown there, as the end of a sentence; NULL: it was.
static const char *show(bolan_target *t, uint32_t framebuffer, uint32_t width, uint32_t height) {
    gl_saved saved;
    if (framebuffer == t->target.id) return "is the target itself";
    bolan_gl_save(&saved, &t->caps, false);
    const char *problem = bolan_gl_framebuffer_problem(framebuffer, GL_TO_COPY);
    if (problem == NULL) bolan_gl_target_show(&t->target, framebuffer, width, height);
    bolan_gl_restore(&saved);
    return problem;
}

void bolan_target_show(bolan_target *t, uint32_t framebuffer, uint32_t width, uint32_t height) {
    BOLAN_ASSERT(t != NULL);
    if (t == NULL) return;
    const char *problem = NULL;
    if (!bolan_gl_has_context())
        problem = "cannot be reached: no OpenGL context is current on this thread";
    else if (!bolan_is_picture_size(width) || !bolan_is_picture_size(height))
        problem = "has a size that is not 1 to 16384 pixels each way";
    else
        problem = show(t, framebuffer, width, height);
    if (problem != NULL && problem != t->refusal)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_TARGET, "target: framebuffer %u to show it in %s", framebuffer,
                  problem);
    t->refusal = problem;
}

void bolan_target_destroy(bolan_target **target) {
    if (target == NULL || *target == NULL) return;
    if (!bolan_gl_has_context())
        bolan_log(
            BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT,
            "target: destroyed while no OpenGL context is current; what it has on the GPU stays until its context "
            "is gone");
    bolan_gl_target_free(&(*target)->target);
    bolan_gl_texture_free(&(*target)->color);
    bolan_release(*target, sizeof **target);
    *target = NULL;
}
