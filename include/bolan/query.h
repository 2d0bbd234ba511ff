// SPDX-License-Identifier: MIT
/// @file query.h
/// Tier 2. Surface height and normal at fixed world points: the surface that is drawn, choppy displacement inverted.
#ifndef BOLAN_QUERY_H
#define BOLAN_QUERY_H

#include "bolan/math.h"
#include "bolan/water.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The surface at one world point.
/// Where choppy water folds, several parcels stand at the point: the answer is the highest parcel that is found.
typedef struct bolan_query_point {
    /// Of the surface above the datum [m].
    float height;
    /// Unit normal, z >= 0.
    bolan_vec3 normal;
    /// Jacobian of the horizontal map at the parcel found; below 0 the surface is folded.
    float jacobian;
    /// Horizontal distance between the point and the parcel [m]: below 1e-3 where the Jacobian is above 0.2.
    float residual;
} bolan_query_point;

/// Heights and normals of @p count world points @p xy [m].
///
/// The fields of the sea are read as images read them, bilinear between samples, so this is the surface that is drawn.
/// A sum of waves is summed at the point itself. The layers of the water are added at the rest point of the parcel.
/// Over a ground each cascade is attenuated by the depth under the parcel's rest point, bolan_coast_attenuations() of
/// 4 sqrt(variance) of the cascades; a sum of waves is attenuated as one cascade, each layer by itself. The lift of the
/// mean falls with the square of the attenuation. The normal ignores how the attenuation varies in space.
/// On dry land the answer is the level of the water: what is above it is ground. Points that are not finite give the
/// level and a vertical normal.
///
/// Positions are reduced in double: 1e6 m from the origin is as good as near it. Each answer depends on its point alone,
/// never on batch, threads or instruction set.
/// Uses the task hook for large batches. Allocates nothing. Cannot fail; a water that is not valid is misuse.
/// Thread-safe between steps of the sea: to step it elsewhere meanwhile, query a fork of it (bolan_sea_fork()).
BOLAN_API void bolan_query_surface(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count,
                                   bolan_query_point *out);
/// Heights alone [m above the datum], count floats. Otherwise like bolan_query_surface().
BOLAN_API void bolan_query_heights(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *height);

#ifdef __cplusplus
}
#endif
#endif
