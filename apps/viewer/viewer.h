// SPDX-License-Identifier: MIT
// The window of `bolan view`: shows a scene, lets a person fly through it and change the sea.
#ifndef VIEWER_H
#define VIEWER_H

#include "bolan/scene.h"

typedef struct viewer_options {
    uint32_t width, height;       // of the window [screen units]; default 1280 x 720
    bolan_quality quality;        // default medium
    bolan_backend backend;        // default auto
    bolan_pixels pixels;          // default auto
    const char *shader_directory; // NULL: the built-in shaders; else read from there, and again when a file changes
    const char *screenshot;       // NULL, or the PNG that receives the last frame
    uint32_t frames;              // quit after so many frames of 1/30 s; 0: when the user quits
    uint32_t samples;             // begin paused, and refine to so many a pixel; 0: run, and refine to 64 when paused
    double render_scale;          // internal resolution, 0.25..1 of the window's; 0: chosen to stay interactive
} viewer_options;

viewer_options viewer_options_default(void);

// Shows the scene until the user quits. Returns the exit status: 0, or 1 after one sentence on stderr.
int viewer_run(const bolan_scene *scene, const viewer_options *options);

#endif
