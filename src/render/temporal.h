// SPDX-License-Identifier: MIT
// Temporal antialiasing of one view: each image has a jitter of its own, and its display values are blended with those
// of the images before it, which motion vectors bring to their places. Shader: temporal.glsl. A view cache owns one.
//
// While nothing changes the history is the mean of up to STILL_IMAGES images, the one that bolan_view.samples has.
// When something moves, the history is clipped to what the neighbours of a pixel show now (variance clipping: Salvi
// 2016, "An Excursion in Temporal Supersampling"; here less what a plane through them explains), and it counts as
// MOVING_IMAGES images at most.
#ifndef BOLAN_RENDER_TEMPORAL_H
#define BOLAN_RENDER_TEMPORAL_H

#include "frame.h"

// What the image before was drawn of.
typedef struct temporal_state {
    bolan_view view;
    bolan_lighting lighting;
    frame_block block;
    bolan_vec3 exposure;
    uint64_t sea, serial, places;
    double time;
} temporal_state;

typedef struct temporal {
    gl_program resolve;
    gl_texture history[2], motion; // display values, and of how many images they are the mean
    gl_target target[2], motion_target;
    uint32_t images;  // since the beginning; 0: none
    uint32_t latest;  // the history that is valid
    bolan_vec2 shift; // of the present image [px]
    float reach;      // of the jitter: its share of a pixel
    bool drawing;     // this view is temporal
    bool still;       // it shows what the one before did
    temporal_state before, now;
} temporal;

// Begins a view that may be temporal: compares it with the one before. Returns the index of its first jitter.
uint32_t bolan_temporal_begin(temporal *t, const render_view *v, const bolan_view *to, uint64_t places);
// After the frame: draws its motion, where something moved. `motion_wanted` of the frame must be set before the step.
struct bolan_renderer;
void bolan_temporal_draw_motion(temporal *t, struct bolan_renderer *r, render_view *v, const bolan_view *to);
// Blends the sum of the display values of this frame's `samples`. Returns the mean.
const gl_texture *bolan_temporal_blend(temporal *t, const render_view *v, const gl_texture *sum, uint32_t samples);
bolan_result bolan_temporal_reload(temporal *t);
void bolan_temporal_free(temporal *t);

#endif
