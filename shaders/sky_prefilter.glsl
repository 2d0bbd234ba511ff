// SPDX-License-Identifier: MIT
// One level of the environment map, blurred: a Gaussian of two of its texels, so that a look-up between the texels of
// even the coarsest level shows no grid (a plain mip chain would). Reads a plain mip chain of the same picture, one
// level finer.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
uniform sampler2D plain_map;
#pragma unit plain_map 15
uniform float level;
out vec4 color;

void main() {
    if (level < 0.5) {
        color = textureLod(plain_map, uv, 0.0);
        return;
    }
    float texel = exp2(level - 1.0) / 512.0, weights = 0.0; // of the level that is read
    vec3 sum = vec3(0.0);
    for (int i = -4; i < 4; ++i) {
        for (int j = -4; j < 4; ++j) {
            vec2 offset = 2.0 * vec2(float(i) + 0.5, float(j) + 0.5);
            float w = exp(-dot(offset, offset) / 32.0);
            sum += w * textureLod(plain_map, uv + offset * texel, level - 1.0).rgb;
            weights += w;
        }
    }
    color = vec4(sum / weights, 1.0);
}
#endif
