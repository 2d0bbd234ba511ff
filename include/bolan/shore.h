// SPDX-License-Identifier: MIT
/// @file shore.h
/// Tier 2. The ground under and beside the sea: elevation of land and sea bed, water depth, and what shallow water does to
/// waves.
#ifndef BOLAN_SHORE_H
#define BOLAN_SHORE_H

#include "bolan/base.h"
#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A regular grid of elevations in local metres. Sample (i, j) is at (west + i * step_x, south + j * step_y) and stands at
/// elevation[j * width + i] [m above mean sea level], row 0 in the south.
typedef struct bolan_heightfield {
    uint32_t width, height;  ///< 2..32768 each
    double west, south;      ///< position of sample (0, 0) [m east, north of the scene origin]
    double step_x, step_y;   ///< [m] > 0
    const float *elevation;
} bolan_heightfield;

typedef struct bolan_terrain_desc {
    bolan_heightfield field; ///< copied
    double detail;           ///< strength of the procedural detail below the grid's spacing, 0..2; default 1
    uint64_t seed;           ///< of the detail
    double edge_elevation;   ///< elevation far outside the grid [m]; the grid's rim blends to it; default -4000
} bolan_terrain_desc;

/// A generated volcanic island with a lagoon side: cliffs and rocks to windward, sandy bays and turquoise shallows to
/// leeward, reefs, and a deep sea bed beyond.
typedef struct bolan_island_desc {
    uint64_t seed;      ///< default 7
    double radius;      ///< of the land [m], 200..20000; default 2200
    double peak;        ///< height of the summit [m], 10..3000; default 620
    double sea_floor;   ///< elevation of the sea bed far out [m], < -20; default -900
    double lagoon_from_deg; ///< compass side where the sandy shallows lie [deg]; default 225
} bolan_island_desc;

typedef struct bolan_terrain bolan_terrain;

bolan_terrain_desc bolan_terrain_desc_default(void);
bolan_island_desc bolan_island_desc_default(void);
/// Errors: ARGUMENT, MEMORY. Immutable afterwards: reads are thread-safe.
bolan_result bolan_terrain_create(const bolan_terrain_desc *desc, bolan_terrain **out);
/// Generates the island deterministically from its desc (no data, same bits everywhere) and makes a terrain of it.
bolan_result bolan_terrain_create_island(const bolan_island_desc *desc, bolan_terrain **out);
/// NULL-safe; NULLs the pointer.
void bolan_terrain_destroy(bolan_terrain **terrain);

/// Elevation [m above mean sea level] at world (x, y) [m], with the detail whose wavelengths are above @p resolution [m]
/// (0: all of it). Continuous, finite everywhere.
float bolan_terrain_elevation(const bolan_terrain *terrain, double x, double y, double resolution);
/// The same at a regular grid of @p nx x @p ny points from (@p west, @p south) with @p step [m]: out[j * nx + i]. Uses the
/// task hook.
void bolan_terrain_elevations(const bolan_terrain *terrain, double west, double south, double step, uint32_t nx,
                              uint32_t ny, float *out);
/// Where the data are: west, south, east, north [m], and the lowest and highest elevation [m].
typedef struct bolan_terrain_extent { double west, south, east, north, lowest, highest, step; } bolan_terrain_extent;
bolan_terrain_extent bolan_terrain_get_extent(const bolan_terrain *terrain);

/// How much of its deep-water amplitude a wave band of significant height @p band_hs [m] keeps in @p depth [m] of water:
/// 1 in deep water, falling to 0 at the waterline so that the local height stays below the breaking limit (about 0.6 of the
/// depth). tanh form: f = tanh(0.6 depth / band_hs), 0 for depth <= 0. The shader twin is shaders/common/shore.glsl.
float bolan_shore_attenuation(float depth, float band_hs);

#ifdef __cplusplus
}
#endif
#endif
