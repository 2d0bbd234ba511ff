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
/// Read-only view of a model; valid while it lives.
typedef struct bolan_model_view {
    uint32_t vertex_count, index_count;
    const bolan_vec3 *positions; ///< [m]
    const bolan_vec3 *normals;   ///< unit
    const bolan_vec4 *colors;    ///< linear albedo rgb, 0..1; w: share of the sky that is open above, 0..1
    const uint32_t *indices;     ///< triangles, counter-clockwise from outside
} bolan_model_view;
/// Copies the view's arrays; indices beyond vertex_count are refused. Errors: ARGUMENT, MEMORY.
bolan_result bolan_model_create(const bolan_model_view *view, bolan_model **out);
/// A built-in model by name without "builtin:": the same on every machine. Errors: ARGUMENT (unknown name), MEMORY.
bolan_result bolan_model_create_builtin(const char *name, bolan_model **out);
/// Names of the built-in models; NULL past the last.
const char *bolan_model_builtin_name(uint32_t index);
/// NULL-safe; NULLs.
void bolan_model_destroy(bolan_model **model);
/// A number made of all its arrays: equal for equal models, different for others (64-bit hash). Thread-safe.
uint64_t bolan_model_id(const bolan_model *model);
/// The least and the greatest coordinates of its vertices [m]. Thread-safe.
void bolan_model_bounds(const bolan_model *model, bolan_vec3 *low, bolan_vec3 *high);
/// Its arrays. Thread-safe.
bolan_model_view bolan_model_get_view(const bolan_model *model);

#ifdef __cplusplus
}
#endif
#endif
