// SPDX-License-Identifier: MIT
// What an image is made of while nothing moves: first the full size of the window, then more and more samples.
#ifndef VIEWER_REFINE_H
#define VIEWER_REFINE_H

#include "bolan/render.h"
#include "bolan/scene.h"

#define REFINE_SAMPLES 64 // a pixel: more change no level of 255 that an eye could see

// What an image depends on. Compared byte by byte: a difference of padding alone costs a new beginning.
typedef struct refine_view {
    bolan_scene scene;
    double time, scale; // of the sea [s], of the size that the user has chosen, 0: automatic
    uint32_t width, height;
    bolan_quality quality;
} refine_view;

typedef enum refine_step {
    REFINE_MOVING, // small and at once
    REFINE_SIZE,   // the full size, one sample
    REFINE_ADD,    // one sample more
    REFINE_DONE,   // nothing is left to draw
} refine_step;

typedef struct refine {
    uint32_t most; // samples that it goes to, set by the caller
    refine_view seen;
    bool any;         // `seen` holds a view
    bool settled;     // the ground of the full size is there
    double still;     // time since the last change [s]
    refine_step step; // of the last frame
    uint32_t samples; // in the mean that is shown; 0: there is none
    uint32_t uploads; // of the renderer, after the last frame
} refine;

// Begins anew at the next frame, after a change that is no part of a refine_view.
void refine_restart(refine *r);
// The step of the next frame, @p seconds after the last.
refine_step refine_next(refine *r, const refine_view *view, double seconds);
// After the step was drawn.
void refine_drawn(refine *r, const bolan_frame_statistics *drawn);
// "refined: 16 samples", or an empty text.
void refine_say(const refine *r, char *text, size_t size);

#endif
