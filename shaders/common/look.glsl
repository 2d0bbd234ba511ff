// SPDX-License-Identifier: MIT
// Which effects are on: bolan_look for the shaders, in the block Water.
#include "common/water_block.glsl"
#include "shared/constants.glsl"

bool effect_is_on(int effect) { return (look_effects & effect) != 0; }
