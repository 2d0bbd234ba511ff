// SPDX-License-Identifier: MIT
/// @file tiles.h
/// Tier 2. Looping sequences of textures baked from a sea, for the two-triangle technique.
/// A frame has heights, a normal map, the water's own texture, and caustics (Ma, Zhu & Gong 2006, sections 2.3 and 3).
///
/// Every tile is a periodic square of n x n texels.
/// Texel (i, j) is at [j * n + i] and stands at tile coordinates (i, j) * length / n, as in the cascade it was baked
/// from.
#ifndef BOLAN_TILES_H
#define BOLAN_TILES_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How tiles are made.
typedef struct bolan_tiles_desc {
    /// Normal maps as the paper prints them, twice as steep as the water; default false.
    bool paper;
    /// Factor on the slopes of the normal maps, 0.01..100; default 1.
    double bump;
    /// Colour of the water's own texture, linear, each component 0..1; default a dark green-blue.
    bolan_vec3 color;
    /// Unit direction to the sun, z > 0; default straight up.
    bolan_vec3 sun;
    /// Depth of the bottom that receives the caustics, under mean water [m], 0.05..200; default 0.
    /// 0: the depth where these waves focus the light best, at most 2 m. Raised beyond it: the caustics blur.
    double depth;
    /// Refractive index of the water, 1.01..3; default 1.34.
    double index;
} bolan_tiles_desc;
/// The defaults named above the fields.
/// Thread-safe.
BOLAN_API bolan_tiles_desc bolan_tiles_desc_default(void);

/// Scale of a byte of a caustics tile: irradiance of the bottom = value * BOLAN_CAUSTICS_RANGE / 255.
/// 1 is the irradiance under flat water; brighter values are clipped.
#define BOLAN_CAUSTICS_RANGE 4.0

/// A sequence of tiles, immutable.
/// Thread-safety: all reads may run at the same time.
typedef struct bolan_tiles bolan_tiles;

/// A read-only view of tiles; valid while they live.
typedef struct bolan_tiles_view {
    /// Texels along a side, 8..1024.
    uint32_t n;
    /// Frames of the loop, 1..BOLAN_MAX_LOOP_FRAMES.
    uint32_t frames;
    /// Side of the tile [m].
    double length;
    /// Angle of the tile against the world, counter-clockwise [rad]; see bolan_cascade_view.
    double angle;
    /// Period of the loop [s].
    double period;
    /// Depth of the bottom that receives the caustics [m].
    double depth;
    /// The normal maps are as the paper prints them.
    bool paper;
    /// Heights: frames x n x n [m].
    const float *height;
    /// Normal maps: frames x n x n x 3 bytes, unit normal * 127.5 + 127.5.
    const uint8_t *normal;
    /// The water's own texture, linear: frames x n x n x 3 bytes. Its mean is half of its brightest channel.
    const uint8_t *detail;
    /// Caustics: frames x n x n bytes.
    const uint8_t *caustics;
} bolan_tiles_view;

/// Bakes the tiles of every frame of a sea of BOLAN_WAVES_TEXTURES.
/// The sea is stepped through its loop and back to its time.
/// Uses the task hook.
/// @param out receives the tiles; NULL on failure.
/// Errors: ARGUMENT (the sentence names the field; or the sea has another wave model), MEMORY.
BOLAN_API bolan_result bolan_tiles_bake(bolan_sea *sea, const bolan_tiles_desc *desc, bolan_tiles **out);

/// Makes tiles of a copy of the arrays of a view, for example from files.
/// Errors: ARGUMENT, MEMORY.
BOLAN_API bolan_result bolan_tiles_create(const bolan_tiles_view *view, bolan_tiles **out);

/// Releases the tiles.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_tiles_destroy(bolan_tiles **tiles);

/// The arrays of the tiles.
/// Thread-safe.
BOLAN_API bolan_tiles_view bolan_tiles_get_view(const bolan_tiles *tiles);

/// The frame of the loop at @p time [s].
/// @param share receives the weight of the next frame, 0..1.
/// Thread-safe.
BOLAN_API uint32_t bolan_tiles_frame(const bolan_tiles *tiles, double time, double *share);

/// Normal map of a periodic n x n height tile.
/// T1 = (1, 0, s (h[x+1] - h[x-1])), T2 = (0, 1, s (h[y+1] - h[y-1])), N = T1 x T2; bytes N/|N| * 127.5 + 127.5.
/// @param s factor on the differences [1/m]. The paper has 1 / texel size.
/// The true slope has half of that, since a difference spans two texels.
/// @param rgb receives 3 n n bytes.
/// Thread-safe.
/// Source: Ma, Zhu & Gong 2006, section 2.3 (3).
BOLAN_API void bolan_tile_normals(const float *height, uint32_t n, double s, uint8_t *rgb);

/// Caustics on a flat bottom under a periodic n x n height tile, relative to flat water: the mean is 1.
/// Sunlight is refracted at each texel; the triangles between the points where it lands carry its light there.
/// Folded triangles count too. The shift of the whole pattern by a low sun is removed.
/// @param length side of the tile [m].
/// @param depth depth of the bottom under the mean of the tile [m].
/// @param sun unit direction to the sun.
/// @param index refractive index of the water.
/// @param light receives n n floats.
/// Thread-safe.
BOLAN_API void bolan_tile_caustics(const float *height, uint32_t n, double length, double depth, bolan_vec3 sun,
                                   double index, float *light);

#ifdef __cplusplus
}
#endif
#endif
