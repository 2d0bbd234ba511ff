// SPDX-License-Identifier: MIT
/// @file tiles.h
/// Tier 2. Looping sequences of textures made from a sea, from which the two-triangle technique draws all of its water: heights, normal
/// maps, the water's own colour, and the light that the waves gather on the bottom (Ma, Zhu & Gong 2006, sections 2.3 and 3).
///
/// Every tile is a periodic square of n x n texels: texel (i, j) is at [j * n + i], at tile coordinates (i, j) * length / n, as the
/// cascade of the sea that it was made from.
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
    bool paper;       ///< normal maps as the paper prints them, twice as steep as the water; default false
    double bump;      ///< factor on the slopes of the normal maps, 0.01..100; default 1
    bolan_vec3 color; ///< of the water's own texture, linear, each 0..1; default a dark green-blue
    bolan_vec3 sun;   ///< unit direction to the sun, z > 0; default straight up
    double
        depth; ///< of the bottom under the mean water that the light is gathered on [m], 0.05..200; 0 (default): where these
               ///< waves draw the clearest net of light, at most 2 m down. Deeper the net falls apart into a blur
    double index; ///< of refraction of the water, 1.01..3; default 1.34
} bolan_tiles_desc;
/// The defaults named beside the fields. Thread-safe.
bolan_tiles_desc bolan_tiles_desc_default(void);

/// Brightness of the bottom that a byte of a caustics tile stands for: value * BOLAN_CAUSTICS_RANGE / 255, where 1 is the light
/// under flat water; what is brighter is cut.
#define BOLAN_CAUSTICS_RANGE 4.0

/// A sequence of tiles, immutable. Thread-safety: all reads may run at the same time.
typedef struct bolan_tiles bolan_tiles;

/// Read-only view of them; valid while they live.
typedef struct bolan_tiles_view {
    uint32_t n;            ///< texels of a side, 8..1024
    uint32_t frames;       ///< of the loop, 1..BOLAN_MAX_LOOP_FRAMES
    double length;         ///< side [m]
    double angle;          ///< of the tile against the world, counter-clockwise [rad]; see bolan_cascade_view
    double period;         ///< of the loop [s]
    double depth;          ///< that the light was gathered at [m]
    bool paper;            ///< the normal maps are as the paper prints them
    const float *height;   ///< frames x n x n [m]
    const uint8_t *normal; ///< frames x n x n x 3: unit normal * 127.5 + 127.5
    const uint8_t
        *detail; ///< frames x n x n x 3: the water's own texture, linear; its mean is half of its brightest channel
    const uint8_t *caustics; ///< frames x n x n
} bolan_tiles_view;

/// Makes the tiles of every frame of a sea of BOLAN_WAVES_TEXTURES: steps it through its loop and back to where it stood. Uses the
/// task hook. Errors: ARGUMENT (field named in the log; a sea of another model), MEMORY; then *out is NULL.
bolan_result bolan_tiles_bake(bolan_sea *sea, const bolan_tiles_desc *desc, bolan_tiles **out);
/// Copies the arrays of a view, such as a reader of files has. Errors: ARGUMENT, MEMORY.
bolan_result bolan_tiles_create(const bolan_tiles_view *view, bolan_tiles **out);
/// NULL-safe; NULLs.
void bolan_tiles_destroy(bolan_tiles **tiles);
/// Its arrays. Thread-safe.
bolan_tiles_view bolan_tiles_get_view(const bolan_tiles *tiles);
/// Place in the loop at @p time [s]: frame and the share, 0..1, of the next one. Thread-safe.
uint32_t bolan_tiles_frame(const bolan_tiles *tiles, double time, double *share);

/// Normal map of a periodic n x n height tile: T1 = (1, 0, s (h[x+1] - h[x-1])), T2 = (0, 1, s (h[y+1] - h[y-1])), N = T1 x T2,
/// as rgb bytes N/|N| * 127.5 + 127.5. The paper has s = 1 / texel size; the true slope is half of that, as the difference spans
/// two texels. @p rgb: 3 n n bytes. Thread-safe. Source: Ma, Zhu & Gong 2006, section 2.3 (3).
void bolan_tile_normals(const float *height, uint32_t n, double s, uint8_t *rgb);
/// Light on a flat bottom @p depth [m] under the mean of a periodic n x n height tile of side @p length [m], as a share of what flat water
/// lets through: its mean is 1. Sunlight from @p sun is refracted at each texel; the triangles between the points where it lands
/// carry their light there, folded ones too. The shift of the whole pattern by a low sun is taken off. @p light: n n floats.
/// Thread-safe.
void bolan_tile_caustics(const float *height, uint32_t n, double length, double depth, bolan_vec3 sun, double index,
                         float *light);

#ifdef __cplusplus
}
#endif
#endif
