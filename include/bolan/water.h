// SPDX-License-Identifier: MIT
/// @file water.h
/// Tier 2. The water that queries read and the renderer draws, one plain struct of borrowed pointers.
/// Wave layers add waves to those of its sea.
#ifndef BOLAN_WATER_H
#define BOLAN_WATER_H

#include "bolan/flow.h"
#include "bolan/ground.h"
#include "bolan/optics.h"
#include "bolan/params.h"
#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- wave layers ----------------------------------------------------------------------------------------------------

/// Waves that are added to those of a sea: to heights and slopes, in queries and images alike.
/// A layer is a function of place and time; the time is that of the sea.
/// Immutable. Thread-safety: all reads may run at the same time.
typedef struct bolan_wave_layer bolan_wave_layer;

/// A wave train: parallel waves of one length inside an area, after the Wave Control packet of CIGI 3.3 and 4.0.
/// The height at (x, y) is height / 2 * edges * cos(k . (x - centre) - omega time + phase).
/// The edges fall from 1 to 0 as smooth steps.
/// The area stands still while the crests run through it.
/// Parcels move up and down only.
typedef struct bolan_wave_train_desc {
    /// Compass direction that the waves come FROM [deg], -360..360; default 0.
    double from_deg;
    /// Distance from crest to crest [m], 0.5..2000; default 100.
    double length;
    /// Time from crest to crest [s], 0.1..1000, or 0 (default): the period of free waves of this length, by dispersion.
    double period;
    /// Wave height from trough to crest [m], 0..40, and at most Miche's limit, 0.142 length tanh(2 pi depth / length);
    /// default 1.
    double height;
    /// Phase at the centre at time 0 [deg], -360..360; default 0: a crest.
    double phase_deg;
    /// Middle of the area in world metres, +-1e7; default (0, 0).
    bolan_dvec2 centre;
    /// Half extents of the area along and across the direction of travel [m], 1..1e7; default 1e7: everywhere.
    double half_length, half_width;
    /// Share of each half extent over which the edge falls, 0.01..1; default 0.5.
    double edge;
    /// Depth for dispersion and Miche's limit [m], 0.1..BOLAN_DEEP; default BOLAN_DEEP.
    double depth;
} bolan_wave_train_desc;
/// The defaults named above the fields.
/// Thread-safe.
BOLAN_API bolan_wave_train_desc bolan_wave_train_desc_default(void);
/// Ranges, defaults and help of the fields.
BOLAN_API extern const bolan_param_table bolan_wave_train_params;

/// Makes a layer of a wave train.
/// Errors: ARGUMENT (the sentence names the field, or the limit that the height exceeds), MEMORY.
/// @p out receives the layer, NULL after an error.
BOLAN_API bolan_result bolan_wave_layer_create_train(const bolan_wave_train_desc *desc, bolan_wave_layer **out);
/// Releases the layer.
/// NULL-safe; NULLs the pointer. No water may hold the layer any more.
BOLAN_API void bolan_wave_layer_destroy(bolan_wave_layer **layer);

/// A layer's waves at one place.
typedef struct bolan_wave_layer_sample {
    /// Added to the height of the surface [m].
    float height;
    /// Added to the slope of the surface, east and north.
    float slope_x, slope_y;
} bolan_wave_layer_sample;
/// Samples the waves of a layer over deep water at @p count places in world metres at @p time [s].
/// Thread-safe.
BOLAN_API void bolan_wave_layer_sample_at(const bolan_wave_layer *layer, double time, const bolan_dvec2 *places,
                                          uint32_t count, bolan_wave_layer_sample *out);
/// Returns a bound of the magnitude of the height [m].
/// Thread-safe.
BOLAN_API double bolan_wave_layer_bound(const bolan_wave_layer *layer);

/// Most wave layers of a water.
#define BOLAN_MAX_WAVE_LAYERS 8

// ---- the water ------------------------------------------------------------------------------------------------------

/// A water: its waves, its bed, its level and its colour.
/// It owns nothing; the objects that it points to must outlive its use.
/// Thread-safety: may be read by many threads between steps of its sea.
typedef struct bolan_water {
    /// The waves. Must not be NULL where the water is queried or drawn. Default NULL.
    const bolan_sea *sea;
    /// The flow of that sea, for questions about moving water. Default NULL: such questions are misuse.
    const bolan_flow *flow;
    /// The ground under the water. Default NULL: deep water everywhere.
    const bolan_ground *ground;
    /// Mean water level above the datum of the ground [m]; default 0.
    double level;
    /// Waves that are added to those of the sea: layer_count pointers, none NULL. Default NULL and 0.
    const bolan_wave_layer *const *layers;
    /// Number of layers, 0..BOLAN_MAX_WAVE_LAYERS.
    uint32_t layer_count;
    /// Colour, clarity and index of refraction; default Jerlov type IB.
    bolan_water_optics optics;
    /// Strength of the foam, 0..2; default 1.
    double foam;
} bolan_water;

/// The defaults named above the fields.
/// Thread-safe.
BOLAN_API bolan_water bolan_water_default(void);
/// Returns whether the water can be queried and drawn: it has a sea, and at most BOLAN_MAX_WAVE_LAYERS layers, none of
/// them NULL. Thread-safe.
BOLAN_API bool bolan_water_is_valid(const bolan_water *water);
/// Returns bounds that the surface does not leave [m]: those of bolan_sea_bounds() plus those of the layers.
/// Thread-safe.
BOLAN_API void bolan_water_bounds(const bolan_water *water, double *vertical, double *horizontal);

#ifdef __cplusplus
}
#endif
#endif
