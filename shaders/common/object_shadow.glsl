// SPDX-License-Identifier: MIT
// Shadows of the scene's objects, each taken as a soft ellipsoid. Needs common/frame.glsl.
#include "shared/refraction.glsl"
uniform vec4 caster[96]; // rows of the maps from the eye-relative world to the ellipsoids' unit balls, 3 for each
uniform int caster_count;

const float CASTER_OPACITY = 0.82;                     // of its middle: leaves and rigging let light through
const float CASTER_WHOLE = 0.45, CASTER_NONE = 1.25; // squared distances from the middle, in radii, of its soft edge

// Share of the sun that a caster takes from a place, on the first `reach` metres of the way to it.
float caster_cover(int i, vec3 position, vec3 direction, float reach) {
    vec3 x = caster[3 * i].xyz, y = caster[3 * i + 1].xyz, z = caster[3 * i + 2].xyz;
    vec3 from = vec3(dot(x, position), dot(y, position), dot(z, position)) +
                vec3(caster[3 * i].w, caster[3 * i + 1].w, caster[3 * i + 2].w);
    vec3 ray = vec3(dot(x, direction), dot(y, direction), dot(z, direction));
    vec3 miss = from + ray * clamp(-dot(from, ray) / dot(ray, ray), 0.0, reach);
    return CASTER_OPACITY * (1.0 - smoothstep(CASTER_WHOLE, CASTER_NONE, dot(miss, miss)));
}

const float TO_THE_SUN = 1e6; // [m]

// Share of the sun that reaches a place past the casters.
float object_shadow(vec3 position) {
    float lit = 1.0;
    for (int i = 0; i < caster_count; ++i) lit *= 1.0 - caster_cover(i, position, sun_direction, TO_THE_SUN);
    return lit;
}

// The same for a place at that height over the water, whose light came through level water where it lies under it. An
// object across the surface takes its share once. One loop for wet and dry: software OpenGL runs both ways of a branch.
float object_shadow_below(vec3 position, float height) {
    float down = max(refracted_cosine(sun_direction.z, water_index), 0.1), reach = max(-height, 0.0) / down, lit = 1.0;
    vec3 bent = vec3(sun_direction.xy / water_index, down), entered = position + bent * reach;
    for (int i = 0; i < caster_count; ++i) {
        float above = caster_cover(i, entered, sun_direction, TO_THE_SUN);
        lit *= 1.0 - max(above, caster_cover(i, position, bent, reach));
    }
    return lit;
}
