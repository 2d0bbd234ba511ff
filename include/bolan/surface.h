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
} bolan_surface_kind;

/// What the surface must cover.
typedef struct bolan_surface_view {
    bolan_dvec3 eye; ///< [m]; z above mean sea level
    double heading_deg, pitch_deg, roll_deg;
    double fov_y;                ///< vertical field of view [rad], 0.001..2.8
    double aspect;               ///< width / height
    uint32_t pixel_height;       ///< of the picture: sets what an angular step is
    double water_level;          ///< [m]
    double vertical, horizontal; ///< bounds of the displacement [m] (bolan_sea_bounds())
} bolan_surface_view;

/// A vertex of mean water, relative to the eye: world axes, origin at the eye; z includes the drop of the round earth.
typedef struct bolan_surface_vertex {
    float x, y, z;
    float
        spacing; ///< distance to the neighbouring vertices [m], the larger direction: waves shorter than twice this must
                 ///< leave the geometry
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
/// Indices of a columns x rows grid, 6 per cell, counter-clockwise seen from above: (columns-1)*(rows-1)*6 values. Returns that count;
/// @p out may be NULL to ask for it.
uint32_t bolan_surface_grid_indices(bolan_surface_size size, uint32_t *out);

#ifdef __cplusplus
}
#endif
#endif
