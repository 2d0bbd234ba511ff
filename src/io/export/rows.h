// SPDX-License-Identifier: MIT
/// @file rows.h
/// The vertices of a mesh, row by row. Private to src/io/export.
///
///     rest points (a rectangle, or the projected grid of a view)
///       -> bolan_query_parcels()      position, normal
///       -> bolan_sea_sample_grid()    foam
///       -> bolan_query_motion()       velocity at the parcel's place
///
/// A mesh is columns x rows vertices, rows from south to north or from near to far, columns from west to east or
/// clockwise; a cell is the two triangles of bolan_surface_grid_indices(). Batches of whole rows are in memory.
#ifndef BOLAN_IO_EXPORT_ROWS_H
#define BOLAN_IO_EXPORT_ROWS_H

#include "bolan/export.h"
#include "bolan/query.h"
#include "bolan/surface.h"

/// In world axes; the position from the origin of the file. 40 bytes.
typedef struct mesh_vertex {
    float position[3], normal[3], foam, velocity[3];
} mesh_vertex;

/// What a mesh is of.
typedef enum mesh_part { MESH_WATER, MESH_GROUND } mesh_part;

typedef struct mesh_rows {
    bolan_world *world;
    const bolan_export_mesh_desc *desc;
    uint32_t columns, rows;
    uint32_t batch;    ///< rows that are made at a time
    bool moves;        ///< the velocity is wanted; else it is 0
    bolan_water water; ///< the world's, with the flow below
    bolan_flow *flow;
    bolan_dvec3 eye;            ///< of a view
    bolan_surface_vertex *grid; ///< of a view: all its vertices; else NULL
    size_t grid_bytes;
    // Of a batch.
    bolan_dvec2 *rest, *place;
    double *base; ///< height of the mean water [m]
    float *spacing;
    bolan_parcel *parcels;
    bolan_sea_sample *samples;
    bolan_surface_motion *motion;
    mesh_vertex *vertices;
    uint32_t capacity;
    uint32_t *strip; ///< indices of two rows, 6 (columns - 1)
} mesh_rows;

/// Checks @p desc, and prepares the rows of the world at its present time. ARGUMENT or MEMORY, logged; close it in any
/// case.
bolan_result bolan_mesh_rows_open(bolan_world *world, const bolan_export_mesh_desc *desc, const char *path,
                                  mesh_rows *out);
void bolan_mesh_rows_close(mesh_rows *r);
/// Makes rows [first, first + r->batch), or fewer at the end, in r->vertices. Returns the number of vertices, 0 past
/// the last row.
uint32_t bolan_mesh_rows_make(mesh_rows *r, mesh_part part, uint32_t first);
/// Steps to a frame of the desc; frame 0 of several settles. With r->moves the flow follows.
void bolan_mesh_rows_step(mesh_rows *r, double start, uint32_t frame);

/// Of a mesh.
static inline uint64_t bolan_mesh_vertices(const mesh_rows *r) { return (uint64_t)r->columns * r->rows; }
static inline uint64_t bolan_mesh_triangles(const mesh_rows *r) {
    return 2 * (uint64_t)(r->columns - 1) * (r->rows - 1);
}
/// Number of meshes of the file: the water, and the ground where it is wanted.
static inline uint32_t bolan_mesh_parts(const mesh_rows *r) { return r->desc->ground ? 2 : 1; }

#endif
