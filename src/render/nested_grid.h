// SPDX-License-Identifier: MIT
// The nested levels of the water, made by the vertex shader: nothing of a vertex is made or sent in a frame. Each level
// is drawn as blocks of cells, instances of one block, as far as the view can show them; blocks at the edges of a level
// and of its hole are cut. Shader: shaders/common/nested.glsl.
#ifndef BOLAN_RENDER_NESTED_GRID_H
#define BOLAN_RENDER_NESTED_GRID_H

#include "frame.h"

#include "bolan/surface.h"

enum { NESTED_BLOCK = 8 }; // cells of a block along a side

// An instance.
typedef struct nested_block {
    float i, j, columns, rows; // its first cell and its cells; the others of a block have no area
    float level;
} nested_block;

typedef struct nested_grid {
    uint32_t cells; // of a level along a side
    gl_buffer corners, indices, edge_corners, edge_indices, blocks, edges;
    gl_mesh block, edge;
    nested_block *list;
    uint32_t capacity;
    uint32_t count, edge_count, triangles; // of this view
    bolan_nested placed;
    bolan_dvec3 eye; // z: above the water
} nested_grid;

// cells: of a level along a side, as bolan_nested_desc has it, at least 12: then spacings rise beyond the hole only.
bolan_result bolan_nested_grid_create(nested_grid *g, uint32_t cells);
// Blocks that cover all cells of the levels but those of the holes, each once, into a list with room for @p capacity.
// Returns their number.
uint32_t bolan_nested_grid_blocks(const bolan_nested *nested, nested_block *out, uint32_t capacity);
// Chooses what the view can show.
void bolan_nested_grid_place(nested_grid *g, const bolan_nested *nested, const bolan_surface_view *view,
                             const bolan_mat4 *view_projection);
// Fills the members nested_... of the uniform block.
struct water_block;
void bolan_nested_grid_fill(const nested_grid *g, struct water_block *b);
void bolan_nested_grid_draw(const nested_grid *g);
void bolan_nested_grid_free(nested_grid *g);

#endif
