// SPDX-License-Identifier: MIT
// The cascades of the sea as textures; twin of bolan_sea_sample_rest() in src/waves. Positions are eye-relative; each
// cascade's tile coordinates of the eye were reduced in double on the CPU.
#include "shared/cascade.glsl"
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

// Share of the amplitude that depth leaves of each cascade.
#ifdef LAND
vec4 cascades_kept(float depth) {
    return coast_attenuations(depth, vec4(cascade_band[0].x, cascade_band[1].x, cascade_band[2].x, cascade_band[3].x));
}
#else
vec4 cascades_kept(float depth) { return vec4(1.0); }
#endif

float lift_of(int c, float spacing) {
    float at = clamp(log2(spacing) - cascade_band[c].w + 2.0, 0.0, 12.0);
    int i = int(min(at, 11.0));
    return mix(cascade_lift[i][c], cascade_lift[i + 1][c], at - float(i));
}

vec2 cascade_uv(int c, vec2 rest) {
    vec4 t = cascade_tile[c];
    return t.xy + vec2(along_tile(rest.x, rest.y, t.z, t.w), across_tile(rest.x, rest.y, t.z, t.w));
}
