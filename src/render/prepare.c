// SPDX-License-Identifier: MIT
// A step as the renderer takes it: what is drawn, its programs, and its waves on the GPU.
#include "renderer.h"

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

// As bolan_frame_prepare() has it.
static frame step_of(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                     const bolan_world *world) {
    const bolan_scene *scene = world != NULL ? bolan_world_scene(world) : NULL;
    frame f = {.caps = &r->caps,
               .compute = r->desc.backend == BOLAN_BACKEND_COMPUTE ? &r->compute : NULL,
               .compute_pixels = r->desc.pixels == BOLAN_PIXELS_COMPUTE,
               .timing = bolan_frame_timing(r),
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

void bolan_frame_prepare(bolan_renderer *r, const bolan_water *water, const bolan_lighting *lighting,
                         const bolan_world *world) {
    r->statistics.gl_calls = r->statistics.gl_questions = 0;
    r->frame = step_of(r, water, lighting, world);
    bolan_frame_begin_part(r, PART_SEA);
    bolan_pass_water_prepare(r->water, &r->frame);
    bolan_frame_end_part(r, PART_SEA);
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
    bolan_frame_prepare(r, water, lighting, NULL);
    bolan_renderer_leave(r);
}
