// SPDX-License-Identifier: MIT
// The image behind the water, as shaded in air. Needs common/frame.glsl.
#pragma unit scene_color 3
#pragma unit scene_depth 4
uniform sampler2D scene_color;
uniform sampler2D scene_depth;

// The colour at a point of the image, and its eye-relative position; w = 0 where nothing was drawn.
vec4 behind(vec2 uv, out vec3 where) {
    float depth = textureLod(scene_depth, uv, 0.0).x;
    where = frame_ray(uv) / max(depth, 1e-9);
    return vec4(textureLod(scene_color, uv, 0.0).rgb, depth > 0.0 ? 1.0 : 0.0);
}

// Whether that point stands above the water, on the round earth.
bool is_dry(vec3 where) { return where.z + eye_height + dot(where.xy, where.xy) / (2.0 * earth_radius) > -0.3; }

// A place of the image for one that may lie outside: a little beyond its edges the image goes on mirrored, for more of
// the same bed lies there. Farther out, under deep water, that would be other land.
const float MIRRORED = 0.25; // of its size
vec2 within_image(vec2 uv) { return 1.0 - abs(1.0 - abs(clamp(uv, -MIRRORED, 1.0 + MIRRORED))); }
