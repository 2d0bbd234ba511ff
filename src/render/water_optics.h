// SPDX-License-Identifier: MIT
// What becomes of light at the water: one table of functions for each bolan_optics_kind, and what they draw with. pass_water.c
// chooses; optics_<name>.c and shaders/water_<name>.glsl are an optics.
#ifndef BOLAN_RENDER_WATER_OPTICS_H
#define BOLAN_RENDER_WATER_OPTICS_H

#include "frame.h"
#include "programs.h"
#include "sea_gpu.h"
#include "water_mesh.h"

// What an optics draws.
typedef struct water_draw {
    render_view *view;
    const sea_gpu *fields;
    const water_mesh *mesh;
    const water_programs *programs;
    water_block_buffers *blocks;
    water_waves waves;
    bool packed;     // layout of the cascades' textures
    double vertical; // bound of the displacement [m]
} water_draw;

// The program of this shader for these waves, this surface, with or without land, and its own defines `own`; used. NULL: it does not compile (logged when it was prepared).
const gl_program *bolan_water_program(const water_draw *d, const water_shader *shader, uint32_t own);
// The one function that writes the block Water.
void bolan_water_fill(water_block *b, const water_draw *d);
// Draws the mesh with its depth into the frame's picture: what most optics do with a program that is set up.
void bolan_water_draw_forward(const water_draw *d);
// Rows of the picture, from the bottom, that can show water: up to the horizon raised by the highest wave.
uint32_t bolan_water_rows(const render_view *v, double vertical);
// The surface that is drawn: two triangles for an eye under water, whatever the technique says.
bolan_surface_kind bolan_water_surface(const render_view *v);

typedef struct water_optics {
    bolan_optics_kind kind; // see bolan_optics_seen_from_below()
    size_t size;      // of its state, which starts as zeros
    bool mirrors;     // it looks up the pictures of planar_views.c
    bool own_sky;     // draws its own sky, so skips the planar views where the scene is empty
    bool static_grid; // it lights each pixel from textures: the static grid is fine enough
    bool keeps_shape; // it lights each pixel from a shape that it keeps, on UNIT_SURFACE: see half_rate.h
    uint32_t columns[BOLAN_QUALITY_ULTRA + 1]; // of pixels that share a sample, by quality; 0: each has its own
    bool packed;                        // of the cascades it reads slopes, pinch and foam, nothing else: see sea_gpu.h
    // True: it has no use for the cascades' textures; NULL: it has.
    bool (*table_only)(const void *state, const frame *f);
    bool (*stale)(const void *state); // it shows what was baked for another sun; may be NULL
    bolan_result (*create)(void *state, bolan_quality quality);
    // Notes every program that draw() can ask for, whatever the eye does; called after prepare().
    void (*list)(const void *state, const water_setup *s, water_programs *all);
    void (*prepare)(void *state, const water_draw *d); // once a frame, before anything is drawn; may be NULL
    void (*draw)(void *state, const water_draw *d);
    void (*free)(void *state);
} water_optics;

extern const water_optics bolan_optics_physical, bolan_optics_mirror, bolan_optics_phong, bolan_optics_lit,
    bolan_optics_crest;

#endif
