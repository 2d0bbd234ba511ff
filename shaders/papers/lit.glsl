// SPDX-License-Identifier: MIT
// Normals of the mesh and one light (Liu, Xu & Chen 2009, section 3): ambient, diffuse and specular, the fixed-function
// lighting of OpenGL.
//
// Beyond the paper, from its list of future work: reflected sky and transmitted light by Fresnel's law, and foam where
// crests fold. The unresolved slopes widen the highlight and blur the reflection.
//
// LAND: there is terrain: the bed is visible through the water, and the shore foams. PAPER: the shading of the paper
// alone. (These are defines, because software OpenGL executes both sides of a branch.)
#include "common/frame.glsl"
#include "common/water_vertex.glsl"

#ifdef VERTEX
void main() { water_vertex(); }
#endif

#ifdef FRAGMENT
#include "common/look.glsl"
#include "shared/fresnel.glsl"
#include "common/ripples.glsl"
#include "common/rough.glsl"
#include "common/water_light.glsl"
out vec4 color;

#pragma unit foam_detail 7
uniform sampler2D foam_detail; // see common/foam.glsl
layout(std140) uniform Optics {
#include "shared/lit_block.glsl"
};

#ifdef LAND
#include "common/behind.glsl"
#include "shared/surf.glsl"
#endif

const float SHORE_REACH = 0.7, SHORE_COVER = 0.5; // foam where the sea ends: within this depth in significant heights
const float FILM = 0.12;                          // depth within which the water's edge fades into wet sand [m]

// Slope, jacobian and foam of the waves here. The paper has those of the vertices.
wave_fields waves_here(water_pixel p, footprint f) {
    wave_fields w = waves_at(p.rest, p.place, f, p.gust, p.depth, p.mesh);
#if defined(PAPER) && !defined(QUAD)
    w.slope = p.mesh.xy;
#endif
    return w;
}

// Opacity of the foam, for a pixel of that width [m]. The bubbles are fetched only where there is foam.
float foam_here(water_pixel p, float width, wave_fields w, vec3 covariance) {
    float hidden = jacobian_variance_of(covariance.x + covariance.z - slopes_beyond_waves, choppiness);
    float cover = foam_cover_fast(foam_jacobian - w.jacobian, hidden + foam_edge * foam_edge);
#ifdef LAND
    cover = max(cover, shallows(p.least / clamp(significant_height, 0.3, 3.0), 0.0, SHORE_REACH) * SHORE_COVER);
#endif
    float alpha = 0.0;
    if (cover > 0.02) {
        vec2 at = mod(water_wrapped + p.rest, WORLD_WRAP);
        float detail = log2(width * 64.0); // texels of a tile of 8 m
        float blurred = clamp(detail * 0.2, 0.0, 1.0), far = clamp(detail * 0.2 - 0.6, 0.0, 1.0);
        vec4 broad = textureLod(foam_detail, at * 0.015625, max(detail - 3.0, 0.0));
        vec4 fine = textureLod(foam_detail, at.yx * 0.125, max(detail, 0.0));
        // values as likely as any: above 1 - cover there is foam, torn and full of holes
        float value = mix(0.5 * (broad.r + fine.r), broad.r, blurred), edge = min(0.3, min(cover, 1.0 - cover)) + 1e-4;
        alpha = smoothstep(1.0 - edge - cover, 1.0 + edge - cover, value) * (0.6 + 0.4 * fine.g);
        alpha = mix(alpha, 0.8 * cover, far); // from afar, the mean
    }
    return alpha * foam_strength;
}

#ifdef LAND
// The radiance from below with the bed, and the opacity of the water, 0 in the last centimetres of depth.
vec3 with_bed(vec3 deep, water_pixel p, vec3 view, vec2 slope, out float film) {
    vec2 here = gl_FragCoord.xy * pixel_size, uv = here - 0.06 * slope * clamp(p.depth * 0.3, 0.0, 1.0);
    vec3 bed;
    vec4 seen = behind(uv, bed);
    if (bed.z > p.position.z) seen = behind(here, bed); // something stands before the water there
    float path = seen.w > 0.0 ? max(p.position.z - bed.z, 0.0) : 1e4;
    film = smoothstep(0.0, FILM, path);
    return radiance_of_bed(seen.rgb, deep,
                           exp(-water_attenuation * bed_path(path, refracted_cosine(view.z, water_index))));
}
#endif

#ifdef PAPER
// Section 3 exactly: no reflection, no transmitted light.
vec3 light_of(water_pixel p, vec3 view, footprint f, wave_fields w) {
    vec3 normal = normalize(vec3(-w.slope, 1.0)), sunlight = sun_light * p.shade, light = vec3(0.0);
    float facing = max(dot(sun_direction, normal), 0.0), high = max(dot(normal, normalize(view + sun_direction)), 1e-6);
    if (effect_is_on(EFFECT_AMBIENT)) light += look_ambient * water_reflectance * (sunlight * facing + sky_light);
    if (effect_is_on(EFFECT_DIFFUSE)) light += look_diffuse * sunlight * facing * 0.31830989;
    if (effect_is_on(EFFECT_SPECULAR))
        light += look_specular * sunlight * exp2(look_shininess * log2(high)) * step(0.0, sun_direction.z);
    return light;
}
#else
vec3 light_of(water_pixel p, vec3 view, footprint f, wave_fields w) {
#ifdef WAVES_CASCADES
    f.minor = max(f.minor, f.major / float(TAPS)); // the width that the fetches really average over
#endif
    vec3 hidden = water_hidden_slopes(p.rest, f, p.depth) * (p.gust * p.gust), covariance = hidden;
    footprint pixel = pixel_footprint(view, length(p.position), p.mesh.xy);
    add_ripples(p.rest, pixel, p.gust, p.depth, w.slope, covariance);
    covariance += vec3(1.0, 0.0, 1.0) / look_shininess;
    rough_facets seen = rough_seen(view, w.slope, covariance);
    float reflectance = rough_fresnel(view, w.slope, seen, water_index), film = 1.0;

    vec3 normal = normalize(vec3(-w.slope, 1.0)), sunlight = sun_light * p.shade, below = vec3(0.0);
    float facing = max(dot(sun_direction, normal), 0.0);
    if (effect_is_on(EFFECT_AMBIENT)) below += look_ambient * water_reflectance * (sunlight * facing + sky_light);
    if (effect_is_on(EFFECT_DIFFUSE)) below += look_diffuse * sunlight * facing * 0.31830989;
#ifdef LAND
    if (effect_is_on(EFFECT_REFRACTION)) below = with_bed(below, p, view, w.slope, film);
#endif
    vec3 light = (1.0 - reflectance) * below;
    vec2 toward = view.xy / max(length(view.xy), 1e-4);
    vec3 mirrored = reflect(-view, normalize(vec3(toward * seen.shift - w.slope, 1.0)));
    if (effect_is_on(EFFECT_REFLECTION))
        light += reflectance * environment_radiance(vec3(mirrored.xy, abs(mirrored.z)), seen.sigma);
    if (effect_is_on(EFFECT_SPECULAR))
        light += look_specular * sunlight * step(-0.01, sun_direction.z) *
                 rough_glint(view, sun_direction, w.slope, covariance, seen, water_index);
    if (effect_is_on(EFFECT_FOAM))
        light = mix(light, foam_radiance(sunlight, facing, sky_light) * FOAM_ALBEDO,
                    foam_here(p, pixel.minor, w, hidden));
#ifdef LAND
    light = mix(textureLod(scene_color, gl_FragCoord.xy * pixel_size, 0.0).rgb, light, film);
#endif
    return light;
}
#endif

void main() {
    water_pixel p = water_here();
#if !defined(QUAD) && !defined(PAPER)
    if (p.spacing > 100.0) p.shade = cloud_shadow(p.position.xy); // between these vertices lies more than one cloud
#endif
    float dist = length(p.position);
    vec3 view = -p.position / dist;
    footprint f = water_footprint(p, view, dist);
    vec3 light = light_of(p, view, f, waves_here(p, f));
    color = vec4(light * p.transmittance + p.inscatter, 1.0);
}
#endif
