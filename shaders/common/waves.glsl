// SPDX-License-Identifier: MIT
// The sea at a place, for either stage, whichever model makes its waves. One of these is defined:
//   WAVES_EXP   a few waves exp(s cos), here for each vertex and pixel (Liu & Xie 2010)
//   WAVES_SUM   many cosines, here for each pixel: only the quad needs that (Liu, Xu & Chen 2009)
//   WAVES_MESH  the same, made on the CPU for each vertex; the pixels interpolate
//   none        cascades: tiles of an FFT
// PACKED: slope_map0 to slope_map3, one for each cascade, hold slope, dxx + dyy, foam memory, and there is no slope_map
// or fold_map (sea_gpu.h). CASCADES: how many of them pixels look up, longest waves first. LAYERS: the water has wave
// layers (common/layers.glsl). Twins of bolan_sea_sample_rest() and bolan_sea_sample_grid() in src/waves.
#include "shared/constants.glsl"
#include "shared/exp_cosine.glsl"
#include "common/water_block.glsl"
#ifdef LAND
#include "common/shore.glsl"
#endif

// Where the waves of a rest point are read.
struct sea_place {
    vec2 at;   // eye-relative [m]
    vec3 bend; // gradient of the place by the rest point, less the identity: xx, xy, yx; yy is -xx
};

#if !defined(WAVES_EXP) && !defined(WAVES_SUM) && !defined(WAVES_MESH)
#define WAVES_CASCADES
#include "common/sea.glsl"
#else
sea_place place_of(vec2 rest) { return sea_place(rest, vec3(0.0)); }
#endif

// Depth of the mean water at a rest point [m]; where there is no ground it is deep.
float water_depth(vec2 rest) {
#ifdef LAND
    return -shore_elevation(rest);
#else
    return 1000.0;
#endif
}

// What the waves do at a place. slope: dz/dx, dz/dy of the displaced surface.
struct wave_fields {
    vec2 slope;
    float jacobian; // of the horizontal map
    float foam;     // foam memory, weighted by foam_weights
};

#if defined(WAVES_EXP) || defined(WAVES_SUM)
#ifdef WAVES_EXP
vec4 wave_of(int i) { return wave_component[i]; }
#else
#pragma unit wave_table 27
uniform highp sampler2D wave_table; // likewise, a texel a wave, 64 in a row; longest first
vec4 wave_of(int i) { return texelFetch(wave_table, ivec2(i & 63, i >> 6), 0); }
#endif
// WAVE_COUNT: how many, where that is known: a loop of so many is a fifth faster
#ifndef WAVE_COUNT
#define WAVE_COUNT wave_count
#endif

// Height of unit amplitude at a phase [rad], and its derivative by the phase. `faded`: log2 of what is kept of the
// wave.
float wave_height(float phase, float faded) {
    float s = half_sine(within_half_a_turn(phase * 0.15915494));
#ifdef WAVES_EXP
    return exp_cosine(exp_sharpness, s, faded) - exp_mean * exp2(faded);
#else
    return (1.0 - 2.0 * s * s) * exp2(faded);
#endif
}

float wave_slope(float phase, float faded) {
    float x = within_half_a_turn(phase * 0.15915494);
#ifdef WAVES_EXP
    return exp_cosine_slope(exp_sharpness, half_sine(x), half_cosine(x), faded);
#else
    return -2.0 * half_sine(x) * half_cosine(x) * exp2(faded);
#endif
}
#endif

// ---- footprints -----------------------------------------------------------------------------------------------------

#pragma unit slope_table 6
uniform sampler3D slope_table;

// The part of the water's plane under one pixel: an ellipse, long along the view.
struct footprint {
    vec2 axis; // horizontal direction of the long side
    float major, minor; // widths [m]
};

footprint pixel_footprint(vec3 view, float dist, vec2 coarse_slope) {
    footprint f;
    f.axis = normalize(view.xy + vec2(1e-6, 0.0));
    float width = max(dist * radians_per_pixel, 1e-4);
    vec3 n = normalize(vec3(-coarse_slope, 1.0));
    f.minor = width * shade_columns; // its columns lie side by side: across the view
    f.major = max(f.minor, width / clamp(dot(view, n), 0.01, 1.0));
    return f;
}

#include "common/layers.glsl"

// Direction of an axis in half turns, 0..1, to 0.002: the table has a texel for every 0.125.
float half_turns(vec2 axis) {
    vec2 a = abs(axis);
    float t = min(a.x, a.y) / max(max(a.x, a.y), 1e-6);
    float turns = t * (0.30952 - 0.06109 * t * t); // atan(t) / pi
    turns = a.y > a.x ? 0.5 - turns : turns;
    return axis.x * axis.y < 0.0 ? 1.0 - turns : turns;
}

// Coordinate in the table of a standard deviation whose log2 is `deviation`.
float slope_table_coordinate(float deviation) {
    return ((deviation - SLOPE_TABLE_FIRST) * SLOPE_TABLE_PER_OCTAVE + 0.5) / float(SLOPE_TABLE_MAJOR);
}

// Slope covariance (xx, xy, yy) that this footprint removes, that of the waves shorter than the cascades included; and
// the share that it removes of the fine waves among these (common/fine.glsl).
vec4 slope_texel(footprint f) {
    float major = log2(max(FOOTPRINT_DEVIATION * f.major, 1e-4));
    float aspect = log2(f.major / max(f.minor, f.major / 127.0));
    float angle = half_turns(f.axis);
    vec3 t = vec3(slope_table_coordinate(major), (aspect + 0.5) / float(SLOPE_TABLE_ASPECT),
                  (angle * float(SLOPE_TABLE_ANGLE) + 0.5) / float(SLOPE_TABLE_LAYERS));
    return textureLod(slope_table, t, 0.0);
}

// The covariance, with the facets that the sun's disc adds.
vec3 unresolved_slopes(footprint f) {
    return slope_texel(f).xyz + vec3(SUN_DISC_SLOPES, 0.0, SUN_DISC_SLOPES);
}

// The same, with what the footprint removes of the layers at a rest point.
vec3 hidden_slopes(vec2 rest, footprint f, float depth) { return unresolved_slopes(f) + layers_hidden(rest, f, depth); }

// ---- vertices -------------------------------------------------------------------------------------------------------

#ifdef VERTEX
#ifdef WAVES_MESH
layout(location = 2) in vec3 mesh_offset; // height, dx, dy
layout(location = 3) in vec4 mesh_fields; // slope, jacobian, foam
#endif

// Displacement of the vertex at `rest`, whose waves are read at `place`, on a mesh of that spacing, over water of that
// depth; fields of the mesh: slope, jacobian, foam.
vec3 wave_offset(vec2 rest, sea_place place, float spacing, float depth, out vec4 fields) {
    vec3 offset = vec3(0.0);
    fields = vec4(0.0, 0.0, 1.0, 0.0);
#ifdef WAVES_MESH
    fields = mesh_fields;
    float keep = 1.0;
#ifdef LAND
    keep = coast_attenuation(depth, significant_height);
#endif
    fields.xy *= keep;
    offset = keep * mesh_offset.yzx;
    offset.z -= keep * (1.0 - keep) * mesh_lift; // it goes with the square of what is kept
#endif
#ifdef WAVES_EXP
    for (int i = 0; i < WAVE_COUNT; ++i) {
        vec4 w = wave_of(i);
        float samples = inversesqrt(max(dot(w.xy, w.xy), 1e-12)) / spacing; // of a wave
        float keep = w.z * clamp(0.5 * samples - 1.0, 0.0, 1.0), phase = 6.28318531 * (dot(w.xy, rest) + w.w);
        offset.z += keep * wave_height(phase, 0.0);
        fields.xy += keep * wave_slope(phase, 0.0) * 6.28318531 * w.xy;
    }
#ifdef LAND
    float shallow = coast_attenuation(depth, significant_height);
    offset.z *= shallow;
    fields.xy *= shallow;
#endif
#endif
#ifdef WAVES_CASCADES
    vec4 kept = cascades_kept(depth);
    vec3 longer = vec3(0.0);
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (spacing > band.z) break; // every wave of it is shorter than the mesh
        float lod = max(log2(spacing) - band.w - 0.5, 0.0); // the triangles blur too: half a level is theirs
        vec2 uv = cascade_uv(c, place.at);
        vec3 s = cascade_displacement(c, uv, lod);
        float keep = kept[c];
        offset += keep * vec3(choppiness * s.xy, s.z + keep * lift_of(c, spacing));
#ifdef BOUND_WAVES
        offset.z += bound_height(c, keep * s, longer);
#endif
#ifndef PACKED
        fields.xy += keep * textureLod(slope_map, vec3(uv, float(c)), lod).xy;
#endif
    }
#ifndef PACKED
    fields.xy = unwarped(place, fields.xy);
#endif
#endif
#ifndef PACKED
    add_layers(rest, spacing, depth, offset, fields.xy);
#else
    vec2 unused = vec2(0.0);
    add_layers(rest, spacing, depth, offset, unused);
#endif
    return offset;
}
#endif

// ---- pixels ---------------------------------------------------------------------------------------------------------

#if !defined(VERTEX) || defined(FRAGMENT) // compute shaders too; a probe has both
// Most texture fetches along the long side of the pixel's footprint. The quality sets TAPS; the default serves an
// offline compiler.
#ifndef TAPS
#define TAPS 4
#endif
// How many are made where `taps` are wanted, and where fetch i lies, in their distances from the middle. Up to two are
// always made, at one place where one is wanted: software OpenGL runs a loop once more than it has trips.
#if TAPS <= 2
#define TAP_COUNT(taps) TAPS
float tap_place(int i, float taps) { return (taps - 1.0) * (float(i) - 0.5 * float(TAPS - 1)); }
#else
#define TAP_COUNT(taps) int(taps)
float tap_place(int i, float taps) { return float(i) - 0.5 * (taps - 1.0); }
#endif

// log2 of the width that each of so many fetches along a footprint averages over. Fetches as wide as they lie apart
// would blur the waves sideways as well: far rows would lose up to a tenth of their contrast (tests/reference). With
// this share of that blur they show what the table of unresolved slopes leaves them.
const float SIDEWAYS = 0.4;
float fetched_width(footprint f, float taps) {
    float minor = log2(f.minor);
    return mix(minor, max(log2(f.major / taps), minor), SIDEWAYS);
}

// Length over which these fetches lie: with their widths they average as a Gaussian of FOOTPRINT_DEVIATION of the
// footprint does.
float fetched_length(footprint f) {
    return FOOTPRINT_DEVIATION * sqrt(12.0 * max(f.major * f.major - f.minor * f.minor, 0.0));
}

#if defined(WAVES_CASCADES) && defined(PACKED)
#ifndef CASCADES
#define CASCADES 4
#endif

vec4 cascade_share(int c, vec4 fields, float gust, float kept) {
    return (cascade_band[c].z < 20.0 ? gust : 1.0) * kept * vec4(fields.xyz, foam_weights[c] * fields.w);
}

vec4 derivatives(sampler2D map, int c, vec2 at, float fine) {
    return textureLod(map, cascade_uv(c, at), derivative_level(fine - cascade_band[c].w));
}

// One texture fetch a cascade, at the level of a width whose log2 is `fine`. Slopes over the displaced surface as if
// waves came from all sides. Textures of their own and no loop: an array, and a loop that pixels leave at different
// times, cost twice as much.
wave_fields waves_of_width(vec2 rest, sea_place place, float fine, float gust, float depth) {
    vec4 kept = cascades_kept(depth);
    vec4 sum = cascade_share(0, derivatives(slope_map0, 0, place.at, fine), gust, kept.x);
#if CASCADES > 1
    sum += cascade_share(1, derivatives(slope_map1, 1, place.at, fine), gust, kept.y);
#endif
#if CASCADES > 2
    sum += cascade_share(2, derivatives(slope_map2, 2, place.at, fine), gust, kept.z);
#endif
#if CASCADES > 3
    sum += cascade_share(3, derivatives(slope_map3, 3, place.at, fine), gust, kept.w);
#endif
    float width = exp2(fine), pinch = choppiness * sum.z;
    sum.xy = unwarped(place, sum.xy);
    sum.xy += layers_slope(rest, footprint(vec2(1.0, 0.0), width, width), depth);
    vec2 slope = sum.xy / max(1.0 + 0.75 * pinch, 0.3);
    return wave_fields(slope * min(1.0, 1.2 * inversesqrt(max(dot(slope, slope), 1e-6))), 1.0 + pinch, sum.w);
}

wave_fields waves_at(vec2 rest, sea_place place, footprint f, float gust, float depth, vec4 mesh) {
    float width = max(f.minor, f.major / float(TAPS));
    return waves_of_width(rest, place, log2(width), gust, depth);
}
#elif defined(WAVES_CASCADES)
// SPLINES: under a footprint of less than half a texel the gradient is that of the cubic splines, which vertices and
// queries have; up to a whole texel it is blended with linear fetches. Without, pixels fetch linearly: half the cost of
// the water on software OpenGL, and 10 % of the rms slope off.
#pragma unit fold_map 10
uniform sampler2DArray fold_map; // r: dxy, g: foam memory

// A cascade under a footprint, and its foam memory. Texels are fetched linearly along the footprint as often as they
// are shorter than it, at most TAPS times; the level of detail makes up for the rest. displaced: 1: g.value is wanted.
cascade_gradient cascade_fetched(int c, vec2 at, footprint f, int displaced, out float foam) {
    float texel = cascade_band[c].y, taps = clamp(ceil(f.major / texel), 1.0, float(TAPS));
    float lod = derivative_level(fetched_width(f, taps) - cascade_band[c].w), near = 0.0;
    vec2 centre = cascade_uv(c, at), fold = textureLod(fold_map, vec3(centre, float(c)), lod).xy;
    foam = foam_weights[c] * fold.y;
    cascade_gradient g = cascade_gradient(vec3(0.0), vec3(0.0), vec3(0.0));
#ifdef SPLINES
    near = clamp(1.0 - 4.0 * lod, 0.0, 1.0);
    if (near > 0.0) g = cascade_spline_gradient(c, centre, near);
    if (near < 1.0)
#endif
    {
        vec2 along = (cascade_uv(c, at + f.axis * fetched_length(f)) - centre) / taps;
        vec4 slopes = vec4(0.0);
        for (int i = 0; i < TAP_COUNT(taps); ++i)
            slopes += textureLod(slope_map, vec3(centre + along * tap_place(i, taps), float(c)), lod);
        slopes /= float(TAP_COUNT(taps));
        g.by_x += (1.0 - near) * vec3(slopes.z, fold.x, slopes.x);
        g.by_y += (1.0 - near) * vec3(fold.x, slopes.w, slopes.y);
        if (displaced > 0)
            g.value += (1.0 - near) * textureLod(displacement_map, vec3(centre, float(c)), lod).xyz;
    }
    return g;
}

// The sums over the cascades, weighted by what depth and gusts leave of each.
struct cascade_sums {
    vec3 by_x, by_y; // as cascade_gradient
    float foam;
#ifdef LAND
    cascades_lean lean;
#endif
#ifdef BOUND_WAVES
    bound_slopes bound;
#endif
};

// Rings whose longest wave is shorter than the pixel is wide have nothing left.
void add_cascade(int c, vec2 at, footprint f, float gust, float kept, int displaced, inout cascade_sums sums) {
    vec4 band = cascade_band[c];
    if (c >= cascade_count || f.minor > 0.6 * band.z) return;
    float memory, fresh = band.z < 20.0 ? gust : 1.0;
    cascade_gradient g = cascade_fetched(c, at, f, displaced, memory);
    vec3 x = kept * g.by_x, y = kept * g.by_y;
    sums.foam += fresh * kept * memory;
#ifdef LAND
    x += sums.lean.x[c] * g.value;
    y += sums.lean.y[c] * g.value;
#endif
#ifdef BOUND_WAVES
    add_bound_slope(c, kept * g.value, fresh * x, fresh * y, sums.bound);
#endif
#ifdef LAND
    float lift = 2.0 * kept * lift_of(c, f.minor);
    x.z += sums.lean.x[c] * lift;
    y.z += sums.lean.y[c] * lift;
#endif
    sums.by_x += fresh * x;
    sums.by_y += fresh * y;
}

// No loop over the cascades: software OpenGL runs the body of a loop once more than it has trips.
wave_fields waves_at(vec2 rest, sea_place place, footprint f, float gust, float depth, vec4 mesh) {
    cascade_sums sums;
    sums.by_x = sums.by_y = vec3(0.0);
    sums.foam = 0.0;
    vec4 kept = cascades_kept(depth);
    int displaced = 0;
#ifdef LAND
    sums.lean = cascades_lean(vec4(0.0), vec4(0.0));
    displaced = is_leaning(depth) ? 1 : 0;
    if (displaced > 0) sums.lean = cascades_lean_at(rest, place, depth);
#endif
#ifdef BOUND_WAVES
    sums.bound = bound_slopes(vec2(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    displaced = 1;
#endif
    add_cascade(0, place.at, f, gust, kept.x, displaced, sums);
    add_cascade(1, place.at, f, gust, kept.y, displaced, sums);
    add_cascade(2, place.at, f, gust, kept.z, displaced, sums);
    add_cascade(3, place.at, f, gust, kept.w, displaced, sums);
    vec3 by_x = sums.by_x, by_y = sums.by_y;
#ifdef BOUND_WAVES
    by_x.z += sums.bound.slope.x;
    by_y.z += sums.bound.slope.y;
#endif
    float foam = sums.foam;
    vec3 bend = place.bend, east = by_x + bend.x * by_x + bend.z * by_y, north = by_y + bend.y * by_x - bend.x * by_y;
    vec2 slope = vec2(east.z, north.z) + layers_slope(rest, f, depth);
    float jxx = 1.0 + choppiness * east.x, jyx = choppiness * east.y;
    float jxy = choppiness * north.x, jyy = 1.0 + choppiness * north.y, jacobian = jxx * jyy - jxy * jyx;
    slope = vec2(slope.x * jyy - slope.y * jyx, slope.y * jxx - slope.x * jxy) / max(jacobian, 0.25);
    // water does not stand steeper than it breaks
    return wave_fields(slope * min(1.0, 1.2 * inversesqrt(max(dot(slope, slope), 1e-6))), jacobian, foam);
}
#endif

#if defined(WAVES_EXP) || defined(WAVES_SUM)
// The derivative by the phase [turns] of unit amplitude.
float wave_derivative(float turns) {
    float x = within_half_a_turn(turns);
    vec2 w = vec2(half_sine(x), half_cosine(x));
#ifdef WAVES_EXP
    float t = w.x * w.x; // exp(-2 s t) by a polynomial: an exponential is dear on the CPU
    vec4 c = exp_slope[0], d = exp_slope[1];
    float high = d.x + t * (d.y + t * (d.z + t * d.w));
    return w.x * w.y * (c.x + t * (c.y + t * (c.z + t * (c.w + t * high))));
#else
    return -12.5663706 * w.x * w.y;
#endif
}

// exp(-16 u) to 1e-3 of 1.
float faded16(float u) {
    u = min(u, 1.0);
    float e = 1.0 - u * (1.0 - 0.5 * u), e2 = e * e, e4 = e2 * e2, e8 = e4 * e4;
    return e8 * e8;
}

// Each wave fades by its own footprint, a Gaussian of 0.4 of the widths. `hidden`: the slope covariance of what they
// lose and of what is no part of them.
wave_fields waves_of_footprint(vec2 rest, footprint f, float gust, float depth, out vec3 hidden) {
    vec2 slope = vec2(0.0), a = f.axis;
    float major = 0.19739209 * f.major * f.major, minor = 0.19739209 * f.minor * f.minor; // (0.4 2 pi)^2 / 2 / 16
    vec3 spread = vec3(a.x * a.x, 2.0 * a.x * a.y, a.y * a.y) * (major - minor) + vec3(minor, 0.0, minor);
    vec3 seen = vec3(0.0);
    for (int i = 0; i < WAVE_COUNT; ++i) {
        vec4 w = wave_of(i);
        vec3 square = w.xxy * w.xyy;
        float keep = faded16(dot(spread, square)), kept = keep * w.z;
        slope += kept * wave_derivative(dot(w.xy, rest) + w.w) * w.xy;
        seen += kept * kept * square;
    }
#ifdef LAND
    float shallow = coast_attenuation(depth, significant_height);
    slope *= shallow;
#endif
    hidden = max(wave_slopes - wave_slope_share * seen, vec3(0.0, -1.0, 0.0));
    hidden += vec3(SUN_DISC_SLOPES, 0.0, SUN_DISC_SLOPES);
    hidden += layers_hidden(rest, f, depth);
    return wave_fields(slope * gust + layers_slope(rest, f, depth), 1.0, 0.0);
}

wave_fields waves_at(vec2 rest, sea_place place, footprint f, float gust, float depth, vec4 mesh) {
    vec3 unused;
    return waves_of_footprint(rest, f, gust, depth, unused);
}
#endif

#ifdef WAVES_MESH
wave_fields waves_at(vec2 rest, sea_place place, footprint f, float gust, float depth, vec4 mesh) {
    return wave_fields(mesh.xy * gust, mesh.z, mesh.w);
}
#endif
#endif
