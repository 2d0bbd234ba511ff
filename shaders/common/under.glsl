// SPDX-License-Identifier: MIT
// What water does to things in it, for the pictures that it mirrors and refracts and for an eye under it: raises them,
// dims them, puts its own light before them, and gathers sunlight on them (Ma, Zhu & Gong 2006, sections 2.2.3, 3 (2)
// and 5).
#include "shared/refraction.glsl"
#include "common/water_light.glsl"
#ifdef PICTURE

// Height above the water [m] at which what stands at that height is seen in this picture.
float seen_height(vec2 position, float height) {
    if (refraction_mode > 1.5) return apparent_height(eye_height, height, length(position), water_index);
    return refraction_mode > 0.5 ? height * refraction_raise : height;
}

// Light of the water itself, seen under it along a unit direction from a depth [m]: what leaves it upwards, before the
// surface takes its share; more from where the light comes.
vec3 water_glow(float upward, float depth) {
    vec3 light = sun_light * max(sun_direction.z, 0.0) + sky_light;
    float from_above = 0.5 + 0.5 * upward;
    return water_reflectance / BED_LEAVES * light * (1.0 + 3.0 * from_above * from_above) *
           exp(-water_attenuation * max(depth, 0.0));
}

// Attenuation and in-scattering of light from a point at that height above the water, seen from above it or under it:
// light * through + veil.
void through_water(vec3 position, float height, out vec3 through, out vec3 veil) {
    through = vec3(1.0);
    veil = vec3(0.0);
    if (under_fog <= 0.0) return;
    float depth = max(-height, 0.0), away = max(length(position), 1e-3);
    if (eye_under_water > 0.5) {
        if (refraction_mode > 0.5) return; // above the water: what lies between is the water pass's to add
        // In the reflection the light comes by way of the surface.
        float reach = mirrored_under_water > 0.5 ? length(vec3(position.xy, eye_height + height)) : away;
        float upward = (mirrored_under_water > 0.5 ? -(eye_height + height) : position.z) / max(reach, 1e-3);
        vec3 left = exp(-under_fog * water_attenuation * reach);
        through = exp(-under_fog * water_attenuation * depth) * left;
        veil = water_glow(upward, -eye_height) * (1.0 - left);
    } else if (clip_side < 0.0) {
        float down = refracted_cosine(position.z / away, water_index);
        vec3 both_ways = exp(-under_fog * water_attenuation * bed_path(depth, down));
        through = BED_LEAVES * both_ways;
        veil = water_reflectance * (sun_light * max(sun_direction.z, 0.0) + sky_light) * (1.0 - both_ways);
    }
}

#ifdef FRAGMENT
#pragma unit water_tile 19
uniform sampler2D water_tile; // a: light on the bottom, a quarter of it

// Sunlight at a depth [m] below level eye-relative xy, as a share of what flat water lets through: the tile lies on the
// surface where the ray came in. Shallow water has not gathered it yet, deep water scatters it.
float gathered_light(vec2 position, float depth) {
    float strength = caustic_strength * clamp(depth * 2.0, 0.0, 1.0) * exp(-0.06 * max(depth, 0.0));
    vec2 p = position - caustic_travel * max(depth, 0.0);
    vec2 uv = caustic_place + vec2(dot(p, caustic_turn), dot(p, vec2(-caustic_turn.y, caustic_turn.x)));
    return mix(1.0, 4.0 * texture(water_tile, uv).a, strength);
}
#endif
#endif
