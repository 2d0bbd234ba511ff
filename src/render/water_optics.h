// SPDX-License-Identifier: MIT
// How the water is shaded: one table of capabilities and functions for each bolan_optics_kind, and what they draw with.
// pass_water.c chooses.
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

// The program of this shader for these waves, this surface, with or without land, and its own defines `own`.
// NULL: it does not compile (logged when it was prepared).
const gl_program *bolan_water_find_program(const water_draw *d, const water_shader *shader, uint32_t own);
const gl_program *bolan_water_program(const water_draw *d, const water_shader *shader, uint32_t own); // and uses it
// The one function that writes the block Water.
void bolan_water_fill(water_block *b, const water_draw *d);
// Draws the mesh with its depth into the frame's picture: what most optics do with a program that is set up.
void bolan_water_draw_forward(const water_draw *d);
// Rows of the picture, from the bottom, that can show water: up to the horizon raised by the highest wave.
uint32_t bolan_water_rows(const render_view *v, double vertical);
// Of these rows from the bottom of the picture, those whose rays go down more steeply than an angle of that sine.
uint32_t bolan_water_rows_steeper(const render_view *v, double sine, uint32_t rows);
// The surface that is drawn: two triangles for an eye under water, whatever the technique says.
bolan_surface_kind bolan_water_surface(const render_view *v);

// Rows of a picture, counted from the bottom.
typedef struct water_rows {
    uint32_t from, to;
} water_rows;

// What an optics can do and needs. The passes and the frame ask this table, and never which optics it is.
typedef struct water_optics {
    bolan_optics_kind kind; // see bolan_optics_seen_from_below()
    size_t size;            // of its state, which starts as zeros
    bool looks_through;     // fetches what lies behind the water from the copy of the frame
    bool planar_mirrors;    // fetches planar views of the world instead: see behind()
    bool own_sky;           // reflects a sky of its own, so needs no planar views where the scene is empty
    bool coarse_grid;       // shades each pixel from textures: a coarse projected grid is fine enough
    bool packed;            // of the cascades it reads slopes, pinch and foam, nothing else: see sea_gpu.h
    // Columns of pixels that share a sample; NULL: each pixel has its own.
    uint32_t (*shade_columns)(const bolan_look *look, bolan_quality quality);
    // Of these rows from the bottom, those where they do; NULL: all. With shape().
    uint32_t (*shared_rows)(const water_draw *d, uint32_t rows);
    // How the mesh of the water differs for this look; NULL, or a function that returns NULL: not at all.
    const mesh_rules *(*mesh)(const bolan_look *look);
    // True: it has no use for the cascades' textures; NULL: it has.
    bool (*table_only)(const void *state, const frame *f);
    bool (*stale)(const void *state); // it shows what was baked for another sun; may be NULL
    bolan_result (*create)(void *state, bolan_quality quality);
    bolan_result (*reload)(void *state); // programs of its own that list() does not note; may be NULL
    // Notes every program that draw() can ask for, whatever the eye does; called after prepare().
    void (*list)(const void *state, const water_setup *s, water_programs *all);
    void (*prepare)(void *state, const water_draw *d); // once a view, before anything is drawn; may be NULL
    // Once a view, after prepare() and the programs, with the fields bound: draws and binds maps of light; may be NULL.
    void (*gather)(void *state, const water_draw *d);
    // Once a sample, after the world and before the water: draws planar views. Where planar_mirrors or draw_below.
    void (*behind)(void *state, const water_draw *d, const world_drawer *world);
    // Draws the water; NULL where the optics has the next two.
    void (*draw)(void *state, const water_draw *d);
    // Draws the shape of the water, which the optics keeps and binds to its own units: see half_rate.h. False:
    // there is nothing to shade, for an eye in the water or because it cannot be drawn (logged).
    bool (*shape)(void *state, const water_draw *d);
    // Shades these rows of the shape into the picture of the view.
    void (*light)(void *state, const water_draw *d, water_rows rows);
    // What flies over the water, over the picture of water and sky, for an eye in the air; NULL: nothing.
    void (*draw_over)(void *state, const water_draw *d);
    // The water round an eye in it, where the depth is 0; such an eye sees two triangles. NULL: not so.
    void (*draw_body)(void *state);
    // What is seen through water by an eye in it or at the waterline, over the frame and its sky; NULL: draw_body() or
    // nothing. Its behind() is called for such an eye only.
    void (*draw_below)(void *state, const water_draw *d);
    void (*free)(void *state);
} water_optics;

extern const water_optics bolan_optics_physical, bolan_optics_mirror, bolan_optics_phong, bolan_optics_lit,
    bolan_optics_crest;

#endif
