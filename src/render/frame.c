// SPDX-License-Identifier: MIT
// One picture, as the list of its passes.
#include "frame.h"

#include <math.h>

#include "below.h"
#include "renderer.h"

_Static_assert((int)PART_COUNT + (int)SEA_STAGES <= BOLAN_MAX_PASSES, "statistics have a place for each");

const char *const bolan_frame_part_names[PART_COUNT] = {"sky tables", "sea",   "view", "terrain", "models",  "copy",
                                                        "mirror",     "water", "sky",  "motion",  "tone map"};

bolan_vec2 bolan_sample_shift(uint32_t i) {
    double x = fmod(0.7548776662466927 * i, 1.0), y = fmod(0.5698402909980532 * i, 1.0);
    return (bolan_vec2){(float)(x < 0.5 ? x : x - 1.0), (float)(y < 0.5 ? y : y - 1.0)};
}

gl_timing bolan_frame_timing(const bolan_renderer *r) {
    if (!r->measure) return GL_TIMING_OFF;
    return r->caps.timers ? GL_TIMING_GPU : GL_TIMING_FINISH;
}

void bolan_frame_begin_part(bolan_renderer *r, frame_part part) {
    bolan_gl_timer_begin(&r->timers[part], bolan_frame_timing(r));
    r->part_begun = bolan_gl_calls().count;
}

void bolan_frame_end_part(bolan_renderer *r, frame_part part) {
    r->part_calls[part] = bolan_gl_calls().count - r->part_begun;
    bolan_gl_timer_end(&r->timers[part], bolan_frame_timing(r));
}

// ---- a picture ------------------------------------------------------------------------------------------------------

void bolan_frame_use(bolan_renderer *r) {
    bolan_frame_fill(&r->frame);
    bolan_blocks_upload_frame(&r->uniforms, &r->frame.block);
}

void bolan_frame_prepare_view(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    bolan_frame_use(r);
    bolan_view_use(v);
    bolan_frame_begin_part(r, PART_SKY_TABLES);
    bolan_pass_sky_prepare(cache->sky, v);
    if (v->medium == EYE_IN_WATER)
        v->light.exposure = bolan_v3_scale(v->light.exposure, bolan_below_exposure(&r->frame, v->eye));
    bolan_frame_end_part(r, PART_SKY_TABLES);
    bolan_frame_begin_part(r, PART_VIEW);
    bolan_view_use(v); // the light is known now
    bolan_blocks_bind(&r->uniforms);
    bolan_pass_ground_prepare(cache->ground, v);
    v->shore = bolan_pass_ground_shore(cache->ground);
    bolan_pass_objects_prepare(r->models, v);
    if (!v->without_water) bolan_pass_water_view(r->water, v);
    if (r->frame.caustics.strength > 0.0f) bolan_frame_use(r); // which the optics has put into it
    bolan_frame_end_part(r, PART_VIEW);
}

static void draw_land(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    bolan_pass_ground_draw(cache->ground, v);
    bolan_pass_objects_draw(r->models, v);
}

static void draw_opaque(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&v->hdr);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_clear_depth(0.0f);
    bolan_frame_begin_part(r, PART_TERRAIN);
    if (!v->without_water) bolan_pass_water_cover(r->water, v);
    bolan_pass_ground_draw(cache->ground, v);
    bolan_frame_end_part(r, PART_TERRAIN);
    bolan_frame_begin_part(r, PART_MODELS);
    bolan_pass_objects_draw(r->models, v);
    bolan_frame_end_part(r, PART_MODELS);
}

// What lies behind the water, for an optics that looks through it.
static void copy_behind(bolan_renderer *r, const render_view *v) {
    bolan_gl_target_copy_color(&r->targets.hdr, &r->targets.behind);
    bolan_gl_target_copy_depth(&r->targets.hdr, &r->targets.behind);
    bolan_gl_texture_bind(&r->targets.behind_color, UNIT_SCENE_COLOR);
    bolan_gl_texture_bind(&r->targets.behind_depth, UNIT_SCENE_DEPTH);
    bolan_gl_target_bind(&v->hdr);
}

typedef struct drawn_world {
    bolan_renderer *renderer;
    bolan_view_cache *cache;
} drawn_world;

static void draw_world(void *user, render_view *v, bool sky) {
    const drawn_world *w = user;
    draw_land(w->renderer, v, w->cache);
    if (v->mirrored_under)
        bolan_pass_water_draw_body(w->renderer->water, v->frame);
    else if (sky)
        bolan_pass_sky_draw(w->cache->sky, v, false);
}

static void draw_behind(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    drawn_world w = {r, cache};
    bolan_frame_begin_part(r, PART_MIRROR);
    bolan_pass_water_behind(r->water, v, &(world_drawer){draw_world, &w});
    bolan_frame_end_part(r, PART_MIRROR);
}

static void draw_water(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    const frame *f = v->frame;
    bolan_frame_begin_part(r, PART_COPY);
    // Clouds below a high eye are laid over by the depth of the land.
    if (f->behind && (bolan_pass_water_looks_through(f) || v->light.above_clouds || f->motion)) copy_behind(r, v);
    bolan_frame_end_part(r, PART_COPY);
    draw_behind(r, v, cache);
    bolan_frame_begin_part(r, PART_WATER);
    bolan_pass_water_draw(r->water, v);
    bolan_frame_end_part(r, PART_WATER);
}

// Last, where nothing stands before it.
static void draw_sky(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    bolan_frame_begin_part(r, PART_SKY);
    if (v->under) {
        bolan_pass_water_draw_body(r->water, v->frame);
    } else if (v->medium != EYE_IN_WATER) {
        bolan_pass_sky_draw(cache->sky, v, true);
        bolan_pass_sky_draw_over(cache->sky, v);
    }
    if (!v->without_water) bolan_pass_water_draw_over(r->water, v);
    bolan_pass_water_draw_below(r->water, v);
    bolan_frame_end_part(r, PART_SKY);
}

static void keep_statistics(bolan_renderer *r, const render_view *v) {
    bolan_frame_statistics *s = &r->statistics;
    s->triangles = v->triangles;
    s->water_triangles = v->water_triangles;
    s->pass_count = PART_COUNT;
    for (int i = 0; i < PART_COUNT; ++i) {
        s->passes[i].name = bolan_frame_part_names[i];
        s->passes[i].ms = r->timers[i].ms;
        s->passes[i].gl_calls = r->part_calls[i];
    }
    const sea_compute *sea = r->frame.compute;
    s->sea_bytes = sea != NULL ? sea->bytes : 0;
    for (int i = 0; sea != NULL && i < SEA_STAGES; ++i) {
        s->passes[s->pass_count].name = bolan_sea_stage_names[i];
        s->passes[s->pass_count].gl_calls = 0; // the part of the sea has them
        s->passes[s->pass_count++].ms = sea->timers[i].ms;
    }
}

static void draw_motion(bolan_renderer *r, render_view *v, const bolan_view *to, bolan_view_cache *cache) {
    bolan_frame_begin_part(r, PART_MOTION);
    bolan_motion_draw_asked(r, v, to, NULL);
    bolan_temporal_draw_motion(&cache->temporal, r, v, to);
    bolan_frame_end_part(r, PART_MOTION);
}

// `first`: the shift of the last sample.
static void draw_sample(bolan_renderer *r, const render_view *whole, const bolan_view *to, bolan_view_cache *cache,
                        uint32_t sample, uint32_t first) {
    render_view v = *whole;
    const bolan_vec2 shift = bolan_sample_shift(first + to->samples - 1 - sample);
    const float reach = cache->temporal.reach;
    bolan_view_shift(&v, (bolan_vec2){reach * shift.x, reach * shift.y});
    bolan_view_use(&v);
    draw_opaque(r, &v, cache);
    if (!v.without_water) draw_water(r, &v, cache);
    draw_sky(r, &v, cache);
    if (sample + 1 == to->samples) draw_motion(r, &v, to, cache);
    bolan_frame_begin_part(r, PART_TONEMAP);
    bolan_pass_tonemap_draw(r->tonemap, &v, to, &r->targets.hdr_color, sample, &cache->temporal);
    bolan_frame_end_part(r, PART_TONEMAP);
    keep_statistics(r, &v);
}

bool bolan_frame_open_view(bolan_renderer *r, render_view *v, const bolan_view *from) {
    const bool zero_to_one = r->caps.clip_control && !r->desc.no_clip_control;
    frame *f = &r->frame;
    if (bolan_renderer_resize(r, from->width, from->height) != BOLAN_OK) return false;
    if (r->caps.clip_control) bolan_gl_set_clip_zero_to_one(zero_to_one);
    bolan_view_open(v, f, from, zero_to_one);
    v->hdr = r->targets.hdr;
    v->hdr_depth = &r->targets.hdr_depth;
    v->depth_serial = r->targets.serial;
    v->bake = !v->progressive || r->bake;
    r->bake = false;
    v->under = v->picture = v->eye.z < f->level && bolan_pass_water_has_body(f);
    v->fog = f->lighting.look.effects & BOLAN_EFFECT_FOG;
    v->uniforms = &r->uniforms;
    r->near_plane = v->near_distance;
    r->radiance_unit = f->block.radiance_unit;
    return true;
}

static void note_stale(bolan_renderer *r, const render_view *v) {
    const bool stale = !v->without_water && bolan_pass_water_needs_baking(r->water, &r->frame);
    if (stale && !r->stale)
        bolan_log(BOLAN_LOG_INFO, BOLAN_LOG_BAKE_WANTED,
                  "draw: the sun has turned since the light on the bottom was baked; bolan_renderer_bake() bakes it "
                  "anew");
    r->stale = stale;
}

static void draw_view(bolan_renderer *r, const bolan_view *to) {
    render_view v = {.frame = NULL};
    bolan_view_cache *cache = to->cache != NULL ? to->cache : &r->own_cache;
    if (!bolan_view_has_framebuffer(r, to)) return;
    bolan_renderer_accept(r, CALL_DRAW);
    if (!bolan_frame_open_view(r, &v, to)) return;
    v.without_water = to->without_water;
    bolan_pass_water_place(&r->frame, &v);
    r->near_plane = v.near_distance;
    bolan_frame_prepare_view(r, &v, cache);
    // The unshifted sample comes last, so that the depth that remains is that of the pixels' middles.
    const uint32_t kept = bolan_pass_tonemap_begin(r->tonemap, to);
    const uint32_t turn = bolan_temporal_begin(&cache->temporal, &v, to, bolan_pass_objects_places(r->models));
    const uint32_t first = to->accumulate ? kept : turn;
    for (uint32_t s = 0; s < to->samples; ++s) draw_sample(r, &v, to, cache, s, first);
    r->statistics.samples = bolan_pass_tonemap_samples(r->tonemap);
    note_stale(r, &v);
}

// ---- into a host's frame --------------------------------------------------------------------------------------------

static void begin_hosted(bolan_renderer *r, render_view *v, const bolan_view *to, const bolan_host *host) {
    if (r->frame.hosted) {
        bolan_host_import(&r->host, v, to, host);
    } else {
        bolan_gl_target_bind(&v->hdr);
        bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
        bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
        bolan_gl_target_clear_depth(0.0f);
    }
    copy_behind(r, v);
}

static void draw_hosted(bolan_renderer *r, const bolan_view *to, const bolan_host *host) {
    render_view v = {.frame = NULL};
    bolan_view_cache *cache = to->cache != NULL ? to->cache : &r->own_cache;
    if (!bolan_frame_open_view(r, &v, to)) return;
    bolan_frame_prepare_view(r, &v, cache);
    if (host->bounds_count > 0 && !bolan_bounds_upload(&r->bounds, host->bounds, host->bounds_count, v.eye)) return;
    begin_hosted(r, &v, to, host);
    draw_behind(r, &v, cache);
    bolan_frame_begin_part(r, PART_WATER);
    bolan_pass_water_draw(r->water, &v);
    bolan_pass_water_draw_over(r->water, &v); // seen where water stands behind it
    bolan_gl_texture_bind(&r->targets.behind_depth, UNIT_SCENE_DEPTH);
    bolan_host_resolve(&r->host, &v, to, host, &r->targets.hdr_color);
    bolan_pass_tonemap_forget(r->tonemap);
    r->statistics.samples = 1;
    bolan_frame_end_part(r, PART_WATER);
    bolan_frame_begin_part(r, PART_MOTION);
    bolan_motion_draw_asked(r, &v, to, host);
    bolan_frame_end_part(r, PART_MOTION);
    keep_statistics(r, &v);
}

// The step as this host sees it; the next view of it may be another's.
static void draw_for(bolan_renderer *r, const bolan_view *to, const bolan_host *host) {
    frame *f = &r->frame;
    r->motion = f->motion = r->motion || to->motion.framebuffer != 0;
    const bool behind = f->behind;
    f->host = host;
    f->hosted = host->color != 0;
    f->behind = f->behind || f->hosted;
    f->bounds_count = host->bounds_count;
    draw_hosted(r, to, host);
    f->host = NULL;
    f->hosted = false;
    f->behind = behind;
    f->bounds_count = 0;
}

void bolan_renderer_draw_water(bolan_renderer *r, const bolan_view *view, const bolan_host *host) {
    const bolan_host nothing = bolan_host_default(), *given = host != NULL ? host : &nothing;
    BOLAN_ASSERT(r != NULL && view != NULL);
    if (r == NULL || view == NULL) return;
    if (!r->prepared) {
        bolan_renderer_refuse(r, CALL_DRAW, BOLAN_LOG_BAD_ARGUMENT,
                              "draw_water: no step is prepared; call bolan_renderer_prepare() before");
        return;
    }
    if (!bolan_view_is_valid(r, view) || !bolan_host_is_valid(r, given, view->framebuffer)) return;
    bolan_renderer_enter(r);
    if (bolan_view_has_framebuffer(r, view)) {
        bolan_renderer_accept(r, CALL_DRAW);
        draw_for(r, view, given);
    }
    bolan_renderer_leave(r);
}

// ---- a world --------------------------------------------------------------------------------------------------------

void bolan_renderer_draw_world(bolan_renderer *r, const bolan_world *world, const bolan_view *view) {
    const bool given = r != NULL && world != NULL && view != NULL;
    BOLAN_ASSERT(given);
    if (!given || !bolan_view_is_valid(r, view)) return;
    const bolan_lighting lighting = bolan_lighting_from_scene(bolan_world_scene(world));
    const bolan_water *water = bolan_world_water(world);
    r->prepared = false;
    if (!bolan_step_is_valid(r, water, &lighting)) return;
    bolan_renderer_accept(r, CALL_PREPARE);
    bolan_renderer_enter(r);
    r->motion = r->motion || view->temporal || view->motion.framebuffer != 0;
    bolan_frame_prepare(r, water, &lighting, world);
    draw_view(r, view);
    bolan_renderer_leave(r);
}
