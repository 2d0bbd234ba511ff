// SPDX-License-Identifier: MIT
// The undisplaced water as triangles, whichever surface makes them, and the waves that the CPU puts on its vertices.
#ifndef BOLAN_RENDER_WATER_MESH_H
#define BOLAN_RENDER_WATER_MESH_H

#include "frame.h"
#include "nested_grid.h"
#include "sea_gpu.h"

typedef struct water_mesh {
    bolan_surface_desc projected;
    bolan_nested_desc nested;
    gl_buffer vertices, waves, indices;
    gl_mesh mesh;
    gl_buffer lines; // of the edges, made when they are first shown
    gl_mesh edges;
    bolan_surface_vertex *cpu_vertices;
    bolan_sea_sample *cpu_waves;
    bolan_dvec2 *cpu_rest;
    float *cpu_spacing;
    uint8_t *cpu_visible;
    uint32_t *cpu_indices;
    uint32_t capacity, index_capacity; // of the buffers: vertices of whichever surface has most, and indices
    // What the index buffer holds
    bolan_surface_kind kind;
    bolan_surface_size grid;
    bolan_nested placed;
    uint32_t index_count; // of this view; 0: no water in sight
    uint32_t seam_count;  // indices after those, of triangles without area
    uint32_t line_count;  // indices of its edges
    // The static grid: one block of cells, uploaded once; the vertex shader puts its instances onto the water
    gl_buffer block_vertices, block_indices;
    gl_mesh block;
    bolan_surface_size coarse, fixed_size; // of a grid for optics that need few vertices, and of this view
    bolan_surface_projector projector;
    nested_grid levels; // the nested surface, made likewise
    bool fixed;         // one of the two is what this view draws
} water_mesh;

// How an optics changes the nested levels; each function is given.
typedef struct mesh_rules {
    // Number and size of the levels.
    bolan_nested_desc (*levels)(const bolan_surface_view *view);
    // Chooses the vertices of m->placed that get waves, in m->cpu_visible, which has the choice of every other optics.
    void (*choose)(water_mesh *m, const bolan_surface_view *view);
    // Puts slopes of its own into m->cpu_waves.
    void (*slopes)(water_mesh *m, uint32_t count);
} mesh_rules;

// max_vertices: of the projected surface, as bolan_renderer_desc has it; 0: by quality.
bolan_result bolan_water_mesh_create(water_mesh *m, bolan_quality quality, uint32_t max_vertices);
// How the projected surface is made.
typedef struct mesh_wishes {
    bool coarse; // for optics that shade each pixel from textures and need few vertices
    bool on_cpu; // its vertices are wanted here, to be looked at
} mesh_wishes;

// Whether the vertex shader makes the vertices: of projected and nested surfaces, but with waves that are made on the
// CPU, with rules of an optics, and where the vertices are wanted here.
bool bolan_water_mesh_is_fixed(bolan_surface_kind kind, water_waves waves, mesh_wishes wishes, const mesh_rules *rules);
// Makes the mesh of this view; WATER_MESH: with waves on its vertices. `rules` may be NULL.
void bolan_water_mesh_build(water_mesh *m, const render_view *v, bolan_surface_kind kind, water_waves waves,
                            mesh_wishes wishes, const mesh_rules *rules);
// Fills the members of the grid that the vertex shader makes, where one is drawn.
void bolan_water_mesh_fill(const water_mesh *m, water_block *b);
void bolan_water_mesh_draw(const water_mesh *m);
// Makes the edges of the triangles, for bolan_water_mesh_draw_edges(). False: there is no memory for them (logged).
bool bolan_water_mesh_find_edges(water_mesh *m);
void bolan_water_mesh_draw_edges(const water_mesh *m);
uint32_t bolan_water_mesh_triangles(const water_mesh *m);
void bolan_water_mesh_free(water_mesh *m);

// The view of this frame for the functions of surface.h.
bolan_surface_view bolan_water_mesh_view(const render_view *v);

#endif
