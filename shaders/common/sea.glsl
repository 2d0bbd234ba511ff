// SPDX-License-Identifier: MIT
// The cascades of the sea as textures; twin of bolan_sea_sample_rest() in src/waves. Positions are eye-relative; each
// cascade's tile coordinates of the eye were reduced in double on the CPU.
#pragma unit displacement_map 8
uniform sampler2DArray displacement_map; // dx, dy, height
#ifndef PACKED
#pragma unit slope_map 9
uniform sampler2DArray slope_map; // slope x, slope y, dxx, dyy
#else
#pragma unit slope_map0 9
#pragma unit slope_map1 20
#pragma unit slope_map2 21
#pragma unit slope_map3 22
uniform sampler2D slope_map0; // slope, dxx + dyy, foam memory
uniform sampler2D slope_map1;
uniform sampler2D slope_map2;
uniform sampler2D slope_map3;
#endif
uniform int cascade_count;
uniform vec4 cascade_tile[4]; // xy: the eye in the tile [0,1), zw: cos(angle), sin(angle) over the side [1/m]
uniform vec4 cascade_band[4]; // x: significant height of the band [m], y: texel [m], z: longest wave [m], w: log2 of the texel
uniform float choppiness;

vec2 cascade_uv(int c, vec2 rest) {
    vec4 t = cascade_tile[c];
    return t.xy + vec2(rest.x * t.z + rest.y * t.w, rest.y * t.z - rest.x * t.w);
}
