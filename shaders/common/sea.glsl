// SPDX-License-Identifier: MIT
// The cascades of the sea as textures; twin of bolan_sea_sample_rest() in src/waves. Positions are eye-relative; each
// cascade's tile coordinates of the eye were reduced in double on the CPU. src/waves/cascades/spline.h says what is in
// the texels: displacements are read by cubic splines, their derivatives linearly.
#include "shared/cascade.glsl"
#include "shared/warp.glsl"
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

// The warped plane that the tiles are read over (bolan/waves.h). Each wave of the warp moves water across its own
// direction, so the gradient has no divergence. Smooth over hundreds of metres: vertices compute it, and pixels
// interpolate.
sea_place place_of(vec2 rest) {
    sea_place p = sea_place(rest - warp_at_eye, vec3(0.0));
    for (int i = 0; i < warp_count; ++i) {
        vec4 wave = warp_wave_of[i];
        float turn = fract(dot(wave.xy, rest) + wave.z);
        vec2 across = vec2(-wave.y, wave.x) * wave.w; // metres a unit of the wave
        p.at += across * warp_wave(turn);
        p.bend += warp_slope(turn) * across.xxy * wave.xyx;
    }
    return p;
}

// The gradient over rest points of what has that gradient over the plane.
vec2 unwarped(sea_place p, vec2 gradient) {
    vec3 b = p.bend;
    return gradient + vec2(dot(gradient, b.xz), gradient.x * b.y - gradient.y * b.x);
}

vec2 cascade_uv(int c, vec2 at) {
    vec4 t = cascade_tile[c];
    return t.xy + vec2(along_tile(at.x, at.y, t.z, t.w), across_tile(at.x, at.y, t.z, t.w));
}

// dx, dy, height at full resolution by a cubic spline: of each two samples a linear fetch gives the weighted mean (Sigg
// & Hadwiger 2005).
vec3 cascade_spline(int c, vec2 uv) {
    float n = float(textureSize(displacement_map, 0).x);
    vec2 at = uv * n - 0.5, t = fract(at), r = 1.0 - t;
    vec2 w0 = r * r * r / 6.0, w3 = t * t * t / 6.0, w1 = t * t * (0.5 * t - 1.0) + 2.0 / 3.0, high = 1.0 - w0 - w1;
    vec2 low = w0 + w1, first = (at - t - 0.5 + w1 / low) / n, last = (at - t + 1.5 + w3 / high) / n;
    float layer = float(c);
    vec3 south = mix(textureLod(displacement_map, vec3(last.x, first.y, layer), 0.0).xyz,
                     textureLod(displacement_map, vec3(first, layer), 0.0).xyz, low.x);
    vec3 north = mix(textureLod(displacement_map, vec3(last, layer), 0.0).xyz,
                     textureLod(displacement_map, vec3(first.x, last.y, layer), 0.0).xyz, low.x);
    return mix(north, south, low.y);
}

vec3 cascade_displacement(int c, vec2 uv, float lod) {
    vec3 coarse = lod > 0.0 ? textureLod(displacement_map, vec3(uv, float(c)), max(lod, 1.0)).xyz : vec3(0.0);
    return lod < 1.0 ? mix(cascade_spline(c, uv), coarse, lod) : coarse;
}

#ifdef BOUND_WAVES
// Bound waves of second order, twins of add_bound() in src/waves/cascades/sample.c. `longer`: the weighted sums of dx,
// dy, height over the longer cascades, which come first; d: those of cascade c.
float bound_height(int c, vec3 d, inout vec3 longer) {
    vec4 w = cascade_bound[c];
    float height = dot(d, w.yyx * d + longer);
    longer += w.wwz * d;
    return height;
}

// The slope, from the cascade's slope and the derivatives xx, yy, xy of its displacement; likewise summed over the
// longer cascades.
struct bound_slopes {
    vec2 slope;
    vec3 longer;
    vec2 longer_slope;
    vec3 longer_bend;
};

vec2 bent(vec3 bend, vec2 d) { return vec2(bend.x * d.x + bend.z * d.y, bend.z * d.x + bend.y * d.y); }

void add_bound_slope(int c, vec3 d, vec2 slope, vec3 bend, inout bound_slopes b) {
    vec4 w = cascade_bound[c];
    vec3 all = 2.0 * w.yyx * d + b.longer;
    b.slope += slope * all.z + bent(bend, all.xy) + b.longer_slope * d.z + bent(b.longer_bend, d.xy);
    b.longer += w.wwz * d;
    b.longer_slope += w.z * slope;
    b.longer_bend += w.w * bend;
}
#endif

// The level of derivatives for a pixel whose width in texels has that log2. Linear fetches of the finest level lose
// nothing; a pixel of one texel should lose a little.
float derivative_level(float width) { return max(width, 0.25 * width + 0.25); }
