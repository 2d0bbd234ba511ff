// SPDX-License-Identifier: MIT
// The water surface: displaced by the cascades, shaded by filtered slopes. What the pixel cannot resolve of the waves is in
// the covariance of its slopes (Bruneton, Neyret & Holzschuch 2010), which widens the sun's glitter, blurs the mirrored
// sky and lowers the mean Fresnel reflectance; the light from below comes from the sea bed behind and from the water's own
// backscatter (Gordon et al. 1988; Lee et al. 1998 for finite depth).
#include "common/frame.glsl"
#include "common/shore.glsl"
#include "common/sea.glsl"

#ifdef VERTEX
layout(location = 0) in vec4 vertex; // eye-relative mean water; w: spacing [m]
out vec3 rest_depth;  // undisplaced xy, mean depth of the water [m]
out vec3 position;    // displaced, eye-relative
out vec2 coarse_slope;

void main() {
    vec2 rest = vertex.xy;
    float depth = -shore_elevation(rest);
    vec3 offset = vec3(0.0);
    coarse_slope = vec2(0.0);
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (vertex.w > band.z) continue; // every wave of it is shorter than the mesh
        float lod = log2(max(vertex.w / band.y, 1.0));
        vec3 uv = vec3(cascade_uv(c, rest), float(c));
        vec4 s = textureLod(displacement_map, uv, lod);
        float keep = shore_attenuation(depth, band.x);
        offset += keep * vec3(choppiness * s.xy, s.z);
        coarse_slope += keep * textureLod(slope_map, uv, lod).xy;
    }
    rest_depth = vec3(rest, depth);
    position = vertex.xyz + offset;
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
#include "common/fresnel.glsl"
#include "common/slopes.glsl"
#include "common/atmosphere.glsl"

in vec3 rest_depth;
in vec3 position;
in vec2 coarse_slope;
out vec4 color;

#pragma unit scene_color 3
#pragma unit scene_depth 4
#pragma unit slope_table 6
#pragma unit foam_detail 7
#pragma unit foam_map 10
uniform sampler2D scene_color;
uniform sampler2D scene_depth;
uniform sampler3D slope_table;
uniform sampler2DArray foam_map;
uniform sampler2D foam_detail;
uniform vec4 foam_memory; // x: threshold of the foam memory, y: its variance, z: variance of the Jacobian, all scales
uniform vec4 foam_law;   // x: Jacobian threshold, y: slope variance beyond the cascades, z: significant height [m], w: peak period [s]

#ifndef TAPS
#define TAPS 2
#endif

// The part of the water's plane under one pixel: an ellipse, long along the view.
struct footprint {
    vec2 axis; // horizontal direction of the long side
    float major, minor; // widths [m]
};

footprint pixel_footprint(vec3 view, float dist) {
    footprint f;
    f.axis = normalize(view.xy + vec2(1e-6, 0.0));
    f.minor = max(dist * lens.x, 1e-4);
    vec3 n = normalize(vec3(-coarse_slope, 1.0));
    f.major = f.minor / clamp(dot(view, n), 0.01, 1.0);
    return f;
}

// Slope covariance (xx, xy, yy) that this footprint removes.
vec3 unresolved_slopes(footprint f) {
    // the look-ups average over about half a width at each end: standard deviation 0.4 of the width
    float major = log2(max(0.4 * f.major, 1e-4)), aspect = log2(f.major / max(f.minor, f.major / 127.0));
    float angle = atan(f.axis.y, f.axis.x) / SLOPES_PI;
    angle -= floor(angle);
    vec3 t = vec3(((major + 8.0) * 1.5 + 0.5) / 24.0, (aspect + 0.5) / 8.0, (angle * 8.0 + 0.5) / 9.0);
    vec3 m = textureLod(slope_table, t, 0.0).xyz; // xx, xy, yy
    return m + vec3(6e-6, 0.0, 6e-6); // the sun's radius, in slopes
}

// Resolved fields, averaged over the footprint.
struct fields {
    vec2 slope;
    vec3 gradient; // dxx, dyy, dxy of the displacement, choppiness applied
    float foam;
};

fields gather(vec2 rest, float depth, footprint f, float gust) {
    fields r = fields(vec2(0.0), vec3(0.0), 0.0);
    float width = max(f.minor, f.major / float(TAPS));
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (width > 0.6 * band.z) continue; // the filter has left nothing of it
        float lod = log2(max(width / band.y, 1e-3));
        vec3 centre = vec3(cascade_uv(c, rest), float(c));
        vec4 slopes = vec4(0.0);
        for (int i = 0; i < TAPS; ++i) {
            vec2 p = rest + f.axis * f.major * ((float(i) + 0.5) / float(TAPS) - 0.5);
            slopes += textureLod(slope_map, vec3(cascade_uv(c, p), float(c)), lod);
        }
        float keep = shore_attenuation(depth, band.x) * (band.z < 20.0 ? gust : 1.0);
        r.slope += keep / float(TAPS) * slopes.xy;
        r.gradient += keep * choppiness * vec3(slopes.zw / float(TAPS), textureLod(displacement_map, centre, lod).w);
        r.foam += keep * textureLod(foam_map, centre, lod).x;
    }
    return r;
}

// The wind is never even: patches of rougher and smoother water, drawn out along it, a few hundred metres to kilometres wide.
// Factor on the rms slope of short waves; its square averages to 1.
float lattice(ivec2 p, int period) {
    p = ivec2(p.x & (period - 1), p.y & (period - 1));
    uint h = uint(p.x) * 0x9E3779B1u ^ uint(p.y) * 0x85EBCA77u;
    h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12u)) * 0x297A2D39u;
    return float(h >> 8u) * (1.0 / 16777216.0);
}

float smooth_noise(vec2 p, int period) {
    ivec2 i = ivec2(floor(p));
    vec2 f = p - vec2(i);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(lattice(i, period), lattice(i + ivec2(1, 0), period), f.x),
               mix(lattice(i + ivec2(0, 1), period), lattice(i + ivec2(1, 1), period), f.x), f.y);
}

float gustiness(vec2 rest, float width) {
    vec2 p = haze.zw + rest;
    p += 700.0 * (vec2(smooth_noise(p / 2048.0, 64), smooth_noise(p.yx / 2048.0 + 17.0, 64)) - 0.5);
    float large = smooth_noise(p / 4096.0, 32) - 0.5;
    float middle = (smooth_noise(p / 1024.0, 128) - 0.5) * clamp(2.0 - width / 500.0, 0.0, 1.0);
    float small = (smooth_noise(p / 256.0, 512) - 0.5) * clamp(2.0 - width / 120.0, 0.0, 1.0);
    return 1.0 + 0.26 * large + 0.24 * middle + 0.16 * small;
}

// What lies behind the water along a direction: its colour as lit in air, and its height; w = 0 where there is nothing.
vec4 behind(vec2 uv, out vec3 where) {
    float depth = texture(scene_depth, uv).x;
    where = frame_ray(uv) / max(depth, 1e-9);
    return vec4(texture(scene_color, uv).rgb, depth > 0.0 ? 1.0 : 0.0);
}

// The land that a mirrored ray meets, found in the picture itself: rgb, w = how much of it counts.
vec4 mirrored_land(vec3 direction) {
    if (direction.z > 0.6) return vec4(0.0);
    float near = 0.0, far = 3.0;
    bool hit = false;
    vec3 found;
    for (int i = 0; i < 14 && !hit; ++i, far *= 1.8) {
        vec4 c = view_projection * vec4(position + direction * far, 1.0);
        vec2 uv = c.xy / c.w * 0.5 + 0.5;
        if (c.w <= 0.0 || uv.x < 0.0 || uv.x > 1.0 || uv.y > 1.0 || uv.y < 0.0) return vec4(0.0);
        float depth = texture(scene_depth, uv).x;
        hit = depth > 0.0 && frame_distance(depth) < c.w;
        if (!hit) near = far;
    }
    if (!hit) return vec4(0.0);
    vec2 uv = vec2(0.0);
    for (int i = 0; i < 5; ++i) {
        float middle = 0.5 * (near + far);
        vec4 c = view_projection * vec4(position + direction * middle, 1.0);
        uv = c.xy / c.w * 0.5 + 0.5;
        float depth = texture(scene_depth, uv).x;
        if (depth > 0.0 && frame_distance(depth) < c.w) far = middle;
        else near = middle;
    }
    vec3 land;
    vec4 seen = behind(uv, land);
    if (seen.w == 0.0 || land.z + eye.z < -0.3) return vec4(0.0); // it ended on the sea bed
    vec2 edge = min(uv, 1.0 - uv);
    return vec4(seen.rgb, smoothstep(0.0, 0.05, min(edge.x, edge.y)));
}

// Radiance that leaves the water from below, before the surface's transmittance to the eye is taken off.
vec3 water_leaving(vec3 view, vec3 normal, vec3 irradiance, out float water_path) {
    vec2 uv = gl_FragCoord.xy * viewport.zw;
    vec3 deep = water_deep.rgb * irradiance;
    vec3 refracted = refract(-view, normal, 1.0 / water_deep.w);
    float down = max(-refracted.z, 0.3);
    vec3 bed;
    vec4 straight = behind(uv, bed);
    water_path = 1e4;
    if (straight.w == 0.0) return deep;
    float drop = clamp(position.z - bed.z, 0.0, 60.0);
    vec4 target = view_projection * vec4(position + refracted * (drop / down), 1.0);
    vec2 bent = target.xy / target.w * 0.5 + 0.5;
    vec3 bent_bed;
    vec4 seen = straight;
    if (all(greaterThan(bent, vec2(0.0))) && all(lessThan(bent, vec2(1.0)))) {
        vec4 s = behind(bent, bent_bed);
        if (s.w > 0.0 && bent_bed.z < position.z) { seen = s; bed = bent_bed; }
    }
    drop = max(position.z - bed.z, 0.0);
    water_path = drop;
    vec3 both_ways = exp(-water_kd.rgb * drop * (1.0 + 1.0 / down));
    // 0.54: through the surface twice, (1 - F)^2 / n^2 with the internal reflection's return
    return seen.rgb * 0.54 * both_ways + deep * (1.0 - both_ways);
}

// Foam. Its share of the pixel comes from the Jacobian's mean and the variance that the filter left (Dupuy & Bruneton 2012).
// Where the bubbles can be seen, a tiled texture whose values are uniformly distributed turns the share into a
// pattern: the texels above 1 - share. `soft` is the width of its edge.
float pattern(float value, float share, float soft) {
    soft = min(soft, 2.0 * min(share, 1.0 - share)) + 1e-4; // then the mean over all values is the share
    return smoothstep(1.0 - share - soft * 0.5, 1.0 - share + soft * 0.5, value);
}

float bubbles(vec2 p, float tile, float width) {
    return textureLod(foam_detail, p / tile, log2(max(width * 512.0 / tile, 1.0))).r;
}

// A weighted mean of uniform values is nearly Gaussian; back to uniform.
float flatten(vec3 values, vec3 weights) {
    return normal_cdf(dot(values - 0.5, weights) * 3.4641016 * inversesqrt(dot(weights, weights)));
}

float foam_cover(vec2 rest, float width, float fresh, float old) {
    if (fresh + old < 0.004) return 0.0;
    vec2 p = mod(eye.xy + rest, 4096.0);
    vec2 streak = vec2(dot(p, wind.xy) * 0.4, dot(p, vec2(-wind.y, wind.x))); // old foam is drawn out along the wind
    float broad = bubbles(p, 64.0, width), middle = bubbles(p.yx, 16.0, width), fine = bubbles(p, 3.0, width);
    float near = clamp(1.6 - width * 20.0, 0.0, 1.0), far = clamp(width / 5.0, 0.0, 1.0);
    float dense = flatten(vec3(broad, middle, fine), vec3(0.5, 0.45, 0.35 * near));
    float torn = bubbles(streak, 96.0, width), lace = flatten(vec3(bubbles(streak.yx, 14.0, width), middle, fine), vec3(0.7, 0.2, 0.3 * near));
    // fresh foam is thick in the middle of a patch and frayed at its edge; old foam is a net that thins out
    float a = mix(pattern(dense, fresh, 0.8) * (0.5 + 0.5 * smoothstep(0.0, 0.6, fresh)), fresh, far);
    float b = mix(pattern(lace, clamp(old * (0.4 + 1.2 * torn), 0.0, 0.9), 0.6) * (0.35 + 0.4 * old), 0.5 * old, far);
    return clamp(a + b * (1.0 - a), 0.0, 1.0) * mix(0.7 + 0.3 * fine, 1.0, far);
}

// How widely the edge of a breaking patch is drawn, in Jacobian; foam_law.x was moved to leave the covered share as it is.
const float FOAM_EDGE = 0.12;

void breaking_cover(fields w, float jacobian, vec3 covariance, out float fresh, out float old) {
    float variance = max(covariance.x + covariance.z - foam_law.y, 0.0) * choppiness * choppiness;
    fresh = normal_cdf((foam_law.x - jacobian) / sqrt(variance + FOAM_EDGE * FOAM_EDGE));
    float hidden = clamp(variance / max(foam_memory.z, 1e-6), 0.0, 1.0);
    old = normal_cdf((w.foam - foam_memory.x) / sqrt(foam_memory.y * (hidden + 0.1)));
}

float shore_cover(float depth, float water_path) {
    if (depth > 25.0) return 0.0;
    float hs = clamp(foam_law.z, 0.25, 4.0), period = clamp(foam_law.w, 3.0, 12.0);
    vec2 p = rest_depth.xy;
    float near_land = depth;
    for (int i = 0; i < 4; ++i) {
        vec2 d = 5.0 * vec2(i < 2 ? 1.0 : -1.0, (i & 1) == 0 ? 1.0 : -1.0);
        near_land = min(near_land, -shore_elevation(p + d));
    }
    vec2 q = mod(eye.xy + p, 4096.0);
    float wobble = textureLod(foam_detail, q / 180.0, 3.0).r - 0.5;
    float zone = smoothstep(1.6 * hs, 0.35 * hs, depth + wobble * hs);
    float phase = depth / (0.7 * hs) + sky_light.w / period + 1.4 * wobble;
    float bore = pow(0.5 + 0.5 * sin(2.0 * SLOPES_PI * phase), 3.0);
    float cover = zone * (0.12 + 0.88 * bore);
    float rocks = smoothstep(0.8, -1.5, near_land) * (0.55 + 0.45 * sin(2.0 * SLOPES_PI * (sky_light.w / period + 2.0 * wobble)));
    float swash = smoothstep(0.35, 0.02, water_path) * 0.75;
    return clamp(max(max(cover, rocks), swash), 0.0, 1.0);
}

void main() {
    float dist = length(position);
    vec3 view = -position / dist;
    float depth = rest_depth.z;
    footprint f = pixel_footprint(view, dist);
    float gust = gustiness(rest_depth.xy, f.major);
    fields w = gather(rest_depth.xy, depth, f, gust);
    f.minor = max(f.minor, f.major / float(TAPS)); // what the look-ups really averaged over
    vec3 covariance = unresolved_slopes(f);
    vec3 shaded = covariance * gust * gust;

    float jxx = 1.0 + w.gradient.x, jyy = 1.0 + w.gradient.y, jxy = w.gradient.z;
    float jacobian = jxx * jyy - jxy * jxy;
    float stretch = max(jacobian, 0.25);
    vec2 slope = vec2(w.slope.x * jyy - w.slope.y * jxy, w.slope.y * jxx - w.slope.x * jxy) / stretch;
    slope *= min(1.0, 1.2 / max(length(slope), 1e-3)); // water does not stand steeper than it breaks

    // the facets that the eye sees lean towards it
    visible_facets seen = facets_seen(view, slope, shaded);
    vec2 toward = view.xy / max(length(view.xy), 1e-4);
    vec3 normal = normalize(vec3(-slope, 1.0));
    vec3 leaning = normalize(vec3(-(slope - toward * seen.shift), 1.0));
    float cos_view = clamp(dot(view, normal), 0.02, 1.0);

    float index = water_deep.w;
    float reflectance = mean_fresnel(cos_view, index, seen.sigma);
    vec3 mirrored = reflect(-view, leaning);
    mirrored.z = abs(mirrored.z);
    vec3 sky = environment_radiance(mirrored, seen.sigma);
    if (shore_present != 0) {
        // three tilts stand for the distribution of the facets: without them a hill is mirrored in scraps
        vec4 land = vec4(0.0);
        for (int i = -1; i <= 1; ++i) {
            vec3 facet = normalize(vec3(-(slope - toward * (seen.shift + 1.2 * float(i) * seen.sigma)), 1.0));
            vec3 ray = reflect(-view, facet);
            vec4 one = mirrored_land(vec3(ray.xy, abs(ray.z)));
            land += (i == 0 ? 0.5 : 0.25) * vec4(one.rgb * one.w, one.w);
        }
        sky = sky * (1.0 - land.w) + land.rgb;
    }

    float shade = cloud_shadow(position.xy);
    vec3 half_vector = normalize(view + sun.xyz);
    vec2 facet = -half_vector.xy / max(half_vector.z, 1e-3);
    float hz2 = half_vector.z * half_vector.z;
    float sun_seen = facets_seen(sun.xyz, slope, shaded).area;
    float glint = slope_density(facet, slope, shaded) * fresnel(clamp(dot(view, half_vector), 0.0, 1.0), index) /
                  (4.0 * hz2 * hz2 * max(seen.area, 0.01)) * clamp(max(sun.z, 0.0) / max(sun_seen, 1e-3), 0.0, 1.0);
    vec3 glitter = sun_light.rgb * shade * min(glint, 400.0) * step(0.0, sun.z + 0.01);

    float sun_into = 1.0 - fresnel(clamp(dot(sun.xyz, normal), 0.05, 1.0), index);
    vec3 sunlit = sun_light.rgb * shade * max(sun.z, 0.0);
    vec3 irradiance = sunlit * sun_into + sky_light.rgb * 0.93;
    float water_path;
    vec3 below = water_leaving(view, normal, irradiance, water_path);
    // light that entered the far side of a crest leaves through the near one
    float through = pow(clamp(dot(-view, normalize(vec3(sun.xy, max(sun.z, 0.05)))), 0.0, 1.0), 3.0);
    float crest = clamp((position.z + eye.z) / max(foam_law.z, 0.3), 0.0, 1.0);
    vec3 glow = water_deep.rgb * sun_light.rgb * shade * (through * 5.0 + 0.6) * crest * clamp(1.0 - jacobian + 0.2, 0.0, 1.0);

    vec3 surface = reflectance * sky + glitter + (1.0 - reflectance) * (below + glow);

    float fresh, old;
    breaking_cover(w, jacobian, covariance, fresh, old);
    fresh = max(fresh, shore_cover(depth, water_path));
    float foam = foam_cover(rest_depth.xy, f.minor, fresh, old) * water_kd.w;
    vec3 foam_light = (sun_light.rgb * shade * max(dot(sun.xyz, normal), 0.0) + sky_light.rgb) / SLOPES_PI;
    surface = mix(surface, foam_light * 0.72, clamp(foam, 0.0, 1.0) * 0.92);

    vec3 transmittance, inscatter;
    aerial_perspective(position, transmittance, inscatter);
    surface = surface * transmittance + inscatter;
    // the last centimetres over the sand
    float film = smoothstep(0.0, 0.12, water_path);
    vec3 bed = texture(scene_color, gl_FragCoord.xy * viewport.zw).rgb;
    color = vec4(mix(bed, surface, film), 1.0);
}
#endif
