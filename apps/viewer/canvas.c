// SPDX-License-Identifier: MIT
// The renderer and its pictures.
#include "canvas.h"

#include "bolan/io.h"
#include "bolan/render.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#define PICTURE_SAMPLES 4 // a saved image may take longer than a frame

bolan_result canvas_open(canvas *c, bolan_quality quality, bolan_backend backend, bolan_pixels pixels,
                         const char *shader_directory) {
    *c = (canvas){.desc = bolan_renderer_desc_default()};
    c->desc.quality = quality;
    c->desc.backend = backend;
    c->desc.pixels = pixels;
    c->desc.restore = BOLAN_RESTORE_DECLARED; // outside of its calls this program keeps OpenGL's initial state
    c->desc.shader_directory = shader_directory;
    return bolan_renderer_create(&c->desc, &c->renderer);
}

void canvas_close(canvas *c) {
    bolan_target_destroy(&c->target);
    bolan_renderer_destroy(&c->renderer);
}

bolan_result canvas_set_quality(canvas *c, bolan_quality quality) {
    bolan_renderer_desc desc = c->desc;
    desc.quality = quality;
    bolan_renderer *fresh = NULL;
    bolan_result result = bolan_renderer_create(&desc, &fresh);
    if (result != BOLAN_OK) return result;
    bolan_renderer_destroy(&c->renderer);
    c->renderer = fresh;
    c->desc = desc;
    return BOLAN_OK;
}

static bool need_target(canvas *c, uint32_t width, uint32_t height) {
    if (c->target != NULL && c->target_width == width && c->target_height == height) return true;
    bolan_target_destroy(&c->target);
    c->target_width = width;
    c->target_height = height;
    return bolan_target_create(width, height, &c->target) == BOLAN_OK;
}

static bolan_view view_of(const bolan_world *w, uint32_t framebuffer, uint32_t width, uint32_t height) {
    bolan_view view = bolan_view_from_camera(&bolan_world_scene(w)->camera, width, height);
    view.eye = bolan_world_clear_eye(w, view.eye);
    view.framebuffer = framebuffer;
    return view;
}

static void draw(canvas *c, const bolan_world *w, const bolan_view *view) {
    if (bolan_renderer_needs_baking(c->renderer))
        bolan_renderer_bake(c->renderer); // after a change of the sun in the panel
    bolan_renderer_draw_world(c->renderer, w, view);
}

static uint32_t scaled(uint32_t pixels, double scale) { return (uint32_t)fmax(round(pixels * scale), 1.0); }

static void draw_frame(canvas *c, const bolan_world *w, uint32_t framebuffer, refine_step step) {
    bolan_view view = view_of(w, framebuffer, c->width, c->height);
    view.progressive = true;
    view.accumulate = step == REFINE_ADD;
    view.temporal = c->temporal && step != REFINE_ADD;
    draw(c, w, &view);
}

void canvas_draw(canvas *c, const bolan_world *w, uint32_t width, uint32_t height, double scale, refine_step step) {
    c->width = scaled(width, scale);
    c->height = scaled(height, scale);
    const bool whole = c->width == width && c->height == height;
    // A mean stays in the target, from which a frame without a change is shown.
    if ((whole && step < REFINE_ADD) || !need_target(c, c->width, c->height)) {
        c->width = width;
        c->height = height;
        draw_frame(c, w, 0, step);
        return;
    }
    if (step != REFINE_DONE) draw_frame(c, w, bolan_target_framebuffer(c->target), step);
    bolan_target_show(c->target, 0, width, height);
}

static bolan_result save(canvas *c, uint32_t framebuffer, uint32_t width, uint32_t height, const char *path) {
    size_t size = (size_t)width * height * 3;
    uint8_t *rgb = bolan_allocate(size);
    if (rgb == NULL) return BOLAN_ERROR_MEMORY;
    bolan_renderer_read_rgb8(c->renderer, framebuffer, width, height, rgb);
    bolan_result result = bolan_png_write(path, width, height, rgb);
    bolan_release(rgb, size);
    return result;
}

bolan_result canvas_save_window(canvas *c, uint32_t width, uint32_t height, const char *path) {
    return save(c, 0, width, height, path);
}

bolan_result canvas_save_picture(canvas *c, const bolan_world *w, uint32_t width, uint32_t height, const char *path) {
    bolan_target *target = NULL;
    bolan_result result = bolan_target_create(width, height, &target);
    if (result != BOLAN_OK) return result;
    bolan_view view = view_of(w, bolan_target_framebuffer(target), width, height);
    view.samples = PICTURE_SAMPLES;
    draw(c, w, &view);
    result = save(c, bolan_target_framebuffer(target), width, height, path);
    bolan_target_destroy(&target);
    return result;
}

void canvas_free_name(char *name, size_t size) {
    for (unsigned i = 1; i <= 9999; ++i) {
        snprintf(name, size, "bolan-%04u.png", i);
        if (access(name, F_OK) != 0) return;
    }
}
