// SPDX-License-Identifier: MIT
// The water's mesh: the vertex stage of every optics, and what its pixels get of it. A vertex shader is
// void main() { water_vertex(); }. What varies slowly (haze, gusts, cloud shadow, depth) is made at the vertices; the
// quad has only four, so there the pixels make it themselves, and the vertices only what is the same for the whole
// picture.
//
// STATIC_GRID: each instance is a block of the unit square, which the projector puts onto the water.
// LAND: there is terrain, and shallow water attenuates the waves. QUAD: the surface is the quad; TRIM: of which the
// corners beyond the horizon can be seen, and are left out. ROUGH_VERTICES: the vertices compute the roughness too.
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/gusts.glsl"
#ifdef STATIC_GRID
#include "common/grid.glsl"
#endif
#ifdef NESTED_GRID
#include "common/nested.glsl"
#endif

// The footprint of the unresolved waves. Where the vertices carry the waves, their spacing limits the resolution: a
// wave of three spacings fades to half (bolan_sea_sample_grid), as under a pixel 1.4 spacings wide.
footprint mesh_footprint(footprint f, float spacing) {
#ifdef WAVES_MESH
    f.minor = max(f.minor, 1.4 * spacing);
    f.major = max(f.major, f.minor);
#endif
    return f;
}

#ifdef VERTEX
#if defined(STATIC_GRID) || defined(NESTED_GRID)
layout(location = 0) in vec2 grid_corner; // of a cell in the block: the same in every frame
#ifdef NESTED_GRID
layout(location = 1) in vec4 nested_block; // its first cell, its cells
layout(location = 2) in float nested_index; // of its level
#endif
#else
layout(location = 0) in vec4 vertex; // eye-relative mean water; w: spacing [m]
layout(location = 1) in vec2 stitch; // to the neighbours whose mean this vertex is; (0, 0): none
#endif
out vec4 water_place;                // eye-relative position, depth of the mean water
out vec2 water_rest;                 // undisplaced xy
#ifndef QUAD
out vec2 water_read;                 // sea_place: where its waves are read
out vec3 water_bend;
out vec4 water_mesh;                 // slope, jacobian, foam of the mesh
out vec4 water_light;                // gust factor, sun through the clouds 0..1, least depth near here [m], spacing [m]
out vec3 water_transmittance;        // of the air to the eye
out vec3 water_inscatter;
#ifdef ROUGH_VERTICES
out vec3 water_hidden;               // covariance of the slopes that neither mesh nor pixel resolves
#endif
#else
flat out vec4 quad_extinction;       // mean of the air's on the way here, a polynomial; w: dip of the horizon [rad]
flat out vec3 quad_extinction1;
flat out vec3 quad_extinction2;
#endif
invariant gl_Position; // several programs draw the same water over its own depth

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
#ifdef NESTED_GRID
    nested_vertex made = nested_vertex_of(nested_block.xy + min(grid_corner, nested_block.zw), int(nested_index));
    vec4 vertex = made.at;
    vec2 stitch = made.stitch;
#endif
#ifdef STATIC_GRID
    vec4 vertex = grid_point(grid_place(grid_corner, gl_InstanceID, grid_cells), grid_reach, grid_azimuth, grid_cells);
#endif
    vec2 rest = vertex.xy;
    float depth = water_depth(rest);
    sea_place place = place_of(rest);
    vec3 offset = wave_offset(rest, place, vertex.w, depth, water_mesh);
#if !defined(WAVES_MESH) && !defined(STATIC_GRID) // there the CPU stitched; here nothing is
    if (stitch != vec2(0.0)) {
        vec4 unused;
        vec2 near = rest - stitch, far = rest + stitch;
        offset = 0.5 * (wave_offset(near, place_of(near), vertex.w, water_depth(near), unused) +
                        wave_offset(far, place_of(far), vertex.w, water_depth(far), unused));
    }
#endif
    vec3 position = vertex.xyz + offset;
    water_place = vec4(position, depth);
    water_rest = rest;
    water_read = place.at;
    water_bend = place.bend;
    water_light = vec4(gustiness(eye_wrapped_wide + rest, vertex.w), cloud_shadow(position.xy),
                       least_depth(rest, depth), vertex.w);
    aerial_perspective(position, water_transmittance, water_inscatter);
#ifdef ROUGH_VERTICES
    float dist = max(length(position), 1e-3);
    footprint pixel = pixel_footprint(-position / dist, dist, water_mesh.xy);
    water_hidden = hidden_slopes(rest, mesh_footprint(pixel, vertex.w), depth);
#endif
    gl_Position = view_projection * vec4(position, 1.0);
}
#else
// Mean over a straight way down to the sea of exp(-height / scale), d^2 = 2 R h x long: x = 0 straight down, x = 1 to
// the horizon. Heights are h (s - x s (1 - s)) on it.
float mean_density(float h, float x, float scale) {
    float sum = 0.0;
    for (int i = 0; i < 32; ++i) {
        float s = (float(i) + 0.5) / 32.0;
        sum += exp(-h * s * (1.0 - x * (1.0 - s)) / scale);
    }
    return sum / 32.0;
}

// The polynomial through x = 0, 1/2, 1.
vec3 density_polynomial(float h, float scale) {
    float a = mean_density(h, 0.0, scale), b = mean_density(h, 0.5, scale), c = mean_density(h, 1.0, scale);
    return vec3(a, 4.0 * b - 3.0 * a - c, 2.0 * a - 4.0 * b + 2.0 * c);
}

void water_vertex() {
    float h = max(eye_height, 0.0);
    water_place = vec4(vertex.xyz, 0.0);
    water_rest = vertex.xy;
    vec3 haze_density = density_polynomial(h, haze_scale()), air_density = density_polynomial(h, RAYLEIGH_SCALE);
    quad_extinction = vec4(RAYLEIGH * air_density.x + mie_extinction() * haze_density.x, horizon_dip(h));
    quad_extinction1 = RAYLEIGH * air_density.y + mie_extinction() * haze_density.y;
    quad_extinction2 = RAYLEIGH * air_density.z + mie_extinction() * haze_density.z;
    gl_Position = view_projection * vec4(vertex.xyz, 1.0);
}
#endif
#endif

#ifdef FRAGMENT
#ifdef BOUNDS
#include "common/bounds.glsl"
#endif
in vec4 water_place;
in vec2 water_rest;
#ifndef QUAD
in vec2 water_read;
in vec3 water_bend;
in vec4 water_mesh;
in vec4 water_light;
in vec3 water_transmittance;
in vec3 water_inscatter;
#ifdef ROUGH_VERTICES
in vec3 water_hidden;
#endif
#else
flat in vec4 quad_extinction;
flat in vec3 quad_extinction1;
flat in vec3 quad_extinction2;
#endif

// A pixel of water, from the varyings alone.
struct water_pixel {
    vec3 position; // eye-relative
    vec2 rest;
    sea_place place;
    float depth, least; // of the mean water here, and the least within a few metres [m]
    float gust, shade;
    float spacing; // of the vertices [m]
    vec4 mesh;
    vec3 transmittance, inscatter;
};

#ifdef QUAD
// For an eye above the water, distance to the water of the round earth over the distance to this plane on the same ray.
// At the horizon the factor is 2 and the water ends; the plane does not, and its square would show corners.
float round_earth(vec2 position) {
    float left = 1.0 - 4.0 * earth_drop(dot(position, position), earth_radius) / max(eye_height, 0.5);
#ifdef TRIM
    if (left < 0.0 && eye_under_water < 0.5) discard;
#endif
    return eye_under_water < 0.5 ? 2.0 / (1.0 + sqrt(max(left, 0.0))) : 1.0;
}

// acos to 7e-5 (Abramowitz & Stegun 4.4.45), and asin, near 0 by its series; the built-in functions cost as much
// as texture fetches.
float quick_acos(float x) {
    float a = abs(x), y = sqrt(max(1.0 - a, 0.0)) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - 0.0187293 * a)));
    return x < 0.0 ? 3.14159265 - y : y;
}
float quick_asin(float x) {
    float x2 = x * x;
    float series = x * (1.0 + x2 * (0.16666667 + x2 * (0.075 + x2 * (0.04464286 + x2 * 0.03))));
    return x2 < 0.16 ? series : 1.57079633 - quick_acos(x);
}

// aerial_perspective() for a point of the mean sea.
void quad_aerial(vec3 position, out vec3 transmittance, out vec3 inscatter) {
    float d = max(length(position), 1e-3), h = max(eye_height, 0.5), x = min(earth_drop(d * d, earth_radius) / h, 1.2);
    if (haze_given > 0.5) {
        given_haze(d, transmittance, inscatter);
        return;
    }
    vec3 dir = position / d;
    transmittance = exp(-d * (quad_extinction.rgb + x * (quad_extinction1 + x * quad_extinction2)));
    float squares = dot(dir.xy, dir.xy) * dot(sun_direction.xy, sun_direction.xy);
    float c = dot(dir.xy, sun_direction.xy) * inversesqrt(max(squares, 1e-12));
    float above = min(quick_asin(clamp(dir.z, -1.0, 1.0)) + quad_extinction.w, 0.0);
    vec3 at = vec3(sqrt(quick_acos(clamp(c, -1.0, 1.0)) / PI),
                   0.5 - 0.5 * sqrt(-above / (0.5 * PI - quad_extinction.w)),
                   aerial_slice(d));
    inscatter = textureLod(aerial_table, to_texel_centres3(at, AERIAL_SIZE), 0.0).rgb;
}
#endif

water_pixel water_here() {
    water_pixel p;
    p.position = water_place.xyz;
    p.rest = water_rest;
#ifdef QUAD
    float away = round_earth(p.position.xy);
    p.position *= away;
    p.rest *= away;
    p.place = place_of(p.rest);
    p.depth = water_depth(p.rest);
    p.least = p.depth;
    p.gust = 1.0;
    p.shade = cloud_shadow(p.position.xy);
    p.mesh = vec4(0.0, 0.0, 1.0, 0.0);
    p.spacing = 0.0;
    quad_aerial(p.position, p.transmittance, p.inscatter);
#else
    p.place = sea_place(water_read, water_bend);
    p.depth = water_place.w;
    p.least = water_light.z;
    p.gust = water_light.x;
    p.shade = water_light.y;
    p.spacing = water_light.w;
    p.mesh = water_mesh;
    p.transmittance = water_transmittance;
    p.inscatter = water_inscatter;
#endif
#ifdef BOUNDS
    if (!is_within_bounds(p.position.xy)) discard;
#endif
    return p;
}

// Eye-relative xy of the drawn surface: a flat one lies before the round earth.
vec2 seen_position(water_pixel p) {
#ifdef QUAD
    return water_place.xy;
#else
    return p.position.xy;
#endif
}

footprint water_footprint(water_pixel p, vec3 view, float dist) {
    return mesh_footprint(pixel_footprint(view, dist, p.mesh.xy), p.spacing);
}

// Unresolved slope covariance of the footprint.
vec3 water_hidden_slopes(vec2 rest, footprint f, float depth) {
#if defined(ROUGH_VERTICES) && !defined(QUAD)
    return water_hidden;
#else
    return hidden_slopes(rest, f, depth);
#endif
}
#endif
