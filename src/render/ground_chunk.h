// SPDX-License-Identifier: MIT
// A square piece of ground at one level of detail: heights, and what shading needs of them. No GL here, so that chunks
// can be built on any thread.
//
//   |<-- border -->|<-------- 128 texels = 32 cells -------->|<-- border -->|
//    8 nodes        129 nodes: heights, normals, shadow, ambient light        8 nodes
//                   every fourth one is a vertex of the mesh; a skirt hangs from the rim
#ifndef BOLAN_RENDER_TERRAIN_CHUNK_H
#define BOLAN_RENDER_TERRAIN_CHUNK_H

#include "bolan/ground.h"

enum {
    CHUNK_CELLS = 32, // of the mesh, per side
    CHUNK_RATIO = 4,  // texels per cell
    CHUNK_TEXELS = CHUNK_CELLS * CHUNK_RATIO,
    CHUNK_MAP = CHUNK_TEXELS + 1, // nodes of the map, per side
    CHUNK_BORDER = 8,
    CHUNK_GRID = CHUNK_MAP + 2 * CHUNK_BORDER,
    CHUNK_RIM = 4 * CHUNK_CELLS, // vertices of the skirt
    CHUNK_VERTICES = (CHUNK_CELLS + 1) * (CHUNK_CELLS + 1) + CHUNK_RIM,
    CHUNK_MESHES = 4, // index lists: every vertex, every second, fourth, eighth
};

// Where the sun stands, for cast shadows.
typedef struct chunk_sun {
    float x, y;  // unit horizontal direction to it
    float slope; // tangent of its elevation
} chunk_sun;
chunk_sun bolan_chunk_sun_from(bolan_vec3 direction);

typedef struct ground_chunk {
    double west, south, size;          // [m]
    float lowest, highest;             // [m]
    float error[CHUNK_MESHES];         // nearly all of each mesh is closer to the heights [m]; not falling
    float skirt;                       // depth of the skirt [m]
    const struct ground_chunk *parent; // NULL for the root; must hold its data while this chunk is built or lit
    float *heights;                    // CHUNK_GRID^2, with the border
    uint16_t *map; // CHUNK_MAP^2 x 4 halfs: normal x, y; shadow clearance [m], > 0 in shadow; open sky 0..1
} ground_chunk;

bolan_result bolan_chunk_allocate(ground_chunk *c);
void bolan_chunk_free(ground_chunk *c);
// Evaluates the heights of the square that west, south, size name, and the normals.
void bolan_chunk_build(ground_chunk *c, const bolan_ground *terrain);
// Shadows and open sky from its heights and its ancestors'.
void bolan_chunk_light(ground_chunk *c, const chunk_sun *sun);
// CHUNK_VERTICES x (east, north of the south-west corner, elevation) [m].
void bolan_chunk_vertices(const ground_chunk *c, float *xyz);
// The meshes' index lists, the same for every chunk, one after the other.
uint32_t bolan_chunk_index_count(uint32_t mesh);
uint32_t bolan_chunk_first_index(uint32_t mesh);
void bolan_chunk_indices(uint32_t *indices); // bolan_chunk_first_index(CHUNK_MESHES) of them

#endif
