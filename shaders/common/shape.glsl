// SPDX-License-Identifier: MIT
// The first texel of the kept shape of a pixel: where its waves are read, its rest point, its window depth. The optics
// that shade each pixel once write it by one shader and read it by another. Depth 0: no water. Needs common/waves.glsl.
//
// A rest point stands within SHIFT_MOST of its distance from where its waves are read, since all waves of the warp bend
// the plane by 6 * 0.036 at most. Two whole numbers of 12 bits hold the difference, each to 7e-5 of the distance: a
// tenth of a pixel of a picture 1000 pixels wide.
const float SHIFT_MOST = 0.28, SHIFT_STEPS = 2047.0, SHIFT_BASE = 4096.0;

vec4 shape_texel(vec2 rest, sea_place place, float depth) {
    vec2 shift = (rest - place.at) / (SHIFT_MOST * length(place.at) + 1e-6);
    vec2 code = floor(clamp(shift, -1.0, 1.0) * SHIFT_STEPS + (SHIFT_STEPS + 0.5));
    return vec4(place.at, code.x * SHIFT_BASE + code.y, depth);
}

vec2 shape_rest_point(vec4 texel) {
    float first = floor(texel.z / SHIFT_BASE);
    vec2 code = vec2(first, texel.z - first * SHIFT_BASE);
    return texel.xy + (code / SHIFT_STEPS - 1.0) * (SHIFT_MOST * length(texel.xy));
}
