// SPDX-License-Identifier: MIT
// Life of the renderer, and reading its pictures back.
#include "renderer.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "memory.h"

enum { LEAST_VERTICES = 1024, MOST_VERTICES = 1000000 }; // of bolan_renderer_desc::max_vertices

bolan_renderer_desc bolan_renderer_desc_default(void) { return (bolan_renderer_desc){.quality = BOLAN_QUALITY_MEDIUM}; }

static bolan_result create_passes(bolan_renderer *r) {
    const bool compute = r->desc.pixels == BOLAN_PIXELS_COMPUTE;
    bolan_result result = bolan_view_cache_open(&r->caps, compute, NULL, &r->own_cache);
    if (result == BOLAN_OK) result = bolan_pass_objects_create(&r->caps, &r->models);
    if (result == BOLAN_OK) result = bolan_pass_water_create(r->desc.quality, r->desc.max_vertices, &r->water);
    if (result == BOLAN_OK) result = bolan_pass_tonemap_create(compute, &r->tonemap);
    if (result == BOLAN_OK) result = bolan_host_create(&r->caps, &r->host);
    if (result == BOLAN_OK) result = bolan_blocks_create(&r->uniforms);
    return result;
}

// ---- entering and leaving -----------------------------------------------------------------------------------------

void bolan_renderer_enter(bolan_renderer *r) {
    r->calls_before = bolan_gl_calls();
    r->programs_before = bolan_gl_programs_compiled();
    bolan_gl_program_set_directory(r->shader_directory[0] ? r->shader_directory : NULL);
    bolan_gl_enter(&r->saved, &r->caps, r->desc.restore, &r->declared, r->desc.debug, &r->empty);
    r->uploads_before = bolan_gl_uploads();
}

void bolan_renderer_leave(bolan_renderer *r) {
    const gl_uploads uploads = bolan_gl_uploads();
    r->statistics.programs += bolan_gl_programs_compiled() - r->programs_before;
    r->statistics.uploads += uploads.count - r->uploads_before.count;
    r->statistics.upload_bytes += uploads.bytes - r->uploads_before.bytes;
    bolan_gl_leave(&r->saved);
    r->statistics.gl_calls += bolan_gl_calls().count - r->calls_before.count;
    r->statistics.gl_questions += bolan_gl_calls().questions - r->calls_before.questions;
}

bool bolan_renderer_refuse(bolan_renderer *r, renderer_call call, bolan_log_id id, const char *format, ...) {
    char sentence[REFUSAL_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    if (strcmp(sentence, r->refusal[call]) != 0) bolan_log(BOLAN_LOG_ERROR, id, "%s", sentence);
    memcpy(r->refusal[call], sentence, sizeof sentence);
    return false;
}

void bolan_renderer_accept(bolan_renderer *r, renderer_call call) { r->refusal[call][0] = '\0'; }

bool bolan_renderer_has_context(bolan_renderer *r, renderer_call call, const char *name) {
    return bolan_gl_has_context() || bolan_renderer_refuse(r, call, BOLAN_LOG_GL_CONTEXT,
                                                           "%s: no OpenGL context is current on this thread", name);
}

// ---- life -----------------------------------------------------------------------------------------------------------

static bolan_result check_backend(bolan_backend backend) {
    if ((int)backend < BOLAN_BACKEND_AUTO || backend > BOLAN_BACKEND_COMPUTE) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "renderer: backend %d is not one of auto, cpu, compute",
                  (int)backend);
        return BOLAN_ERROR_ARGUMENT;
    }
    const bolan_gl_info info = bolan_gl_get_info();
    if (backend != BOLAN_BACKEND_COMPUTE || info.compute) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "renderer: backend is compute, and this context (OpenGL %s) has no compute shaders; expected OpenGL 4.3, "
              "OpenGL ES 3.1 with texture views, or another backend",
              info.version);
    return BOLAN_ERROR_UNSUPPORTED;
}

static bolan_result check_pixels(bolan_pixels pixels) {
    if ((int)pixels < BOLAN_PIXELS_AUTO || pixels > BOLAN_PIXELS_COMPUTE) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "renderer: pixels %d is not one of auto, fragment, compute",
                  (int)pixels);
        return BOLAN_ERROR_ARGUMENT;
    }
    const bolan_gl_info info = bolan_gl_get_info();
    if (pixels != BOLAN_PIXELS_COMPUTE || info.compute) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
              "renderer: pixels is compute, and this context (OpenGL %s) has no compute shaders; expected OpenGL 4.3, "
              "OpenGL ES 3.1 with texture views, or fragment",
              info.version);
    return BOLAN_ERROR_UNSUPPORTED;
}

static bolan_result check_desc(const bolan_renderer_desc *desc) {
    if ((int)desc->restore < BOLAN_RESTORE_FULL || desc->restore > BOLAN_RESTORE_NONE) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "renderer: restore %d is not one of full, declared, none",
                  (int)desc->restore);
        return BOLAN_ERROR_ARGUMENT;
    }
    if ((int)desc->quality < BOLAN_QUALITY_LOW || desc->quality > BOLAN_QUALITY_ULTRA) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
                  "renderer: quality %d is not one of low, medium, high, ultra", (int)desc->quality);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (desc->max_vertices != 0 && (desc->max_vertices < LEAST_VERTICES || desc->max_vertices > MOST_VERTICES)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
                  "renderer: max_vertices is %u; expected 0 (by quality) or %d to %d", desc->max_vertices,
                  LEAST_VERTICES, MOST_VERTICES);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (desc->shader_directory != NULL && strlen(desc->shader_directory) >= DIRECTORY_BYTES) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
                  "renderer: shader_directory has %zu characters; expected at most %d", strlen(desc->shader_directory),
                  DIRECTORY_BYTES - 1);
        return BOLAN_ERROR_ARGUMENT;
    }
    const bolan_result result = check_backend(desc->backend);
    return result == BOLAN_OK ? check_pixels(desc->pixels) : result;
}

// On software OpenGL the CPU is several times as fast at this as its compute shaders.
static bolan_backend backend_of(const bolan_renderer_desc *desc, const gl_caps *caps) {
    if (desc->backend != BOLAN_BACKEND_AUTO) return desc->backend;
    return caps->compute && !caps->software ? BOLAN_BACKEND_COMPUTE : BOLAN_BACKEND_CPU;
}

// Software OpenGL runs fragments and invocations at one speed, and a rasterizer wastes no group at an edge.
static bolan_pixels pixels_of(const bolan_renderer_desc *desc, const gl_caps *caps) {
    if (desc->pixels != BOLAN_PIXELS_AUTO) return desc->pixels;
    return caps->compute && !caps->software ? BOLAN_PIXELS_COMPUTE : BOLAN_PIXELS_FRAGMENT;
}

static bolan_renderer *allocate(const bolan_renderer_desc *desc) {
    bolan_renderer *r = allocate_for("a renderer", sizeof *r);
    if (r == NULL) return NULL;
    r->desc = *desc;
    r->declared = bolan_gl_state_default();
    r->desc.shader_directory = NULL; // the caller's memory; copied
    if (desc->shader_directory != NULL)
        snprintf(r->shader_directory, sizeof r->shader_directory, "%s", desc->shader_directory);
    r->caps = bolan_gl_get_caps();
    r->desc.backend = backend_of(desc, &r->caps);
    r->desc.pixels = pixels_of(desc, &r->caps);
    if (desc->force_timers) r->caps.timers = r->caps.timestamps;
    return r;
}

bolan_result bolan_renderer_create(const bolan_renderer_desc *desc, bolan_renderer **out) {
    BOLAN_ASSERT(desc != NULL && out != NULL);
    if (desc == NULL || out == NULL) return BOLAN_ERROR_ARGUMENT;
    *out = NULL;
    bolan_result result = bolan_gl_check_context("renderer");
    if (result == BOLAN_OK) result = check_desc(desc);
    if (result != BOLAN_OK) return result;
    bolan_renderer *r = allocate(desc);
    if (r == NULL) return BOLAN_ERROR_MEMORY;
    bolan_renderer_enter(r);
    result = create_passes(r);
    bolan_renderer_leave(r);
    if (result != BOLAN_OK) {
        bolan_renderer_destroy(&r);
        return result;
    }
    *out = r;
    return BOLAN_OK;
}

// Nothing is bound here, so nothing of the caller's is to be saved.
void bolan_renderer_destroy(bolan_renderer **renderer) {
    if (renderer == NULL || *renderer == NULL) return;
    bolan_renderer *r = *renderer;
    if (!bolan_gl_has_context())
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT,
                  "renderer: destroyed while no OpenGL context is current; what it has on the GPU stays until its "
                  "context is gone");
    bolan_view_cache_close(&r->own_cache);
    bolan_pass_objects_destroy(&r->models);
    bolan_pass_water_destroy(&r->water);
    bolan_pass_tonemap_destroy(&r->tonemap);
    bolan_host_free(&r->host);
    bolan_gl_ring_free(&r->bounds);
    bolan_host_fields_free(&r->fields);
    bolan_sea_compute_free(&r->compute);
    bolan_blocks_free(&r->uniforms);
    bolan_gl_program_free(&r->yardstick);
    bolan_gl_mesh_free(&r->empty);
    bolan_gl_depth_reader_free(&r->depth_reader);
    bolan_surface_reader_free(&r->surfaces);
    bolan_motion_free(&r->motion_pass);
    for (int i = 0; i < PART_COUNT; ++i) bolan_gl_timer_free(&r->timers[i]);
    bolan_renderer_free_targets(r);
    bolan_release(r->scratch, r->scratch_bytes);
    bolan_release(r, sizeof *r);
    *renderer = NULL;
}

static bolan_result reload_passes(bolan_renderer *r) {
    const bolan_result results[] = {bolan_pass_sky_reload(r->own_cache.sky),
                                    bolan_pass_ground_reload(r->own_cache.ground),
                                    bolan_pass_objects_reload(r->models),
                                    bolan_pass_water_reload(r->water),
                                    bolan_sea_compute_reload(&r->compute),
                                    bolan_pass_tonemap_reload(r->tonemap),
                                    bolan_host_reload(&r->host),
                                    bolan_motion_reload(&r->motion_pass),
                                    bolan_temporal_reload(&r->own_cache.temporal)};
    for (size_t i = 0; i < sizeof results / sizeof results[0]; ++i)
        if (results[i] != BOLAN_OK) return results[i];
    return BOLAN_OK;
}

bolan_result bolan_renderer_reload(bolan_renderer *r) {
    BOLAN_ASSERT(r != NULL);
    bolan_result result = bolan_gl_check_context("renderer");
    if (result != BOLAN_OK) return result;
    bolan_renderer_enter(r);
    result = reload_passes(r);
    for (bolan_view_cache *c = r->caches; c != NULL; c = c->next) bolan_view_cache_share(c, &r->own_cache);
    bolan_renderer_leave(r);
    return result;
}

bolan_backend bolan_renderer_backend(const bolan_renderer *r) {
    BOLAN_ASSERT(r != NULL);
    return r != NULL ? r->desc.backend : BOLAN_BACKEND_CPU;
}

bolan_pixels bolan_renderer_pixels(const bolan_renderer *r) {
    BOLAN_ASSERT(r != NULL);
    return r != NULL ? r->desc.pixels : BOLAN_PIXELS_FRAGMENT;
}

bool bolan_renderer_needs_baking(const bolan_renderer *r) {
    BOLAN_ASSERT(r != NULL);
    return r != NULL && r->stale;
}

void bolan_renderer_bake(bolan_renderer *r) {
    BOLAN_ASSERT(r != NULL);
    if (r != NULL) r->bake = true;
}

// ---- reading back ---------------------------------------------------------------------------------------------------

// Memory that is kept for the next reading; NULL: there is none (logged).
static void *scratch_of(bolan_renderer *r, size_t bytes) {
    if (r->scratch_bytes >= bytes) return r->scratch;
    bolan_release(r->scratch, r->scratch_bytes);
    r->scratch = allocate_for("reading a picture back", bytes);
    r->scratch_bytes = r->scratch != NULL ? bytes : 0;
    return r->scratch;
}

static void read_radiance(bolan_renderer *r, float *scratch, float *rgb) {
    const size_t width = r->width, height = r->height;
    const uint32_t samples = bolan_pass_tonemap_read_sum(r->tonemap, scratch);
    if (samples == 0) bolan_gl_target_read_float(&r->targets.hdr, 0, scratch);
    const float unit = r->radiance_unit * (float)(samples > 0 ? samples : 1);
    for (size_t j = 0; j < height; ++j)
        for (size_t i = 0; i < width; ++i)
            for (size_t c = 0; c < 3; ++c)
                rgb[3 * ((height - 1 - j) * width + i) + c] = scratch[4 * (j * width + i) + c] / unit;
}

static void read_distance(bolan_renderer *r, float *scratch, float *distance) {
    const size_t width = r->width, height = r->height;
    if (bolan_gl_depth_read(&r->depth_reader, &r->targets.hdr_depth, scratch) != BOLAN_OK) return;
    for (size_t j = 0; j < height; ++j)
        for (size_t i = 0; i < width; ++i) {
            const float depth = scratch[4 * (j * width + i)];
            distance[(height - 1 - j) * width + i] = depth > 0.0f ? (float)(r->near_plane / depth) : INFINITY;
        }
}

void bolan_renderer_read_linear(bolan_renderer *r, float *rgb, float *distance) {
    BOLAN_ASSERT(r != NULL);
    if (r == NULL || !bolan_renderer_has_context(r, CALL_READ_LINEAR, "read_linear")) return;
    if (r->width == 0) {
        bolan_renderer_refuse(r, CALL_READ_LINEAR, BOLAN_LOG_BAD_ARGUMENT,
                              "read_linear: this renderer has drawn no picture yet");
        return;
    }
    float *scratch = scratch_of(r, (size_t)r->width * r->height * 4 * sizeof(float));
    if (scratch == NULL) return;
    bolan_renderer_accept(r, CALL_READ_LINEAR);
    bolan_renderer_enter(r);
    if (rgb != NULL) read_radiance(r, scratch, rgb);
    if (distance != NULL) read_distance(r, scratch, distance);
    bolan_renderer_leave(r);
}

void bolan_renderer_read_rgb8(bolan_renderer *r, uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgb) {
    BOLAN_ASSERT(r != NULL && rgb != NULL);
    if (r == NULL || rgb == NULL || !bolan_renderer_has_context(r, CALL_READ_RGB8, "read_rgb8")) return;
    if (!bolan_is_picture_size(width) || !bolan_is_picture_size(height)) {
        bolan_renderer_refuse(r, CALL_READ_RGB8, BOLAN_LOG_OUT_OF_RANGE,
                              "read_rgb8: %u x %u pixels; expected 1 to %d each way", width, height, MOST_PIXELS);
        return;
    }
    uint8_t *scratch = scratch_of(r, (size_t)width * height * 4);
    if (scratch == NULL) return;
    bolan_renderer_enter(r);
    const char *problem = bolan_gl_framebuffer_problem(framebuffer, GL_TO_READ);
    if (problem == NULL) {
        bolan_renderer_accept(r, CALL_READ_RGB8);
        bolan_gl_read_rgb8(framebuffer, width, height, scratch, rgb);
    } else {
        bolan_renderer_refuse(r, CALL_READ_RGB8, BOLAN_LOG_GL_TARGET, "read_rgb8: framebuffer %u %s", framebuffer,
                              problem);
    }
    bolan_renderer_leave(r);
}
