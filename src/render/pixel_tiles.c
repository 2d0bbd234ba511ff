// SPDX-License-Identifier: MIT
// See pixel_tiles.h.
#include "pixel_tiles.h"

// The buffer, twin of shaders/common/tiles.glsl, in whole numbers: groups x, y, z and tiles of each class; whether land
// is in sight; then the lists.
enum { RUN = 4, HEAD = RUN * TILE_CLASSES + 1, SLOT = 0 };

static uint32_t groups(uint32_t pixels) { return (pixels + PIXEL_GROUP - 1) / PIXEL_GROUP; }

bolan_result bolan_pixel_tiles_create(uint32_t width, uint32_t height, pixel_tiles *out) {
    const size_t tiles = (size_t)groups(width) * groups(height);
    return bolan_gl_buffer_create(GL_BUFFER_STORAGE, GL_USAGE_STATIC, (HEAD + TILE_CLASSES * tiles) * sizeof(uint32_t),
                                  NULL, &out->lists);
}

static void set_region(const gl_program *g, const gl_target *t, uint32_t from, uint32_t to) {
    bolan_gl_program_use(g);
    bolan_gl_program_vec4(g, "region", (bolan_vec4){0.0f, (float)from, (float)t->width, (float)to});
}

void bolan_pixel_tiles_sort(const pixel_tiles *t, const gl_program *begin, const gl_program *sort,
                            const gl_target *target, uint32_t from, uint32_t to) {
    bolan_gl_storage_bind(&t->lists, SLOT);
    bolan_gl_program_use(begin);
    bolan_gl_dispatch(1, 1, 1);
    bolan_gl_wait_for(GL_BARRIER_STORAGE);
    set_region(sort, target, from, to);
    bolan_gl_dispatch(groups(target->width), groups(to - from), 1);
    bolan_gl_wait_for(GL_BARRIER_ARGUMENTS);
}

void bolan_pixel_tiles_draw(const pixel_tiles *t, const gl_program *const programs[TILE_CLASSES],
                            const gl_target *target, uint32_t from, uint32_t to) {
    bolan_gl_arguments_bind(&t->lists);
    bolan_gl_image_bind(&target->color, 0, 0);
    for (int i = 0; i < TILE_CLASSES; ++i) {
        set_region(programs[i], target, from, to);
        bolan_gl_program_int(programs[i], "tile_class", i);
        bolan_gl_dispatch_indirect((size_t)(RUN * i) * sizeof(uint32_t));
    }
    bolan_gl_wait_for(GL_BARRIER_ALL);
}

void bolan_pixel_tiles_free(pixel_tiles *t) { bolan_gl_buffer_free(&t->lists); }
