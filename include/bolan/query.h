// SPDX-License-Identifier: MIT
/// @file query.h
/// Tier 2. Questions to the sea at fixed world points: the surface that is drawn, choppy displacement inverted.
#ifndef BOLAN_QUERY_H
#define BOLAN_QUERY_H

#include "bolan/ground.h"
#include "bolan/math.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The surface at one world point. Where choppy water folds, several parcels stand at the point: the answer is the highest of
/// those that are found.
typedef struct bolan_query_point {
    float height;      ///< of the surface above the scene's datum [m]
    bolan_vec3 normal; ///< unit, z >= 0
    float jacobian;    ///< of the horizontal map at the parcel found; below 0 the surface is folded
    float residual;    ///< horizontal distance between the point and the parcel [m]: < 1e-3 where the Jacobian > 0.2
} bolan_query_point;

/// Heights [m] of the surface above mean water over @p count world points @p xy [m] into @p height (count floats). The fields
/// are read as the picture reads them, bilinear between samples, so this is the surface that is drawn. A sum of waves
/// is summed at the point itself. Positions are reduced in double: 1e6 m from the origin is as good as near it. Points
/// that are not finite give 0. Uses the task hook for large batches; each answer depends on its point alone, so never
/// on batch, threads or instruction set. Thread-safe between steps of @p sea; allocates nothing; cannot fail.
void bolan_query_heights(const bolan_sea *sea, const bolan_dvec2 *xy, uint32_t count, float *height);
/// Heights and normals. @p terrain may be NULL (deep water). With it each cascade is attenuated, as it is drawn, by the
/// depth under the parcel's rest point at @p water_level [m above the datum]: bolan_coast_attenuations() of 4
/// sqrt(variance) of the cascades; a sum of waves is attenuated as one cascade. The lift of the mean falls with the
/// square of the attenuation. The normal ignores how the attenuation varies in space. Heights include @p water_level,
/// and points that are not finite give it. On dry land the answer is @p water_level: what is above it is terrain.
/// Otherwise like bolan_query_heights().
void bolan_query_surface(const bolan_sea *sea, const bolan_ground *terrain, double water_level, const bolan_dvec2 *xy,
                         uint32_t count, bolan_query_point *out);

#ifdef __cplusplus
}
#endif
#endif
