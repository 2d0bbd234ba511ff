// SPDX-License-Identifier: MIT
// Light through the crests and ramps of foam (Ni, Zhang & Tan, "Ocean simulation of a flight simulator's view"), per
// pixel:
//
//   color = F sky(mirrored) + glitter + (1 - F) (bed or deep water + light through crests), under foam
//
// Light that enters the far side of a wave leaves through the near one. Where that can be, a mask of crests says; how
// much, the directions of sun and view. The paper: mask = |displacement| / peak wave length, a fixed tint. Here by
// default: a mask from height, pinch and the side that faces the eye, and the tint that the water's own attenuation
// leaves of sunlight over a path through the crest.
//
// The shape of the water is there already (crest_shape.glsl), and what varies slowly over the picture
// (water_air.glsl). The facets that the eye sees lean towards it; their mean tilt, their area and the mean Fresnel
// reflectance are rational and quadratic forms (common/rough.glsl).
//
// LAND: there is terrain. SPARSE: into a cleared picture of fewer columns. CASCADES: how many of them these rows show.
// TAPS: how much sharper than its long side a footprint is looked up. Waves: see common/waves.glsl.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#ifndef TAPS // set by quality; this serves an offline compiler
#define TAPS 2
#endif
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/rough.glsl"
#include "common/look.glsl"
#include "common/water_light.glsl"
#include "common/shape.glsl"
#include "common/water_air.glsl"
#ifdef LAND
#include "common/behind.glsl"
#include "common/surf.glsl"
#endif
out vec4 color;

#include "common/shape_maps.glsl"

layout(std140) uniform Optics {
#include "shared/crest_block.glsl"
};

#pragma unit crest_tables 15
// Rows by t: shares of three densities of foam and of foam without holes (a) by intensity (s), for the zones RAMP_...;
// and by log2 of the width that the waves are averaged over, the slope covariance xx, xy, yy that this removes, and the
// lit share of the facets that face the sun (a). Twin of crest::table in src/render/papers/crest.c.
uniform sampler2D crest_tables;
const float TABLE_TEXELS = 128.0;
const float RAMP_SWASH = 0.1, RAMP_SURF = 0.3, RAMP_OPEN = 0.5, TABLE_SLOPES = 0.9;

vec4 slopes_of_width(float fine) {
    float texel = slope_table_coordinate(fine + log2(FOOTPRINT_DEVIATION)) * float(SLOPE_TABLE_MAJOR);
    texel = clamp(texel, 0.5, float(SLOPE_TABLE_MAJOR) - 0.5);
    return textureLod(crest_tables, vec2(texel / TABLE_TEXELS, TABLE_SLOPES), 0.0);
}

// What a pixel of water knows.
struct crest_pixel {
    vec3 position, view; // eye-relative; to the eye
    vec2 rest;
    sea_place place;
    float dist, width, fine; // [m], what the waves are averaged over [m], its log2
    float depth, shore;
    water_air air;
    vec3 slopes; // covariance of what is averaged away
    float lit;   // share of the facets turned to the sun that no wave shades
    vec4 mesh;
};

crest_pixel pixel_here(ivec2 at, uvec4 texel) {
    crest_pixel p;
    vec2 uv = (vec2(at) + 0.5) * pixel_size;
    p.position = frame_ray(uv) / shape_depth(texel);
    water_shape shape = shape_of(texel, p.position.xy);
    p.rest = shape.rest;
    p.place = place_of(p.rest);
    p.dist = sqrt(dot(p.position, p.position));
    p.view = -p.position / p.dist;
    p.mesh = vec4(0.0, 0.0, 1.0, 0.0);
#ifdef WAVES_MESH
    p.mesh = vec4(shape.slope, shape.spacing, shape.depth);
#endif
    p.width = max(p.dist * radians_per_pixel, 1e-4);
    p.width = max(p.width * shade_columns, p.width / (float(TAPS) * clamp(p.view.z, 0.02, 1.0)));
    p.fine = log2(p.width);
    p.air = air_at(uv, p.dist, p.view.z);
    p.depth = 1000.0;
    p.shore = 1e4;
#ifdef LAND
    vec2 bed = bed_at(uv);
    p.depth = bed.x;
    p.shore = bed.y;
#endif
    vec4 rough = slopes_of_width(p.fine);
    p.slopes = rough.xyz * (p.air.gust * p.air.gust);
    p.lit = rough.w;
    return p;
}

wave_fields waves_here(crest_pixel p) {
#if defined(WAVES_CASCADES) && defined(PACKED)
    return waves_of_width(p.rest, p.place, p.fine, p.air.gust, p.depth);
#else
    return waves_at(p.rest, p.place, footprint(vec2(1.0, 0.0), p.width, p.width), p.air.gust, p.depth, p.mesh);
#endif
}

#pragma unit foam_densities 19
uniform sampler2D foam_densities; // opacity of thin, middling and dense foam; a: its bubbles

const vec3 FOAM_DENSITIES = vec3(FOAM_THIN, FOAM_MIDDLING, FOAM_DENSE); // mean opacity of the three

const vec3 PAPER_TINT = vec3(0.088, 0.497, 0.456);
const float PAPER_SUN = 1.7; // the paper's factor of sunlight; its base is 0

// How this optics shows crests, chosen by eye on waves of 0.5 to 5 m. The mask is the product of three ramps:
const float HIGH_MEAN = 0.35, HIGH_RISE = 0.9;       // height: at the mean water, and a significant height over it
const float PINCH_MEAN = 0.25, PINCH_RISE = 1.3;     // pinch: of flat water, and for each unit that the Jacobian lacks
const float FACING_LEVEL = 0.4, FACING_RISE = 2.0;   // side: of level water, and for each unit of slope to the eye
const float MASK_GAIN = 2.0;
const float GLOW_FORWARD = 0.16, GLOW_AROUND = 0.012; // of sunlight: scattered forwards, and to all sides
const float GLOW_SKY = 0.3;                           // skylight beside it
const float PATH_HEIGHTS = 1.2;                       // way through a crest, in significant heights
const float OLD_OPACITY = 0.55;                       // of old foam beside fresh

// ---- light through crests -------------------------------------------------------------------------------------------

// The mask of crests, 0..1. `rise`: of the mean water's surface here [m]; toward: horizontal direction to the eye.
float crest_mask(crest_pixel p, wave_fields w, float rise, vec2 toward) {
    if (to_the_letter > 0.5)
        return clamp(10.0 * length(vec3(p.position.xy - p.rest, rise)) / peak_length, 0.0, 1.0);
    float high = clamp(HIGH_MEAN + HIGH_RISE * rise / max(significant_height, 0.2), 0.0, 1.0);
    float pinched = clamp(PINCH_MEAN + PINCH_RISE * (1.0 - w.jacobian), 0.0, 1.0);
    float facing = clamp(FACING_LEVEL - FACING_RISE * dot(w.slope, toward), 0.0, 1.0);
    return high * pinched * facing * MASK_GAIN * min(1.0, 2.0 * high); // troughs, twice: by their depth squared
}

// Light from below that came through crests. ahead: cosine between the view and the sunlight's way.
vec3 crest_light(float mask, vec3 view, vec3 sunlight) {
    float ahead = max(-dot(view, sun_direction), 0.0);
    float towards = ahead * ahead;
    towards *= towards * ahead; // ^5
    float across = (1.0 - view.z * view.z) * mask;
    if (to_the_letter > 0.5) return PAPER_SUN * towards * across * PAPER_TINT * sunlight / PI;
    float path = clamp(PATH_HEIGHTS * significant_height, 0.5, 5.0);
    // forward scattering, most of it within 40 degrees; the rest, from all around, lights every thin crest a little
    return (GLOW_FORWARD * towards + GLOW_AROUND) * across * exp(-path * water_attenuation) *
           (sunlight + GLOW_SKY * sky_light);
}

// ---- foam -----------------------------------------------------------------------------------------------------------

// Shares of foam by breaking crests and by what they left behind (means over what the pixel does not resolve).
float open_foam(wave_fields w, vec3 slopes) {
    float hidden = jacobian_variance_of(slopes.x + slopes.z - slopes_beyond_cascades, choppiness);
    float fresh = foam_cover_fast(breaking_pinch + 1.0 - w.jacobian, hidden + fresh_edge);
    float old = foam_cover_fast(w.foam - old_foam_memory, hidden * memory_share + old_edge);
    return max(fresh, OLD_OPACITY * old);
}

// Opacity; a: brightness of the bubbles.
vec2 foam_opacity(vec2 rest, float width_log2, float intensity, float zone) {
    vec2 at = mod(water_wrapped + rest, WORLD_WRAP);
    float level = width_log2 + 9.0; // a tile has 512 texels
    vec4 tile = textureLod(foam_densities, at * (1.0 / 16.0), max(level - 4.0, 0.0));
    if (width_log2 < -4.0) {
        vec4 close = textureLod(foam_densities, at.yx * (1.0 / 4.0), max(level - 2.0, 0.0));
        tile = mix(tile, sqrt(tile * close), clamp(-4.0 - width_log2, 0.0, 1.0) * 0.6);
    }
#ifdef LAND
    vec4 ramp = textureLod(crest_tables, vec2(intensity, zone), 0.0);
    float opacity = clamp(dot(tile.rgb, ramp.rgb) + ramp.a, 0.0, 1.0);
#else // the row of the open sea: between nothing, thin, middling, dense, everything
    vec4 from = vec4(0.0, FOAM_DENSITIES), to = vec4(FOAM_DENSITIES, 1.0);
    vec4 share = clamp((intensity - from) / (to - from), 0.0, 1.0);
    float opacity = mix(mix(mix(tile.r * share.x, tile.g, share.y), tile.b, share.z), 1.0, share.w);
#endif
    return vec2(opacity, 0.75 + 0.25 * tile.a);
}

#ifdef LAND
// How this optics shows the shore, chosen by eye.
const surf_look SURF_LOOK = surf_look(0.88, 2.2, 0.06, 0.05, 0.5, 0.6, 0.3);
const float SURF_FULL_FROM_SHORE = 2.0, SURF_NONE_FROM_SHORE = 6.0; // over the length from front to front
const float SWASH_ZONE = 12.0; // [m] from the shore, within which foam takes the ramp of swash
const float FILM = 0.15;       // depth within which the water's edge fades into wet sand [m]

// Foam of the shore: bores that run in over the shallows, denser with less depth, and swash at the edge. bed: depth of
// the bed below the surface here [m]. Gives intensity and zone.
vec2 shore_foam(crest_pixel p, float bed) {
    float hs = shore_height;
    float depth = min(bed, max(p.depth, 0.0) + hs), length = bore_length();
    // where the bed hardly rises, waves broke before they came there
    float near = shallows(p.shore / length, SURF_FULL_FROM_SHORE, SURF_NONE_FROM_SHORE);
    if (near <= 0.0 || depth >= SURF_LOOK.zone_none * hs) return vec2(0.0, RAMP_SURF);
    vec2 at = mod(eye_wrapped + p.rest, WORLD_WRAP) * (2.0 * PI / WORLD_WRAP);
    float wobble = sin(61.0 * at.x + 2.0 * sin(37.0 * at.y)) + sin(83.0 * at.y + 2.0 * sin(49.0 * at.x));
    float front = bore_foam(behind_front(p.rest, max(p.depth, 0.0), 0.22 * wobble));
    float running = mix(BORE_MEAN, front, clamp(length / (6.0 * p.width), 0.0, 1.0));
    float breaking = surf_cover(mix(SURF_LOOK.zone_none, max(depth / hs, 0.0), near), running, SURF_LOOK);
    float edge = swash_cover(bed, surf_time + 0.2 * wobble, SURF_LOOK);
    return vec2(clamp(max(breaking, edge), 0.0, 1.0),
                mix(RAMP_SURF, RAMP_SWASH, clamp(1.0 - p.shore / SWASH_ZONE, 0.0, 1.0)));
}

// How deep below the pixel's water what is behind it lies [m]; 1e4 where nothing is.
float bed_depth(ivec2 at, vec3 position) {
    float depth = texelFetch(scene_depth, at, 0).x;
    if (depth <= 0.0) return 1e4;
    vec3 bed = frame_ray((vec2(at) + 0.5) * pixel_size) / depth;
    return position.z - bed.z;
}

// The bed through the water, bent by the waves, or the deep water's light where it is out of sight.
vec3 bed_light(ivec2 at, vec3 deep, vec3 position, vec3 view, vec2 slope, inout float bed) {
    vec3 both_ways = exp(-water_attenuation * bed_path(bed, refracted_cosine(view.z, water_index)));
    if (max(both_ways.b, both_ways.g) < 0.01) return deep;
    float bend = min(bed, 3.0) * 0.25 / (length(position) * radians_per_pixel);
    vec2 aside = vec2(dot(slope, vec2(-view.y, view.x)), -dot(slope, view.xy)) * bend;
    ivec2 bent = clamp(at + ivec2(aside), ivec2(0), ivec2(viewport_size) - 1);
    if (effect_is_on(EFFECT_DISTORTION) && bed_depth(bent, position) > 0.0) at = bent;
    return radiance_of_bed(texelFetch(scene_color, at, 0).rgb, deep, both_ways);
}
#endif

// ---- together -------------------------------------------------------------------------------------------------------

vec3 sun_glitter(crest_pixel p, vec2 slope, float area, vec3 sunlight) {
    vec3 middle = p.view + sun_direction;
    middle *= inversesqrt(max(dot(middle, middle), 1e-6));
    float reflectance = fresnel_fast(clamp(dot(p.view, middle), 0.0, 1.0), water_index);
    float up = step(-0.01, sun_direction.z);
    return sunlight * (up * rough_glint_at(middle, reflectance, slope, p.slopes, area, p.lit));
}

// False colours (the paper's figure 3): red crests, green shore and foam, blue open sea, shaded by what is mirrored.
vec3 false_colors(float mask, float foam, float reflectance, vec3 normal) {
    float rest = 1.0 - max(mask, foam);
    return vec3(mask, foam, rest) * (0.35 + 0.65 * reflectance + 0.3 * normal.x) / max(exposure, vec3(1e-9));
}

vec3 light_here(ivec2 at, uvec4 shape) {
    crest_pixel p = pixel_here(at, shape);
    wave_fields w = waves_here(p);
    float flat_length = max(sqrt(dot(p.view.xy, p.view.xy)), 1e-4);
    vec2 toward = p.view.xy / flat_length;
    rough_facets seen = rough_seen(p.view, w.slope, p.slopes);
    vec3 normal = normalize(vec3(toward * seen.shift - w.slope, 1.0));
    float reflectance = fresnel_mean_fast(max(dot(p.view, normal), 0.0), seen.sigma, water_index);

    vec3 sunlight = sun_light * p.air.shade;
    vec3 below = water_reflectance * (sunlight * (max(sun_direction.z, 0.0) * SUN_ENTERS) + SKY_ENTERS * sky_light);
    float rise = earth_height(p.position.z, eye_height, dot(p.rest, p.rest), earth_radius);
    float mask = crest_mask(p, w, rise, toward);
    float foam = open_foam(w, p.slopes), zone = RAMP_OPEN;
#ifdef LAND
    float bed = bed_depth(at, p.position);
    vec2 surf = shore_foam(p, bed);
    if (surf.x > foam) {
        foam = surf.x;
        zone = surf.y;
    }
    if (effect_is_on(EFFECT_REFRACTION)) below = bed_light(at, below, p.position, p.view, w.slope, bed);
#endif
    if (effect_is_on(EFFECT_SCATTERING)) below += crest_light(mask, p.view, sunlight);
    vec3 surface = (1.0 - reflectance) * below;
    if (effect_is_on(EFFECT_REFLECTION)) {
        vec3 mirrored = reflect(-p.view, normal);
        surface += reflectance * environment_radiance(vec3(mirrored.xy, abs(mirrored.z)), seen.sigma);
    }
    if (effect_is_on(EFFECT_GLITTER)) surface += sun_glitter(p, w.slope, seen.area, sunlight);
    if (effect_is_on(EFFECT_FOAM) && foam > 0.0) {
        vec2 lather = vec2(foam, 0.87); // from afar, the mean
        if (foam > 0.02 && p.fine < 2.0) lather = foam_opacity(p.rest, p.fine, foam, zone);
        vec3 light = foam_radiance(sunlight, dot(sun_direction, normal), sky_light);
        light *= lather.y * FOAM_ALBEDO * FOAM_DENSEST;
        surface = mix(surface, light, lather.x * min(foam_strength, 1.0));
    }
    surface = surface * p.air.transmittance + p.air.inscatter;
    if (look_show > 0.5 && look_show < 1.5) surface = false_colors(mask, foam, reflectance, normal);
#ifdef LAND
    float film = smoothstep(0.0, FILM, bed);
    if (film < 1.0) surface = mix(texelFetch(scene_color, at, 0).rgb, surface, film);
#endif
    return surface;
}

void main() {
    ivec2 at = sampled_pixel(gl_FragCoord.xy);
    uvec4 shape = texelFetch(surface_shape, at, 0);
    color = vec4(0.0);
    if (shape.x != 0u) color = vec4(light_here(at, shape), 1.0);
#ifndef SPARSE // there, what is cleared is no water
    if (shape.x == 0u) discard;
#endif
}
#endif
