// SPDX-License-Identifier: MIT
// Life of the renderer, its targets, read-back, and the yardstick of the benchmarks.
#include "renderer.h"

#include <math.h>
#include <time.h>

enum { LEAST_VERTICES = 1024, MOST_VERTICES = 1000000 }; // of bolan_renderer_desc::max_vertices

bolan_renderer_desc bolan_renderer_desc_default(void) { return (bolan_renderer_desc){.quality = BOLAN_QUALITY_MEDIUM}; }

bolan_frame_desc bolan_frame_desc_default(void) {
    return (bolan_frame_desc){.width = 1280, .height = 720, .samples = 1};
}

static bolan_result create_passes(bolan_renderer *r) {
    bolan_result result = pass_sky_create(&r->caps, &r->sky);
    if (result == BOLAN_OK) result = pass_terrain_create(&r->caps, &r->terrain);
    if (result == BOLAN_OK) result = pass_models_create(&r->caps, &r->models);
    if (result == BOLAN_OK) result = pass_water_create(r->desc.quality, r->desc.max_vertices, &r->water);
    if (result == BOLAN_OK) result = pass_mirror_create(&r->mirror);
    if (result == BOLAN_OK) result = pass_tonemap_create(&r->caps, &r->tonemap);
    if (result == BOLAN_OK)
        result = gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof(frame_uniforms), NULL, &r->uniforms);
    return result;
}

bolan_result bolan_renderer_create(const bolan_renderer_desc *desc, bolan_renderer **out) {
    BOLAN_ASSERT(desc != NULL && out != NULL);
    if (bolan_gl_get_info().version[0] == '\0') {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_CONTEXT, "renderer: no OpenGL context is current on this thread");
        return BOLAN_ERROR_GL;
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
    bolan_renderer *r = bolan_allocate(sizeof *r);
    if (r == NULL) return BOLAN_ERROR_MEMORY;
    r->desc = *desc;
    r->caps = gl_get_caps();
    r->saved = bolan_allocate(gl_saved_size());
    bolan_result result = r->saved != NULL ? BOLAN_OK : BOLAN_ERROR_MEMORY;
    if (result == BOLAN_OK) {
        gl_save(r->saved);
        gl_debug_log(desc->debug);
        gl_program_set_directory(desc->shader_directory);
        result = create_passes(r);
        for (int i = 0; i < PART_COUNT; ++i) gl_timer_create(&r->timers[i]);
        gl_restore(r->saved);
    }
    if (result != BOLAN_OK) {
        bolan_renderer_destroy(&r);
        return result;
    }
    *out = r;
    return BOLAN_OK;
}

static void free_targets(bolan_renderer *r) {
    gl_target_free(&r->hdr);
    gl_target_free(&r->behind);
    gl_texture_free(&r->hdr_color);
    gl_texture_free(&r->hdr_depth);
    gl_texture_free(&r->behind_color);
    gl_texture_free(&r->behind_depth);
    r->width = r->height = 0;
}

void bolan_renderer_destroy(bolan_renderer **renderer) {
    if (renderer == NULL || *renderer == NULL) return;
    bolan_renderer *r = *renderer;
    pass_sky_destroy(&r->sky);
    pass_terrain_destroy(&r->terrain);
    pass_models_destroy(&r->models);
    pass_water_destroy(&r->water);
    pass_mirror_destroy(&r->mirror);
    pass_tonemap_destroy(&r->tonemap);
    gl_buffer_free(&r->uniforms);
    gl_program_free(&r->yardstick);
    for (int i = 0; i < PART_COUNT; ++i) gl_timer_free(&r->timers[i]);
    free_targets(r);
    bolan_release(r->saved, gl_saved_size());
    bolan_release(r, sizeof *r);
    *renderer = NULL;
}

bolan_result bolan_renderer_reload(bolan_renderer *r) {
    gl_program_set_directory(r->desc.shader_directory);
    bolan_result results[] = {pass_sky_reload(r->sky),       pass_terrain_reload(r->terrain),
                              pass_models_reload(r->models), pass_water_reload(r->water),
                              pass_mirror_reload(r->mirror), pass_tonemap_reload(r->tonemap)};
    for (size_t i = 0; i < sizeof results / sizeof results[0]; ++i)
        if (results[i] != BOLAN_OK) return results[i];
    return BOLAN_OK;
}

static bolan_result create_target(gl_texture *color, gl_texture *depth, gl_target *target, uint32_t width,
                                  uint32_t height) {
    gl_texture_desc c = {
        .format = GL_FMT_RGBA16F, .width = width, .height = height, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_CLAMP};
    gl_texture_desc d = {.format = GL_FMT_DEPTH32F,
                         .width = width,
                         .height = height,
                         .filter = GL_FILTER_NEAREST,
                         .wrap = GL_WRAP_CLAMP};
    bolan_result result = gl_texture_create(&c, color);
    if (result == BOLAN_OK) result = gl_texture_create(&d, depth);
    const gl_texture *colors[] = {color};
    if (result == BOLAN_OK) result = gl_target_create(colors, 1, depth, -1, 0, target);
    return result;
}

bolan_result renderer_resize(bolan_renderer *r, uint32_t width, uint32_t height) {
    if (r->width == width && r->height == height) return BOLAN_OK;
    free_targets(r);
    bolan_result result = create_target(&r->hdr_color, &r->hdr_depth, &r->hdr, width, height);
    if (result == BOLAN_OK) result = create_target(&r->behind_color, &r->behind_depth, &r->behind, width, height);
    if (result != BOLAN_OK) {
        free_targets(r);
        return result;
    }
    r->width = width;
    r->height = height;
    return BOLAN_OK;
}

void bolan_renderer_read_linear(bolan_renderer *r, float *rgb, float *distance) {
    BOLAN_ASSERT(r != NULL && r->width > 0);
    size_t width = r->width, height = r->height, bytes = width * height * 4 * sizeof(float);
    float *scratch = bolan_allocate(bytes);
    if (scratch == NULL) return;
    gl_save(r->saved);
    if (rgb != NULL) {
        const uint32_t samples = pass_tonemap_read_sum(r->tonemap, scratch);
        if (samples == 0) gl_target_read_float(&r->hdr, 0, scratch);
        const float unit = r->radiance_unit * (float)(samples > 0 ? samples : 1);
        for (size_t j = 0; j < height; ++j)
            for (size_t i = 0; i < width; ++i)
                for (size_t c = 0; c < 3; ++c)
                    rgb[3 * ((height - 1 - j) * width + i) + c] = scratch[4 * (j * width + i) + c] / unit;
    }
    if (distance != NULL) {
        gl_target_read_depth(&r->hdr, &r->hdr_depth, scratch);
        for (size_t j = 0; j < height; ++j)
            for (size_t i = 0; i < width; ++i) {
                float depth = scratch[j * width + i];
                distance[(height - 1 - j) * width + i] = depth > 0.0f ? (float)(r->near_plane / depth) : INFINITY;
            }
    }
    gl_restore(r->saved);
    bolan_release(scratch, bytes);
}

void bolan_renderer_read_rgb8(bolan_renderer *r, uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgb) {
    gl_save(r->saved);
    gl_read_rgb8(framebuffer, width, height, rgb);
    gl_restore(r->saved);
}

void bolan_renderer_measure_passes(bolan_renderer *r, bool on) { r->measure = on; }

bolan_frame_statistics bolan_renderer_statistics(const bolan_renderer *r) { return r->statistics; }

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

double bolan_renderer_yardstick(bolan_renderer *r, uint32_t width, uint32_t height, uint32_t repeats) {
    if (r->yardstick.id == 0 && gl_program_create("yardstick", NULL, &r->yardstick) != BOLAN_OK) return 0.0;
    gl_save(r->saved);
    double elapsed = 0.0;
    gl_texture image = {0};
    gl_texture_desc desc = {
        .format = GL_FMT_RGBA16F, .width = 256, .height = 256, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_REPEAT};
    if (renderer_resize(r, width, height) == BOLAN_OK && gl_texture_create(&desc, &image) == BOLAN_OK) {
        gl_target_bind(&r->hdr);
        gl_set_state(&(gl_state){.color_write = true});
        gl_texture_bind(&image, UNIT_PASS);
        gl_program_use(&r->yardstick);
        gl_program_int(&r->yardstick, "image", UNIT_PASS);
        gl_draw_fullscreen(); // the first pays for compilation
        gl_finish();
        double start = now_ms();
        for (uint32_t i = 0; i < repeats; ++i) {
            gl_draw_fullscreen();
            gl_finish();
        }
        elapsed = (now_ms() - start) / (repeats > 0 ? repeats : 1);
    }
    gl_texture_free(&image);
    gl_restore(r->saved);
    return elapsed;
}

// ---- a target for callers without one ----

struct bolan_target {
    gl_texture color;
    gl_target target;
};

bolan_result bolan_target_create(uint32_t width, uint32_t height, bolan_target **out) {
    bolan_target *t = bolan_allocate(sizeof *t);
    if (t == NULL) return BOLAN_ERROR_MEMORY;
    gl_texture_desc desc = {
        .format = GL_FMT_RGBA8, .width = width, .height = height, .filter = GL_FILTER_NEAREST, .wrap = GL_WRAP_CLAMP};
    bolan_result result = gl_texture_create(&desc, &t->color);
    const gl_texture *colors[] = {&t->color};
    if (result == BOLAN_OK) result = gl_target_create(colors, 1, NULL, -1, 0, &t->target);
    if (result != BOLAN_OK) {
        bolan_target_destroy(&t);
        return result;
    }
    *out = t;
    return BOLAN_OK;
}

uint32_t bolan_target_framebuffer(const bolan_target *target) { return target->target.id; }

void bolan_target_show(const bolan_target *target, uint32_t framebuffer, uint32_t width, uint32_t height) {
    BOLAN_ASSERT(target != NULL && width > 0 && height > 0);
    gl_target_show(&target->target, framebuffer, width, height);
}

void bolan_target_destroy(bolan_target **target) {
    if (target == NULL || *target == NULL) return;
    gl_target_free(&(*target)->target);
    gl_texture_free(&(*target)->color);
    bolan_release(*target, sizeof **target);
    *target = NULL;
}
