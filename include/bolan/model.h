// SPDX-License-Identifier: MIT
/// @file model.h
/// Tier 3. Triangle meshes with colours.
#ifndef BOLAN_MODEL_H
#define BOLAN_MODEL_H

#include "bolan/base.h"
#include "bolan/math.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A triangle mesh with colours, immutable. x right, y ahead, z up [m].
/// Thread-safety: all reads may run at the same time.
typedef struct bolan_model bolan_model;

/// The arrays of a model, read-only; valid while the model lives.
typedef struct bolan_model_view {
    /// Number of vertices, 3..67108864; number of indices, a multiple of 3 up to 67108864.
    uint32_t vertex_count, index_count;
    /// Positions of the vertices [m].
    const bolan_vec3 *positions;
    /// Unit normals of the vertices.
    const bolan_vec3 *normals;
    /// Linear albedo in x, y, z, 0..1; in w the share of the sky that is open above the vertex, 0..1.
    const bolan_vec4 *colors;
    /// Triangles, counter-clockwise from outside.
    const uint32_t *indices;
} bolan_model_view;

/// Makes a model of a copy of the arrays.
/// @param out receives the model; NULL on failure.
/// Errors: ARGUMENT (an index beyond the last vertex, a vertex that is not finite), MEMORY.
BOLAN_API bolan_result bolan_model_create(const bolan_model_view *view, bolan_model **out);

/// Releases the model.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_model_destroy(bolan_model **model);

/// A 64-bit hash of all arrays: equal for equal models.
/// Thread-safe.
BOLAN_API uint64_t bolan_model_id(const bolan_model *model);

/// The least and the greatest coordinates of the vertices [m].
/// Thread-safe.
BOLAN_API void bolan_model_bounds(const bolan_model *model, bolan_vec3 *low, bolan_vec3 *high);

/// The arrays of the model.
/// Thread-safe.
BOLAN_API bolan_model_view bolan_model_get_view(const bolan_model *model);

/// Which axis of a model file points up.
typedef enum bolan_up {
    /// y, as in OBJ and glTF: (x, y, z) of the file becomes (x, -z, y).
    BOLAN_UP_Y,
    /// z, as in files of geographic information systems: (x, y, z) stays.
    BOLAN_UP_Z,
} bolan_up;

#ifdef __cplusplus
}
#endif
#endif
