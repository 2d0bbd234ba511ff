// SPDX-License-Identifier: MIT
// See temporal.h.
#include "temporal.h"

#include "motion.h"
#include "renderer.h"

#include <string.h>

enum { STILL_IMAGES = 64, MOVING_IMAGES = 8 };
static const float MOVING_REACH = 0.7f; // of the jitter while something moves: a compromise of open sea and land

static void free_targets(temporal *t) {
    for (int i = 0; i < 2; i++) {
        bolan_gl_target_free(&t->target[i]);
        bolan_gl_texture_free(&t->history[i]);
    }
    bolan_gl_target_free(&t->motion_target);
    bolan_gl_texture_free(&t->motion);
}

static bolan_result create_target(gl_texture *texture, gl_target *target, uint32_t width, uint32_t height) {
    const gl_texture_desc desc = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    const gl_texture *colors[] = {texture};
    const bolan_result result = bolan_gl_texture_create(&desc, texture);
    return result == BOLAN_OK ? bolan_gl_target_create(colors, 1, NULL, -1, 0, target) : result;
}

// False: there is no memory, or the shader does not compile (logged).
static bool fit(temporal *t, uint32_t width, uint32_t height) {
    if (t->resolve.stem[0] == '\0') bolan_gl_program_create("temporal", NULL, &t->resolve);
    if (t->resolve.id == 0) return false;
    if (t->motion_target.id != 0 && t->motion.width == width && t->motion.height == height) return true;
    free_targets(t);
    t->images = 0;
    bolan_result result = create_target(&t->motion, &t->motion_target, width, height);
    for (int i = 0; i < 2 && result == BOLAN_OK; i++)
        result = create_target(&t->history[i], &t->target[i], width, height);
    if (result != BOLAN_OK) free_targets(t);
    return result == BOLAN_OK;
}

static bool is_same_camera(const bolan_view *a, const bolan_view *b) {
    return memcmp(&a->eye, &b->eye, sizeof a->eye) == 0 && memcmp(&a->view, &b->view, sizeof a->view) == 0 &&
           memcmp(&a->projection, &b->projection, sizeof a->projection) == 0 && a->tile.x == b->tile.x &&
           a->tile.y == b->tile.y && a->without_water == b->without_water;
}

// Whether the same is shown. Bytes between the members of a struct may differ: then it only counts as moving.
static bool is_still(const temporal_state *a, const temporal_state *b) {
    return is_same_camera(&a->view, &b->view) && a->sea == b->sea && a->serial == b->serial && a->places == b->places &&
           a->time == b->time && memcmp(&a->block, &b->block, sizeof a->block) == 0 &&
           memcmp(&a->exposure, &b->exposure, sizeof a->exposure) == 0 &&
           memcmp(&a->lighting.technique, &b->lighting.technique, sizeof a->lighting.technique) == 0 &&
           memcmp(&a->lighting.look, &b->lighting.look, sizeof a->lighting.look) == 0;
}

static bolan_vec2 mean_shift(uint32_t first, uint32_t samples, float reach) {
    bolan_vec2 sum = {0.0f, 0.0f};
    for (uint32_t i = first; i < first + samples; i++) {
        const bolan_vec2 s = bolan_sample_shift(i);
        sum.x += reach * s.x / (float)samples;
        sum.y += reach * s.y / (float)samples;
    }
    return sum;
}

uint32_t bolan_temporal_begin(temporal *t, const render_view *v, const bolan_view *to, uint64_t places) {
    const frame *f = v->frame;
    t->drawing = to->temporal && !to->accumulate && to->output != BOLAN_OUTPUT_LINEAR && fit(t, v->width, v->height);
    if (!t->drawing) {
        t->images = 0;
        t->reach = 1.0f;
        return 0;
    }
    t->now = (temporal_state){.view = *to,
                              .lighting = f->lighting,
                              .block = f->block,
                              .exposure = v->light.exposure,
                              .sea = bolan_sea_id(f->sea),
                              .serial = bolan_sea_serial(f->sea),
                              .places = places,
                              .time = f->time};
    t->still = t->images > 0 && is_still(&t->before, &t->now);
    const uint32_t first = t->images % STILL_IMAGES * to->samples;
    t->reach = t->still || t->images == 0 ? 1.0f : MOVING_REACH;
    t->shift = mean_shift(first, to->samples, t->reach);
    return first;
}

void bolan_temporal_draw_motion(temporal *t, bolan_renderer *r, render_view *v, const bolan_view *to) {
    if (!t->drawing || t->images == 0 || t->still) return;
    const motion_request q = {.framebuffer = t->motion_target.id, .before = &t->before.view, .time = t->before.time};
    bolan_motion_draw(r, v, to, &q);
}

const gl_texture *bolan_temporal_blend(temporal *t, const render_view *v, const gl_texture *sum, uint32_t samples) {
    const uint32_t to = t->latest ^ 1u;
    bolan_gl_target_bind(&t->target[to]);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_program_use(&t->resolve);
    bolan_gl_program_vec4(&t->resolve, "settings",
                          (bolan_vec4){1.0f / (float)samples, t->still ? 1.0f : 0.0f,
                                       (float)(t->still ? STILL_IMAGES : MOVING_IMAGES), t->images > 0 ? 1.0f : 0.0f});
    bolan_gl_program_vec2(&t->resolve, "shift", t->shift.x, t->shift.y);
    bolan_gl_texture_bind(sum, UNIT_OWN);
    bolan_gl_texture_bind(&t->history[t->latest], UNIT_OWN + 1);
    bolan_gl_texture_bind(&t->motion, UNIT_OWN + 2);
    bolan_gl_texture_bind(v->hdr_depth, UNIT_OWN + 3);
    bolan_gl_draw_fullscreen();
    t->latest = to;
    t->images++;
    t->before = t->now;
    return &t->history[to];
}

bolan_result bolan_temporal_reload(temporal *t) {
    return t->resolve.id != 0 ? bolan_gl_program_reload(&t->resolve) : BOLAN_OK;
}

void bolan_temporal_free(temporal *t) {
    free_targets(t);
    bolan_gl_program_free(&t->resolve);
}
