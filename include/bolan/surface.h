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
    BOLAN_SURFACE_PROJECTED, ///< a grid of constant angular steps seen from the eye: cost independent of distance
    BOLAN_SURFACE_NESTED,    ///< square grids round the point looked at, each twice as fine (Liu, Xu & Chen 2009)
    BOLAN_SURFACE_QUAD,      ///< two triangles (Ma, Zhu & Gong 2006)
} bolan_surface_kind;
#define BOLAN_SURFACE_KINDS 3 ///< how many there are
/// The names that the command line and scene files use, "projected" ...; by bolan_surface_kind, NULL at the end.
extern const char *const bolan_surface_kind_names[BOLAN_SURFACE_KINDS + 1];

/// What the surface must cover.
typedef struct bolan_surface_view {
    bolan_dvec3 eye; ///< [m]; z above mean sea level
    double heading_deg, pitch_deg, roll_deg;
    double fov_y;                ///< vertical field of view [rad], 0.001..2.8
    double aspect;               ///< width / height
    uint32_t pixel_height;       ///< of the picture: sets what an angular step is
    double water_level;          ///< [m]
    double vertical, horizontal; ///< bounds of the displacement [m] (bolan_sea_bounds())
    /// Of an off-centre frustum: the picture's middle lies so many half widths right of the camera's axis and half
    /// heights above it; default 0, 0.
    double shift_x, shift_y;
} bolan_surface_view;

/// A vertex of mean water, relative to the eye: world axes, origin at the eye; z includes the drop of the round earth.
typedef struct bolan_surface_vertex {
    float x, y, z;
    /// Distance to the neighbouring vertices [m], the larger direction: waves shorter than twice this must leave the geometry,
    /// best by and by from eight times on.
    float spacing;
    /// NESTED: this vertex lies on the straight edge between its neighbours at -stitch and +stitch [m], and is displaced to
    /// their mean (x, y, z and spacing are theirs already); (0, 0): an ordinary vertex.
    float stitch_x, stitch_y;
} bolan_surface_vertex;

/// How fine the surface is.
typedef struct bolan_surface_desc {
    bolan_surface_kind kind;
    double pixels_per_vertex; ///< 1..32; default 3. Raised: fewer triangles
    uint32_t
        max_vertices; ///< capacity of the caller's vertex buffer, >= 1024; the grid is coarsened to fit; default 200000
} bolan_surface_desc;

/// The defaults named beside the fields.
bolan_surface_desc bolan_surface_desc_default(void);

/// Number of columns and rows written: vertices[row * columns + column], rows run from near to far, columns clockwise.
/// Zero when no water can be in view. Triangles: two per cell; indices by bolan_surface_grid_indices().
typedef struct bolan_surface_size {
    uint32_t columns, rows;
} bolan_surface_size;
/// Fills @p vertices (at least desc->max_vertices). Pure, thread-safe, allocates nothing.
bolan_surface_size bolan_surface_projected(const bolan_surface_desc *desc, const bolan_surface_view *view,
                                           bolan_surface_vertex *vertices);

/// The projector behind bolan_surface_projected() for one view: a map from the unit square to mean water, in closed form,
/// so that a grid that never changes can be put onto the water by a vertex shader (the static buffer of Ni, Zhang &
/// Tan, after Johanson 2004). Level, and at the eye's own vertical: it covers what the view can see of the water,
/// raised and pushed by the displacement's bounds, and nothing of the sky.
typedef struct bolan_surface_projector {
    bool visible;  ///< false: no water can be in view, nothing need be drawn
    double height; ///< of the eye over the water [m], as the steps take it: at least 0.5
    double above;  ///< of the eye over the water [m]
    double near_parameter,
        range;            ///< rows are even steps of s over this range; distance = height * x(s), see projected.c
    double heading, half; ///< azimuths, clockwise from north: heading +- half [rad]
    double guard;         ///< nearer than this the rows close to full circles, for waves that lean into view [m]
} bolan_surface_projector;
/// Places it. Pure, thread-safe.
bolan_surface_projector bolan_surface_projector_of(const bolan_surface_view *view);
/// Its grid of @p size, columns and rows at least 2, as bolan_surface_projected() lays them out. Pure, thread-safe.
void bolan_surface_projector_vertices(const bolan_surface_projector *projector, bolan_surface_size size,
                                      bolan_surface_vertex *vertices);
/// The same for a vertex shader (grid_point() in shaders/common/grid.glsl, the twin): near_parameter, range, height,
/// above; azimuth in the middle (snapped to the columns), half, guard, earth radius.
void bolan_surface_projector_uniforms(const bolan_surface_projector *projector, bolan_surface_size size, float out[8]);

/// The quad: 4 vertices (south-west, south-east, north-west, north-east) of a square round the point under the eye, on the
/// flat plane of the mean water. Its sides are as long as the horizon is far. Do not draw what lies farther from the
/// eye's foot than half a side, in the corners: there the plane would stand above the horizon of the round earth. Pure,
/// thread-safe. Source: Ma, Zhu & Gong 2006, section 2.1.
void bolan_surface_quad(const bolan_surface_view *view, bolan_surface_vertex vertices[4]);
/// Its 6 indices, counter-clockwise seen from above.
extern const uint32_t bolan_surface_quad_indices[6];

// ---- nested grids ---------------------------------------------------------------------------------------------------

#define BOLAN_NESTED_MAX_LEVELS 16 ///< of a nested surface
#define BOLAN_NESTED_PARTS 12      ///< index lists of a level: 8 blocks (SW S SE W E NW N NE), 4 T-strips (S N W E)

/// How nested grids are made. n = cells.
typedef struct bolan_nested_desc {
    uint32_t cells;  ///< n along a side of every level, a multiple of 4, 4..256; default 32. Raised: finer everywhere
    uint32_t levels; ///< 1..BOLAN_NESTED_MAX_LEVELS; default 6. Raised: each one more is twice as fine at the middle
    /// d_0 of the coarsest level [m], > 0, kept to the precision of float; 0 (default): the least power of two with which
    /// the coarsest level reaches to half a pixel below the horizon: from 10 m up, 6 levels of 32 cells end at 16 m, 10 at 1 m.
    double spacing;
} bolan_nested_desc;
/// The defaults named beside the fields.
bolan_nested_desc bolan_nested_desc_default(void);

/// One level where a view puts it: vertex (i, j) stands at (x0 + i d, y0 + j d), world metres; the next finer level
/// covers the cells [hole_i, hole_i + n/2) x [hole_j, hole_j + n/2). The finest level has no hole: (0, 0).
typedef struct bolan_nested_level {
    double x0, y0, spacing;
    uint32_t hole_i, hole_j;
} bolan_nested_level;
/// All levels of a view, 0 the coarsest.
typedef struct bolan_nested {
    uint32_t cells, levels;
    bolan_dvec2 centre; ///< the point that the levels lie round [m]
    /// Smallest spacing of any vertex [m], so that detail comes and goes smoothly with the eye's height.
    double least_spacing;
    bolan_nested_level level[BOLAN_NESTED_MAX_LEVELS];
} bolan_nested;
/// Places the levels round the point of the mean water in the middle of the view, or nearer to the eye where that point is
/// so far that the finest level would be lost there: at most twice as far as the nearest water in the picture
/// (or the eye's height).
/// Every level stands on multiples of its own spacing, exactly, and moves in steps of two: no vertex moves over the water,
/// and where a level stands depends on the centre and its spacing alone (n > 4; for n = 4 the hole cannot move).
/// Levels whose cells would be below two pixels are left out. Pure, thread-safe, the same on every machine. Misuse:
/// @p desc out of range is clamped. Source: Liu, Xu & Chen 2009, section 1.
bolan_nested bolan_surface_nested_place(const bolan_nested_desc *desc, const bolan_surface_view *view);
/// (n + 1)^2 for each level.
uint32_t bolan_surface_nested_vertex_count(const bolan_nested *nested);
/// The vertices, level by level, row by row from the south-west: vertex (i, j) of a level is its (j (n + 1) + i)th. Each of
/// the three arrays holds bolan_surface_nested_vertex_count() or is NULL: @p rest in world metres, @p vertices relative to
/// the eye, @p visible 1 where the view can show a triangle of the vertex (section 4: two cross products in plan, widened
/// by a cell and the bounds of the displacement; the four side planes of the picture where it is wide or looks down), 0
/// where its waves need not be computed. Vertices inside a hole are written too, and belong to no triangle.
///
/// A vertex's spacing grows from d to 2 d towards the border of its level, by its distance from the centre, so that it is
/// continuous over the water and in time; where levels meet, both sides have the same position, spacing and visibility, bit for bit.
/// Odd vertices on the border of a level inside another are stitched (section 2); their neighbours are never stitched.
/// Pure, thread-safe, allocates nothing. @p view may be NULL where only @p rest is asked for.
void bolan_surface_nested_vertices(const bolan_nested *nested, const bolan_surface_view *view, bolan_dvec2 *rest,
                                   bolan_surface_vertex *vertices, uint8_t *visible);
/// Index list @p part of @p level as plain triangles, counter-clockwise seen from above; returns the count (0 where the finest
/// level has no such part); @p out may be NULL to ask for it. The T-strips are the level's own outermost ring of cells, the
/// blocks what is between it and the hole; the finest level is one block, part 0, its ring included. All parts of all
/// levels together: 2 n^2 triangles for the finest and 2 (n^2 - n^2/4) for each other. Thread-safe.
uint32_t bolan_surface_nested_indices(const bolan_nested *nested, uint32_t level, uint32_t part, uint32_t *out);
/// Normals of the displaced mesh as the paper makes them: the mean of the unit normals of the triangles round each vertex,
/// of both levels where two meet; a stitched vertex has the mean of its neighbours' normals, as the edge it lies on. Up for
/// vertices inside a hole. @p positions: displaced vertices, @p normals receives unit vectors, both of
/// bolan_surface_nested_vertex_count(). Thread-safe, allocates nothing. Source: Liu, Xu & Chen 2009, section 3.
void bolan_surface_nested_normals(const bolan_nested *nested, const bolan_vec3 *positions, bolan_vec3 *normals);

// ---- grids ----------------------------------------------------------------------------------------------------------

/// Indices of a columns x rows grid, 6 per cell, counter-clockwise seen from above: (columns-1)*(rows-1)*6 values. Returns that count;
/// @p out may be NULL to ask for it.
uint32_t bolan_surface_grid_indices(bolan_surface_size size, uint32_t *out);

#ifdef __cplusplus
}
#endif
#endif
