// SPDX-License-Identifier: MIT
// A query block: 16 points whose rest points are looked for at once, one lane each.
//
// The surface is known on rest points x0: the parcel of x0 is found at x0 + choppiness * sum_c att_c D_c(x0). A
// question is asked at a world point x, so each lane solves for the offset o = x0 - x that makes
//
//     r(o) = o + choppiness * sum_c att_c D_c(x + o) = 0                                                         (1)
//
// x is kept only as a cell and a fraction in each cascade, reduced in double precision; all that follows is float on
// small numbers, so that a point at 1e6 m is answered as well as one at the origin. Cascades are read over a warped
// plane (bolan/waves.h); within an offset it is its tangent at x. Lanes never look at one another: what a point gets
// does not depend on which points share its block, and so not on how a batch is cut over threads.
//
// A lane is solved by two passes over the cascades, long waves first, and a Newton step after each cascade:
//
//     guess    dx and dy of each, read linearly             2 rows of 2 texels, some 70 operations
//     refine   height, dx and dy by cubic splines           4 rows of 4 texels, some 400 operations (splines.h)
//
// Each pass takes the cascades before the present one, and after it those of the last pass, by their tangents, so a
// spline is read once, close to the root. The error is then of second order: half the curvature of each cascade times
// the square of how far the root still moved. Its estimate is the doubt of the lane. Lanes whose doubt is too large,
// that lie over a coast, or near a fold, are gathered into blocks of their own, and go on by plain Newton steps:
//
//     evaluate  height, dx and dy of all cascades, and gradients, at one place
//
// Slopes and Jacobians are gradients of the very splines whose heights are answered:
//
//     surface   the short cascades again, where the root ended up; the long ones by the tangents of `refine`
//
// A lane of little doubt has not moved far since a cascade was read: its doubt bounds curvature x distance^2 / 2, and
// so the error of a slope, curvature x distance. `again` is the first cascade where the bound of the latter is above
// QUERY_SLOPE_ERROR.
#ifndef BOLAN_QUERY_BLOCK_H
#define BOLAN_QUERY_BLOCK_H

#include "bolan/water.h"

#include "waves/sea.h"
#include "waves/sum/sum.h"

enum {
    QUERY_LANES = 16,
    QUERY_BLOCKS = 2, // at most, that are solved side by side: one waits for memory and for roots, the other computes
    QUERY_MAX_OFFSET = 1000, // [m], far beyond any displacement: keeps the cell arithmetic inside int
};

// [m] far below the residual that query.h promises.
#define QUERY_CONVERGED 1.5e-5f
// [m] of the doubt, which overestimates the residual: at 256 samples a side 1 in 400 of the lanes below it has a
// residual above QUERY_CONVERGED, and none above 6e-5 m.
#define QUERY_DOUBTFUL 3e-5f
// Of a cascade that is not read again: the bound of its error, which is some ten times the rms.
#define QUERY_SLOPE_ERROR 4e-3f
// Determinant below which a second root may be near.
#define QUERY_FOLD 0.25f
// Determinant below which the matrix of a Newton step says nothing.
#define QUERY_REGULAR 0.1f

// One cascade as the kernels read it.
typedef struct query_cascade {
    const float *texels; // {dx, dy, height, dxy}
    uint32_t n, pitch;
    float cells_per_metre;
    float c, s;              // cosine and sine of the tile's angle
    double tile_c, tile_s;   // the same over the tile's length: world [m] -> tiles
    float linear;            // what a linear fetch of dx and dy is multiplied with, to be right in the mean
    float own[3], longer[3]; // bolan_bound_weights of dx, dy, height: with itself, with shorter cascades
    float curvature;         // typical second derivative of the displacement, with choppiness [1/m]
} query_cascade;

typedef struct query_sea {
    uint32_t count;
    uint32_t again; // the first of the cascades that bolan_query_surface() reads again; below `count`
    bool bound;     // there are bound waves
    float choppiness;
    double origin_x, origin_y; // where the tiles lie: they drift with the current [m]
    query_cascade cascade[BOLAN_MAX_CASCADES];
    bolan_sea_warp warp;
    float lift[BOLAN_MAX_CASCADES]; // [m] of each cascade; bolan_sea_lift()
    const sum_tables *sum;          // waves instead of cascades, as if they were one; or NULL
    sum_fields_function *sum_fields;
} query_sea;

// Cells of a tile per metre of offset, the warp included: along the tile by x and y, across it by x and y.
typedef struct query_axes {
    _Alignas(64) float ux[QUERY_LANES], uy[QUERY_LANES], vx[QUERY_LANES], vy[QUERY_LANES];
} query_axes;

// Functions of the offset, value + gradient . offset: of the displacement, times choppiness and attenuation, and of the
// height.
typedef struct query_tangent {
    _Alignas(64) float x[QUERY_LANES], y[QUERY_LANES];
    float xx[QUERY_LANES], xy[QUERY_LANES], yx[QUERY_LANES], yy[QUERY_LANES];
} query_tangent;

typedef struct query_height_tangent {
    _Alignas(64) float value[QUERY_LANES], x[QUERY_LANES], y[QUERY_LANES];
} query_height_tangent;

// Sums over the cascades before query_sea.again.
typedef struct query_kept {
    query_tangent sum;
    query_height_tangent height;
} query_kept;

// Every array of 16 numbers fills whole cache lines.
typedef struct query_block {
    _Alignas(64) double x[QUERY_LANES], y[QUERY_LANES];                                       // asked points [m]
    int32_t cell_u[BOLAN_MAX_CASCADES][QUERY_LANES], cell_v[BOLAN_MAX_CASCADES][QUERY_LANES]; // their cells
    float part_u[BOLAN_MAX_CASCADES][QUERY_LANES], part_v[BOLAN_MAX_CASCADES][QUERY_LANES];   // and fractions, 0..1
    query_axes axes[BOLAN_MAX_CASCADES];
    float attenuation[BOLAN_MAX_CASCADES][QUERY_LANES];                                     // by shallow water, 0..1
    float lean_x[BOLAN_MAX_CASCADES][QUERY_LANES], lean_y[BOLAN_MAX_CASCADES][QUERY_LANES]; // its gradient [1/m]
    float ox[QUERY_LANES], oy[QUERY_LANES];                                       // rest point - asked point [m]
    float rx[QUERY_LANES], ry[QUERY_LANES];                                       // residual of (1) [m]
    float height[QUERY_LANES], slope_x[QUERY_LANES], slope_y[QUERY_LANES];        // at the rest point
    float jxx[QUERY_LANES], jxy[QUERY_LANES], jyx[QUERY_LANES], jyy[QUERY_LANES]; // Jacobian matrix of x0 -> x
    query_kept kept;
    bool settled[QUERY_LANES]; // the attenuation is the same all around
    const float *fade;         // of sums: 1 / (2 spacing) of each lane, for a grid of that spacing; NULL: no low-pass
    bool leans;                // a lane has a gradient of the attenuation
} query_block;

// The lanes that a kernel works on, a bit each.
#define QUERY_ALL_LANES 0xffffu

// The kernels of one instruction set. All sets give the same bits.
typedef struct query_kernels {
    // Sets cell and part from x and y. Lanes whose point is not finite get cell 0.
    void (*locate)(const query_sea *sea, query_block *block);
    // Offsets from 0 and heights by `guess` and `refine`, of `count` blocks, 1 .. QUERY_BLOCKS. `certain`: the lanes of
    // each whose answer is certain: little doubt, and no fold near. NULL where a sum has no cascades to read.
    void (*approach)(const query_sea *sea, query_block *blocks, uint32_t count, uint32_t *certain);
    // Residual, slopes and Jacobian matrix of the certain lanes of a block, after `approach`. NULL where that is.
    void (*surface)(const query_sea *sea, query_block *block);
    // Residual, height, slopes and Jacobian matrix at the present offsets.
    void (*evaluate)(const query_sea *sea, uint32_t lanes, query_block *block);
} query_kernels;

static inline float query_determinant(const query_block *b, uint32_t l) {
    return b->jxx[l] * b->jyy[l] - b->jxy[l] * b->jyx[l];
}

// Newton's step from what was evaluated, kept inside QUERY_MAX_OFFSET.
static inline void query_newton(query_block *block, uint32_t l) {
    const float rx = block->rx[l], ry = block->ry[l];
    const float det = query_determinant(block, l);
    // Near a fold the linear model does not say where the root is; there the plain fixed point x0 = x - D goes on.
    const bool regular = det > QUERY_REGULAR || det < -QUERY_REGULAR;
    const float inverse = 1.0f / (regular ? det : 1.0f);
    const float sx = regular ? (block->jyy[l] * rx - block->jxy[l] * ry) * inverse : rx;
    const float sy = regular ? (block->jxx[l] * ry - block->jyx[l] * rx) * inverse : ry;
    const float x = block->ox[l] - sx, y = block->oy[l] - sy;
    block->ox[l] = x > QUERY_MAX_OFFSET ? QUERY_MAX_OFFSET : x < -QUERY_MAX_OFFSET ? -QUERY_MAX_OFFSET : x;
    block->oy[l] = y > QUERY_MAX_OFFSET ? QUERY_MAX_OFFSET : y < -QUERY_MAX_OFFSET ? -QUERY_MAX_OFFSET : y;
}

// The kernels of a sum, which has its own for every instruction set inside (sums.c).
extern const query_kernels bolan_query_sum_kernels;
// The kernels for a sea made with `cpu`.
const query_kernels *bolan_query_kernels_for(bolan_cpu cpu);

// What all blocks of one batch share.
typedef struct query {
    query_sea sea;
    const query_kernels *kernels;
    const bolan_water *water;
    double time;                       // of the sea [s]
    float band_hs[BOLAN_MAX_CASCADES]; // significant height of each cascade [m]
    float hs;                          // of all cascades [m]
    float reach;                       // how far apart the roots of a fold may lie [m]
} query;

enum { QUERY_STEPS = 6, QUERY_SEARCH_STEPS = 10 };

void bolan_query_prepare(const bolan_water *water, query *out);
// Heights over the datum of `count` points, and their offsets, on the calling thread.
void bolan_query_rest_points(const query *q, const bolan_dvec2 *xy, uint32_t count, float *height, bolan_vec2 *offset);

// Newton steps from the present offsets until the lanes of `lanes` have converged, `steps` at most, each with the
// attenuation of the depth at its rest points; leaves them evaluated.
void bolan_query_solve(const query *q, uint32_t lanes, uint32_t steps, query_block *block);
// Puts `lanes` rest points into a block, to be evaluated where they are: offsets 0, with the attenuation there.
void bolan_query_open_block(const query *q, const bolan_dvec2 *rest, uint32_t lanes, query_block *block);
// Adds the layers at the rest points, to a block that was evaluated.
void bolan_query_add_layers(const query *q, query_block *block);
// Unit normal of the displaced surface at a lane that was evaluated, z >= 0.
bolan_vec3 bolan_query_normal(const query_block *block, uint32_t l);
// Copies what belongs to the place of lane `lane`, and its offset, into lane `l` of `to`.
void bolan_query_copy_place(const query *q, const query_block *from, uint32_t lane, query_block *to, uint32_t l);
// Unit vector along which the Jacobian matrix (xx, xy; xy, yy) compresses most: the eigenvector of the smaller
// eigenvalue.
bolan_vec2 bolan_query_compressed_direction(float xx, float yy, float xy);
// Where steps did not converge or the surface is about to fold: looks for every root near lane `lane` and puts the
// highest into the lane (all members). The block must have been evaluated.
void bolan_query_search_folds(const query *q, query_block *block, uint32_t lane);

#endif
