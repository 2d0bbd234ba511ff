// SPDX-License-Identifier: MIT
// Which chunks a view needs: a quadtree over the terrain, refined until a texel and the mesh's error are small on the
// picture, and a fixed pool of chunks kept by last use.
#ifndef BOLAN_RENDER_TERRAIN_TREE_H
#define BOLAN_RENDER_TERRAIN_TREE_H

#include "ground_chunk.h"

typedef struct chunk_slot {
    ground_chunk chunk;
    uint32_t level, x, y;       // place in the tree
    uint64_t used;              // frame of the last use; 0: never filled
    uint64_t lit;               // light number of its shadows
    uint32_t mesh;              // the coarsest mesh that is good enough for the view
    bool fresh_mesh, fresh_map; // must be uploaded
    uint32_t next;              // in its hash chain
} chunk_slot;

typedef struct tree_view {
    bolan_dvec3 eye;            // world [m]
    bolan_mat4 view_projection; // eye-relative world -> clip
    bolan_mat4 mirrored;        // likewise, of the world mirrored in the water; where `mirrors`
    bool mirrors;
    float pixel;        // radians
    double water_level; // [m]
    chunk_sun sun;
    bool complete; // build all that is missing now; else at most `budget` chunks
    uint32_t budget;
    float texel_pixels; // a texel of the map may be this large on the picture [px]
    float error_pixels; // the mesh may depart this far from the ground [px]; its finest, twice as far
} tree_view;

typedef struct ground_tree ground_tree;

bolan_result bolan_ground_tree_create(uint32_t slots, ground_tree **out);
void bolan_ground_tree_destroy(ground_tree **tree);
// Forgets every chunk and starts on another terrain.
void bolan_ground_tree_reset(ground_tree *t, const bolan_ground *terrain);
// Chooses the chunks of a view, builds and lights what is missing (on the task hook). Afterwards the slots of
// bolan_ground_tree_draw_list() hold their data, nearest first; fresh ones are to be uploaded by the caller.
void bolan_ground_tree_select(ground_tree *t, const tree_view *view);
const uint32_t *bolan_ground_tree_draw_list(const ground_tree *t, uint32_t *count);
chunk_slot *bolan_ground_tree_slot(ground_tree *t, uint32_t index);
// Chunks built or lit again by the last call.
uint32_t bolan_ground_tree_work(const ground_tree *t);

#endif
