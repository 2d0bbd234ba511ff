// SPDX-License-Identifier: MIT
// Images of the reflected and of the refracted scene, fetched where the waves bend the ray; the water's own texture,
// shaded as a bumpy surface; the sun's glitter by a projected texture (Ma, Zhu & Gong 2006).
//
// TILES: the waves are tiles baked from the sea, else waves_at() has them. RIPPLES: with a second, finer tile. HIGH:
// cloud shadows vary over the water, and the air thins with height. PAPER: the paper exactly: its normal maps, its
// disturbance, its sums. BELOW: the eye is under water.
#include "common/frame.glsl"
#include "common/water_vertex.glsl"
#ifdef QUAD
#include "common/haze.glsl"
#endif

#ifdef VERTEX
#ifdef QUAD
flat out float water_shade; // share of the sun that passes the clouds round the eye
#endif

void main() {
    water_vertex();
#ifdef QUAD
    water_shade = cloud_shadow(vec2(0.0));
    haze_vertex();
#endif
}
#endif

#ifdef FRAGMENT
#include "common/look.glsl"
#include "shared/cascade.glsl"
#include "shared/constants.glsl"
#include "shared/fresnel.glsl"
#define PICTURE
#include "common/under.glsl"
out vec4 color;

#ifdef QUAD
flat in float water_shade;
#endif
#pragma unit reflection_picture 16
#pragma unit refraction_picture 17
#pragma unit reflection_depth 24
#pragma unit refraction_depth 15
#pragma unit tile_slopes 18
#pragma unit ripple_slopes 26
#pragma unit glint_texture 25
uniform sampler2D reflection_picture;
uniform sampler2D refraction_picture;
uniform highp sampler2D reflection_depth;
uniform highp sampler2D refraction_depth;
// Slopes along the world's axes, the sum of their squares, brightness of the water's own texture; PAPER: unit normal.
uniform sampler2D tile_slopes;
uniform sampler2D ripple_slopes;  // of shorter waves
uniform sampler2D glint_texture;  // r: the sun as the slide has it
layout(std140) uniform Optics {
#include "shared/mirror_block.glsl"
};


vec2 in_tile(vec4 place, vec2 p) {
    return place.xy + vec2(along_tile(p.x, p.y, place.z, place.w), across_tile(p.x, p.y, place.z, place.w));
}
// Along the tile's sides to along the world's axes.
vec2 out_of_tile(vec4 place, vec2 s) {
    vec2 turn = place.zw * inversesqrt(dot(place.zw, place.zw));
    return vec2(dot(s, vec2(turn.x, -turn.y)), dot(s, turn.yx));
}

// Where many repetitions of a tile are visible, its slopes fade into roughness.
float far_share(vec4 place, float dist) { return 40.0 / (40.0 + dist * dist * dot(place.zw, place.zw)); }

// The waves at a pixel.
struct waves_here {
    vec2 slope;
    float variance; // of the slopes that the pixel cannot show, along one axis
    vec3 own;       // radiance of the water's own texture in the light on flat water
};

waves_here look_at_waves(water_pixel p, vec3 view, float dist) {
    waves_here w;
    footprint f = pixel_footprint(view, dist, p.mesh.xy);
#ifdef TILES
    float lod = log2(max(f.minor, 0.5 * f.major)); // sharper than the long side at a grazing look, and still quiet
    vec2 uv = in_tile(tile_place, p.rest);
    vec4 t = textureLod(tile_slopes, uv, lod + tile_texels);
#ifdef PAPER
    w.slope = -out_of_tile(tile_place, t.xy); // the normal's x and y, as eq. 9 to 11 take them, turned into slopes
    w.variance = 1e-4;
#else
    float keep = far_share(tile_place, dist);
    w.slope = keep * t.xy;
    float lost = max(t.z - keep * keep * dot(t.xy, t.xy), 0.0);
#ifdef RIPPLES
    vec4 r = textureLod(ripple_slopes, in_tile(ripple_place, p.rest), lod + ripple_texels);
    keep = far_share(ripple_place, dist);
    w.slope += ripple_share * keep * r.xy;
    lost += ripple_share * ripple_share * max(r.z - keep * keep * dot(r.xy, r.xy), 0.0);
#endif
    vec3 layers = layers_hidden(p.rest, f, p.depth);
    w.slope += layers_slope(p.rest, f, p.depth);
    w.variance = 0.5 * (lost + missing_slopes + layers.x + layers.z);
#endif
#ifdef PAPER
    w.own = own_radiance * textureLod(water_tile, uv, lod + tile_texels).rgb;
#else
    w.own = own_radiance * t.w;
#endif
#else
    wave_fields at = waves_at(p.rest, p.place, f, p.gust, p.depth, p.mesh);
    vec3 c = hidden_slopes(p.rest, f, p.depth);
    w.slope = at.slope;
    w.variance = 0.5 * (c.x + c.z);
    w.own = own_radiance;
#endif
    return w;
}

vec2 place_in_picture(vec3 direction) {
    vec4 c = view_projection * vec4(direction, 0.0);
    return clamp(c.xy / max(c.w, 1e-4) * 0.5 + 0.5, 0.5 * pixel_size, 1.0 - 0.5 * pixel_size);
}

// Share of the turn of a bent ray that shifts the fetch: 0 for objects that touch the water, 1 for the sky.
float bent_share(highp sampler2D depth, vec2 uv) {
    float behind = textureLod(depth, uv, 0.0).x / (near_distance * gl_FragCoord.w);
    return clamp(1.0 - behind, 0.0, 1.0) * look_distortion;
}

float slide(vec3 mirrored, vec2 push, float spread) {
    vec3 s = vec3(dot(sun_slide[0].xyz, mirrored), dot(sun_slide[1].xyz, mirrored), dot(sun_slide[2].xyz, mirrored));
    vec2 uv = (s.xy / max(s.z, 1e-4) + push - 0.5) * spread + 0.5;
    return s.z > 0.0 ? textureLod(glint_texture, uv, 0.0).r : 0.0; // black at its rim
}

#ifndef BELOW
// Exact dielectric, the mean tilt of the facets that face the eye, and the glitter as wide as what the pixel cannot
// show makes it.
vec3 light_of_water(water_pixel p, waves_here w, vec3 to, vec2 screen) {
#if defined(QUAD) && !defined(HIGH)
    vec3 light = sun_light * water_shade;
#else
    vec3 light = sun_light * p.shade;
#endif
    vec3 view = -to;
    float level = inversesqrt(max(dot(to.xy, to.xy), 1e-6)), tangent = view.z * level;
    vec2 toward = view.xy * level;
    // Facets that are turned away are hidden.
    vec2 tilt = w.slope - toward * (w.variance * inversesqrt(tangent * tangent + 1.6 * w.variance));
    // normals need no unit length where their square is divided by
    float n2 = 1.0 / (1.0 + dot(tilt, tilt)), flat2 = 1.0 / (1.0 + dot(w.slope, w.slope));
    // Cosines times the length of the normal.
    float facing = view.z + dot(to.xy, tilt), flat_facing = view.z + dot(to.xy, w.slope);
    bool mirrors = effect_is_on(EFFECT_REFLECTION), clear = effect_is_on(EFFECT_REFRACTION);
    bool bends = effect_is_on(EFFECT_DISTORTION);
    float reflectance = fresnel(clamp(facing * sqrt(n2), 0.02, 1.0), water_index);

    vec3 ray = to + 2.0 * facing * n2 * vec3(-tilt, 1.0);
    ray.z = abs(ray.z);
    float turn = bent_share(reflection_depth, screen);
    vec3 bent = mix(to, vec3(ray.xy, -ray.z), bends ? turn : 0.0);
    // rough water blurs what it mirrors: along the view by twice its rms slope, across by less
    float blur = blur_texels * turn * sqrt(w.variance * max(view.z, 0.03));
    vec3 mirrored = textureLod(reflection_picture, place_in_picture(bent), log2(max(blur, 1.0))).rgb;

    // the ray in the water, n times its level part: as it would come out of flat water
    float c = flat_facing * sqrt(flat2);
    vec2 down = to.xy + w.slope * sqrt(flat2) * (sqrt(water_index * water_index - 1.0 + c * c) - c);
    vec3 apparent = vec3(down, -sqrt(max(1.0 - dot(down, down), 0.0025)));
    bent = mix(to, apparent, bends ? bent_share(refraction_depth, screen) : 0.0);
    vec3 seen = textureLod(refraction_picture, place_in_picture(bent), 0.0).rgb;

    float sun_cosine = max((sun_direction.z - dot(w.slope, sun_direction.xy)) * sqrt(flat2), 0.0);
    vec3 own = effect_is_on(EFFECT_BUMP) ? w.own * (light * sun_cosine + sky_light)
                                         : own_radiance * (light * max(sun_direction.z, 0.0) + sky_light);
    vec3 below = mix(own, seen, clear ? look_blend : 0.0);
    vec3 result = mix(below, mirrored, mirrors ? reflectance : 0.0);
    if (effect_is_on(EFFECT_GLITTER)) {
        // a facet turns the ray by twice its tilt; the texture's own sun has the rms radius slide_radius
        ray = to + 2.0 * flat_facing * flat2 * vec3(-w.slope, 1.0);
        float narrow = inversesqrt(4.0 * w.variance + slide_radius * slide_radius);
        float peak = min(narrow * narrow * (0.5 / PI), 90.0);
        float glint = slide(vec3(ray.xy, abs(ray.z)), vec2(0.0), slide_radius * narrow);
        float half_way = sqrt(0.5 + 0.5 * clamp(dot(view, sun_direction), -1.0, 1.0));
        result += light * (fresnel_fast(half_way, water_index) * peak * glint); // at the facet that reflects the sun
    }
    return result;
}

// As printed: eq. 9 and 10, lerps, a sum.
vec3 printed_light(water_pixel p, waves_here w, vec3 to, vec2 screen) {
    vec3 n = normalize(vec3(-w.slope, 1.0)), light = sun_light;
    vec3 own = w.own * (light + sky_light);
    if (effect_is_on(EFFECT_BUMP)) own *= max(dot(n, sun_direction), 0.0);
    vec2 bent = effect_is_on(EFFECT_DISTORTION) ? screen + picture_push * screen * n.xy : screen; // eq. 9
    vec3 mirrored = mix(own, textureLod(reflection_picture, bent, 0.0).rgb, look_blend);
    vec3 seen = mix(own, textureLod(refraction_picture, bent, 0.0).rgb, look_blend);
    bool mirrors = effect_is_on(EFFECT_REFLECTION), clear = effect_is_on(EFFECT_REFRACTION);
    vec3 result = mirrors ? (clear ? 0.5 * (mirrored + seen) : mirrored) : (clear ? seen : own);
    if (effect_is_on(EFFECT_GLITTER)) result += light * slide(vec3(to.xy, -to.z), glitter_push * n.xy, 1.0); // eq. 10
    return result;
}
#else
// From under water: the scene above in Snell's window, and around it the reflected scene below.
vec3 light_from_below(waves_here w, vec3 to, float dist, vec2 screen) {
    vec3 up = normalize(vec3(-w.slope, 1.0));
    float cosine = clamp(dot(to, up), 0.0, 1.0), reflectance = fresnel(max(cosine, 1e-3), 1.0 / water_index);
    vec3 ray = reflect(to, up);
    ray.z = -abs(ray.z);
    bool bends = effect_is_on(EFFECT_DISTORTION);
    vec3 bent = mix(to, vec3(ray.xy, -ray.z), bends ? bent_share(reflection_depth, screen) : 0.0);
    vec3 mirrored = vec3(0.0);
    if (effect_is_on(EFFECT_REFLECTION)) mirrored = textureLod(reflection_picture, place_in_picture(bent), 0.0).rgb;
    vec3 out_ray = refract(to, -up, water_index); // zero beyond the window
    vec2 flat_ray = out_ray.xy / water_index;     // as it would come in through flat water
    float turn = bends ? bent_share(refraction_depth, screen) : 0.0;
    bent = mix(to, vec3(flat_ray, sqrt(max(1.0 - dot(flat_ray, flat_ray), 0.0))), turn);
    vec4 land = textureLod(refraction_picture, place_in_picture(bent), 0.0);
    vec3 sky = environment_radiance(vec3(out_ray.xy, max(out_ray.z, 0.0)), 0.02);
    if (effect_is_on(EFFECT_GLITTER)) {
        // A facet turns a ray through the surface by a third of its tilt.
        float sigma = sqrt(0.2 * w.variance + slide_radius * slide_radius);
        float peak = min(1.0 / (2.0 * PI * sigma * sigma), 90.0);
        sky += sun_light * peak * slide(out_ray, vec2(0.0), slide_radius / sigma);
    }
    vec3 window = mix(sky, land.rgb, land.a) * (effect_is_on(EFFECT_REFRACTION) ? water_index * water_index : 0.0);
    vec3 left = exp(-under_fog * water_attenuation * dist);
    vec3 veil = water_glow(to.z, -eye_height) * (1.0 - left); // the mirrored picture has its own
    return mix(window * left + veil, mirrored, reflectance);
}
#endif

void main() {
    water_pixel p = water_here();
    float dist = length(p.position);
    vec3 to = p.position / dist;
    vec2 screen = gl_FragCoord.xy * pixel_size;
    vec3 view = -to;
#ifdef BELOW
    view.z = -view.z;
#endif
    waves_here w = look_at_waves(p, view, dist);
#ifdef BELOW
    color = vec4(light_from_below(w, to, dist, screen), 1.0);
#else
#ifdef PAPER
    vec3 light = printed_light(p, w, to, screen);
#else
    vec3 light = light_of_water(p, w, to, screen);
#endif
#if defined(QUAD) && !defined(HIGH)
    color = vec4(through_haze(light, to, dist), 1.0);
#else
    color = vec4(light * p.transmittance + p.inscatter, 1.0);
#endif
#endif
}
#endif
