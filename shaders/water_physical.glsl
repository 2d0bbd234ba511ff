// SPDX-License-Identifier: MIT
// Shades the water, each pixel once, from the outputs of water_shape.glsl. The unresolved waves of a pixel are a
// covariance of slopes (Bruneton, Neyret & Holzschuch 2010), which widens the sun's glitter, blurs the reflected sky
// and lowers the mean Fresnel reflectance. Waves shadow and mask each other (common/reflection.glsl). The light from
// below comes from the sea bed and from the backscatter of the water (Gordon et al. 1988; Lee et al. 1998 for finite
// depth).
//
// LAND: there is terrain: depth attenuates the waves, the bed is visible through the water, land is reflected, the
// shore foams. BEHIND: of these, the bed is visible and land is reflected. TAPS: most texture fetches along the long
// side of the pixel's footprint. RAYS: reflected rays that search for land. BARE: the sea never foams. STREAKS: the
// wind blows foam into streaks.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifndef VERTEX
#ifndef RAYS // set by quality; this serves an offline compiler
#define RAYS 3
#define LAND_STEPS 32
#endif
#if defined(LAND) && !defined(BEHIND)
#define BEHIND
#endif
#include "common/waves.glsl"
#include "common/atmosphere.glsl"
#include "common/shape.glsl"
#include "common/water_air.glsl"
#include "shared/fresnel.glsl"
#include "common/slopes.glsl"
#include "common/reflection.glsl"
#include "common/rough.glsl"
#include "common/water_light.glsl"
#include "common/foam.glsl"
#include "common/look.glsl"

#include "common/shape_maps.glsl"
layout(std140) uniform Optics {
#include "shared/physical_block.glsl"
};

#include "common/fine.glsl"

#ifdef BEHIND
#include "common/behind.glsl"
#endif
#ifdef LAND
#include "common/shore_foam.glsl"
#endif

// The ray that a facet of that slope reflects towards the observer.
vec3 reflected_ray(vec3 view, vec2 slope) { return reflect(-view, normalize(vec3(-slope, 1.0))); }

#ifdef BEHIND
#pragma unit land_mirror 19
uniform sampler2D land_mirror; // land_mirror.glsl


// The land that a lobe of reflected rays meets, found in screen space along its middle: rgb times the share, the share.
// width: angle that the lobe spans [rad].
vec4 mirrored_land(vec3 position, vec3 direction, float width) {
    if (direction.z > 0.6) return vec4(0.0);
    vec4 origin = view_projection * vec4(position, 1.0), step = view_projection * vec4(direction, 0.0);
    // Of the ray, what the whole picture shows, so that a tile of it takes the same steps: to one of its edges, or so
    // far that the end is the point where the ray vanishes.
    vec2 shift = tile_share + 2.0 * tile_corner * (pixel_size * tile_share) - 1.0;
    vec2 from = origin.xy * tile_share + origin.w * shift, along = step.xy * tile_share + step.w * shift;
    vec4 inside = vec4(origin.w + from, origin.w - from);
    vec4 loss = max(-vec4(step.w + along, step.w - along), 1e-6 * origin.w);
    vec2 least = min(inside.xy / loss.xy, inside.zw / loss.zw);
    float end = min(least.x, least.y), end_w = origin.w + end * step.w;
    // Steps over the screen, so that no hill is passed over that is wider than one of them; they are short at first,
    // where a boat may lie. A ray that meets nothing still has land beside it, about where it vanishes.
    float near = 0.0, far = 1.0, gap = 0.0; // gap: distance of the ray behind the visible surface [m]
    bool hit = false;
    for (int i = 0; i < LAND_STEPS && !hit; ++i) {
        far = (float(i) + 1.0) / float(LAND_STEPS);
        far *= sqrt(far);
        vec4 c = origin + step * (end * far * origin.w / mix(end_w, origin.w, far));
        float depth = textureLod(scene_depth, c.xy / c.w * 0.5 + 0.5, 0.0).x;
        hit = depth > 0.0 && frame_distance(depth) < c.w && max(abs(c.x), abs(c.y)) <= c.w;
        if (!hit) near = far;
    }
    for (int i = 0; i < 5 && hit; ++i) {
        float middle = 0.5 * (near + far);
        vec4 c = origin + step * (end * middle * origin.w / mix(end_w, origin.w, middle));
        float depth = textureLod(scene_depth, c.xy / c.w * 0.5 + 0.5, 0.0).x;
        bool behind_it = depth > 0.0 && frame_distance(depth) < c.w;
        if (behind_it) {
            far = middle;
            gap = c.w - frame_distance(depth);
        } else {
            near = middle;
        }
    }
    float there = end * far * origin.w / mix(end_w, origin.w, far);
    float before = end * near * origin.w / mix(end_w, origin.w, near);
    // Land reaches down to the ground, so a ray behind it has met it. On the open sea objects may float in the air.
    if (shore_present == 0 && (!hit || gap > 0.5 + 2.0 * (there - before))) return vec4(0.0);
    vec4 c = origin + step * there;
    vec2 uv = c.xy / c.w * 0.5 + 0.5;
    // A lobe is long upwards and narrow sideways: three texture fetches over one another, each round. Pixels of the
    // coarsest level are whole in every tile of a picture.
    float pixels = width * there / (c.w * radians_per_pixel * float(3 * LAND_MIRROR_PART));
    pixels = min(pixels, exp2(LAND_MIRROR_LEVELS));
    vec4 rise = view_projection[2];
    vec2 up = normalize((rise.xy - (c.xy / c.w) * rise.w) * viewport_size), size = vec2(textureSize(land_mirror, 0));
    vec2 at = uv * viewport_size / (size * float(LAND_MIRROR_PART)), apart = up * max(pixels, 1.0) / size;
    float level = log2(max(pixels, 1.0));
    vec4 land = (1.0 / 3.0) * (textureLod(land_mirror, at - apart, level) + textureLod(land_mirror, at, level) +
                               textureLod(land_mirror, at + apart, level));
    if (pixels < 1.0 && hit) { // sharper than the small picture
        vec3 where;
        vec4 seen = behind(uv, where);
        land = mix(seen.w > 0.0 && is_dry(where) ? vec4(seen.rgb, 1.0) : vec4(0.0), land, pixels);
    }
    // What of the lobe lies below the horizon meets other waves.
    land *= 1.0 / clamp(0.5 + direction.z / max(width, 1e-3), 0.5, 1.0);
    vec2 whole = uv * tile_share + tile_corner * (pixel_size * tile_share), edge = min(whole, 1.0 - whole);
    return land * (smoothstep(0.0, 0.05, min(edge.x, edge.y)) / max(land.w, 1.0));
}

// The reflected sky with the land before it. Several tilts sample the distribution of the facets, each with its part of
// the lobe. The share `mirror.clear` of sky and land is not hidden by waves.
vec3 with_land(vec3 sky, vec3 position, vec3 view, vec2 slope, vec2 toward, rough_reflection mirror) {
    vec4 land = vec4(0.0);
    float width = (RAYS == 1 ? 5.0 : 2.4) * mirror.spread; // a facet's tilt turns the ray by twice as much
    for (int i = 0; i < RAYS; ++i) {
        float tilt = RAYS == 1 ? 0.0 : float(i - 1) * 1.2;
        vec3 ray = reflected_ray(view, slope + toward * (mirror.tilt + tilt * mirror.spread));
        float weight = RAYS == 1 ? 1.0 : i == 1 ? 0.5 : 0.25;
        land += weight * mirrored_land(position, vec3(ray.xy, abs(ray.z)), width);
    }
    return sky * (1.0 - land.w) + land.rgb * mirror.clear;
}

// The mesh of the bed may depart from the ground by some pixels (quality_table of src/render/pass_ground.c): far away
// by more than the water is deep. Within that error the depth is that of the shore map; beyond it an object stands in
// the water.
const float BED_ERROR = 4.0; // [px]

// The bed's share of the radiance that leaves the water, and the depth of water over it [m]. entered: share of the
// light on the water that enters it; mapped: that depth by the shore map.
vec3 bed_radiance(vec2 uv, vec3 deep, vec3 position, vec3 view, vec3 normal, vec3 entered, float mapped,
                  out float water_path) {
    vec3 refracted = refract(-view, normal, 1.0 / water_index);
    float down = max(-refracted.z, 0.3);
    vec3 bed, bent_bed;
    vec4 seen = behind(uv, bed);
    float drop = clamp(position.z - bed.z, 0.0, 60.0);
    vec4 target = view_projection * vec4(position + refracted * (drop / down), 1.0);
    vec2 bent = within_image(target.xy / target.w * 0.5 + 0.5);
    vec4 s = behind(bent, bent_bed);
    if (seen.w > 0.0 && s.w > 0.0 && bent_bed.z < position.z) { seen = s; bed = bent_bed; }
    float error = BED_ERROR * radians_per_pixel * length(position), measured = position.z - bed.z;
    water_path = seen.w > 0.0 ? max(clamp(mapped, measured - error, measured + error), 0.0) : 1e4;
    return radiance_of_bed(seen.rgb * entered / BED_ENTERS, deep, exp(-water_attenuation * bed_path(water_path, down)));
}

#endif

#pragma unit sun_share 17
uniform sampler2D sun_share; // that the objects of the host and of the scene leave; a single texel where there are none
float sun_left(ivec2 pixel) { return texelFetch(sun_share, min(pixel, textureSize(sun_share, 0) - 1), 0).r; }

// A pixel of water before it is shaded.
struct water_here {
    vec3 position, view;    // eye-relative; towards the eye
    vec2 rest;              // undisplaced xy
    float depth;            // of the mean water [m]
    float shade;            // share of the sun that passes the clouds and a host's objects
    water_air air;
    float height;           // over the mean water [m]
    footprint place;
    float width;            // of the pixel, for textures that are fetched once [m]
    wave_fields waves;
    vec2 slope;             // mean slope of the resolved waves, as the eye sees it
    vec3 normal;            // of that slope
    vec3 hidden, roughness; // unresolved slope covariance: of an even wind, and here
    surroundings near;
    visible_facets whole, seen; // over the slope of the mesh, and over `slope`
};

// Slope covariance that the mesh lacks: a wave of three spacings fades to half on it, as it does under a pixel 1.4
// spacings wide.
const float MESH_WIDTH = 1.4;
vec3 slopes_beyond_mesh(vec2 rest, footprint f, float depth, float spacing) {
#ifndef WAVES_MESH // where the vertices carry all waves, the texture fetches resolve no more than the mesh
    f.major = f.minor = MESH_WIDTH * exp2(spacing);
#endif
    return hidden_slopes(rest, f, depth);
}

// Share of the amplitude that shallow water leaves.
float waves_left(float depth) {
#ifdef LAND
    return max(coast_attenuation(depth, significant_height), 0.05);
#else
    return 1.0;
#endif
}

water_here water_at(ivec2 pixel, vec2 uv, uvec4 texel) {
    water_here p;
    p.position = frame_ray(uv) / shape_depth(texel);
    water_shape shape = shape_of(texel, p.position.xy);
    p.rest = shape.rest;
    p.depth = shape.depth;
    sea_place read = place_of(p.rest);
    p.height = earth_height(p.position.z, eye_height, dot(p.position.xy, p.position.xy), earth_radius);
    float dist = length(p.position), left = waves_left(p.depth);
    p.view = -p.position / dist;
    p.air = air_at(uv, dist, p.view.z);
    p.shade = cloud_shadow(p.position.xy) * sun_left(pixel);
    float gust = p.air.gust;
    p.place = pixel_footprint(p.view, dist, shape.slope);
    vec3 beyond = slopes_beyond_mesh(p.rest, p.place, p.depth, shape.spacing) * gust * gust;
    p.whole = facets_seen(p.view, shape.slope, beyond);
    // Visible facets lean towards the eye, so that it sees less length of them than of their mean plane. A mean over
    // them varies as a mean over that length does.
    float facing = p.view.z - dot(shape.slope, p.view.xy) + p.whole.shift * length(p.view.xy);
    p.place.major = max(p.place.minor, min(p.place.major, dist * radians_per_pixel / max(facing, 0.01)));
    p.waves = waves_at(p.rest, read, p.place, gust, p.depth, vec4(shape.slope, shape.spacing, 0.0));
    p.width = max(p.place.minor, p.place.major / float(TAPS));
    p.hidden = hidden_slopes(p.rest, p.place, p.depth);
    p.roughness = p.hidden * gust * gust;
#ifdef WAVES_CASCADES
    add_fine(read, p.place, gust, p.depth, p.waves.slope, p.roughness);
#endif
    vec3 total = mix(beyond, slope_total, left * left);
    p.near = surroundings_of(shape.slope, beyond, total, p.height / (height_deviation * left));
    p.slope = seen_slope(p.view, p.waves.slope, p.near, p.whole, p.roughness);
    p.seen = facets_seen(p.view, p.slope, p.roughness);
    p.normal = normalize(vec3(-p.slope, 1.0));
    return p;
}

#ifdef LAND
// Depth of the bed under a pixel [m], for what the water's edge has and a hull has not. water_path: depth of what is
// seen under it, which is less only over an object.
float over_bed(water_here p, float water_path) { return max(water_path, p.depth + p.height); }
#endif

// The reflected sky and land: radiance times reflectance. Two texture fetches along the lobe, which is long along the
// view and narrows across it by the sine of the grazing angle. Rays that another wave stops are reflected again there,
// and come from the low sky.
vec3 reflected_light(water_here p, rough_reflection mirror) {
    vec2 pair = fetches_of(mirror.spread, p.seen.across * clamp(dot(p.view, p.normal), 0.0, 1.0));
    float blur = pair.x, apart = pair.y;
    vec3 low = reflected_ray(p.view, p.slope + p.seen.toward * (mirror.tilt - apart));
    vec3 high = reflected_ray(p.view, p.slope + p.seen.toward * (mirror.tilt + apart));
    vec3 low_sky = environment_radiance(vec3(low.xy, abs(low.z)), blur);
    vec3 high_sky = environment_radiance(vec3(high.xy, abs(high.z)), blur);
    vec3 light = mirror.clear * 0.5 * (low_sky + high_sky);
#ifdef BEHIND
    light = with_land(light, p.position, p.view, p.slope, p.seen.toward, mirror);
#endif
    float again = level_reflectance(slope_variance(normalize(level_part(p.view)), slope_total));
    return light + (mirror.reflectance - mirror.clear) * again * low_sky;
}

// Irradiance just below the surface.
vec3 light_below(vec3 sunlight) {
    rough_facets to_sun = rough_seen(sun_direction, vec2(0.0), slope_total);
    float enters = 1.0 - rough_fresnel(sun_direction, vec2(0.0), to_sun, water_index);
    return sunlight * (max(sun_direction.z, 0.0) * enters) + sky_light * SKY_ENTERS;
}

// The far side of the crest leans towards the sun as this one leans away from it.
vec3 light_through_crest(water_here p, vec3 sunlight) {
    vec2 to_sun = normalize(sun_direction.xy + vec2(1e-6, 0.0));
    float rise = dot(p.waves.slope, to_sun), path = crest_path(p.height, rise, 1.0 - p.waves.jacobian);
    vec3 beam = refract(-sun_direction, normalize(vec3(to_sun * max(rise, 0.0), 1.0)), 1.0 / water_index);
    vec3 back = -refract(-p.view, p.normal, 1.0 / water_index);
    return crest_light(water_scattering, water_attenuation, sunlight, dot(beam, back), path, water_index);
}

// The radiance from below the surface: of the water itself and of the bed. water_path: depth under the pixel [m].
vec3 transmitted_light(water_here p, vec2 uv, vec3 sunlight, vec3 lit, out float water_path) {
    vec3 below = effect_is_on(EFFECT_AMBIENT) ? water_reflectance * lit : vec3(0.0);
    water_path = 1e4;
#ifdef BEHIND
    vec3 entered = lit / max(sunlight * max(sun_direction.z, 0.0) + sky_light, vec3(1e-9));
    vec3 over_bed = bed_radiance(uv, below, p.position, p.view, p.normal, entered, p.depth + p.height, water_path);
    if (effect_is_on(EFFECT_REFRACTION)) below = over_bed;
#endif
    if (effect_is_on(EFFECT_SCATTERING)) {
        below += light_through_crest(p, sunlight);
    }
    return below;
}

// The light that leaves the clean surface.
vec3 surface_light(water_here p, vec3 sunlight, vec3 below) {
    rough_reflection mirror = reflection_of(p.view, p.slope, p.seen, p.near, water_index);
    vec3 light = (1.0 - mirror.reflectance) * below;
    if (effect_is_on(EFFECT_REFLECTION)) light += reflected_light(p, mirror);
    if (effect_is_on(EFFECT_GLITTER) && sun_direction.z > -0.01)
        light += sunlight *
                 sun_glint(p.view, sun_direction, p.slope, p.roughness, p.seen, p.near, p.whole, water_index);
    return light;
}

// Densities, by eye: of fresh foam per unit of Jacobian, of old foam and of bubbles per deviation of the foam memory,
// of foam at the shore and of streaks per deviation of their noise.
const float FRESH_DENSITY = 60.0, OLD_DENSITY = 8.0, SHORE_DENSITY = 2.0, STREAK_DENSITY = 1.4, BUBBLES_DENSITY = 0.6;
// How far bubbles reach beyond old foam, and the variance that softens their cloud, by deviations of the foam memory.
const float BUBBLES_REACH = 0.2, BUBBLES_BLUR = 0.5;
const float STREAK_BUBBLES = 0.6; // that the converging water of a windrow draws down with an opaque streak

struct foam_here {
    float opacity; // of the film on the water
    float bubbles; // share of their densest cloud below it
    float relief;  // foam_relief(), of dense foam
    float hollows; // foam_hollows(), of dense foam
};

// share: of the variance of the Jacobian, that the pixel hides.
float streak_film(water_here p, float share, foam_texels texels) {
    float pinch = STREAKS_ON_CRESTS * (1.0 - p.waves.jacobian) * inversesqrt(jacobian_variance);
    float across = windrow_width(p.place.axis, p.place.minor, p.width);
    return foam_film(streak_excess + pinch, STREAKS_ON_CRESTS * STREAKS_ON_CRESTS * share, 1.0,
                     streak_grain(texels, p.width, windrow_texels(p.rest, across), across), STREAK_DENSITY);
}

// By the law of shared/foam.glsl. The pixel hides the same share of the slope variance, of the variance of the Jacobian
// and of the foam memory. shore: share that broken waves at the shore cover.
foam_here foam_at(water_here p, float shore, foam_texels texels) {
    float width = p.width, slopes = p.hidden.x + p.hidden.z - slopes_beyond_cascades;
    float hidden = jacobian_variance_of(slopes, choppiness);
    float share = clamp(hidden / max(jacobian_variance, 1e-6), 0.0, 1.0);
    foam_grain grain = patch_grain(texels, FRESH_WEIGHTS, width);
    float fresh = foam_film(breaking_jacobian - p.waves.jacobian, hidden, sqrt(fresh_edge), grain, FRESH_DENSITY);
    fresh = breaking_jacobian <= 1.0 - FOAM_NEVER ? 0.0 : fresh;
#ifdef LAND
    if (shore > 0.0) fresh = max(fresh, foam_film(foam_quantile(shore), 0.0, 1.0, grain, SHORE_DENSITY));
#endif
    float excess = (p.waves.foam - old_foam_memory) * inversesqrt(memory_variance);
    float old = foam_film(excess, share, sqrt(old_edge), patch_grain(texels, OLD_WEIGHTS, width), OLD_DENSITY);
    float bubbles = foam_opacity(excess + BUBBLES_REACH, share + BUBBLES_BLUR, BUBBLES_DENSITY);
    bool none = old_foam_memory >= FOAM_NEVER;
    old = none ? 0.0 : old;
    bubbles = none ? 0.0 : bubbles;
    float clear = (1.0 - fresh) * (1.0 - old);
#ifdef STREAKS
    float streaks = streak_film(p, share, texels);
    clear *= 1.0 - streaks;
    bubbles = max(bubbles, STREAK_BUBBLES * streaks);
#endif
    return foam_here(clamp((1.0 - clear) * foam_strength, 0.0, 1.0), max(bubbles, shore) * foam_strength,
                     foam_relief(texels, p.rest, width), foam_hollows(texels));
}

// The surface under its foam.
vec3 covered(vec3 surface, water_here p, vec3 sunlight, foam_here foam) {
    float facing = dot(sun_direction, p.normal) - foam.opacity * foam.relief;
    vec3 from_sky = sky_light * mix(1.0, foam.hollows, foam.opacity);
    return mix(surface, foam_radiance(sunlight, facing, from_sky) * FOAM_ALBEDO, foam.opacity);
}

const float FILM = 0.12; // depth within which the water's edge fades into wet sand [m]

// False: there is no water under the pixel of the target with that centre.
bool shade(vec2 centre, out vec4 color) {
    ivec2 pixel = sampled_pixel(centre);
    vec2 uv = (vec2(pixel) + 0.5) * pixel_size;
    uvec4 shape = texelFetch(surface_shape, pixel, 0);
    color = vec4(0.0);
    if (shape.x == 0u) return false;
    water_here p = water_at(pixel, uv, shape);
    vec3 sunlight = sun_light * p.shade;
    float water_path;
    vec3 lit = light_below(sunlight);
    vec3 below = transmitted_light(p, uv, sunlight, lit, water_path);
#ifndef BARE
    foam_here foam = foam_here(0.0, 0.0, 0.0, 1.0);
    if (effect_is_on(EFFECT_FOAM)) {
        foam_texels texels = foam_look_up(p.rest, p.width);
        float shore = 0.0;
#ifdef LAND
        vec2 noise = smooth_patches(p.rest, p.width);
        shore = shore_cover(p.rest, p.depth, over_bed(p, water_path), noise);
#endif
        foam = foam_at(p, shore, texels);
    }
    below += bubble_reflectance(water_attenuation, foam.bubbles) * lit;
#endif
    vec3 surface = surface_light(p, sunlight, below);
#ifndef BARE
    surface = covered(surface, p, sunlight, foam);
#endif
#ifdef LAND
    surface = mix(texelFetch(scene_color, pixel, 0).rgb, surface, smoothstep(0.0, FILM, over_bed(p, water_path)));
#endif
    color = vec4(surface * p.air.transmittance + p.air.inscatter, 1.0);
    return true;
}

#include "common/pixels.glsl"
#endif
