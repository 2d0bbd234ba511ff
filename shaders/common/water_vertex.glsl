// SPDX-License-Identifier: MIT
// The water's mesh: the vertex stage of every optics, and what its pixels get of it. A vertex shader is
// void main() { water_vertex(); }. What varies slowly (haze, gusts, cloud shadow, depth) is made at the vertices; the quad has only
// four, so there the pixels make it themselves.
//
// STATIC_GRID: the vertices are places of the unit square, which the projector puts onto the water.
// LAND: there is terrain, and shallow water attenuates the waves. QUAD: the surface is the quad.
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/gusts.glsl"
#ifdef STATIC_GRID
#include "common/grid.glsl"
#endif

#ifdef VERTEX
#ifdef STATIC_GRID
layout(location = 0) in vec2 grid_place; // column and row in 0..1: the same in every frame
uniform vec4 grid_reach, grid_azimuth; // see common/grid.glsl
uniform vec2 grid_cells;
#else
layout(location = 0) in vec4 vertex; // eye-relative mean water; w: spacing [m]
layout(location = 1) in vec2 stitch; // to the neighbours whose mean this vertex is; (0, 0): none
#endif
out vec4 water_place;                // eye-relative position, depth of the mean water
out vec2 water_rest;                 // undisplaced xy
#ifndef QUAD
out vec4 water_mesh;                 // slope, jacobian, foam of the mesh
out vec3 water_light;                // gust factor, share of the sun that passes the clouds, least depth near here [m]
out vec3 water_transmittance;        // of the air to the eye
out vec3 water_inscatter;
#endif

float water_depth(vec2 rest) {
#ifdef LAND
    return -shore_elevation(rest);
#else
    return 1000.0;
#endif
}

#ifndef QUAD
float least_depth(vec2 rest, float depth) {
    float least = depth;
#ifdef LAND
    for (int i = 0; i < 4; ++i) {
        vec2 d = 5.0 * vec2(i < 2 ? 1.0 : -1.0, (i & 1) == 0 ? 1.0 : -1.0);
        least = min(least, -shore_elevation(rest + d));
    }
#endif
    return least;
}

void water_vertex() {
#ifdef STATIC_GRID
    vec4 vertex = grid_point(grid_place, grid_reach, grid_azimuth, grid_cells);
#endif
    vec2 rest = vertex.xy;
    float depth = water_depth(rest);
    vec3 offset = wave_offset(rest, vertex.w, depth, water_mesh);
#if !defined(WAVES_MESH) && !defined(STATIC_GRID) // there the CPU stitched; here nothing is
    if (stitch != vec2(0.0)) {
        vec4 unused;
        offset = 0.5 * (wave_offset(rest - stitch, vertex.w, water_depth(rest - stitch), unused) +
                        wave_offset(rest + stitch, vertex.w, water_depth(rest + stitch), unused));
    }
#endif
    vec3 position = vertex.xyz + offset;
    water_place = vec4(position, depth);
    water_rest = rest;
    water_light = vec3(gustiness(haze.zw + rest, vertex.w), cloud_shadow(position.xy), least_depth(rest, depth));
    aerial_perspective(position, water_transmittance, water_inscatter);
    gl_Position = view_projection * vec4(position, 1.0);
}
#else
void water_vertex() {
    water_place = vec4(vertex.xyz, 0.0);
    water_rest = vertex.xy;
    gl_Position = view_projection * vec4(vertex.xyz, 1.0);
}
#endif
#endif

#ifdef FRAGMENT
in vec4 water_place;
in vec2 water_rest;
#ifndef QUAD
in vec4 water_mesh;
in vec3 water_light;
in vec3 water_transmittance;
in vec3 water_inscatter;
#endif

// What a pixel of water knows before it looks anything up.
struct water_pixel {
    vec3 position; // eye-relative
    vec2 rest;
    float depth, least; // of the mean water here, and the least within a few metres [m]
    float gust, shade;
    vec4 mesh;
    vec3 transmittance, inscatter;
};

water_pixel water_here() {
    water_pixel p;
    p.position = water_place.xyz;
    p.rest = water_rest;
#ifdef QUAD
#ifdef LAND
    p.depth = -shore_elevation(p.rest);
#else
    p.depth = 1000.0;
#endif
    p.least = p.depth;
    p.gust = 1.0;
    p.shade = cloud_shadow(p.position.xy);
    p.mesh = vec4(0.0, 0.0, 1.0, 0.0);
    aerial_perspective(p.position, p.transmittance, p.inscatter);
#else
    p.depth = water_place.w;
    p.least = water_light.z;
    p.gust = water_light.x;
    p.shade = water_light.y;
    p.mesh = water_mesh;
    p.transmittance = water_transmittance;
    p.inscatter = water_inscatter;
#endif
    return p;
}
#endif
