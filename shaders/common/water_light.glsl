// SPDX-License-Identifier: MIT
// Light that comes out of the water, and off the foam on it. Constants that the optics share.

#include "shared/bed.glsl"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#include "shared/fournier_forand.glsl"
#include "shared/refraction.glsl"

// The radiance over the water of a bed of radiance `bed`, and of the water `deep` over it. both_ways: share of the
// light that is left after bed_path(), by Beer's law with the diffuse attenuation.
vec3 radiance_of_bed(vec3 bed, vec3 deep, vec3 both_ways) {
    return bed * BED_LEAVES * both_ways + deep * (1.0 - both_ways);
}

// Level way through a crest to its sunny side [m]. In deep water a wave of amplitude A and phase x has the height
// A cos x, the slope A k sin x, and pinches the surface by A k cos x. So x is known, and k is the pinch over the
// height. rise: slope towards the sun; pinch: 1 less the Jacobian. Endless where the crest is not pinched.
float crest_path(float height, float rise, float pinch) {
    float p = max(pinch, 1e-4);
    return 2.0 * max(height, 0.0) / p * atan(max(rise, 0.0), p);
}

// Waves turn the beam by more than that: the phase function has no finite value straight ahead.
const float PHASE_NEAREST = 0.99;
const float PETZOLD = 3.5835; // exponent of the sizes of Petzold's mean particles

// Sunlight that entered the sunny side of a crest, `path` away, and is scattered once on its way to the eye. The phase
// function of particles points forwards: crests glow before the sun and are dark elsewhere. cosine: of the angle by
// which light turns. Radiance in the water over index squared.
vec3 crest_light(vec3 scattering, vec3 attenuation, vec3 sunlight, float cosine, float path, float index) {
    float phase = fournier_forand(min(cosine, PHASE_NEAREST), fournier_forand_index(PETZOLD), PETZOLD);
    return sunlight * (SUN_ENTERS * phase * path / (index * index)) * scattering * exp(-attenuation * path);
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
