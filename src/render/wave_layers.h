// SPDX-License-Identifier: MIT
// Wave layers for shaders/common/layers.glsl.
#ifndef BOLAN_RENDER_WAVE_LAYERS_H
#define BOLAN_RENDER_WAVE_LAYERS_H

#include "bolan/water.h"
#include "water_block.h"

// Sets the members of the block that begin with layer_, for an eye in world metres.
void bolan_wave_layers_fill(water_block *block, const bolan_water *water, bolan_dvec3 eye);

#endif
