// SPDX-License-Identifier: MIT
// Wave layers in the uniform block of the water: phases and places at the eye, reduced in double.
#include "wave_layers.h"

#include "water/layer.h"

#include <math.h>

_Static_assert(sizeof((water_block *)0)->layer_wave / sizeof(vec4) == BOLAN_MAX_WAVE_LAYERS, "a place for every layer");

int bolan_wave_layers_fill(const bolan_water *water, bolan_dvec3 eye, bolan_vec4 *wave, bolan_vec4 *area,
                           bolan_vec4 *extent) {
    if (water->layer_count == 0) return 0;
    const double time = bolan_sea_time(water->sea);
    for (uint32_t i = 0; i < water->layer_count; ++i) {
        const bolan_wave_layer *w = water->layers[i];
        const bolan_wave_train_desc *d = &w->train;
        const double x = d->centre.x - eye.x, y = d->centre.y - eye.y;
        const double phase = remainder(w->phase - w->kx * x - w->ky * y - w->omega * time, 2.0 * BOLAN_PI);
        wave[i] = (bolan_vec4){(float)w->kx, (float)w->ky, (float)w->bound, (float)phase};
        area[i] = (bolan_vec4){(float)x, (float)y, (float)w->c, (float)w->s};
        extent[i] = (bolan_vec4){(float)(1.0 / d->half_length), (float)(1.0 / d->half_width), (float)d->edge, w->hs};
    }
    return (int)water->layer_count;
}
