// SPDX-License-Identifier: MIT
// The renderer and the picture it draws into the window, at the window's resolution or below it.
#ifndef VIEWER_CANVAS_H
#define VIEWER_CANVAS_H

#include "bolan/render.h"
#include "bolan/world.h"
#include "refine.h"

typedef struct canvas {
    bolan_renderer *renderer;
    bolan_renderer_desc desc;
    bolan_target *target; // of a picture below the window's resolution
    uint32_t target_width, target_height;
    uint32_t width, height; // of the last picture
    bool temporal;          // antialiasing over frames
} canvas;

// Needs the window's context.
bolan_result canvas_open(canvas *c, bolan_quality quality, bolan_backend backend, bolan_pixels pixels,
                         const char *shader_directory);
void canvas_close(canvas *c);
// Makes the renderer again; the old one stays on failure.
bolan_result canvas_set_quality(canvas *c, bolan_quality quality);
// Draws the world into the window of width x height pixels, at @p scale (0.25..1) of its resolution: enlarged linearly.
void canvas_draw(canvas *c, const bolan_world *w, uint32_t width, uint32_t height, double scale, refine_step step);
// Writes what the window shows now, before it is presented, as PNG.
bolan_result canvas_save_window(canvas *c, uint32_t width, uint32_t height, const char *path);
// Draws the world once more, fine and without panel, as PNG.
bolan_result canvas_save_picture(canvas *c, const bolan_world *w, uint32_t width, uint32_t height, const char *path);
// The first name bolan-0001.png, bolan-0002.png .. that is free in the current folder.
void canvas_free_name(char *name, size_t size);

#endif
