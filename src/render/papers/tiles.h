// SPDX-License-Identifier: MIT
// Baked tiles on the GPU: the textures of the present moment, blended of two frames where the loop is to run smoothly.
#ifndef BOLAN_RENDER_WATER_TILES_H
#define BOLAN_RENDER_WATER_TILES_H

#include "render/frame.h"

#include "bolan/tiles.h"

typedef struct paper_tiles {
    // RGBA16F: slopes along the world's axes, the sum of their squares, brightness; in paper mode unit normals.
    gl_texture slopes, ripples;
    gl_texture own; // RGBA8: the water's own texture; a: light on the bottom
    gl_texture glint;
    bolan_tiles *base, *fine; // baked here; base NULL: the sea has other waves than textures
    uint64_t sea;             // id of the sea that they were baked for; 0: none yet
    const bolan_tiles *given; // the caller's, where they are of use here
    const bolan_tiles *asked; // the caller's that these were baked for
    bolan_vec3 sun;           // that the light on the bottom is made for
    bolan_vec3 color;
    bool ready, failed, paper, whole; // whole: the sea's waves are in the tiles
    bool stale;                       // the light on the bottom is of another sun, until baking is asked for
    int brightest;                    // channel of the water's own texture
    double shown;                     // time that the textures show
    float *staging;
    size_t staging_bytes;
    double base_variance, fine_variance; // of their slopes
} paper_tiles;

bolan_result bolan_paper_tiles_create(paper_tiles *t);
// Fills the textures of the frame's time. Bakes for a sea, water or mode that is new; where the sun alone has turned,
// only if render_view::bake asks for it, and sets `stale` otherwise.
void bolan_paper_tiles_prepare(paper_tiles *t, const render_view *v);
// The tiles of the sea's own waves; NULL: it has none.
const bolan_tiles *bolan_paper_tiles_base(const paper_tiles *t);
// Those of shorter waves, and of the light on the bottom: the same, where the sea's are short enough. NULL: there are
// none.
const bolan_tiles *bolan_paper_tiles_fine(const paper_tiles *t);
// At which the ripples lie: across the other tile, so that their repetitions never line up [rad].
double bolan_paper_tiles_ripple_angle(const paper_tiles *t);
void bolan_paper_tiles_bind(const paper_tiles *t);
void bolan_paper_tiles_free(paper_tiles *t);

#endif
