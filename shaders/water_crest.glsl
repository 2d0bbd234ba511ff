// SPDX-License-Identifier: MIT
// Light through the crests and ramps of foam (Ni, Zhang & Tan, "Ocean simulation of a flight simulator's view"), per pixel:
//
//   color = F sky(mirrored) + glitter + (1 - F) (bed or deep water + light through crests), under foam
//
// Light that enters the far side of a wave leaves through the near one. Where that can be, a mask of crests says; how much, the
// directions of sun and view. The paper: mask = |displacement| / peak wave length, a fixed tint. Here by default: a mask from
// height, pinch and the side that faces the eye, and the tint that the water's own attenuation leaves of sunlight over a
// path through the crest.
//
// What varies slowly is made at the vertices: roughness below the pixel, its share of light and shade, widths. The facets that
// the eye sees lean towards it; their mean tilt, their area and the mean Fresnel reflectance are rational and quadratic forms of
// what common/slopes.glsl and common/fresnel.glsl have by exponentials (tests/shaders/test_crest_shader.c binds them).
//
// LAND, QUAD, PACKED: see common/water_vertex.glsl and common/waves.glsl. TAPS: how much sharper than its long side a footprint is
// looked up.
#include "common/frame.glsl"
#ifndef TAPS
#define TAPS 2
#endif
#include "common/water_vertex.glsl"
#include "common/facets.glsl"

// What a pixel does not resolve: slope covariance (xx, xy, yy); w: rms slope along the view.
// x: log2 of the width [m] that the waves are looked up at, y: steepness of the edges of fresh foam, z: of old foam, w: share of
// the sunlit facets that no wave shades.
struct crest_rough { vec4 slopes, widths; };

uniform vec4 crest_foam;   // x: sum dxx + dyy (choppiness applied) where a crest breaks, y: foam memory where old foam begins, z, w: variances that soften these edges
uniform vec4 crest_hidden; // x: slope variance beyond the cascades, y: choppiness squared, z: variance of the memory over that of the slopes

crest_rough rough_at(vec3 position, vec2 slope, float gust) {
    float dist = length(position);
    vec3 view = -position / dist;
    footprint f = pixel_footprint(view, dist, slope);
    f.minor = max(f.minor, f.major / float(TAPS));
    vec3 c = unresolved_slopes(f);
    float hidden = max(c.x + c.z - crest_hidden.x, 0.0) * crest_hidden.y;
    vec2 edges = inversesqrt(6.2831853 * vec2(hidden + crest_foam.z, hidden * crest_hidden.z + crest_foam.w));
    c *= gust * gust;
    float lit = facets_lit(sun.xyz, sqrt(facets_variance(c, sun.xy)));
    return crest_rough(vec4(c, sqrt(facets_variance(c, view.xy))), vec4(log2(f.minor), edges, lit));
}

#ifdef VERTEX
#ifndef QUAD
out vec4 crest_slopes;
out vec4 crest_widths;
#ifdef LAND
out float crest_shore; // distance to the shore as the bed's slope here has it [m]
#endif

#ifdef LAND
float shore_distance(vec2 rest, float depth) {
    vec2 x = vec2(8.0, 0.0), rise = vec2(water_depth(rest + x) - water_depth(rest - x), water_depth(rest + x.yx) - water_depth(rest - x.yx));
    return depth * 16.0 * inversesqrt(max(dot(rise, rise), 1e-4));
}
#endif
#endif

void main() {
    water_vertex();
#ifndef QUAD
    crest_rough r = rough_at(water_place.xyz, water_mesh.xy, water_light.x);
    crest_slopes = r.slopes;
    crest_widths = r.widths;
#ifdef LAND
    crest_shore = shore_distance(water_rest, water_place.w);
#endif
#endif
}
#endif

#ifdef FRAGMENT
#include "common/look.glsl"
out vec4 color;

#ifndef QUAD
in vec4 crest_slopes;
in vec4 crest_widths;
#ifdef LAND
in float crest_shore;
#endif
#endif

#pragma unit foam_densities 18
#pragma unit foam_ramps 19
uniform sampler2D foam_densities; // opacity of thin, middling and dense foam; a: its bubbles
uniform sampler2D foam_ramps;     // by intensity (s) and zone (t): the shares of the three; a: foam without holes

const float RAMP_SWASH = 0.125, RAMP_SURF = 0.375, RAMP_OPEN = 0.625; // rows of foam_ramps

const vec3 PAPER_TINT = vec3(0.088, 0.497, 0.456);

crest_rough rough_here(water_pixel p) {
#ifdef QUAD
    return rough_at(p.position, vec2(0.0), 1.0);
#else
    return crest_rough(crest_slopes, crest_widths);
#endif
}

wave_fields waves_here(water_pixel p, crest_rough r) {
#if defined(WAVES_CASCADES) && defined(PACKED)
    return waves_of_width(p.rest, r.widths.x, p.gust, p.depth);
#else
    float dist = length(p.position);
    return waves_at(p.rest, pixel_footprint(-p.position / dist, dist, p.mesh.xy), p.gust, p.depth, p.mesh);
#endif
}

// ---- light through crests -------------------------------------------------------------------------------------------

// The mask of crests, 0..1. `rise`: of the mean water's surface here [m]; toward: horizontal direction to the eye.
float crest_mask(water_pixel p, wave_fields w, float rise, vec2 toward) {
    if (look_mix.z > 0.5) return clamp(10.0 * length(vec3(p.position.xy - p.rest, rise)) / sea_law.y, 0.0, 1.0);
    float high = clamp(0.35 + 0.9 * rise / max(sea_law.x, 0.2), 0.0, 1.0);
    float pinched = clamp(0.25 + 1.3 * (1.0 - w.jacobian), 0.0, 1.0);
    float facing = clamp(0.4 - 2.0 * dot(w.slope, toward), 0.0, 1.0); // the side that leans to the eye
    return high * pinched * facing * 2.0 * min(1.0, 2.0 * high);
}

// Light from below that came through crests. ahead: cosine between the view and the sunlight's way.
vec3 crest_light(float mask, vec3 view, vec3 sunlight) {
    float ahead = max(-dot(view, sun.xyz), 0.0);
    float towards = ahead * ahead;
    towards *= towards * ahead; // ^5
    float across = (1.0 - view.z * view.z) * mask;
    if (look_mix.z > 0.5) return 1.7 * towards * across * PAPER_TINT * sunlight / 3.14159265; // base 0, sun 1.7
    float path = clamp(1.2 * sea_law.x, 0.5, 5.0);
    // forward scattering, most of it within 40 degrees; the rest, from all around, lights every thin crest a little
    return (0.16 * towards + 0.012) * across * exp(-path * water_kd.rgb) * (sunlight + 0.3 * sky_light.rgb);
}

// ---- foam -----------------------------------------------------------------------------------------------------------

// Shares of foam by breaking crests and by what they left behind (means over what the pixel does not resolve).
float open_foam(wave_fields w, crest_rough r) {
    float fresh = clamp(0.5 + (crest_foam.x - (w.jacobian - 1.0)) * r.widths.y, 0.0, 1.0);
    float old = clamp(0.5 + (w.foam - crest_foam.y) * r.widths.z, 0.0, 1.0);
    return max(fresh, 0.55 * old);
}

// Opacity; a: brightness of the bubbles.
vec2 foam_opacity(vec2 rest, float width_log2, float intensity, float zone) {
    vec4 ramp = textureLod(foam_ramps, vec2(intensity, zone), 0.0);
    vec2 at = mod(eye.xy + rest, 4096.0);
    float level = width_log2 + 9.0; // a tile has 512 texels
    vec4 tile = textureLod(foam_densities, at * (1.0 / 16.0), max(level - 4.0, 0.0));
    if (width_log2 < -4.0) {
        vec4 close = textureLod(foam_densities, at.yx * (1.0 / 4.0), max(level - 2.0, 0.0));
        tile = mix(tile, sqrt(tile * close) , clamp(-4.0 - width_log2, 0.0, 1.0) * 0.6);
    }
    return vec2(clamp(dot(tile.rgb, ramp.rgb) + ramp.a, 0.0, 1.0), 0.75 + 0.25 * tile.a);
}

#ifdef LAND
// Foam of the shore: bores that run in over the shallows, denser with less depth, and swash at the edge. bed: depth of the bed below
// the surface here [m]. Gives intensity and zone.
vec2 shore_foam(water_pixel p, float bed, float width) {
    float hs = clamp(sea_law.x, 0.25, 4.0), period = clamp(sea_law.z, 3.0, 12.0);
    float depth = min(bed, max(p.depth, 0.0) + hs), reach = 2.2 * hs;
    float near = clamp(1.0 - depth / reach, 0.0, 1.0); // the paper's t = 1 - depth / foam depth
    if (near <= 0.0) return vec2(0.0, RAMP_SURF);
#ifdef QUAD
    float distance = 8.0 * depth;
#else
    float distance = crest_shore;
#endif
    float length = 0.5 * period * sqrt(9.81 * hs);
    vec2 at = (eye.xy + p.rest) * (6.2831853 / 4096.0);
    float wobble = sin(31.0 * at.x + 3.0 * sin(17.0 * at.y)) + sin(43.0 * at.y + 2.0 * sin(29.0 * at.x));
    float behind = fract(distance / length + sky_light.w / period + 0.16 * wobble);
    float bore = mix(0.3, smoothstep(0.0, 0.08, behind) * exp(-3.0 * behind), clamp(length / (6.0 * width), 0.0, 1.0));
    float surf = smoothstep(0.0, 0.5, near) * (0.12 + 0.88 * bore);
    float edge = smoothstep(0.5, 0.05, bed) * (0.6 + 0.3 * sin(6.2831853 * (sky_light.w / period + 0.2 * wobble)));
    return vec2(clamp(max(surf, edge), 0.0, 1.0), mix(RAMP_SURF, RAMP_SWASH, clamp(1.0 - distance / 12.0, 0.0, 1.0)));
}

#pragma unit scene_color 3
#pragma unit scene_depth 4
uniform sampler2D scene_color; // what lies behind the water
uniform sampler2D scene_depth;

// How deep below the pixel's water what is behind it lies [m]; 1e4 where nothing is.
float bed_depth(ivec2 at, vec3 position) {
    float depth = texelFetch(scene_depth, at, 0).x;
    if (depth <= 0.0) return 1e4;
    vec3 bed = frame_ray((vec2(at) + 0.5) * viewport.zw) / depth;
    return position.z - bed.z;
}

// The bed through the water, bent by the waves, or the deep water's light where it is out of sight.
vec3 bed_light(vec3 deep, vec3 position, vec3 view, vec2 slope, inout float bed) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 both_ways = exp(-water_kd.rgb * bed * (1.0 + 1.0 / max(0.66, sqrt(0.44 + 0.56 * view.z * view.z))));
    if (max(both_ways.b, both_ways.g) < 0.01) return deep;
    float bend = min(bed, 3.0) * 0.25 / (length(position) * lens.x);
    ivec2 bent = clamp(at + ivec2(vec2(dot(slope, vec2(-view.y, view.x)), -dot(slope, view.xy)) * bend), ivec2(0), ivec2(viewport.xy) - 1);
    if (effect_is_on(EFFECT_DISTORTION) && bed_depth(bent, position) > 0.0) at = bent;
    // 0.54: through the surface twice, (1 - F)^2 / n^2 with the internal reflection's return
    return texelFetch(scene_color, at, 0).rgb * 0.54 * both_ways + deep * (1.0 - both_ways);
}
#endif

// ---- together -------------------------------------------------------------------------------------------------------

vec3 sun_glitter(vec3 view, vec2 slope, crest_rough r, float area, vec3 sunlight) {
    vec3 bisector = view + sun.xyz;
    vec2 off = -bisector.xy / max(bisector.z, 1e-3) - slope;
    float det = max(r.slopes.x * r.slopes.z - r.slopes.y * r.slopes.y, 1e-14);
    float q = (r.slopes.z * off.x * off.x - 2.0 * r.slopes.y * off.x * off.y + r.slopes.x * off.y * off.y) / det;
    if (q > 30.0 || sun.z < -0.01) return vec3(0.0);
    float length2 = dot(bisector, bisector), hz2 = bisector.z * bisector.z / length2;
    float grazing = 1.0 - 0.5 * sqrt(length2); // the bisector's length is twice the cosine of incidence
    float fresnel = 0.02 + 0.98 * grazing * grazing * grazing * grazing * grazing;
    float density = exp(-0.5 * q) * inversesqrt(det) * (0.5 / 3.14159265);
    return sunlight * min(density * fresnel / (4.0 * hz2 * hz2 * max(area, 0.01)) * r.widths.w, 400.0);
}

void main() {
    water_pixel p = water_here();
    crest_rough r = rough_here(p);
    wave_fields w = waves_here(p, r);
    vec3 view = -p.position * inversesqrt(dot(p.position, p.position));
    float flat_length = max(length(view.xy), 1e-4);
    vec2 toward = view.xy / flat_length;
    facets seen = facets_toward(view.z, flat_length, dot(w.slope, toward), r.slopes.w);
    vec3 normal = normalize(vec3(toward * seen.tilt - w.slope, 1.0));
    float reflectance = facets_fresnel(max(dot(view, normal), 0.0), seen.rms, water_deep.w);

    vec3 sunlight = sun_light.rgb * p.shade;
    vec3 below = water_deep.rgb * (sunlight * (max(sun.z, 0.0) * 0.95) + 0.93 * sky_light.rgb);
    float rise = p.position.z + eye.z + dot(p.rest, p.rest) / (2.0 * lens.w);
    float foam = 0.0, zone = RAMP_OPEN, film = 1.0, shore = 0.0;
#ifdef LAND
    float bed = bed_depth(ivec2(gl_FragCoord.xy), p.position);
    film = smoothstep(0.0, 0.15, bed); // the last centimetres over the sand
    vec2 surf = shore_foam(p, bed, exp2(r.widths.x));
    shore = surf.x;
    if (effect_is_on(EFFECT_REFRACTION)) below = bed_light(below, p.position, view, w.slope, bed);
#endif
    float mask = crest_mask(p, w, rise, toward);
    foam = open_foam(w, r);
#ifdef LAND
    if (shore > foam) {
        foam = shore;
        zone = surf.y;
    }
#endif
    if (look_mix.w > 0.5 && look_mix.w < 1.5) { // the paper's figure 3
        color = vec4(vec3(mask, max(foam, shore), 1.0 - max(mask, max(foam, shore))) * (0.35 + 0.65 * reflectance + 0.3 * normal.x) / max(sun_light.w, 1e-9), 1.0);
        return;
    }
    if (effect_is_on(EFFECT_SCATTERING)) below += crest_light(mask, view, sunlight);
    vec3 surface = (1.0 - reflectance) * below;
    if (effect_is_on(EFFECT_REFLECTION)) {
        vec3 mirrored = reflect(-view, normal);
        surface += reflectance * environment_radiance(vec3(mirrored.xy, abs(mirrored.z)), seen.rms);
    }
    if (effect_is_on(EFFECT_GLITTER)) surface += sun_glitter(view, w.slope, r, seen.area, sunlight);
    if (effect_is_on(EFFECT_FOAM) && foam > 0.004) {
        vec2 lather = foam_opacity(p.rest, r.widths.x, foam, zone);
        vec3 light = (sunlight * max(dot(sun.xyz, normal), 0.0) + sky_light.rgb) * (lather.y * 0.66 / 3.14159265);
        surface = mix(surface, light, lather.x * min(water_kd.w, 1.0));
    }
    color = vec4(surface * p.transmittance + p.inscatter, 1.0);
#ifdef LAND
    if (film < 1.0) color.rgb = mix(texelFetch(scene_color, ivec2(gl_FragCoord.xy), 0).rgb, color.rgb, film);
#endif
}
#endif
