// SPDX-License-Identifier: MIT
// Shadows of the scene's objects, each taken as a soft ellipsoid. Needs common/frame.glsl.
uniform vec4 caster[96]; // rows of the maps from the eye-relative world to the ellipsoids' unit balls, 3 for each
uniform int caster_count;

const float CASTER_OPACITY = 0.82;                     // of its middle: leaves and rigging let light through
const float CASTER_WHOLE = 0.45, CASTER_NONE = 1.25; // squared distances from the middle, in radii, of its soft edge

// Share of the sun that reaches a place past all objects but the caster `own`.
float object_shadow(vec3 position, int own) {
    float lit = 1.0;
    for (int i = 0; i < caster_count; ++i) {
        if (i == own) continue;
        vec4 x = caster[3 * i], y = caster[3 * i + 1], z = caster[3 * i + 2], at = vec4(position, 1.0);
        vec3 from = vec3(dot(x, at), dot(y, at), dot(z, at));
        vec3 ray = vec3(dot(x.xyz, sun_direction), dot(y.xyz, sun_direction), dot(z.xyz, sun_direction));
        vec3 miss = from - ray * min(dot(from, ray) / dot(ray, ray), 0.0);
        lit *= 1.0 - CASTER_OPACITY * (1.0 - smoothstep(CASTER_WHOLE, CASTER_NONE, dot(miss, miss)));
    }
    return lit;
}
