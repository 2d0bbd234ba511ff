// SPDX-License-Identifier: MIT
// The uniform block of the water's passes.
layout(std140) uniform Water {
#include "shared/water_block.glsl"
};
