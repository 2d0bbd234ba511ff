// SPDX-License-Identifier: MIT
/// @file surface.h
/// Tier 2. Geometry of the undisplaced water for one view, written into the caller's buffers.
#ifndef BOLAN_SURFACE_H
#define BOLAN_SURFACE_H

#include "bolan/base.h"
#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How the undisplaced water is cut into triangles.
typedef enum bolan_surface_kind {
    /// A grid of constant angular steps seen from the eye: cost independent of distance.
    BOLAN_SURFACE_PROJECTED,
    /// Square grids round the point looked at, each twice as fine (Liu, Xu & Chen 2009).
    BOLAN_SURFACE_NESTED,
    /// Two triangles (Ma, Zhu & Gong 2006).
    BOLAN_SURFACE_QUAD,
} bolan_surface_kind;
/// Number of surface kinds.
#define BOLAN_SURFACE_KINDS 3
/// The names that the command line and scene files use, "projected" ...; by bolan_surface_kind, NULL at the end.
BOLAN_API extern const char *const bolan_surface_kind_names[BOLAN_SURFACE_KINDS + 1];

/// The view that the surface must cover.
typedef struct bolan_surface_view {
    /// Position of the eye [m]; z above mean sea level.
    bolan_dvec3 eye;
    /// Attitude of the camera [deg]: heading by compass, pitch up, roll clockwise.
    double heading_deg, pitch_deg, roll_deg;
    /// Vertical field of view [rad], 0.001..2.8.
    double fov_y;
    /// Width over height of the view.
    double aspect;
    /// Height of the view [pixels]; it sets the angular step of the grid.
    uint32_t pixel_height;
    /// Height of mean water [m].
    double water_level;
    /// Bounds of the vertical and horizontal displacement [m]; see bolan_sea_bounds().
    double vertical, horizontal;
    /// Centre of an off-centre frustum, right of and above the camera's axis; default 0, 0.
    /// Unit: half widths of the view (x) and half heights (y).
    double shift_x, shift_y;
} bolan_surface_view;

/// A vertex of mean water.
typedef struct bolan_surface_vertex {
    /// Position relative to the eye, along the world's axes [m]. z includes the drop of the round earth.
    float x, y, z;
    /// Distance to the neighbouring vertices [m]; of the two directions the larger.
    /// The geometry must not carry waves shorter than twice the spacing.
    /// Waves should fade out between eight and two times the spacing.
    float spacing;
    /// NESTED: offset to the two neighbours [m]; they lie at -stitch and +stitch, and this vertex lies between them.
    /// A stitched vertex is displaced to the mean of its neighbours' displaced positions.
    /// Its x, y, z and spacing are already their means.
    /// (0, 0): the vertex is not stitched.
    float stitch_x, stitch_y;
} bolan_surface_vertex;

/// How fine the surface is.
typedef struct bolan_surface_desc {
    /// The kind of surface; default PROJECTED.
    bolan_surface_kind kind;
    /// Distance of neighbouring vertices [pixels], 1..32; default 3. Raised: fewer triangles.
    double pixels_per_vertex;
    /// Capacity of the caller's vertex buffer, >= 1024; default 200000. The grid is coarsened to fit.
    uint32_t max_vertices;
} bolan_surface_desc;

/// The defaults named above the fields.
BOLAN_API bolan_surface_desc bolan_surface_desc_default(void);

/// The size of a grid of vertices: vertices[row * columns + column].
/// Rows run from near to far, columns clockwise.
/// Both are zero when no water can be in view.
/// A cell is two triangles; bolan_surface_grid_indices() writes their indices.
typedef struct bolan_surface_size {
    uint32_t columns, rows;
} bolan_surface_size;

/// Writes the projected grid of a view.
/// @param vertices receives the grid; its capacity is desc->max_vertices.
/// Pure, thread-safe, allocates nothing.
BOLAN_API bolan_surface_size bolan_surface_projected(const bolan_surface_desc *desc, const bolan_surface_view *view,
                                                     bolan_surface_vertex *vertices);

/// The projector of bolan_surface_projected() for one view: a map from the unit square to mean water in closed form.
/// With it a vertex shader can place a static grid on the water (Ni, Zhang & Tan, after Johanson 2004).
/// The projector stands at the eye and is level.
/// It covers the water in view, enlarged by the bounds of the displacement, and no sky.
typedef struct bolan_surface_projector {
    /// False: no water can be in view, and nothing needs to be drawn.
    bool visible;
    /// Height of the eye over the water [m], at least 0.5; the rows are computed from it.
    double height;
    /// Height of the eye over the water [m], without a lower bound.
    double above;
    /// First value and length of the range of the row parameter s. Rows are even steps of s.
    /// The distance of a row is height * x(s); projected.c has x(s).
    double near_parameter, range;
    /// Range of azimuths, clockwise from north: heading +- half [rad].
    double heading, half;
    /// Rows nearer than this distance [m] are full circles, for waves that lean into the view.
    double guard;
} bolan_surface_projector;

/// The projector of a view.
/// Pure, thread-safe.
BOLAN_API bolan_surface_projector bolan_surface_projector_of(const bolan_surface_view *view);

/// Largest block of bolan_surface_projector_size().
#define BOLAN_SURFACE_MAX_BLOCK 16

/// The size of the projector's grid: angular steps of desc->pixels_per_vertex pixels, larger ones where
/// desc->max_vertices asks for it. 0 columns and rows where no water can be in view.
/// The cells along both sides are whole blocks of @p block x @p block cells, 1..BOLAN_SURFACE_MAX_BLOCK, so that a grid
/// can be drawn as instances of one block.
/// @param projector that of @p view; its azimuths are widened by what columns that are snapped may fall short.
/// Pure, thread-safe.
BOLAN_API bolan_surface_size bolan_surface_projector_size(const bolan_surface_desc *desc,
                                                          const bolan_surface_view *view, uint32_t block,
                                                          bolan_surface_projector *projector);

/// Writes the projector's grid of @p size, in the order of bolan_surface_projected().
/// @param size columns and rows, each at least 2.
/// Pure, thread-safe.
BOLAN_API void bolan_surface_projector_vertices(const bolan_surface_projector *projector, bolan_surface_size size,
                                                bolan_surface_vertex *vertices);

/// The projector as the uniforms of a vertex shader; the twin is grid_point() in shaders/common/grid.glsl.
/// @param out near_parameter, range, height, above, azimuth of the middle (snapped to the columns), half, guard, earth
/// radius.
BOLAN_API void bolan_surface_projector_uniforms(const bolan_surface_projector *projector, bolan_surface_size size,
                                                float out[8]);

/// Writes the quad: a square round the point under the eye, on the flat plane of mean water.
/// A side is as long as the distance to the horizon.
/// Draw only what lies within half a side of the point under the eye; the corners lie outside.
/// Reason: farther out the flat plane stands above the horizon of the round earth.
/// @param vertices south-west, south-east, north-west, north-east.
/// Pure, thread-safe.
/// Source: Ma, Zhu & Gong 2006, section 2.1.
BOLAN_API void bolan_surface_quad(const bolan_surface_view *view, bolan_surface_vertex vertices[4]);
/// The 6 indices of the quad, counter-clockwise seen from above.
BOLAN_API extern const uint32_t bolan_surface_quad_indices[6];

// ---- nested grids ---------------------------------------------------------------------------------------------------

/// Most levels of a nested surface.
#define BOLAN_NESTED_MAX_LEVELS 16
/// Index lists of a level: 8 blocks (SW S SE W E NW N NE), then 4 T-strips (S N W E).
#define BOLAN_NESTED_PARTS 12

/// How nested grids are made. n stands for `cells`.
typedef struct bolan_nested_desc {
    /// Cells along a side of every level, a multiple of 4, 4..256; default 32. Raised: finer everywhere.
    uint32_t cells;
    /// Number of levels, 1..BOLAN_NESTED_MAX_LEVELS; default 6. Raised by one: twice as fine at the middle.
    uint32_t levels;
    /// Spacing d_0 of the coarsest level [m], > 0, rounded to float; default 0.
    /// 0: the smallest power of two for which the coarsest level reaches to half a pixel below the horizon.
    /// For an eye at 10 m, the finest of 6 levels of 32 cells then has a spacing of 16 m, and of 10 levels 1 m.
    double spacing;
} bolan_nested_desc;
/// The defaults named above the fields.
BOLAN_API bolan_nested_desc bolan_nested_desc_default(void);

/// The place of one level: vertex (i, j) stands at (x0 + i d, y0 + j d), d the spacing.
typedef struct bolan_nested_level {
    /// Place of vertex (0, 0) in the world, and the spacing d [m].
    double x0, y0, spacing;
    /// The next finer level covers the cells [hole_i, hole_i + n/2) x [hole_j, hole_j + n/2).
    /// The finest level has no hole: (0, 0).
    uint32_t hole_i, hole_j;
} bolan_nested_level;

/// All levels of a view.
typedef struct bolan_nested {
    /// Cells along a side, and number of levels.
    uint32_t cells, levels;
    /// The point that the levels lie round [m].
    bolan_dvec2 centre;
    /// Smallest spacing of any vertex [m]. It varies smoothly with the eye's height, so that detail does not pop.
    double least_spacing;
    /// The levels; 0 is the coarsest.
    bolan_nested_level level[BOLAN_NESTED_MAX_LEVELS];
} bolan_nested;

/// Places the levels for a view.
/// The centre is the point of mean water in the middle of the view.
/// The centre is moved nearer where that point is too far for the finest level to be seen.
/// The bound is twice the distance of the nearest water in view (or twice the eye's height).
/// Every level stands on exact multiples of its own spacing and moves in steps of two spacings.
/// So no vertex moves over the water.
/// For n > 4 the place of a level depends on the centre and its spacing alone; for n = 4 the hole cannot move.
/// Levels whose cells would be smaller than two pixels are left out.
/// Values of @p desc outside their ranges are clamped.
/// Pure, thread-safe, the same on every machine.
/// Source: Liu, Xu & Chen 2009, section 1.
BOLAN_API bolan_nested bolan_surface_nested_place(const bolan_nested_desc *desc, const bolan_surface_view *view);

/// Number of vertices: (n + 1)^2 for each level.
BOLAN_API uint32_t bolan_surface_nested_vertex_count(const bolan_nested *nested);

/// Writes the vertices, level by level, row by row from the south-west: vertex (i, j) of a level is its (j (n + 1) +
/// i)th.
/// Each array has bolan_surface_nested_vertex_count() elements or is NULL.
/// @param view may be NULL where only @p rest is asked for.
/// @param rest receives world positions [m].
/// @param vertices receives vertices relative to the eye.
/// @param visible receives 1 where the view can show a triangle of the vertex, and 0 where no waves are needed.
///
/// Visibility is tested by two cross products in plan, widened by a cell and the bounds of the displacement (section
/// 4). A view that is wide or looks down is tested by its four side planes.
/// Vertices inside a hole are written too; no triangle uses them.
/// The spacing of a vertex grows from d at the centre to 2 d at the border of its level.
/// So the spacing is continuous over the water and in time.
/// Where levels meet, both have the same position, spacing and visibility, bit for bit.
/// Odd vertices on the border of an inner level are stitched (section 2); their neighbours are never stitched.
/// Pure, thread-safe, allocates nothing.
BOLAN_API void bolan_surface_nested_vertices(const bolan_nested *nested, const bolan_surface_view *view,
                                             bolan_dvec2 *rest, bolan_surface_vertex *vertices, uint8_t *visible);

/// Writes index list @p part of @p level as triangles, counter-clockwise seen from above, and returns their count.
/// The count is 0 where the finest level has no such part.
/// The T-strips are the outermost ring of cells of the level; the blocks lie between the ring and the hole.
/// The finest level is one block, part 0, with its ring.
/// All parts together have 2 n^2 triangles for the finest level and 2 (n^2 - n^2/4) for each other level.
/// @param out receives the indices; NULL asks for the count alone.
/// Thread-safe.
BOLAN_API uint32_t bolan_surface_nested_indices(const bolan_nested *nested, uint32_t level, uint32_t part,
                                                uint32_t *out);

/// Normals of the displaced mesh after the paper: the mean of the unit normals of the triangles round each vertex.
/// Where two levels meet, the triangles of both count.
/// A stitched vertex lies on the edge between its neighbours and has the mean of their normals.
/// Vertices inside a hole have normals that point up.
/// @param positions displaced vertices, bolan_surface_nested_vertex_count() of them.
/// @param normals receives as many unit vectors.
/// Thread-safe, allocates nothing.
/// Source: Liu, Xu & Chen 2009, section 3.
BOLAN_API void bolan_surface_nested_normals(const bolan_nested *nested, const bolan_vec3 *positions,
                                            bolan_vec3 *normals);

// ---- grids ----------------------------------------------------------------------------------------------------------

/// Writes the indices of a grid, 6 per cell, counter-clockwise seen from above.
/// Returns their number, (columns - 1) * (rows - 1) * 6.
/// @param out receives the indices; NULL asks for the number alone.
BOLAN_API uint32_t bolan_surface_grid_indices(bolan_surface_size size, uint32_t *out);

#ifdef __cplusplus
}
#endif
#endif
