// SPDX-License-Identifier: MIT
// Images of any size: what is larger than OpenGL draws at once is drawn in tiles, whose guard bands are cut off.
#ifndef BOLAN_CLI_TILES_H
#define BOLAN_CLI_TILES_H

#include "bolan/render.h"

typedef struct tiles {
    bolan_renderer *renderer; // borrowed
    bolan_target *target;
    uint32_t width, height;           // of the whole [px]
    uint32_t columns, rows;           // of a tile without its guard
    uint32_t guard;                   // 0: the whole is one tile
    uint32_t most_columns, most_rows; // of a tile with it
    uint8_t *rgb;                     // of one tile
    float *linear, *distance;         // of one tile; NULL where they are not asked for
    bolan_surfaces surfaces;          // of one tile; likewise
    size_t rgb_bytes, linear_bytes, distance_bytes, pixels;
} tiles;

// most: largest side that is drawn at once [px], 0: as the context has it. linear: tiles_draw() gives radiance and
// distance too. False: it cannot be had (logged).
bool tiles_open(tiles *t, bolan_renderer *renderer, uint32_t width, uint32_t height, uint32_t most, bool linear);
// Makes room for surfaces of one tile, of which tiles_draw() then gives those that are asked for here. False: no
// memory.
bool tiles_add_surfaces(tiles *t, const bolan_surfaces *wanted);
// Draws a view of the whole into buffers of width * height, top row first: 3 bytes a pixel, and where they are not NULL
// 3 floats of radiance and 1 of distance; surfaces where it is not NULL. @p whole has no tile and no framebuffer.
void tiles_draw(const tiles *t, const bolan_world *world, const bolan_view *whole, uint8_t *rgb, float *linear,
                float *distance, const bolan_surfaces *surfaces);
void tiles_close(tiles *t);

#endif
