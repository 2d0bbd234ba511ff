// SPDX-License-Identifier: MIT
// What a step and a view must be before they are drawn, and what the host declares of its state.
#include "bounds.h"
#include "host_light.h"
#include "renderer.h"

#include <math.h>

// Whether `ask` says yes to that name. Unless the caller's state is asked for in any case, it is asked once.
static bool is_kind(bolan_renderer *r, gl_known_kind kind, uint32_t name, bool (*ask)(uint32_t)) {
    if (r->desc.restore == BOLAN_RESTORE_FULL) return ask(name);
    if (bolan_gl_knows(&r->known, kind, name)) return true;
    if (!ask(name)) return false;
    bolan_gl_know(&r->known, kind, name);
    return true;
}

static bool is_2d(bolan_renderer *r, uint32_t name) { return is_kind(r, GL_KNOWN_2D, name, bolan_gl_is_2d); }

static bool is_multisampled(bolan_renderer *r, uint32_t name) {
    return is_kind(r, GL_KNOWN_MULTISAMPLED, name, bolan_gl_is_multisampled);
}

static const char *cube_problem(bolan_renderer *r, uint32_t cube) {
    if (cube == 0 || is_kind(r, GL_KNOWN_CUBE, cube, bolan_gl_is_cube)) return NULL;
    return "environment.cube is no cube map of this context";
}

static bool check_kind(bolan_renderer *r, const char *field, int value, int count) {
    if (value >= 0 && value < count) return true;
    return bolan_renderer_refuse(r, CALL_PREPARE, BOLAN_LOG_OUT_OF_RANGE, "draw: technique.%s is %d; expected 0 to %d",
                                 field, value, count - 1);
}

bool bolan_step_is_valid(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting) {
    const bolan_technique *t = &lighting->technique;
    const bolan_wave_model waves = bolan_sea_get_desc(water->sea)->waves;
    if (!bolan_gl_has_context())
        return bolan_renderer_refuse(r, CALL_PREPARE, BOLAN_LOG_GL_CONTEXT,
                                     "draw: no OpenGL context is current on this thread");
    if (!check_kind(r, "waves", (int)t->waves, BOLAN_WAVE_MODELS) ||
        !check_kind(r, "surface", (int)t->surface, BOLAN_SURFACE_KINDS) ||
        !check_kind(r, "optics", (int)t->optics, BOLAN_OPTICS_KINDS))
        return false;
    const char *problem = cube_problem(r, lighting->environment.cube);
    if (problem == NULL) problem = bolan_environment_problem(&lighting->environment);
    if (problem == NULL) problem = bolan_haze_problem(&lighting->haze);
    if (problem != NULL)
        return bolan_renderer_refuse(r, CALL_PREPARE, BOLAN_LOG_GUEST_LIGHT, "prepare: the lighting's %s", problem);
    if (t->waves == waves) return true;
    return bolan_renderer_refuse(r, CALL_PREPARE, BOLAN_LOG_BAD_ARGUMENT,
                                 "draw: technique.waves is %s, but the sea is made of %s; expected the same wave model",
                                 bolan_wave_model_names[t->waves], bolan_wave_model_names[waves]);
}

static bool check_numbers(bolan_renderer *r, const bolan_view *v) {
    if (v->width < 1 || v->width > MOST_PIXELS || v->height < 1 || v->height > MOST_PIXELS)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                     "draw: the view is %u x %u pixels; expected 1 to %d each way", v->width, v->height,
                                     MOST_PIXELS);
    if (v->samples < 1 || v->samples > MOST_SAMPLES)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                     "draw: the view has %u samples; expected 1 to %d", v->samples, MOST_SAMPLES);
    if ((int)v->output < 0 || v->output > BOLAN_OUTPUT_LINEAR)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_OUT_OF_RANGE,
                                     "draw: the view's output is %d; expected 0 to %d", (int)v->output,
                                     (int)BOLAN_OUTPUT_LINEAR);
    return true;
}

bool bolan_view_is_valid(bolan_renderer *r, const bolan_view *v) {
    if (!bolan_gl_has_context())
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_GL_CONTEXT,
                                     "draw: no OpenGL context is current on this thread");
    if (!check_numbers(r, v)) return false;
    if (v->cache != NULL && v->cache->renderer != r)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_BAD_ARGUMENT,
                                     "draw: the view's cache belongs to another renderer");
    const char *problem = bolan_view_problem(v);
    if (problem != NULL)
        return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_VIEW, "draw: the view cannot be drawn: %s", problem);
    if (v->motion.framebuffer != 0 && v->motion.before != NULL) problem = bolan_view_problem(v->motion.before);
    return problem == NULL ||
           bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_VIEW, "draw: the view before has no motion: %s", problem);
}

static bool can_draw_into(bolan_renderer *r, uint32_t framebuffer) {
    const bool trusts = r->desc.restore != BOLAN_RESTORE_FULL;
    if (trusts && bolan_gl_knows(&r->known, GL_KNOWN_FRAMEBUFFER, framebuffer)) return true;
    const char *problem = bolan_gl_framebuffer_problem(framebuffer, GL_TO_DRAW);
    if (problem == NULL && trusts) bolan_gl_know(&r->known, GL_KNOWN_FRAMEBUFFER, framebuffer);
    if (problem == NULL) return true;
    return bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_GL_TARGET, "draw: framebuffer %u %s", framebuffer, problem);
}

bool bolan_view_has_framebuffer(bolan_renderer *r, const bolan_view *v) {
    return can_draw_into(r, v->framebuffer) && (v->motion.framebuffer == 0 || can_draw_into(r, v->motion.framebuffer));
}

static const char *scene_problem(const bolan_host *h, bolan_renderer *r) {
    if ((h->color == 0) != (h->depth == 0)) return "color and depth are not both given, or both left out";
    if (h->color == 0) return NULL;
    if (h->samples <= 1) {
        if (!is_2d(r, h->color)) return "color is no 2D texture of this context, and samples is not above 1";
        return is_2d(r, h->depth) ? NULL : "depth is no 2D texture of this context, and samples is not above 1";
    }
    if (r->caps.es) return "samples is above 1, and OpenGL ES 3.0 has no multisampled textures: resolve them first";
    if (!is_multisampled(r, h->color)) return "color is no multisampled 2D texture, and samples is above 1";
    return is_multisampled(r, h->depth) ? NULL : "depth is no multisampled 2D texture, and samples is above 1";
}

static const char *shadow_problem(const bolan_host *h, bolan_renderer *r) {
    if (h->shadow == 0) return NULL;
    if (!is_2d(r, h->shadow)) return "shadow is no 2D texture of this context";
    for (int i = 0; i < 16; ++i)
        if (!isfinite(h->shadow_matrix.m[i])) return "shadow_matrix is not finite";
    if (!isfinite(h->shadow_bias)) return "shadow_bias is not finite";
    const bool reads = r->frame.lighting.technique.optics == BOLAN_OPTICS_PHYSICAL;
    return reads ? NULL : "shadow is given, and the optics is not physical";
}

static const char *host_problem(const bolan_host *h, bolan_renderer *r, uint32_t framebuffer) {
    const char *problem = scene_problem(h, r);
    if (problem == NULL) problem = shadow_problem(h, r);
    if (problem != NULL) return problem;
    if (h->stencil_mask != 0 && !is_kind(r, GL_KNOWN_STENCIL, framebuffer, bolan_gl_has_stencil))
        return "stencil_mask is not 0, and the view's framebuffer has no stencil";
    if (h->mask != 0 && !is_2d(r, h->mask)) return "mask is no 2D texture of this context";
    return bolan_bounds_problem(h->bounds, h->bounds_count);
}

bool bolan_host_is_valid(bolan_renderer *r, const bolan_host *h, uint32_t framebuffer) {
    const char *problem = host_problem(h, r, framebuffer);
    return problem == NULL ||
           bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_GUEST_FRAME, "draw_water: the host's %s", problem);
}

void bolan_renderer_declare_state(bolan_renderer *r, const bolan_gl_state *state) {
    BOLAN_ASSERT(r != NULL && state != NULL);
    if (r != NULL && state != NULL) r->declared = *state;
}
