// SPDX-License-Identifier: MIT
/// @file ground.h
/// Tier 2. The ground under and beside the sea: elevation of land and sea bed.
#ifndef BOLAN_GROUND_H
#define BOLAN_GROUND_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/params.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A regular grid of elevations in local metres. Sample (i, j) is at (west + i * step_x, south + j * step_y) and stands
/// at elevation[j * width + i] [m above mean sea level], row 0 in the south. All samples lie within +-1e8 m of the
/// origin.
typedef struct bolan_heightfield {
    uint32_t width, height; ///< 2..32768 each
    double west, south;     ///< position of sample (0, 0) [m east, north of the scene origin]
    double step_x, step_y;  ///< [m] 1e-3..1e7
    const float *elevation; ///< width * height values within +-1e6 m
} bolan_heightfield;

/// How a terrain is made of a grid.
typedef struct bolan_ground_desc {
    bolan_heightfield field; ///< copied
    double detail; ///< strength of the procedural detail below the grid's spacing, 0..2; default 1; 0: the data alone
    uint64_t seed; ///< of the detail; default 1
    double edge_elevation; ///< elevation far outside the grid [m], +-1e6; its rim blends to it; default -4000
} bolan_ground_desc;

/// A generated volcanic island with a lagoon side: a horseshoe of eroded peaks, cliffs and rock stacks to windward,
/// sandy bays between headlands to leeward, turquoise shallows 1-6 m deep behind a barrier reef with sand islets, and a
/// deep sea bed beyond. The land is centred on the scene origin.
typedef struct bolan_island_desc {
    uint64_t seed;          ///< default 7
    double radius;          ///< of the land [m], 200..20000; default 2200
    double peak;            ///< height of the summit [m], 10..3000; default 620
    double sea_floor;       ///< elevation of the sea bed far out [m], -11000..-20; default -900
    double lagoon_from_deg; ///< compass side where the sandy shallows lie [deg], -360..360; default 225
} bolan_island_desc;

/// The parameters of bolan_island_desc.
extern const bolan_param_table bolan_island_params;

/// Immutable ground: data, interpolated, with procedural detail below their spacing.
/// Thread-safety: all reads may run at the same time.
typedef struct bolan_ground bolan_ground;

/// The defaults named beside the fields, and no grid.
bolan_ground_desc bolan_ground_desc_default(void);
/// The defaults named beside the fields.
bolan_island_desc bolan_island_desc_default(void);
/// Makes a terrain of a grid. Between the nodes the data are interpolated by limited bicubic patches (C1, no overshoot;
/// Fritsch & Carlson 1980); below twice the spacing the detail adds ridges and gullies that run down the slopes of the
/// data.
/// @param out receives the terrain, NULL on failure. Errors: ARGUMENT (the sentence names the field), MEMORY.
bolan_result bolan_ground_create(const bolan_ground_desc *desc, bolan_ground **out);
/// Generates the island deterministically from its desc (no data, same bits everywhere) and makes a terrain of it.
/// Takes about a second; uses the task hook. Errors: ARGUMENT, MEMORY.
bolan_result bolan_ground_create_island(const bolan_island_desc *desc, bolan_ground **out);
/// The pond of the scene of that name: a basin 90 m across in a meadow, 0.4 to 4 m deep, with a sandy shelf in the
/// south. Errors: MEMORY.
bolan_result bolan_ground_create_pond(bolan_ground **out);
/// The elevation it is made of [m]; thread-safe.
float bolan_pond_elevation(double x, double y);
/// NULL-safe; NULLs the pointer.
void bolan_ground_destroy(bolan_ground **terrain);

/// Elevation [m above mean sea level] at world (x, y) [m] as a grid of spacing @p resolution [m] can carry it: the data
/// are low-passed where the spacing is coarser than theirs, and detail of a wavelength below twice the spacing is left
/// out (it fades in up to four times). 0: everything. Continuous in x, y and resolution, finite everywhere.
/// Thread-safe.
float bolan_ground_elevation(const bolan_ground *terrain, double x, double y, double resolution);
/// The same at a regular grid of @p nx x @p ny points from (@p west, @p south) with @p step [m], which is the
/// resolution too: out[j * nx + i]. Uses the task hook; equal to single calls for any number of threads. Thread-safe.
void bolan_ground_elevations(const bolan_ground *terrain, double west, double south, double step, uint32_t nx,
                             uint32_t ny, float *out);
/// Where the data are: west, south, east, north [m], the lowest and highest elevation of the data [m], and their
/// spacing [m] (the coarser of the two).
typedef struct bolan_ground_extent {
    double west, south, east, north, lowest, highest, step;
} bolan_ground_extent;
/// Of the data the terrain was made from. Thread-safe.
bolan_ground_extent bolan_ground_get_extent(const bolan_ground *terrain);
/// A number made of everything the terrain was created from: equal for equal terrains, different for others (64-bit
/// hash). Thread-safe.
uint64_t bolan_ground_id(const bolan_ground *terrain);
/// Bounds [m] that no elevation, at any resolution, inside the square of side @p size [m] from (@p west, @p south)
/// leaves. Not tight; costs a few look-ups, for culling. Thread-safe.
void bolan_ground_bounds(const bolan_ground *terrain, double west, double south, double size, float *lowest,
                         float *highest);

#ifdef __cplusplus
}
#endif
#endif
