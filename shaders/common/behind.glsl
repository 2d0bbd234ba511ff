// SPDX-License-Identifier: MIT
// The picture behind the water, as lit in air. Needs common/frame.glsl.
#pragma unit scene_color 3
#pragma unit scene_depth 4
uniform sampler2D scene_color;
uniform sampler2D scene_depth;

// The colour at a place of the picture, and where it is, eye-relative; w = 0 where there is nothing.
vec4 behind(vec2 uv, out vec3 where) {
    float depth = textureLod(scene_depth, uv, 0.0).x;
    where = frame_ray(uv) / max(depth, 1e-9);
    return vec4(textureLod(scene_color, uv, 0.0).rgb, depth > 0.0 ? 1.0 : 0.0);
}
