// SPDX-License-Identifier: MIT
/// @file query.h
/// Tier 2. Questions to the sea at fixed world points: the surface that is drawn, choppy displacement inverted.
#ifndef BOLAN_QUERY_H
#define BOLAN_QUERY_H

#include "bolan/math.h"
#include "bolan/shore.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bolan_query_point {
    float height;       ///< of the surface above mean sea level [m]
    bolan_vec3 normal;  ///< unit, up
    float jacobian;     ///< of the horizontal map
    float residual;     ///< horizontal distance between the asked and the found point [m]: < 1e-3 where the Jacobian > 0.2
} bolan_query_point;

/// Heights [m] of the surface over @p count world points [m]. Uses the task hook for large batches; thread-safe between
/// steps; allocates nothing. Points that are not finite give height 0.
void bolan_query_heights(const bolan_sea *sea, const bolan_dvec2 *xy, uint32_t count, float *height);
/// Heights and normals. @p terrain may be NULL (deep water); with it waves are attenuated by the depth at @p water_level
/// [m], exactly as they are drawn. Heights include @p water_level.
void bolan_query_surface(const bolan_sea *sea, const bolan_terrain *terrain, double water_level, const bolan_dvec2 *xy,
                         uint32_t count, bolan_query_point *out);

#ifdef __cplusplus
}
#endif
#endif
