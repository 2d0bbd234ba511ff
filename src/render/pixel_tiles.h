// SPDX-License-Identifier: MIT
// Tiles of pixels in lists, by what their pixels need, and a compute shader for each list. The GPU fills the lists and
// the numbers of groups, so that the CPU neither knows nor waits. Shaders: shaders/common/tiles.glsl.
#ifndef BOLAN_RENDER_PIXEL_TILES_H
#define BOLAN_RENDER_PIXEL_TILES_H

#include "gl/gl.h"
#include "pixels.h"

typedef enum pixel_tile_class { TILES_OPEN, TILES_DEEP, TILES_NEAR, TILE_CLASSES } pixel_tile_class;

typedef struct pixel_tiles {
    gl_buffer lists;
} pixel_tiles;

// For targets of at most that size. Where caps.compute.
bolan_result bolan_pixel_tiles_create(uint32_t width, uint32_t height, pixel_tiles *out);
// Fills the lists for rows from..to - 1 of the target: by one group of the program `begin`, then by `sort`.
void bolan_pixel_tiles_sort(const pixel_tiles *t, const gl_program *begin, const gl_program *sort,
                            const gl_target *target, uint32_t from, uint32_t to);
// Shades each list by its program, after bolan_pixel_tiles_sort(). Both are called between bolan_gl_compute_begin() and
// bolan_gl_compute_end().
void bolan_pixel_tiles_draw(const pixel_tiles *t, const gl_program *const programs[TILE_CLASSES],
                            const gl_target *target, uint32_t from, uint32_t to);
void bolan_pixel_tiles_free(pixel_tiles *t);

#endif
