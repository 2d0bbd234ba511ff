// SPDX-License-Identifier: MIT
// Light inside the water, for an eye in it. The light at a depth is irradiance * exp(-Kd depth), Kd by Jerlov's type.
// A ray towards the eye loses what its water absorbs, and what it scatters by more than the blur of an image; light
// that is scattered by less still forms the image. The veil before an image has two sources:
//
//   the field    light that was scattered often: the same in all directions, as strong as makes the radiance that
//                leaves deep water upwards the one that is seen from above (Gordon et al. 1988)
//   the beam     sunlight that was scattered once, by the phase function less its value straight back, which the field
//                has already
//
// Needs common/frame.glsl, shared/bed.glsl and the block of below_block.glsl.
#include "shared/fournier_forand.glsl"

// The direction to the sun as it is seen in the water behind a level surface.
vec3 sun_below() {
    vec2 level = sun_direction.xy / water_index;
    return vec3(level, sun_below_z);
}

// Irradiance of sun and sky on a level just under the surface. sunlight: at normal incidence, over the water.
vec3 light_entering(vec3 sunlight) {
    float height = max(sun_direction.z, 0.0);
    return sunlight * (height * (1.0 - fresnel(height, water_index))) + sky_light * SKY_ENTERS;
}

// Irradiance across the refracted rays of the sun.
vec3 beam_entering(vec3 sunlight) {
    float height = max(sun_direction.z, 0.0);
    return sunlight * (height * (1.0 - fresnel(height, water_index)) / sun_below_z);
}

// Share of the light that is left at a depth [m].
vec3 light_left(float depth) { return exp(-water_attenuation * max(depth, 0.0)); }

// Integral of exp(-k x) from 0 to `reach`, any k.
vec3 fading_path(vec3 k, float reach) {
    vec3 x = k * reach, series = reach * (1.0 - x * (0.5 - x / 6.0));
    return mix((1.0 - exp(-x)) / k, series, lessThan(abs(x), vec3(1e-2)));
}

vec3 phase_beyond_blur(float cosine) {
    float c = min(cosine, blur_cosine);
    vec3 p;
    for (int i = 0; i < 3; ++i) {
        float m = particle_exponent[i], n = fournier_forand_index(m);
        p[i] = max(fournier_forand(c, n, m) - fournier_forand(-1.0, n, m), 0.0);
    }
    return p;
}

// The veil of the field over `reach` metres of a ray that begins at a depth and rises by `up` a metre.
vec3 field_veil(vec3 entering, float depth, float up, float reach) {
    vec3 fading = beam_attenuation - water_attenuation * up;
    return diffuse_source * entering * light_left(depth) * fading_path(fading, reach);
}

// Of the beam, per unit of its phase function: the light fades on its slanting way down, and on its way to the eye.
vec3 beam_veil(vec3 beam, float depth, float up, float reach) {
    vec3 down = beam_attenuation / sun_below_z;
    return wide_scattering * beam * exp(-down * max(depth, 0.0)) * fading_path(beam_attenuation - down * up, reach);
}

// The whole veil.
vec3 veil(vec3 sunlight, float depth, vec3 dir, float reach) {
    return field_veil(light_entering(sunlight), depth, dir.z, reach) +
           phase_beyond_blur(dot(dir, sun_below())) * beam_veil(beam_entering(sunlight), depth, dir.z, reach);
}
