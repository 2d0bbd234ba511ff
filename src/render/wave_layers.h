// SPDX-License-Identifier: MIT
// Wave layers for shaders/common/layers.glsl.
#ifndef BOLAN_RENDER_WAVE_LAYERS_H
#define BOLAN_RENDER_WAVE_LAYERS_H

#include "bolan/water.h"
#include "water_block.h"

// The members of a uniform block that begin with layer_, for an eye in world metres; arrays of BOLAN_MAX_WAVE_LAYERS.
// Returns layer_count.
int bolan_wave_layers_fill(const bolan_water *water, bolan_dvec3 eye, bolan_vec4 *wave, bolan_vec4 *area,
                           bolan_vec4 *extent);

#endif
