// SPDX-License-Identifier: MIT
// Who owns which texture of a picture's size: the renderer has one colour and depth that a view is drawn into, and one
// copy of them that the water looks through. The optics own what they keep of a shape.
#include "renderer.h"

static void free_set(frame_targets *t) {
    bolan_gl_target_free(&t->hdr);
    bolan_gl_target_free(&t->behind);
    bolan_gl_texture_free(&t->hdr_color);
    bolan_gl_texture_free(&t->hdr_depth);
    bolan_gl_texture_free(&t->behind_color);
    bolan_gl_texture_free(&t->behind_depth);
}

static bolan_result create_target(gl_texture *color, gl_texture *depth, gl_target *target, uint32_t width,
                                  uint32_t height, bool storage) {
    gl_texture_desc c = {.format = GL_FMT_RGBA16F,
                         .width = width,
                         .height = height,
                         .storage = storage,
                         .filter = GL_FILTER_LINEAR,
                         .wrap = GL_WRAP_CLAMP};
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

// storage: compute shaders write the color.
static bolan_result create_set(frame_targets *t, uint32_t width, uint32_t height, bool storage) {
    const bolan_result result = create_target(&t->hdr_color, &t->hdr_depth, &t->hdr, width, height, storage);
    if (result != BOLAN_OK) return result;
    return create_target(&t->behind_color, &t->behind_depth, &t->behind, width, height, false);
}

bolan_result bolan_renderer_resize(bolan_renderer *r, uint32_t width, uint32_t height) {
    if (r->width == width && r->height == height) return BOLAN_OK;
    bool fresh;
    const uint32_t slot = bolan_kept_sizes_use(&r->kept, width, height, &fresh);
    frame_targets *t = &r->sizes[slot];
    uint32_t over;
    if (fresh) free_set(t);
    while (bolan_kept_sizes_over(&r->kept, &over)) free_set(&r->sizes[over]);
    const bolan_result result = fresh ? create_set(t, width, height, r->desc.pixels == BOLAN_PIXELS_COMPUTE) : BOLAN_OK;
    r->width = r->height = 0;
    if (result != BOLAN_OK) {
        free_set(t);
        bolan_kept_sizes_forget(&r->kept, slot);
        return result;
    }
    if (fresh) t->serial = ++r->target_serial;
    r->targets = *t;
    r->width = width;
    r->height = height;
    return BOLAN_OK;
}

void bolan_renderer_free_targets(bolan_renderer *r) {
    for (int i = 0; i < KEPT_SIZES; ++i) free_set(&r->sizes[i]);
    r->width = r->height = 0;
}
