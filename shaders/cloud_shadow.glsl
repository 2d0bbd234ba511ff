// SPDX-License-Identifier: MIT
// Share of the sun that the low clouds let through to each point of a square of the sea round the eye.
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/clouds.glsl"
uniform vec2 strip; // of the map that is drawn now: its first u, its width
uniform float shadow_size;
out vec4 color;

const int STEPS = 14;

void main() {
    vec2 position = (vec2(strip.x + strip.y * uv.x, uv.y) - 0.5) * shadow_size;
    float up = max(sun_direction.z, 0.06), depth = 0.0, step_height = cloud_origin.z / float(STEPS);
    vec2 run = sun_direction.xy / up;
    for (int i = 0; i < STEPS; ++i) {
        float h = cloud_base + (float(i) + 0.5) * step_height;
        depth += cloud_extinction(position + run * h, h, 0.0) * step_height / up;
    }
    color = vec4(exp(-0.6 * depth)); // part of the light that is scattered forward arrives
}
#endif
