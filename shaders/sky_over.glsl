// SPDX-License-Identifier: MIT
// The clouds below a high eye, laid over sea and land at the end of the picture. Peaks that stand above them stay
// clear.
#include "common/fullscreen.glsl"
#include "common/frame.glsl"
#ifdef VERTEX
out vec3 ray;
void main() {
    fullscreen(0.5);
    ray = frame_ray(uv);
}
#endif
#ifdef FRAGMENT
#include "common/atmosphere.glsl"
uniform sampler2D scene_depth; // of land and sea bed
#pragma unit scene_depth 4
uniform float rise; // of the eye since the map was made [m]
in vec3 ray;
out vec4 color;

const float MIDDLE = 400.0; // of the layer, above its base [m]

// The direction from the eye of the map to the same point of the middle of the layer, so that clouds stay in place
// while the eye moves.
vec3 from_map(vec3 dir, float h) {
    float b = (earth_radius + h) * dir.z, c = earth_shell(h, cloud_base + MIDDLE, earth_radius);
    float root = sqrt(max(b * b - c, 0.0)), d = c / max(root - b, 1.0); // nearest to it, where the ray passes over it
    return normalize(dir * d + vec3(cloud_offset, rise));
}

void main() {
    vec3 dir = normalize(ray);
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r, h = max(eye_height, 0.0);
    float land = depth > 0.0 ? air_height(h, dir.z, length(ray) / depth) : 0.0;
    float below = step(angle_above_horizon(dir, h), 0.0) * (1.0 - smoothstep(cloud_base, cloud_base + 300.0, land));
    color = textureLod(cloud_map, vec3(cloud_uv(from_map(dir, h), max(h - rise, 0.0)), 0.0), 0.0) * below;
}
#endif
