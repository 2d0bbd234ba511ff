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

fields gather(vec2 rest, float depth, footprint f) {
    fields r = fields(vec2(0.0), vec3(0.0), 0.0);
    float width = max(f.minor, f.major / float(TAPS));
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (width > band.z) continue;
        float lod = log2(max(width / band.y, 1e-3));
        vec4 slopes = vec4(0.0);
        float dxy = 0.0, foam = 0.0;
        for (int i = 0; i < TAPS; ++i) {
            vec2 p = rest + f.axis * f.major * ((float(i) + 0.5) / float(TAPS) - 0.5);
            vec3 uv = vec3(cascade_uv(c, p), float(c));
            slopes += textureLod(slope_map, uv, lod);
            dxy += textureLod(displacement_map, uv, lod).w;
            foam += textureLod(foam_map, uv, lod).x;
        }
        float keep = shore_attenuation(depth, band.x) / float(TAPS);
        r.slope += keep * slopes.xy;
        r.gradient += keep * choppiness * vec3(slopes.zw, dxy);
        r.foam += keep * foam;
    }
    return r;
}

// What lies behind the water along a direction: its colour as lit in air, and its height; w = 0 where there is nothing.
vec4 behind(vec2 uv, out vec3 where) {
    float depth = texture(scene_depth, uv).x;
    where = frame_ray(uv) / max(depth, 1e-9);
    return vec4(texture(scene_color, uv).rgb, depth > 0.0 ? 1.0 : 0.0);
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

// Foam: covered share of the pixel. J has the mean and the variance that the filter left; beyond that the bubbles' own
// structure decides, by a tiled texture whose values are uniformly distributed, so that a threshold gives the share.
float foam_structure(vec2 rest, float width, float cover) {
    vec2 p = mod(eye.xy + rest, 4096.0);
    float lod = log2(max(width * 512.0 / 16.0, 1.0));
    float coarse = textureLod(foam_detail, p / 64.0, max(lod - 2.0, 0.0)).r;
    float fine = textureLod(foam_detail, p.yx / 16.0, lod).r;
    float v = mix(fine, coarse, 0.4);
    float soft = mix(0.18, 1.0, clamp(width / 4.0, 0.0, 1.0));
    float sharp = smoothstep(1.0 - cover - soft * 0.5, 1.0 - cover + soft * 0.5, v);
    return mix(sharp, cover, clamp(width / 6.0, 0.0, 1.0)) * smoothstep(0.0, 0.08, cover);
}

float breaking_cover(fields w, float jacobian, vec3 covariance) {
    float variance = max(covariance.x + covariance.z - foam_law.y, 0.0) * choppiness * choppiness;
    float active = normal_cdf((foam_law.x - jacobian) / sqrt(variance + 0.0025));
    float old = smoothstep(0.0, 0.35, w.foam - (1.0 - foam_law.x) - 0.12);
    return clamp(active + 0.55 * old, 0.0, 1.0);
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
    fields w = gather(rest_depth.xy, depth, f);
    f.minor = max(f.minor, f.major / float(TAPS)); // what the look-ups really averaged over
    vec3 covariance = unresolved_slopes(f);

    float jxx = 1.0 + w.gradient.x, jyy = 1.0 + w.gradient.y, jxy = w.gradient.z;
    float jacobian = jxx * jyy - jxy * jxy;
    float stretch = max(jacobian, 0.25);
    vec2 slope = vec2(w.slope.x * jyy - w.slope.y * jxy, w.slope.y * jxx - w.slope.x * jxy) / stretch;
    slope *= min(1.0, 1.2 / max(length(slope), 1e-3)); // water does not stand steeper than it breaks

    // the facets that the eye sees lean towards it
    visible_facets seen = facets_seen(view, slope, covariance);
    vec2 toward = view.xy / max(length(view.xy), 1e-4);
    vec3 normal = normalize(vec3(-slope, 1.0));
    vec3 leaning = normalize(vec3(-(slope - toward * seen.shift), 1.0));
    float cos_view = clamp(dot(view, normal), 0.02, 1.0);

    float index = water_deep.w;
    float reflectance = mean_fresnel(cos_view, index, seen.sigma);
    vec3 mirrored = reflect(-view, leaning);
    mirrored.z = abs(mirrored.z);
    vec3 sky = environment_radiance(mirrored, seen.sigma);

    float shade = cloud_shadow(position.xy);
    vec3 half_vector = normalize(view + sun.xyz);
    vec2 facet = -half_vector.xy / max(half_vector.z, 1e-3);
    float hz2 = half_vector.z * half_vector.z;
    float sun_seen = facets_seen(sun.xyz, slope, covariance).area;
    float glint = slope_density(facet, slope, covariance) * fresnel(clamp(dot(view, half_vector), 0.0, 1.0), index) /
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

    float cover = breaking_cover(w, jacobian, covariance);
    float foam = foam_structure(rest_depth.xy, f.minor, cover);
    float shore = shore_cover(depth, water_path);
    foam = max(foam, foam_structure(rest_depth.xy, f.minor, shore)) * water_kd.w;
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
