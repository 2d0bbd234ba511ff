// SPDX-License-Identifier: MIT
// The rays of sunlight that enter the water, one for each node of a square patch of the drawn surface: see
// caustics.glsl. The refraction is that of refracted() in src/tiles/caustics.c. LAND: there is a bed.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#define TAPS 1
#include "common/waves.glsl"
layout(location = 0) out vec4 out_ray;   // displacement of the node, level; level travel a metre less flat water's
layout(location = 1) out vec4 out_light; // height of the surface, light over flat water's, depth of the bed

uniform vec4 patch_place; // eye-relative corner, cell [m]

const float LEAST_FACING = 0.02; // a facet in its own shadow takes grazing light
const float DEEPEST = 60.0;      // bed that is lit [m]

void main() {
    float cell = patch_place.z, depth = 1000.0, bed = DEEPEST;
    vec2 rest = patch_place.xy + (gl_FragCoord.xy - 0.5) * cell;
#ifdef LAND
    depth = -shore_elevation(rest);
    bed = clamp(-shore_elevation(rest + caustic_travel * clamp(depth, 0.0, DEEPEST)), 0.0, DEEPEST);
#endif
    footprint f = footprint(vec2(1.0, 0.0), cell, cell);
    sea_place place = place_of(rest);
    wave_fields w = waves_at(rest, place, f, 1.0, depth, vec4(0.0, 0.0, 1.0, 0.0));
    vec3 offset = vec3(0.0);
#ifdef WAVES_CASCADES
    vec4 kept = cascades_kept(depth);
    for (int c = 0; c < cascade_count; ++c) {
        vec4 band = cascade_band[c];
        if (cell > band.z) break;
        vec3 d = kept[c] * cascade_displacement(c, cascade_uv(c, place.at), max(log2(cell) - band.w, 0.0));
        offset += vec3(choppiness * d.xy, d.z);
    }
#endif
    vec3 up = normalize(vec3(-w.slope, 1.0)), down = -sun_direction;
    float facing = max(dot(up, sun_direction), LEAST_FACING), eta = 1.0 / water_index;
    vec3 ray = eta * down + (eta * facing - sqrt(1.0 - eta * eta * (1.0 - facing * facing))) * up;
    out_ray = vec4(offset.xy, ray.xy / -ray.z - caustic_travel);
    out_light = vec4(offset.z, max(dot(up, sun_direction), 0.0) / (up.z * sun_direction.z), bed, 0.0);
}
#endif
