// SPDX-License-Identifier: MIT
// A terrain: a pyramid of height grids, smooth interpolation in it (heightfield.c), and the procedural detail below its
// spacing (detail.c).
//
//   level 0   o-o-o-o-o-o-o-o-o   the data
//   level 1   o---o---o---o---o   every second node, filtered 1-2-1 in both directions: nodes stay where they are
//   ...
//   blocks    [   8 x 8 cells  ]  lowest and highest node, for culling; again a pyramid
#ifndef BOLAN_SHORE_TERRAIN_H
#define BOLAN_SHORE_TERRAIN_H

#include "bolan/ground.h"

#define TERRAIN_LEVELS 16
#define TERRAIN_BLOCK 8u

typedef struct height_level {
    uint32_t width, height;
    double step_x, step_y;
    float *z;
} height_level;

typedef struct block_level {
    uint32_t width, height;
    float *low, *high;
} block_level;

struct bolan_ground {
    double west, south, east, north;
    double step;   // the coarser of the two spacings [m]
    double margin; // width of the blend outside the rim [m]
    float edge_elevation;
    float lowest, highest;
    double detail;
    double detail_wavelength; // longest wavelength of the detail [m]
    uint32_t seed;
    uint64_t id;
    uint32_t level_count, block_count;
    height_level level[TERRAIN_LEVELS];
    block_level block[TERRAIN_LEVELS];
};

// Elevation and gradient of the interpolated data.
typedef struct surface_point {
    float z, dx, dy;
} surface_point;

// The cubic patch of the last cell, one per level of the blend; regular grids reuse it.
typedef struct height_cursor {
    const bolan_ground *terrain;
    int64_t i[2], j[2];
    uint32_t level[2];
    float patch[2][16];
} height_cursor;

bolan_result bolan_heightfield_build(bolan_ground *t, const bolan_heightfield *field);
void bolan_heightfield_free(bolan_ground *t);
void bolan_height_cursor_start(height_cursor *c, const bolan_ground *t);
// The data alone, low-passed to @resolution [m]; outside the grid the rim blends to edge_elevation.
surface_point bolan_height_cursor_at(height_cursor *c, double x, double y, double resolution);

// Adds the detail to an interpolated point. @inside is 1 within the data and falls to 0 across the margin.
float bolan_detail_apply(const bolan_ground *t, surface_point base, double x, double y, double resolution,
                         float inside);
// One octave: where a point lies in its lattice, which is turned against the world.
typedef struct detail_lattice {
    double x, y; // lattice coordinates
    float c, s;  // cosine and sine of the turn
    float wavelength;
    uint32_t seed;
} detail_lattice;
// The height of the octave at a point whose gradient so far is (*dx, *dy), in world axes; adds the gradient of the
// octave.
float bolan_detail_octave(const detail_lattice *o, float slope, float gully, float rubble, float *dx, float *dy);
// No detail raises or lowers the ground by more than this [m].
float bolan_detail_bound(const bolan_ground *t);

float bolan_ground_inside(const bolan_ground *t, double x, double y);

#endif
