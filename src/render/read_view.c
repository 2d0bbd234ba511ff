// SPDX-License-Identifier: MIT
// What is read back of a view but its picture: the surfaces at its pixels, and the sky round an eye.
#include "renderer.h"

#include "memory.h"

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
    bolan_frame_prepare_view(r, v, cache);
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
        bolan_gl_depth_read(&r->depth_reader, &r->targets.hdr_depth, memory) == BOLAN_OK &&
        bolan_frame_open_view(r, &v, view)) {
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
    if (!bolan_frame_open_view(r, &v, &view)) return BOLAN_ERROR_GL;
    bolan_frame_use(r);
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
