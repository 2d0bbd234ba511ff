// SPDX-License-Identifier: MIT
/// @file layer.h
/// A wave layer behind a table of functions. Private to the library.
///
/// A layer adds height and slope at *rest* points, like the cascades of a sea. The solver of the query has nothing to
/// invert for a layer, and shaders add it where they add a cascade. The bed attenuates each layer like a sea of its own
/// height: bolan_coast_attenuation().
#ifndef BOLAN_WATER_LAYER_H
#define BOLAN_WATER_LAYER_H

#include "bolan/water.h"

enum { LAYER_LANES = 16 }; // points of one call

/// The water under a layer's waves at one place: what flow_motion holds of a sea.
typedef struct wave_layer_flow {
    double vx, vy, vz, ax, ay, az;
    double potential; ///< pressure over -density [m2/s2]
} wave_layer_flow;

/// A kind of layer. All functions are pure and thread-safe.
typedef struct wave_layer_kind {
    /// Writes height and slopes at @p count <= LAYER_LANES places.
    void (*sample)(const bolan_wave_layer *layer, double time, uint32_t count, const double *x, const double *y,
                   bolan_wave_layer_sample *out);
    /// Writes the flow at the depth @p below, at rest [m].
    void (*flow)(const bolan_wave_layer *layer, double time, double x, double y, double below, wave_layer_flow *out);
} wave_layer_kind;

struct bolan_wave_layer {
    const wave_layer_kind *kind;
    double bound;                ///< of the height, up or down [m]
    float hs;                    ///< height by which the bed attenuates it [m]
    bolan_wave_train_desc train; ///< period filled in
    double kx, ky, omega, phase; ///< of the train [rad/m, rad/s, rad]
    double c, s;                 ///< unit direction of travel
};

#endif
