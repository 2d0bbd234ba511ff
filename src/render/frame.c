// SPDX-License-Identifier: MIT
// One picture, as the list of its passes.
#include "frame.h"

#include <math.h>

#include "below.h"
#include "memory.h"
#include "renderer.h"

_Static_assert((int)PART_COUNT + (int)SEA_STAGES <= BOLAN_MAX_PASSES, "statistics have a place for each");

const char *const bolan_frame_part_names[PART_COUNT] = {"sky tables", "sea",   "view", "terrain", "models",  "copy",
                                                        "mirror",     "water", "sky",  "motion",  "tone map"};

bolan_vec2 bolan_sample_shift(uint32_t i) {
    double x = fmod(0.7548776662466927 * i, 1.0), y = fmod(0.5698402909980532 * i, 1.0);
    return (bolan_vec2){(float)(x < 0.5 ? x : x - 1.0), (float)(y < 0.5 ? y : y - 1.0)};
}

static gl_timing timing_of(const bolan_renderer *r) {
    if (!r->measure) return GL_TIMING_OFF;
    return r->caps.timers ? GL_TIMING_GPU : GL_TIMING_FINISH;
}

static void begin_part(bolan_renderer *r, frame_part part) {
    bolan_gl_timer_begin(&r->timers[part], timing_of(r));
    r->part_begun = bolan_gl_calls().count;
}

static void end_part(bolan_renderer *r, frame_part part) {
    r->part_calls[part] = bolan_gl_calls().count - r->part_begun;
    bolan_gl_timer_end(&r->timers[part], timing_of(r));
}

// ---- the step -------------------------------------------------------------------------------------------------------

bolan_lighting bolan_lighting_from_scene(const bolan_scene *scene) {
    BOLAN_ASSERT(scene != NULL);
    return (bolan_lighting){.sky = scene->sky,
                            .exposure = scene->exposure,
                            .technique = scene->technique,
                            .look = scene->look,
                            .environment = bolan_environment_default()};
}

bolan_lighting bolan_lighting_default(void) {
    const bolan_scene scene = bolan_scene_default();
    return bolan_lighting_from_scene(&scene);
}

// `world`: objects and tiles are drawn too; NULL: the water alone.
static frame step_of(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                     const bolan_world *world) {
    const bolan_scene *scene = world != NULL ? bolan_world_scene(world) : NULL;
    frame f = {.caps = &r->caps,
               .compute = r->desc.backend == BOLAN_BACKEND_COMPUTE ? &r->compute : NULL,
               .compute_pixels = r->desc.pixels == BOLAN_PIXELS_COMPUTE,
               .timing = timing_of(r),
               .motion = r->motion,
               .quality = r->desc.quality,
               .water = *water,
               .sea = water->sea,
               .ground = water->ground,
               .level = water->level,
               .lighting = *lighting,
               .scene = scene,
               .models = world != NULL ? bolan_world_object_models(world) : NULL,
               .tiles = world != NULL ? bolan_world_tiles(world) : NULL};
    f.behind = water->ground != NULL || (scene != NULL && scene->object_count > 0);
    bolan_frame_fill(&f);
    return f;
}

bolan_result bolan_renderer_compile(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                                    bolan_progress *progress, void *user) {
    const bool given = r != NULL && water != NULL && water->sea != NULL && lighting != NULL;
    BOLAN_ASSERT(given);
    if (!given) return BOLAN_ERROR_ARGUMENT;
    if (!bolan_gl_has_context()) return bolan_gl_check_context("compile");
    if (!bolan_step_is_valid(r, water, lighting)) return BOLAN_ERROR_ARGUMENT;
    const frame f = step_of(r, water, lighting, NULL);
    bolan_renderer_enter(r);
    const bolan_result result = bolan_pass_water_compile(r->water, &f, progress, user);
    bolan_renderer_leave(r);
    return result;
}

static void prepare(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                    const bolan_world *world) {
    r->statistics.gl_calls = r->statistics.gl_questions = 0;
    r->frame = step_of(r, water, lighting, world);
    begin_part(r, PART_SEA);
    bolan_pass_water_prepare(r->water, &r->frame);
    end_part(r, PART_SEA);
    r->prepared = true;
}

void bolan_renderer_prepare(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting) {
    const bool given = r != NULL && water != NULL && water->sea != NULL && lighting != NULL;
    BOLAN_ASSERT(given);
    if (!given) return;
    r->prepared = false;
    if (!bolan_step_is_valid(r, water, lighting)) return;
    bolan_renderer_accept(r, CALL_PREPARE);
    bolan_renderer_enter(r);
    prepare(r, water, lighting, NULL);
    bolan_renderer_leave(r);
}

// ---- a picture ------------------------------------------------------------------------------------------------------

static void use_frame(bolan_renderer *r) {
    bolan_frame_fill(&r->frame);
    bolan_blocks_upload_frame(&r->uniforms, &r->frame.block);
}

// Everything that does not depend on the sub-pixel shift.
static void prepare_view(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    use_frame(r);
    bolan_view_use(v);
    begin_part(r, PART_SKY_TABLES);
    bolan_pass_sky_prepare(cache->sky, v);
    if (v->medium == EYE_IN_WATER)
        v->light.exposure = bolan_v3_scale(v->light.exposure, bolan_below_exposure(&r->frame, v->eye));
    end_part(r, PART_SKY_TABLES);
    begin_part(r, PART_VIEW);
    bolan_view_use(v); // the light is known now
    bolan_blocks_bind(&r->uniforms);
    bolan_pass_ground_prepare(cache->ground, v);
    v->shore = bolan_pass_ground_shore(cache->ground);
    bolan_pass_objects_prepare(r->models, v);
    if (!v->without_water) bolan_pass_water_view(r->water, v);
    if (r->frame.caustics.strength > 0.0f) use_frame(r); // which the optics has put into it
    end_part(r, PART_VIEW);
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
    begin_part(r, PART_TERRAIN);
    if (!v->without_water) bolan_pass_water_cover(r->water, v);
    bolan_pass_ground_draw(cache->ground, v);
    end_part(r, PART_TERRAIN);
    begin_part(r, PART_MODELS);
    bolan_pass_objects_draw(r->models, v);
    end_part(r, PART_MODELS);
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
    begin_part(r, PART_MIRROR);
    bolan_pass_water_behind(r->water, v, &(world_drawer){draw_world, &w});
    end_part(r, PART_MIRROR);
}

static void draw_water(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    const frame *f = v->frame;
    begin_part(r, PART_COPY);
    // Clouds below a high eye are laid over by the depth of the land.
    if (f->behind && (bolan_pass_water_looks_through(f) || v->light.above_clouds || f->motion)) copy_behind(r, v);
    end_part(r, PART_COPY);
    draw_behind(r, v, cache);
    begin_part(r, PART_WATER);
    bolan_pass_water_draw(r->water, v);
    end_part(r, PART_WATER);
}

// Last, where nothing stands before it.
static void draw_sky(bolan_renderer *r, render_view *v, bolan_view_cache *cache) {
    begin_part(r, PART_SKY);
    if (v->under) {
        bolan_pass_water_draw_body(r->water, v->frame);
    } else if (v->medium != EYE_IN_WATER) {
        bolan_pass_sky_draw(cache->sky, v, true);
        bolan_pass_sky_draw_over(cache->sky, v);
    }
    if (!v->without_water) bolan_pass_water_draw_over(r->water, v);
    bolan_pass_water_draw_below(r->water, v);
    end_part(r, PART_SKY);
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
    begin_part(r, PART_MOTION);
    bolan_motion_draw_asked(r, v, to, NULL);
    bolan_temporal_draw_motion(&cache->temporal, r, v, to);
    end_part(r, PART_MOTION);
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
    begin_part(r, PART_TONEMAP);
    bolan_pass_tonemap_draw(r->tonemap, &v, to, &r->targets.hdr_color, sample, &cache->temporal);
    end_part(r, PART_TONEMAP);
    keep_statistics(r, &v);
}

static bool open_view(bolan_renderer *r, render_view *v, const bolan_view *from) {
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
    if (!open_view(r, &v, to)) return;
    v.without_water = to->without_water;
    bolan_pass_water_place(&r->frame, &v);
    r->near_plane = v.near_distance;
    prepare_view(r, &v, cache);
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
    if (!open_view(r, &v, to)) return;
    prepare_view(r, &v, cache);
    if (host->bounds_count > 0 && !bolan_bounds_upload(&r->bounds, host->bounds, host->bounds_count, v.eye)) return;
    begin_hosted(r, &v, to, host);
    draw_behind(r, &v, cache);
    begin_part(r, PART_WATER);
    bolan_pass_water_draw(r->water, &v);
    bolan_pass_water_draw_over(r->water, &v); // seen where water stands behind it
    bolan_gl_texture_bind(&r->targets.behind_depth, UNIT_SCENE_DEPTH);
    bolan_host_resolve(&r->host, &v, to, host, &r->targets.hdr_color);
    bolan_pass_tonemap_forget(r->tonemap);
    r->statistics.samples = 1;
    end_part(r, PART_WATER);
    begin_part(r, PART_MOTION);
    bolan_motion_draw_asked(r, &v, to, host);
    end_part(r, PART_MOTION);
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
    prepare(r, water, &lighting, world);
    draw_view(r, view);
    bolan_renderer_leave(r);
}

// ---- what stands at the pixels --------------------------------------------------------------------------------------

static const char *surfaces_problem(const bolan_renderer *r, const bolan_world *world, const bolan_view *view,
                                    const bolan_surfaces *out) {
    const bolan_water *water = bolan_world_water(world);
    if (r->width != view->width || r->height != view->height || !r->prepared) return "the last view was another";
    if (r->frame.water.sea != water->sea) return "the last view was of another world";
    if (view->eye.z < water->level) return "the eye is below the level of the water";
    if (out->motion != NULL && out->flow == NULL) return "motion needs a flow; expected bolan_surfaces.flow";
    return NULL;
}

static void draw_surfaces(bolan_renderer *r, render_view *v, const bolan_view *view) {
    bolan_view_cache *cache = view->cache != NULL ? view->cache : &r->own_cache;
    v->without_water = view->without_water;
    bolan_pass_water_place(&r->frame, v);
    prepare_view(r, v, cache);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_gl_target_bind(&r->surfaces.target);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_clear_depth(0.0f);
    bolan_pass_ground_draw_surfaces(cache->ground, v, &r->surfaces.land);
    bolan_pass_objects_draw_surfaces(r->models, v, &r->surfaces.object, BOLAN_LABEL_OBJECT);
}

static void read_surfaces(bolan_renderer *r, const bolan_view *view, const bolan_surfaces *out) {
    const size_t plane = (size_t)view->width * view->height * 4, bytes = 3 * plane * sizeof(float);
    render_view v = {.frame = NULL};
    float *memory = allocate_for("reading surfaces back", bytes);
    if (memory != NULL && bolan_surface_reader_fit(&r->surfaces, view->width, view->height) == BOLAN_OK &&
        bolan_gl_depth_read(&r->depth_reader, &r->targets.hdr_depth, memory) == BOLAN_OK && open_view(r, &v, view)) {
        draw_surfaces(r, &v, view);
        bolan_gl_target_read_float(&r->surfaces.target, 0, memory + plane);
        const surface_pixels pixels = {memory, memory + 2 * plane, memory + plane};
        if (bolan_gl_depth_read(&r->depth_reader, &r->surfaces.depth, memory + 2 * plane) == BOLAN_OK)
            bolan_surfaces_fill(&v, &pixels, out);
    }
    bolan_release(memory, bytes);
}

void bolan_renderer_read_surfaces(bolan_renderer *r, const bolan_world *world, const bolan_view *view,
                                  const bolan_surfaces *out) {
    const bool given = r != NULL && world != NULL && view != NULL && out != NULL;
    BOLAN_ASSERT(given);
    if (!given || !bolan_view_is_valid(r, view)) return;
    const char *problem = surfaces_problem(r, world, view, out);
    if (problem != NULL) {
        bolan_renderer_refuse(r, CALL_READ_SURFACES, BOLAN_LOG_BAD_ARGUMENT, "read_surfaces: %s", problem);
        return;
    }
    bolan_renderer_accept(r, CALL_READ_SURFACES);
    bolan_renderer_enter(r);
    read_surfaces(r, view, out);
    bolan_renderer_leave(r);
}

// ---- the sky alone --------------------------------------------------------------------------------------------------

// As bolan_renderer_read_sky(), in this context; @p rgba has room for the map.
static bolan_result read_sky(bolan_renderer *r, bolan_dvec3 eye, uint32_t width, uint32_t height, float *rgba,
                             bolan_sky_light *light) {
    bolan_view view = bolan_view_default();
    render_view v = {.frame = NULL};
    view.eye = eye;
    view.width = view.height = 64; // what the sky is made for does not depend on it
    if (!open_view(r, &v, &view)) return BOLAN_ERROR_GL;
    use_frame(r);
    bolan_view_use(&v);
    bolan_pass_sky_prepare(r->own_cache.sky, &v);
    bolan_view_use(&v);
    bolan_blocks_bind(&r->uniforms);
    *light = (bolan_sky_light){r->frame.sun_direction, v.light.sun, v.light.sky};
    light->sun_irradiance = bolan_v3_scale(light->sun_irradiance, 1.0f / r->radiance_unit);
    light->sky_irradiance = bolan_v3_scale(light->sky_irradiance, 1.0f / r->radiance_unit);
    return bolan_pass_sky_map(r->own_cache.sky, width, height, rgba);
}

bolan_result bolan_renderer_read_sky(bolan_renderer *r, bolan_dvec3 eye, uint32_t width, uint32_t height, float *rgb,
                                     bolan_sky_light *light) {
    const bool given = r != NULL && rgb != NULL && light != NULL && r->prepared && width > 0 && height > 0;
    BOLAN_ASSERT(given);
    if (!given) return BOLAN_ERROR_ARGUMENT;
    if (!bolan_gl_has_context()) return bolan_gl_check_context("read_sky");
    if (width > (uint32_t)r->caps.max_texture_size || height > (uint32_t)r->caps.max_texture_size) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "read_sky: a map of %ux%u; expected at most %d each way",
                  (unsigned)width, (unsigned)height, r->caps.max_texture_size);
        return BOLAN_ERROR_ARGUMENT;
    }
    const size_t pixels = (size_t)width * height, bytes = 4 * pixels * sizeof(float);
    float *rgba = allocate_for("a map of the sky", bytes);
    if (rgba == NULL) return BOLAN_ERROR_MEMORY;
    bolan_renderer_enter(r);
    const bolan_result result = read_sky(r, eye, width, height, rgba, light);
    bolan_renderer_leave(r);
    for (size_t i = 0; i < pixels && result == BOLAN_OK; ++i) {
        const size_t from = (height - 1 - i / width) * width + i % width; // the top row comes last
        for (int c = 0; c < 3; ++c) rgb[3 * i + (size_t)c] = rgba[4 * from + (size_t)c] / r->radiance_unit;
    }
    bolan_release(rgba, bytes);
    return result;
}
