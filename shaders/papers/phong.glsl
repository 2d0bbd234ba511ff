// SPDX-License-Identifier: MIT
// Images of the reflected and refracted scene, mixed by Fresnel's law, with three parts of light (Liu & Xie 2010,
// sections 1.2 and 1.3; the images are those of planar_views.c):
//
//     C = F reflection + (1 - F) refraction,   each fetched where the waves bend the ray
//     ambient = Ka water (N . V)   diffuse = Kd light max(N . L, 0)   specular = Ks light max(N . H, 0)^shininess
//
// Beyond the paper: the unresolved slopes blur the reflection and widen the highlight; the fetch is displaced by the
// reflected ray itself; the water's own colour replaces the light that the water absorbs from the bed, so that the
// factor of Ka is (1 - F) and not N . V.
//
// PICTURES: the planar views are not empty. TAPS: texture fetches across the blur. PAPER: the shading of the paper
// alone. (These are defines, because software OpenGL executes both sides of a branch.)
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#if defined(QUAD) && !defined(FINE)
#include "common/haze.glsl"
#define HAZE
#endif

#ifdef VERTEX
void main() {
    water_vertex();
#ifdef HAZE
    haze_vertex();
#endif
}
#endif

#ifdef FRAGMENT
#include "common/look.glsl"
#include "shared/fresnel.glsl"
#include "common/ripples.glsl"
#include "common/rough.glsl"
#include "common/water_light.glsl"
out vec4 color;

#ifdef PICTURES
#pragma unit reflection_picture 16
#pragma unit refraction_picture 17
uniform sampler2D reflection_picture; // premultiplied: a is 0 where there is only sky
uniform sampler2D refraction_picture; // a is 0 where there is only water
#endif
layout(std140) uniform Optics {
#include "shared/phong_block.glsl"
};

// A pixel of water, its waves and their roughness.
struct phong_surface {
    water_pixel here;
    vec3 view;
    float dist;
    vec2 slope;
    vec3 covariance, normal;
    rough_facets seen;
};

// The triangle mesh of the paper's table 1: waves and normals are those of its vertices, and the pixels interpolate.
#if defined(PAPER) && defined(WAVES_EXP) && !defined(QUAD)
#define VERTEX_NORMALS
#endif

#if !defined(WAVES_CASCADES) && !defined(PAPER)
// An offset [m] that varies over kilometres and bends the crests, which would otherwise be straight.
vec2 wander_of(vec2 rest) {
    vec2 at = wander_eye.xy + rest * wander_fine, broad = wander_eye.zw + rest.yx * wander_broad;
    return 0.25 * peak_length * (textureLod(ripple_map, at, 5.0).xy + textureLod(ripple_map, broad, 5.0).yx);
}
#endif

phong_surface surface_here() {
    phong_surface s;
    s.here = water_here();
    s.dist = length(s.here.position);
    s.view = -s.here.position / s.dist;
#ifdef HAZE
    s.here.transmittance = haze_transmittance(s.dist);
    s.here.inscatter = haze_inscatter(-s.view, s.here.transmittance);
#endif
    footprint f = water_footprint(s.here, s.view, s.dist);
#if defined(VERTEX_NORMALS)
    s.slope = s.here.mesh.xy;
    s.covariance = vec3(0.0);
#elif defined(WAVES_EXP) || defined(WAVES_SUM)
    footprint wide = f;
    vec2 at = s.here.rest;
#ifndef PAPER
    // A sum of few waves repeats. It fades into roughness where a wave is a few pixels long, and earlier from high up,
    // where many repetitions are visible; the longest waves of the tile bend it.
    float high = smoothstep(30.0, 200.0, eye_height);
    wide.minor *= 3.0 + 7.0 * high;
    wide.major = max(f.major, wide.minor);
    if (eye_height > 30.0) at += wander_of(at) * high;
#endif
    s.slope = waves_of_footprint(at, wide, s.here.gust, s.here.depth, s.covariance).slope;
#else
    s.slope = waves_at(s.here.rest, s.here.place, f, s.here.gust, s.here.depth, s.here.mesh).slope;
#ifdef WAVES_CASCADES
    f.minor = max(f.minor, f.major / float(TAPS)); // the width that the fetches really average over
#endif
    s.covariance = hidden_slopes(s.here.rest, f, s.here.depth);
#endif
    s.covariance *= s.here.gust * s.here.gust;
#ifndef PAPER
    add_ripples(s.here.rest, f, s.here.gust, s.here.depth, s.slope, s.covariance);
#endif
    s.covariance += vec3(1.0, 0.0, 1.0) / look_shininess;
    s.normal = normalize(vec3(-s.slope, 1.0));
    s.seen = rough_seen(s.view, s.slope, s.covariance);
    return s;
}

float bending() { return effect_is_on(EFFECT_DISTORTION) ? look_distortion : 0.0; }

// The coordinates of an eye-relative point in the planar views, in which the water plane stays in place.
vec2 picture_of(vec3 point) {
    vec4 c = view_projection * vec4(point, 1.0);
    return clamp(c.xy / max(c.w, 1e-3) * 0.5 + 0.5, 0.002, 0.998);
}

#ifdef PICTURES
// A planar view includes the haze up to the object; the part of the haze before the water is applied to the water
// itself.
vec4 behind_water(sampler2D picture, vec3 point, float level, water_pixel p) {
    vec4 c = textureLod(picture, picture_of(point), level);
    return vec4(max(c.rgb - c.a * p.inscatter, 0.0) / max(p.transmittance, vec3(0.02)), c.a);
}
#endif

#ifdef PAPER
// (Du, Dv) = dC (Nx, Ny), on the water's plane, before the projection.
vec3 reflection(phong_surface s) {
    vec3 at = s.here.position + vec3(reflection_push * bending() * s.normal.xy, 0.0);
    vec3 ray = normalize(at);
    vec3 sky = environment_radiance(vec3(ray.xy, abs(ray.z)), 0.0);
#ifdef PICTURES
    vec4 land = behind_water(reflection_picture, at, 0.0, s.here);
    sky = sky * (1.0 - land.a) + land.rgb;
#endif
    return sky;
}

#else
// The ray that a facet of slope m reflects, upwards.
vec3 mirrored_ray(vec3 view, vec2 m) {
    vec3 r = reflect(-view, normalize(vec3(-m, 1.0)));
    return vec3(r.xy, abs(r.z));
}

// The reflected object is assumed as far behind the water as the water is from the eye.
vec3 reflection(phong_surface s) {
    vec2 toward = s.view.xy / max(length(s.view.xy), 1e-4);
    vec2 leaning = bending() * (s.slope - toward * s.seen.shift);
    vec3 sky = environment_radiance(mirrored_ray(s.view, leaning), s.seen.sigma);
#ifdef PICTURES
    vec4 land = vec4(0.0);
    // a facet's slope turns the ray by twice that, of which the other side of the picture's place shows half, and
    // across the view little
    float rows = float(textureSize(reflection_picture, 0).y) * pixel_size.y;
    float texels = 0.25 * s.seen.sigma / float(TAPS) * rows / radians_per_pixel;
    float level = log2(clamp(texels, 1.0, 4.0)); // further up, the steps from one to the next would show
    for (int i = 0; i < TAPS; ++i) {
        float tilt = (float(2 * i + 1) / float(TAPS) - 1.0) * 1.3;
        vec3 ray = mirrored_ray(s.view, leaning - bending() * tilt * s.seen.sigma * toward);
        land += behind_water(reflection_picture, s.here.position + 0.5 * s.dist * vec3(ray.xy, -ray.z), level, s.here);
    }
    land *= 1.0 / float(TAPS);
    sky = sky * (1.0 - land.a) + land.rgb;
#endif
    return sky;
}

#endif

// The radiance of the bed through the water; `passed` receives the transmitted share.
vec3 refraction(phong_surface s, out vec3 passed, out vec4 bed) {
    passed = vec3(0.0);
    bed = vec4(0.0);
#ifndef PICTURES
    return vec3(0.0);
#else
    float depth = clamp(s.here.depth, 0.0, 60.0);
#ifdef PAPER
    float shift = refraction_push;
#else
    float shift = -0.25 * depth; // (1/n - 1) of it
#endif
    bed = behind_water(refraction_picture, s.here.position + vec3(shift * bending() * s.normal.xy, 0.0), 0.0, s.here);
#ifdef PAPER
    passed = vec3(bed.a);
    return bed.rgb;
#else
    passed = bed.a * exp(-water_attenuation * bed_path(depth, refracted_cosine(s.view.z, water_index)));
    return bed.rgb * (BED_LEAVES / max(bed.a, 1e-3)) * passed;
#endif
#endif
}

float highlight(phong_surface s) {
#ifdef PAPER
    return exp2(look_shininess * log2(max(dot(s.normal, normalize(s.view + sun_direction)), 1e-6)));
#else
    return rough_glint(s.view, sun_direction, s.slope, s.covariance, s.seen, water_index);
#endif
}

void main() {
    phong_surface s = surface_here();
    vec3 sunlight = sun_light * s.here.shade;
    float facing = max(dot(sun_direction, s.normal), 0.0);
#ifdef PAPER
    float f = fresnel(clamp(dot(s.view, s.normal), 0.01, 1.0), water_index);
#else
    float f = rough_fresnel(s.view, s.slope, s.seen, water_index);
#endif
    vec3 mirrored = vec3(0.0), passed = vec3(0.0), through = vec3(0.0);
    vec4 bed = vec4(0.0); // as it is seen
    if (effect_is_on(EFFECT_REFLECTION)) mirrored = reflection(s);
    if (effect_is_on(EFFECT_REFRACTION)) through = refraction(s, passed, bed);
    vec3 light = f * mirrored + (1.0 - f) * through;

    vec3 water = water_reflectance * (sunlight * facing + sky_light), diffuse = sunlight * facing * 0.31830989;
#ifdef PAPER
    vec3 ambient = water * max(dot(s.normal, s.view), 0.0);
#else
    vec3 ambient = water * (1.0 - f) * (1.0 - passed);
    diffuse *= 1.0 - f;
#endif
    if (effect_is_on(EFFECT_AMBIENT)) light += look_ambient * ambient;
    if (effect_is_on(EFFECT_DIFFUSE)) light += look_diffuse * diffuse;
    if (effect_is_on(EFFECT_SPECULAR)) light += look_specular * highlight(s) * sunlight * step(-0.01, sun_direction.z);
#if defined(PICTURES) && !defined(PAPER)
    // the last centimetres over the sand, where nothing is bent any more
    light = mix(bed.rgb, light, max(smoothstep(0.0, 0.12, s.here.depth), 1.0 - bed.a));
#endif
    color = vec4(light * s.here.transmittance + s.here.inscatter, 1.0);
}
#endif
