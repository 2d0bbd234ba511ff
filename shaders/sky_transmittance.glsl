// SPDX-License-Identifier: MIT
// Table: optical depth of the air from a height along a zenith angle to space (common/air.glsl, transmittance_uv).
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/air.glsl"
out vec4 color;

const int STEPS = 60;

void main() {
    float h, mu;
    transmittance_ray(uv, h, mu);
    float reach = distance_to_top(h, mu);
    // Where the ray comes lowest the air is densest: steps grow from there to both sides.
    float low = clamp(-(earth_radius + h) * mu, 0.0, reach), share = low / reach;
    vec3 depth = vec3(0.0);
    for (int side = 0; side < 2; ++side) {
        float span = side == 0 ? low : reach - low, direction = side == 0 ? -1.0 : 1.0, start = 0.0;
        if (span < 1.0) continue;
        for (int i = 0; i < STEPS; ++i) {
            float s = float(i + 1) / float(STEPS), end = span * s * s;
            float height = max(air_height(h, mu, low + direction * 0.5 * (start + end)), 0.0);
            depth += air_extinction(air_density(height)) * (end - start);
            start = end;
        }
    }
    color = vec4(depth, 1.0);
}
#endif
