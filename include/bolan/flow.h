// SPDX-License-Identifier: MIT
/// @file flow.h
/// Tier 2. The flow of a sea: what linear theory says of the water under its waves, at one time.
///
/// **What it is.** The flow of a linear wave is that of a potential. With h(k, t) the mode of the sea (waves.h), d >= 0
/// the depth of a point at rest below the mean level and H the depth of the sea, the potential of displacement is
///
///     Phi = sum of h(k, t) / k cosh k(H - d) / sinh kH e^{i k.x},                                                  (1)
///
/// in deep water cosh / sinh is e^{-kd}. Displacement is grad Phi, velocity grad dPhi/dt, acceleration grad d2Phi/dt2,
/// dynamic pressure -density d2Phi/dt2 (Lamb 1932, section 229; Dean & Dalrymple 1991, section 3.4). At d = 0 the
/// displacement is that of the sea's own fields.
///
/// **How it is stored.** The potential of each cascade is synthesised at four depths: 0, and three others chosen for
/// the band of the cascade. The potential at any other depth is a combination of the four, whose weights are a least
/// squares fit of e^{-kd} over the band, weighted by the energy of its modes. Between samples the potential is a cubic
/// B-spline, whose transfer is divided out of the modes. Against the direct sum the error of velocity, acceleration and
/// pressure is below 1 % of their root mean square at the surface, at every depth (tests/physics/test_below.c). A sum
/// of waves is summed wave by wave.
///
/// **Order 2.** The flow of a sea of order 2 (bolan_sea_desc.order) has the potentials that belong to its bound waves,
/// those of Sharma & Dean (1981), in any depth. Waves of a cascade make Q = -d/dt |u|^2 - eta d/dz (g phi_z + phi_tt)
/// at z = 0; its sums and differences, of wave vector K and frequency W, make phi2 = Q / (g K tanh KH - W^2), with cosh
/// K(H + z) below. The products are exact; the divisor is a least squares fit over the pairs of waves of each K. Short
/// cascades are read where the longer ones have carried them, which is what theory has for waves of very different
/// length, and holds where its expansion fails. Velocity is grad phi, acceleration its rate for the parcel, -grad of
/// pressure / density, and pressure / density -phi_t - |grad phi|^2 / 2.
/// The mean velocity at a fixed point is 0: parcels drift (Stokes), and water returns under the groups of waves. The
/// mean of the dynamic pressure is -density times that of the square of the vertical velocity.
/// Against the sum over all pairs, for waves of Hs 3 m and 8 s in 12 m of water and deeper, the error is below 1 % of
/// the values of first order at the surface, at every depth, and below 18 % of the velocity that order 2 adds there
/// (tests/physics/test_below_second.c). A cascade of less than 0.2 % of the velocity has none. Waves and pairs of
/// indices beyond 85 of the longest cascade, 42 of a shorter one, are left out.
///
/// **Memory and time.** A sample takes 64 bytes. The last cascade has twice as many samples a side, because its
/// shortest waves span few samples: four cascades of 256 take 36 MB, and bolan_flow_size() returns the exact figure. A
/// step costs several steps of the sea. A question costs most at the surface, where every cascade is read, and least at
/// depths where only long waves are left. With order 2 the longest cascade takes 14 MB more and the others 2 MB each,
/// and a step 24 complex FFTs more for each cascade, of 256 x 256 for the longest and of 128 x 128 for the others: four
/// times as long in all, of four cascades of 128. A question takes three to six times as long. Order 1 pays nothing.
#ifndef BOLAN_FLOW_H
#define BOLAN_FLOW_H

#include "bolan/base.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The density by which pressures are computed, sea water at 15 degrees [kg/m3].
#define BOLAN_SEA_WATER_DENSITY 1026.0

/// The water under the waves of one sea at one time.
typedef struct bolan_flow bolan_flow;

/// Creates the flow of a sea, at the time of the sea, and reserves all memory.
/// The flow keeps nothing of @p sea, which may be destroyed before it.
/// Uses the task hook. Errors: MEMORY. Then *out is NULL.
/// Thread-safe between steps of the sea.
BOLAN_API bolan_result bolan_flow_create(const bolan_sea *sea, bolan_flow **out);
/// NULL-safe; NULLs.
BOLAN_API void bolan_flow_destroy(bolan_flow **flow);

/// Brings the flow to the time of @p sea, which is the sea of its creation or a fork of it.
/// A step to the time at which the flow stands does nothing. Allocates nothing. Uses the task hook. Never fails.
/// Queries must not run meanwhile.
BOLAN_API void bolan_flow_step(bolan_flow *flow, const bolan_sea *sea);
/// The time of the flow [s]. Thread-safe between steps.
BOLAN_API double bolan_flow_time(const bolan_flow *flow);
/// The number of the sea that the flow belongs to: bolan_sea_id(). Thread-safe.
BOLAN_API uint64_t bolan_flow_sea_id(const bolan_flow *flow);
/// Bytes that the flow holds. Thread-safe.
BOLAN_API size_t bolan_flow_size(const bolan_flow *flow);

#ifdef __cplusplus
}
#endif
#endif
