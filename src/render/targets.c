// SPDX-License-Identifier: MIT
// Who owns which texture of a picture's size: the renderer has one colour and depth that a view is drawn into, and one
// copy of them that the water looks through. The optics own what they keep of a shape.
#include "renderer.h"

static void free_targets(bolan_renderer *r) {
    bolan_gl_target_free(&r->hdr);
    bolan_gl_target_free(&r->behind);
    bolan_gl_texture_free(&r->hdr_color);
    bolan_gl_texture_free(&r->hdr_depth);
    bolan_gl_texture_free(&r->behind_color);
    bolan_gl_texture_free(&r->behind_depth);
    r->width = r->height = 0;
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
    bolan_result result = bolan_gl_texture_create(&c, color);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&d, depth);
    const gl_texture *colors[] = {color};
    if (result == BOLAN_OK) result = bolan_gl_target_create(colors, 1, depth, -1, 0, target);
    return result;
}

bolan_result bolan_renderer_resize(bolan_renderer *r, uint32_t width, uint32_t height) {
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

void bolan_renderer_free_targets(bolan_renderer *r) { free_targets(r); }
