// SPDX-License-Identifier: MIT
// The bundle of a water, and the functions that all kinds of layers share.
#include "water/layer.h"

bolan_water bolan_water_default(void) {
    return (bolan_water){.optics = bolan_water_optics_from_jerlov(BOLAN_JERLOV_IB), .foam = 1.0};
}

bool bolan_water_is_valid(const bolan_water *water) {
    if (water == NULL || water->sea == NULL || water->layer_count > BOLAN_MAX_WAVE_LAYERS) return false;
    if (water->layer_count > 0 && water->layers == NULL) return false;
    for (uint32_t i = 0; i < water->layer_count; ++i)
        if (water->layers[i] == NULL) return false;
    return true;
}

void bolan_water_bounds(const bolan_water *water, double *vertical, double *horizontal) {
    bolan_sea_bounds(water->sea, vertical, horizontal);
    for (uint32_t i = 0; i < water->layer_count; ++i) *vertical += water->layers[i]->bound;
}

void bolan_wave_layer_destroy(bolan_wave_layer **layer) {
    if (layer == NULL || *layer == NULL) return;
    bolan_release(*layer, sizeof **layer);
    *layer = NULL;
}

double bolan_wave_layer_bound(const bolan_wave_layer *layer) { return layer->bound; }

void bolan_wave_layer_sample_at(const bolan_wave_layer *layer, double time, const bolan_dvec2 *places, uint32_t count,
                                bolan_wave_layer_sample *out) {
    BOLAN_ASSERT(layer && (count == 0 || (places && out)));
    double x[LAYER_LANES], y[LAYER_LANES];
    for (uint32_t first = 0; first < count; first += LAYER_LANES) {
        const uint32_t lanes = count - first < LAYER_LANES ? count - first : LAYER_LANES;
        for (uint32_t i = 0; i < lanes; ++i) x[i] = places[first + i].x, y[i] = places[first + i].y;
        layer->kind->sample(layer, time, lanes, x, y, out + first);
    }
}
