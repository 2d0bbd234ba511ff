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

#ifdef LAND
// Derivatives by the plane's axes of what depth leaves of the amplitude of each cascade.
struct cascades_lean {
    vec4 x, y;
};

bool is_leaning(float depth) { return shore_present == 1 && feels_bed(depth, significant_height); }

// Where the depth changes, so do the amplitudes, and that leans the water. Twin of add_lean() in
// src/query/block.kernel.c.
cascades_lean cascades_lean_at(vec2 rest, sea_place place, float depth) {
    vec4 by_depth = (cascades_kept(depth + LEAN_STEP) - cascades_kept(depth - LEAN_STEP)) / (2.0 * LEAN_STEP);
    vec2 fall = shore_fall(rest);
    fall = 2.0 * fall - unwarped(place, fall); // along the axes of the plane, where the bend is small
    return cascades_lean(by_depth * fall.x, by_depth * fall.y);
}
#endif

vec2 cascade_uv(int c, vec2 at) {
    vec4 t = cascade_tile[c];
    return t.xy + vec2(along_tile(at.x, at.y, t.z, t.w), across_tile(at.x, at.y, t.z, t.w));
}

// dx, dy, height at full resolution by a cubic spline: of each two samples a linear fetch gives the weighted mean (Sigg
// & Hadwiger 2005).
vec3 spline_of(sampler2DArray map, int c, vec2 uv) {
    float n = float(textureSize(map, 0).x);
    vec2 at = uv * n - 0.5, t = fract(at), r = 1.0 - t;
    vec2 w0 = r * r * r / 6.0, w3 = t * t * t / 6.0, w1 = t * t * (0.5 * t - 1.0) + 2.0 / 3.0, high = 1.0 - w0 - w1;
    vec2 low = w0 + w1, first = (at - t - 0.5 + w1 / low) / n, last = (at - t + 1.5 + w3 / high) / n;
    float layer = float(c);
    vec3 south = mix(textureLod(map, vec3(last.x, first.y, layer), 0.0).xyz,
                     textureLod(map, vec3(first, layer), 0.0).xyz, low.x);
    vec3 north = mix(textureLod(map, vec3(last, layer), 0.0).xyz,
                     textureLod(map, vec3(first.x, last.y, layer), 0.0).xyz, low.x);
    return mix(north, south, low.y);
}

vec3 cascade_spline(int c, vec2 uv) { return spline_of(displacement_map, c, uv); }

// Weights of four samples around the fraction t of a cell, and their derivatives by t: src/waves/cascades/spline.h.
vec4 spline_weights(float t) {
    float r = 1.0 - t;
    return vec4(r * r * r, t * t * (3.0 * t - 6.0) + 4.0, r * r * (3.0 * r - 6.0) + 4.0, t * t * t) / 6.0;
}
vec4 spline_slopes(float t) {
    float r = 1.0 - t;
    return vec4(-0.5 * r * r, t * (1.5 * t - 2.0), r * (2.0 - 1.5 * r), 0.5 * t * t);
}

vec3 cascade_displacement(int c, vec2 uv, float lod) {
    vec3 coarse = lod > 0.0 ? textureLod(displacement_map, vec3(uv, float(c)), max(lod, 1.0)).xyz : vec3(0.0);
    return lod < 1.0 ? mix(cascade_spline(c, uv), coarse, lod) : coarse;
}

// Displacement (dx, dy, height) of a cascade and its derivatives along the axes of the plane.
struct cascade_gradient {
    vec3 value, by_x, by_y;
};

// `share` of that of the splines, from the 16 texels around. Twin of read_splines() in src/query/block.kernel.c.
cascade_gradient cascade_spline_gradient(int c, vec2 uv, float share) {
    int n = textureSize(displacement_map, 0).x;
    vec2 at = uv * float(n) - 0.5, t = fract(at);
    ivec2 first = ivec2(at - t) - 1;
    ivec4 column = (first.x + ivec4(0, 1, 2, 3)) & (n - 1);
    vec4 wx = spline_weights(t.x), dx = spline_slopes(t.x), wy = share * spline_weights(t.y);
    vec4 dy = share * spline_slopes(t.y);
    vec3 value = vec3(0.0), along = vec3(0.0), across = vec3(0.0);
    for (int j = 0; j < 4; ++j) {
        int row = (first.y + j) & (n - 1);
        vec3 a = texelFetch(displacement_map, ivec3(column.x, row, c), 0).xyz;
        vec3 b = texelFetch(displacement_map, ivec3(column.y, row, c), 0).xyz;
        vec3 d = texelFetch(displacement_map, ivec3(column.z, row, c), 0).xyz;
        vec3 e = texelFetch(displacement_map, ivec3(column.w, row, c), 0).xyz;
        vec3 sum = wx.x * a + wx.y * b + wx.z * d + wx.w * e;
        value += wy[j] * sum;
        along += wy[j] * (dx.x * a + dx.y * b + dx.z * d + dx.w * e);
        across += dy[j] * sum;
    }
    vec2 axis = float(n) * cascade_tile[c].zw; // texels a metre
    return cascade_gradient(value, axis.x * along - axis.y * across, axis.y * along + axis.x * across);
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

// The slope, from the displacement d of the cascade and its derivatives; likewise summed over the longer cascades.
struct bound_slopes {
    vec2 slope;
    vec3 longer, longer_x, longer_y;
};

void add_bound_slope(int c, vec3 d, vec3 by_x, vec3 by_y, inout bound_slopes b) {
    vec4 w = cascade_bound[c];
    vec3 all = 2.0 * w.yyx * d + b.longer;
    b.slope += vec2(dot(by_x, all) + dot(b.longer_x, d), dot(by_y, all) + dot(b.longer_y, d));
    b.longer += w.wwz * d;
    b.longer_x += w.wwz * by_x;
    b.longer_y += w.wwz * by_y;
}
#endif

// The level of derivatives for a pixel whose width in texels has that log2. A trilinear fetch averages with a deviation
// of half a texel, a pixel with FOOTPRINT_DEVIATION of its width: log2 of twice that is -0.32, of which so much is used
// as keeps the slope variance within 3 %. Linear fetches of the finest level lose nothing; a pixel of one texel should
// lose a little.
float derivative_level(float width) { return max(width - 0.15, 0.25 * width + 0.21); }
