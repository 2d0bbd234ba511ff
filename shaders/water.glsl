// SPDX-License-Identifier: MIT
// The light of the water, pixel by pixel over the surface that water_surface.glsl left. What the pixel cannot resolve of the
// waves is in the covariance of its slopes (Bruneton, Neyret & Holzschuch 2010), which widens the sun's glitter, blurs the
// mirrored sky and lowers the mean Fresnel reflectance; the light from below comes from the sea bed behind and from the water's
// own backscatter (Gordon et al. 1988; Lee et al. 1998 for finite depth).
//
// LAND: there is terrain: depth attenuates the waves, the bed shines through, land is mirrored, the shore foams.
// TAPS: most look-ups along the long side of the pixel's footprint. RAYS: mirrored rays that look for land.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#ifndef RAYS // set by quality; this serves an offline compiler
#define RAYS 3
#endif
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/fresnel.glsl"
#include "common/slopes.glsl"
#include "common/foam.glsl"
#include "common/surf.glsl"

out vec4 color;

#pragma unit surface_rest 16
#pragma unit surface_slope 17
#pragma unit surface_transmittance 18
#pragma unit surface_inscatter 19
uniform highp sampler2D surface_rest; // water_surface.glsl's outputs
uniform sampler2D surface_slope;
uniform sampler2D surface_transmittance;
uniform sampler2D surface_inscatter;
uniform vec4 foam_law;    // x: Jacobian threshold (below -999: nothing foams), y: slope variance beyond the cascades
uniform vec4 foam_edge;   // x, y: variances that soften the edges of fresh and of old foam; the thresholds allow for them; z: choppiness squared
uniform vec4 foam_memory; // x: threshold of the foam memory (above 999: none), y: its variance, z: variance of the Jacobian, all scales

#ifdef LAND
#pragma unit scene_color 3
#pragma unit scene_depth 4
uniform sampler2D scene_color; // what lies behind the water
uniform sampler2D scene_depth;
#endif

#ifdef LAND
// What lies behind the water at a place of the picture: its colour as lit in air, and where it is; w = 0 where there is nothing.
vec4 behind(vec2 uv, out vec3 where) {
    float depth = textureLod(scene_depth, uv, 0.0).x;
    where = frame_ray(uv) / max(depth, 1e-9);
    return vec4(textureLod(scene_color, uv, 0.0).rgb, depth > 0.0 ? 1.0 : 0.0);
}

// The land that a mirrored ray meets, found in the picture itself: rgb, w = how much of it counts.
vec4 mirrored_land(vec3 position, vec3 direction) {
    vec4 origin = view_projection * vec4(position, 1.0), step = view_projection * vec4(direction, 0.0);
    float near = 0.0, far = 3.0;
    bool hit = false, lost = direction.z > 0.6;
    for (int i = 0; i < 12 && !hit && !lost; ++i) {
        vec4 c = origin + step * far;
        vec2 uv = c.xy / c.w * 0.5 + 0.5;
        lost = c.w <= 0.0 || uv.x < 0.0 || uv.x > 1.0 || uv.y > 1.0 || uv.y < 0.0;
        float depth = textureLod(scene_depth, uv, 0.0).x;
        hit = !lost && depth > 0.0 && frame_distance(depth) < c.w;
        if (!hit) { near = far; far *= 2.0; }
    }
    vec2 uv = vec2(0.0);
    for (int i = 0; i < 5 && hit; ++i) {
        float middle = 0.5 * (near + far);
        vec4 c = origin + step * middle;
        uv = c.xy / c.w * 0.5 + 0.5;
        float depth = textureLod(scene_depth, uv, 0.0).x;
        if (depth > 0.0 && frame_distance(depth) < c.w) far = middle;
        else near = middle;
    }
    vec3 land;
    vec4 seen = behind(uv, land);
    bool dry = hit && seen.w > 0.0 && land.z + eye.z > -0.3; // else it ended on the sea bed
    vec2 edge = min(uv, 1.0 - uv);
    return vec4(seen.rgb, dry ? smoothstep(0.0, 0.05, min(edge.x, edge.y)) : 0.0);
}

// The mirrored sky with the land before it. Several tilts stand for the distribution of the facets: with one alone a hill is
// mirrored in scraps.
vec3 mirror_land(vec3 sky, vec3 position, vec3 view, vec2 slope, vec2 toward, visible_facets seen) {
    vec4 land = vec4(0.0);
    for (int i = 0; i < RAYS; ++i) {
        float tilt = RAYS == 1 ? 0.0 : float(i - 1) * 1.2;
        vec3 ray = reflect(-view, normalize(vec3(-(slope - toward * (seen.shift + tilt * seen.sigma)), 1.0)));
        vec4 one = mirrored_land(position, vec3(ray.xy, abs(ray.z)));
        float weight = RAYS == 1 ? 0.75 : i == 1 ? 0.5 : 0.25;
        land += weight * vec4(one.rgb * one.w, one.w);
    }
    return sky * (1.0 - land.w) + land.rgb;
}

// The bed's share of the radiance that leaves the water, and the depth of water over it [m].
vec3 bed_radiance(vec2 uv, vec3 deep, vec3 position, vec3 view, vec3 normal, out float water_path) {
    vec3 refracted = refract(-view, normal, 1.0 / water_deep.w);
    float down = max(-refracted.z, 0.3);
    vec3 bed, bent_bed;
    vec4 seen = behind(uv, bed);
    float drop = clamp(position.z - bed.z, 0.0, 60.0);
    vec4 target = view_projection * vec4(position + refracted * (drop / down), 1.0);
    vec2 bent = clamp(target.xy / target.w * 0.5 + 0.5, 0.001, 0.999);
    vec4 s = behind(bent, bent_bed);
    if (s.w > 0.0 && bent_bed.z < position.z) { seen = s; bed = bent_bed; }
    water_path = seen.w > 0.0 ? max(position.z - bed.z, 0.0) : 1e4;
    vec3 both_ways = exp(-water_kd.rgb * water_path * (1.0 + 1.0 / down));
    // 0.54: through the surface twice, (1 - F)^2 / n^2 with the internal reflection's return
    return seen.rgb * 0.54 * both_ways + deep * (1.0 - both_ways);
}

// Broken water near the shore: bores that run in over the shallows with foam behind their fronts, surge at rocks, swash at
// the edge. Up a slope the fronts follow the depth; over flats they travel the way the sea goes.
float shore_cover(vec2 rest, float depth, float least, float water_path, vec4 noise) {
    float hs = surf_height(), wobble = noise.b - 0.5;
    float zone = smoothstep(1.6 * hs, 0.35 * hs, depth + wobble * hs);
    float cover = zone * (0.1 + 0.9 * bore(behind_front(rest, depth, 0.9 * wobble + 0.5 * noise.a)));
    float surge = 0.55 + 0.45 * sin(2.0 * SLOPES_PI * (surf.w + 2.0 * wobble));
    float rocks = smoothstep(0.8, -1.5, least) * surge;
    float swash = smoothstep(0.35, 0.02, water_path) * 0.75;
    return clamp(max(max(cover, rocks), swash), 0.0, 1.0);
}
#endif

// Covered shares by breaking crests and by what they leave (Dupuy & Bruneton 2012: the mean and the hidden variance of the Jacobian).
void breaking_cover(wave_fields w, vec3 covariance, out float fresh, out float old) {
    float variance = max(covariance.x + covariance.z - foam_law.y, 0.0) * foam_edge.z;
    fresh = foam_law.x < -999.0 ? 0.0 : normal_cdf((foam_law.x - w.jacobian) * inversesqrt(variance + foam_edge.x));
    float hidden = clamp(variance / max(foam_memory.z, 1e-6), 0.0, 1.0);
    old = foam_memory.x > 999.0 ? 0.0 : normal_cdf((w.foam - foam_memory.x) * inversesqrt(foam_memory.y * (hidden + foam_edge.y)));
}

void main() {
    ivec2 pixel = sampled_pixel();
    vec2 uv = (vec2(pixel) + 0.5) * viewport.zw;
    vec4 through_air = texelFetch(surface_transmittance, pixel, 0);
    if (through_air.w < 0.5) discard; // no water here
    vec4 rest_depth = texelFetch(surface_rest, pixel, 0), slope_light = texelFetch(surface_slope, pixel, 0);
    vec4 from_air = texelFetch(surface_inscatter, pixel, 0);
    vec3 position = frame_ray(uv) / rest_depth.w;
    vec2 rest = rest_depth.xy;
    float gust = slope_light.z, shade = slope_light.w;
    float dist = length(position);
    vec3 view = -position / dist;
    footprint f = pixel_footprint(view, dist, slope_light.xy);
    wave_fields w = waves_at(rest, f, gust, rest_depth.z, vec4(slope_light.xy, through_air.w - 4.0, 0.0));
#ifdef WAVES_CASCADES
    f.minor = max(f.minor, f.major / float(TAPS)); // what the look-ups really averaged over
#endif
    vec3 covariance = unresolved_slopes(f);
    vec3 shaded = covariance * gust * gust;

    vec2 slope = w.slope;
    // the facets that the eye sees lean towards it
    visible_facets seen = facets_seen(view, slope, shaded);
    vec2 toward = view.xy / max(length(view.xy), 1e-4);
    vec3 normal = normalize(vec3(-slope, 1.0));
    vec3 leaning = normalize(vec3(-(slope - toward * seen.shift), 1.0));
    float index = water_deep.w;
    float reflectance = mean_fresnel(clamp(dot(view, normal), 0.02, 1.0), index, seen.sigma);
    vec3 mirrored = reflect(-view, leaning);
    mirrored.z = abs(mirrored.z);
    vec3 sky = environment_radiance(mirrored, seen.sigma);
#ifdef LAND
    sky = mirror_land(sky, position, view, slope, toward, seen);
#endif

    vec3 half_vector = normalize(view + sun.xyz);
    vec2 facet = -half_vector.xy / max(half_vector.z, 1e-3);
    float hz2 = half_vector.z * half_vector.z;
    float sun_seen = facets_seen(sun.xyz, slope, shaded).area;
    float glint = slope_density(facet, slope, shaded) * fresnel(clamp(dot(view, half_vector), 0.0, 1.0), index) /
                  (4.0 * hz2 * hz2 * max(seen.area, 0.01)) * clamp(max(sun.z, 0.0) / max(sun_seen, 1e-3), 0.0, 1.0);
    vec3 sunlight = sun_light.rgb * shade;
    vec3 glitter = sunlight * min(glint, 400.0) * step(-0.01, sun.z);

    vec3 irradiance = sunlight * max(sun.z, 0.0) * (1.0 - fresnel(clamp(dot(sun.xyz, normal), 0.05, 1.0), index)) +
                      sky_light.rgb * 0.93;
    vec3 below = water_deep.rgb * irradiance;
    // light that entered the far side of a crest leaves through the near one
    float ahead = clamp(dot(-view, normalize(vec3(sun.xy, max(sun.z, 0.05)))), 0.0, 1.0);
    float crest = clamp((position.z + eye.z) / max(sea_law.x, 0.3), 0.0, 1.0);
    vec3 glow = water_deep.rgb * sunlight * (ahead * ahead * ahead * 5.0 + 0.6) * crest * clamp(1.2 - w.jacobian, 0.0, 1.0);

    float fresh, old, film = 1.0;
    breaking_cover(w, covariance, fresh, old);
    foam_texels texels = foam_look_up(rest, f.minor);
#ifdef LAND
    float water_path;
    below = bed_radiance(uv, below, position, view, normal, water_path);
    fresh = max(fresh, shore_cover(rest, rest_depth.z, from_air.w, water_path, texels.broad));
    film = smoothstep(0.0, 0.12, water_path); // the last centimetres over the sand
#endif
    vec3 surface = reflectance * sky + glitter + (1.0 - reflectance) * (below + glow);

    float foam = foam_alpha(texels, f.minor, fresh, old) * water_kd.w;
    vec3 foam_light = (sunlight * max(dot(sun.xyz, normal), 0.0) + sky_light.rgb) / SLOPES_PI;
    surface = mix(surface, foam_light * 0.72, clamp(foam, 0.0, 1.0) * 0.92);
#ifdef LAND
    surface = mix(texelFetch(scene_color, pixel, 0).rgb, surface, film);
#endif
    color = vec4(surface * through_air.rgb + from_air.rgb, 1.0);
}
#endif
