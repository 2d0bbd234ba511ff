// SPDX-License-Identifier: MIT
// What an eye in the water sees, each pixel once, from the outputs of water_shape.glsl: the under side of the surface,
// things in the water, and the water itself. Inside Snell's window a facet shows sky and land; outside it reflects what
// lies below. Sunlight comes through facets of any slope by the microfacet law of Walter et al. 2007.
//
// LAND: there is terrain, or an object. TAPS: as in water_physical.glsl. WATERLINE: the surface cuts the near plane;
// pixels are drawn where that plane lies in the water, with a meniscus along its edge.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"
#include "common/atmosphere.glsl"

#ifdef VERTEX
#include "common/gusts.glsl"
flat out float eye_shade; // share of the sun that passes the clouds over the eye
flat out float eye_gust;  // factor on the slope of short waves there

void main() {
    fullscreen(0.0);
    eye_shade = cloud_shadow(vec2(0.0));
    eye_gust = gustiness(eye_wrapped_wide, 1.0);
}
#endif

#ifdef FRAGMENT
#include "common/waves.glsl"
#include "shared/fresnel.glsl"
#include "shared/microfacets.glsl"
#include "shared/bed.glsl"
#include "common/look.glsl"

#include "common/shape.glsl"

flat in float eye_shade;
flat in float eye_gust;
out vec4 color;

#include "common/shape_maps.glsl"
layout(std140) uniform Optics {
#include "shared/below_block.glsl"
};
#include "common/below_medium.glsl"
#include "common/fine.glsl"
#include "common/gathered.glsl"

#ifdef LAND
#include "common/behind.glsl"
#pragma unit window_image 25
uniform sampler2D window_image; // what stands above the water, as a level surface refracts it; w: something does
#endif

const float FARTHEST = 1e4; // of a ray that meets nothing [m]

// ---- light from things in the water ---------------------------------------------------------------------------------

vec3 light_over(vec3 sunlight) { return sunlight * max(sun_direction.z, 0.0) + sky_light; }

// Radiance of a thing at a depth, which was shaded as if dry.
vec3 lit_below(vec3 dry, float depth) {
    return dry * light_entering(sun_light) / max(light_over(sun_light), vec3(1e-9)) * light_left(depth);
}

#ifdef LAND
// The bed that a reflected ray meets where the image does not show it: a bright mean of sand and reef.
const vec3 BED_ALBEDO = vec3(0.35, 0.31, 0.22);
const int BED_STEPS = 5; // a level bed is met to 0.3^5 of its depth

// Of the bed that a ray meets which goes down from a place on the surface, within the water: its radiance at the
// surface.
vec3 bed_along(vec3 from, vec3 dir, vec3 sunlight, out float near) {
    float down = max(-dir.z, 0.02), height = eye_height + from.z;
    bool met = false;
    near = 0.0;
    for (int i = 0; i < BED_STEPS && !met; ++i) {
        float to_bed = height - near * down - shore_elevation((from + dir * near).xy);
        near += max(0.7 * to_bed, 0.05) / down;
        met = to_bed < 0.1;
    }
    vec3 at = from + dir * near, seen_at;
    vec4 c = view_projection * vec4(at, 1.0);
    vec2 uv = c.xy / max(c.w, 1e-4) * 0.5 + 0.5;
    vec2 inside = min(uv, 1.0 - uv);
    vec3 dry = BED_ALBEDO / PI * light_over(sunlight);
    vec4 seen = behind(clamp(uv, 0.001, 0.999), seen_at);
    bool same = c.w > 0.0 && seen.w > 0.0 && seen_at.z + eye_height < 0.0 && distance(seen_at, at) < 0.3 * length(at);
    vec3 bed = mix(dry, seen.rgb, same ? smoothstep(0.0, 0.08, min(inside.x, inside.y)) : 0.0);
    return lit_below(bed, -(eye_height + at.z)) * exp(-beam_attenuation * near);
}
#endif

// ---- the surface from below -----------------------------------------------------------------------------------------

// The sky, and the land before it, along a ray in the air; straight: the ray in the water as a level surface would have
// bent it.
vec3 light_above(vec3 dir, float blur) {
    vec3 sky = environment_radiance(vec3(dir.xy, max(dir.z, 0.0)), blur);
#ifdef LAND
    if (window_present > 0.5) {
        vec2 level = dir.xy / water_index;
        vec4 c = view_projection * vec4(level, sqrt(max(1.0 - dot(level, level), 0.0)), 0.0);
        vec2 uv = c.xy / max(c.w, 1e-4) * 0.5 + 0.5;
        vec4 land = textureLod(window_image, uv, 0.0);
        bool inside = c.w > 0.0 && uv == clamp(uv, 0.0, 1.0);
        sky = inside ? mix(sky, land.rgb, land.a) : sky;
    }
#endif
    return sky;
}

// Radiance of the sun through facets of mean slope `slope` and covariance `c`, for an irradiance of 1 across its rays.
// area: plan area that a unit of plan area shows the eye.
float sun_through(vec3 dir, vec2 slope, vec3 c, float area) {
    vec3 h = normalize(water_index * dir - sun_direction);
    float to_sun = dot(sun_direction, h), to_eye = dot(dir, h);
    if (h.z < 0.05 || to_sun <= 0.0 || to_eye <= 0.0 || sun_direction.z <= 0.0) return 0.0;
    vec2 off = -h.xy / h.z - slope;
    float up2 = h.z * h.z, bend = water_index * to_eye - to_sun;
    float lit = slope_density(off.x, off.y, c.x, c.y, c.z) / (up2 * up2);
    float passes = 1.0 - fresnel(to_sun, water_index);
    return water_index * water_index * passes * lit * to_sun * to_eye / (max(area, 0.05) * bend * bend);
}

// Variance of the slopes that turn the sun's disc to one ray: half its radius over n - 1.
const float SUN_DISC_THROUGH = 4.7e-5;

// The facets in sight of a ray from below: their slope along its way over the mean, which is Gaussian about `middle`
// with deviation `spread`, and the share that lets light through. Facets that lean along the ray by more than some edge
// reflect all of it.
struct facets_below {
    vec2 along;           // horizontal direction of the ray
    float area;           // plan area that a unit of plan area shows
    float middle, spread;
    float open;           // share on the open side of the edge
    vec2 inside, outside; // mean and deviation on both sides of it, in deviations about the middle
};

facets_below facets_from_below(vec3 dir, vec2 slope, vec3 hidden) {
    facets_below f;
    float level = max(length(dir.xy), 1e-4);
    f.along = dot(dir.xy, dir.xy) > 1e-8 ? dir.xy / level : vec2(1.0, 0.0);
    vec2 h = f.along;
    float sigma = sqrt(max(hidden.x * h.x * h.x + 2.0 * hidden.y * h.x * h.y + hidden.z * h.y * h.y, 1e-8));
    facing_facets seen = facing_exact((dir.z - dot(slope, h) * level) / (level * sigma));
    f.area = level * sigma * seen.area;
    f.middle = -sigma * seen.tilt;
    f.spread = length(vec2(sigma * seen.kept, FOOTPRINT_DEVIATION * radians_per_pixel)); // a pixel is no point
    float critical = sqrt(water_index * water_index - 1.0); // tangent of the least elevation that level water lets out
    float edge = (dir.z - critical * level) / (level + critical * dir.z) - dot(slope, h);
    float u = clamp((edge - f.middle) / f.spread, -3.0, 3.0), pdf = normal_pdf(u);
    f.open = normal_below(u, pdf);
    float below = pdf / max(f.open, 1e-3), above = pdf / max(1.0 - f.open, 1e-3);
    f.inside = vec2(-below, sqrt(max(1.0 - u * below - below * below, 0.02)));
    f.outside = vec2(above, sqrt(max(1.0 + u * above - above * above, 0.02)));
    return f;
}

vec3 facet_normal(facets_below f, vec2 slope, float deviations) {
    return normalize(vec3(-slope - f.along * (f.middle + f.spread * deviations), 1.0));
}

// A ray that facets of that slope reflect down into the water.
vec3 reflected_down(facets_below f, vec3 dir, vec2 slope, float deviations) {
    vec3 down = reflect(dir, facet_normal(f, slope, deviations));
    return vec3(down.xy, -abs(down.z));
}

// Radiance of what the facets reflect, `reflectance` of them on the inside: water, and the bed by two rays a deviation
// off the mean.
vec3 reflected_below(facets_below f, vec3 position, vec3 dir, vec2 slope, float reflectance, vec3 sunlight) {
    float far = 1.0 - f.open, near = f.open * reflectance, all = max(far + near, 1e-4), reach = FARTHEST;
    float mean = (far * f.outside.x + near * f.inside.x) / all;
    vec3 bed = vec3(0.0);
#ifdef LAND
    // a loop: software OpenGL goes past a loop that no pixel enters; an object alone has no bed under it
    for (int once = 0; once < shore_present; ++once) {
        float square = far * dot(f.outside, f.outside) + near * dot(f.inside, f.inside), a, b;
        float deviation = sqrt(max(square / all - mean * mean, 0.0));
        bed = 0.5 * bed_along(position, reflected_down(f, dir, slope, mean - deviation), sunlight, a);
        bed += 0.5 * bed_along(position, reflected_down(f, dir, slope, mean + deviation), sunlight, b);
        reach = 0.5 * (a + b);
    }
#endif
    return bed + veil(sunlight, -(eye_height + position.z), reflected_down(f, dir, slope, mean), reach);
}

// Radiance that the surface sends down along the ray -dir.
vec3 surface_from_below(vec3 position, vec3 dir, vec2 slope, vec3 hidden, vec3 sunlight) {
    facets_below f = facets_from_below(dir, slope, hidden);
    vec3 through = vec3(0.0);
    float reflected = 0.0; // by the facets on the open side
    for (int i = 0; i < 2; ++i) {
        vec3 up = facet_normal(f, slope, f.inside.x + (i == 0 ? f.inside.y : -f.inside.y));
        float cosine = clamp(dot(dir, up), 0.0, 1.0), r = fresnel(cosine, 1.0 / water_index);
        if (r < 1.0) through += (1.0 - r) * light_above(refract(dir, -up, water_index), 0.5 * f.spread);
        reflected += 0.5 * r;
    }
    vec3 light = effect_is_on(EFFECT_REFRACTION) ? 0.5 * f.open * water_index * water_index * through : vec3(0.0);
    if (effect_is_on(EFFECT_GLITTER))
        light += sunlight *
                 sun_through(dir, slope, hidden + vec3(SUN_DISC_THROUGH, 0.0, SUN_DISC_THROUGH), f.area);
    if (effect_is_on(EFFECT_REFLECTION))
        light += (1.0 - f.open * (1.0 - reflected)) *
                 reflected_below(f, position, dir, slope, reflected, sunlight);
    return light;
}

// ---- shafts of light ------------------------------------------------------------------------------------------------

const float SHAFTS_REACH = 14.0; // to the edge of the caustics' patch [m]
#if TAPS > 2
const int SHAFT_STEPS = 32;
#else
const int SHAFT_STEPS = 12;
#endif
const float STEP_BLUR = 0.2; // of the pattern, over the length of a step; more blurs the shafts, less leaves noise

// Mean of the gathered light along a ray, weighted by what reaches the eye of it. Steps are short near the eye, where
// shafts are wide, and each stands for the pattern along its length; their start differs from pixel to pixel, so that
// no bands show.
float gathered_along(vec3 dir, float reach) {
    float first = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float sum = 0.0, weights = 1e-6, fading = beam_attenuation.g * (1.0 - dir.z / sun_below_z);
    float across = length(dir.xy + caustic_travel * dir.z); // how fast the ray crosses the pattern
    for (int i = 0; i < SHAFT_STEPS; ++i) {
        float t = (float(i) + first) / float(SHAFT_STEPS), s = reach * t * t, weight = t * exp(-fading * s);
        float apart = STEP_BLUR * across * 2.0 * t * reach / float(SHAFT_STEPS);
        vec3 at = dir * s;
        sum += weight * gathered_in_water(at.xy, max(-(eye_height + at.z), 0.0), apart);
        weights += weight;
    }
    return sum / weights;
}

// The veil before what lies `reach` away, with the shafts that the caustics cast through it.
vec3 veil_with_shafts(vec3 sunlight, vec3 dir, float reach) {
    float depth = -eye_height, near = min(reach, SHAFTS_REACH);
    vec3 beam = beam_veil(beam_entering(sunlight), depth, dir.z, reach);
    if (caustic_spread.x > 0.0)
        beam += beam_veil(beam_entering(sunlight), depth, dir.z, near) * (gathered_along(dir, near) - 1.0);
    return field_veil(light_entering(sunlight), depth, dir.z, reach) +
           phase_beyond_blur(dot(dir, sun_below())) * beam;
}

// ---- the pixel ------------------------------------------------------------------------------------------------------

// What the ray meets, and its radiance there.
vec3 seen_thing(ivec2 pixel, vec2 uv, vec3 ray, vec3 dir, out float reach) {
    uvec4 texel = texelFetch(surface_shape, pixel, 0);
    reach = FARTHEST;
    if (texel.x != 0u) {
        vec3 position = ray / shape_depth(texel);
        water_shape s = shape_of(texel, position.xy);
        reach = length(position);
        footprint f = pixel_footprint(vec3(-dir.xy, abs(dir.z)), reach, vec2(0.0));
        sea_place read = place_of(s.rest);
        wave_fields w = waves_at(s.rest, read, f, eye_gust, s.depth, vec4(s.slope, s.spacing, 0.0));
        vec3 hidden = hidden_slopes(s.rest, f, s.depth) * eye_gust * eye_gust;
#ifdef WAVES_CASCADES
        add_fine(read, f, eye_gust, s.depth, w.slope, hidden);
#endif
        return surface_from_below(position, dir, w.slope, hidden, sun_light * cloud_shadow(position.xy));
    }
#ifdef LAND
    vec3 at;
    vec4 thing = behind(uv, at);
    if (thing.w > 0.0) {
        reach = length(at);
        return lit_below(thing.rgb, -(at.z + eye_height));
    }
#endif
    return vec3(0.0);
}

#ifdef WATERLINE
const float MENISCUS = 2.5; // half its width [px]

const float FINEST_MESH = 0.01; // spacing of the mesh at the eye [m]

// Height of the surface over an eye-relative place; twin of wave_offset() of common/waves.glsl.
float surface_height(vec2 place) {
#ifdef WAVES_CASCADES
#ifdef LAND
    float depth = -shore_elevation(place);
#else
    float depth = 1000.0;
#endif
    vec4 kept = cascades_kept(depth);
    vec2 rest = place;
    float height = 0.0;
    for (int i = 0; i < 4; ++i) {
        sea_place at = place_of(rest);
        vec3 sum = vec3(0.0);
        vec3 longer = vec3(0.0);
        for (int c = 0; c < cascade_count; ++c) {
            vec3 d = kept[c] * cascade_spline(c, cascade_uv(c, at.at));
            sum += d + vec3(0.0, 0.0, kept[c] * kept[c] * lift_of(c, FINEST_MESH));
#ifdef BOUND_WAVES
            sum.z += bound_height(c, d, longer);
#endif
        }
        rest = place - choppiness * sum.xy;
        height = sum.z;
    }
    for (int i = 0; i < LAYER_COUNT; ++i) height += layer_at(i, rest, depth).height;
    return height;
#else
    return 0.0;
#endif
}

// Height of the near plane's point over the water [px].
float over_water(vec3 point) {
    return (point.z + eye_height - surface_height(point.xy)) / (near_distance * radians_per_pixel);
}
#endif

void main() {
    ivec2 pixel = sampled_pixel(gl_FragCoord.xy);
    vec2 uv = (vec2(pixel) + 0.5) * pixel_size;
    vec3 ray = frame_ray(uv), dir = normalize(ray);
    float cover = 1.0, shade = 1.0;
#ifdef WATERLINE
    float over = over_water(ray);
    if (over > MENISCUS) discard;
    // the film on the lens: dark where it turns the view away, down to a thin bright line at its lower edge
    float film = 1.0 - smoothstep(0.0, MENISCUS, abs(over));
    cover = clamp(1.0 - over / MENISCUS, 0.0, 1.0);
    shade = 1.0 - 0.75 * film;
#endif
    vec3 sunlight = sun_light * eye_shade;
    float reach;
    vec3 thing = seen_thing(pixel, uv, ray, dir, reach);
    vec3 light = thing;
    if (effect_is_on(EFFECT_FOG))
        light = thing * exp(-beam_attenuation * reach) + veil_with_shafts(sunlight, dir, reach);
    color = vec4(light * shade, cover);
}
#endif
