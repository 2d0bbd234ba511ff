// SPDX-License-Identifier: MIT
// Light that comes out of the water, and off the foam on it. Constants that the optics share.

#include "shared/bed.glsl"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#include "shared/refraction.glsl"

// Light through crests: `GLOW_ALL` for every azimuth, GLOW_AHEAD more towards the sun, chosen by eye.
const float GLOW_ALL = 0.6, GLOW_AHEAD = 5.0;

// The radiance over the water of a bed of radiance `bed`, and of the water `deep` over it. both_ways: share of the
// light that is left after bed_path(), by Beer's law with the diffuse attenuation.
vec3 radiance_of_bed(vec3 bed, vec3 deep, vec3 both_ways) {
    return bed * BED_LEAVES * both_ways + deep * (1.0 - both_ways);
}

// Light that entered the far side of a crest and leaves through the near one [radiance for the water's reflectance
// `deep`]. `height`: over the mean water in significant heights; pinched crests (Jacobian below 1) are thin. Seen from
// above nothing glows: the way through the crest is level.
vec3 crest_glow(vec3 deep, vec3 sunlight, vec3 view, vec3 to_sun, float height, float jacobian) {
    float ahead = clamp(dot(-view, normalize(vec3(to_sun.xy, max(to_sun.z, 0.05)))), 0.0, 1.0);
    float level = 1.0 - view.z * view.z;
    return deep * sunlight * (ahead * ahead * ahead * GLOW_AHEAD + GLOW_ALL) * clamp(height, 0.0, 1.0) *
           clamp(1.2 - jacobian, 0.0, 1.0) * (level * level);
}

// Bubbles that breaking waves drive into the water scatter all colours alike, and the water between them absorbs the
// red: a milky green. By eye: what the densest cloud scatters back [1/m].
const float BUBBLE_BACKSCATTER = 0.25;
// Irradiance reflectance for backscatter over the sum of absorption and backscatter (Gordon et al. 1988).
const float GORDON_SHARE = 0.33;

// Remote-sensing reflectance that bubbles add [1/sr]. density: share of the densest cloud.
vec3 bubble_reflectance(vec3 attenuation, float density) {
    float scatter = BUBBLE_BACKSCATTER * density;
    return (BED_LEAVES * GORDON_SHARE / PI) * scatter / (attenuation + scatter);
}

// Radiance of foam of albedo 1 that the sun meets at that cosine: a Lambertian surface.
vec3 foam_radiance(vec3 sunlight, float facing, vec3 sky) { return (sunlight * max(facing, 0.0) + sky) * (1.0 / PI); }
