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
in vec3 ray;
out vec4 color;

void main() {
    vec3 dir = normalize(ray);
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r, h = max(eye.z, 0.0);
    float land = depth > 0.0 ? air_height(h, dir.z, length(ray) / depth) : 0.0;
    float below = step(angle_above_horizon(dir, h), 0.0) * (1.0 - smoothstep(haze.y, haze.y + 300.0, land));
    color = cloud_radiance(dir) * below;
}
#endif
