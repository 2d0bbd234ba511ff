// SPDX-License-Identifier: MIT
// The mean water on a ray, and its gusts, for the small image of water_air.glsl.
#include "common/gusts.glsl"
#include "shared/earth.glsl"

// Where a ray meets the mean water of the round earth, or passes nearest to it; a ray that sinks by less than
// `least_slope` for each metre is taken as one that does.
vec3 mean_water(vec3 direction, float least_slope) {
    float h = max(eye_height, 0.3), flat_length = max(length(direction.xy), 1e-5);
    float r = earth_meets(max(-direction.z / flat_length, least_slope), h, earth_radius);
    if (r < 0.0) r = earth_horizon(h, earth_radius);
    return vec3(direction.xy * (r / flat_length), -h - earth_drop(r * r, earth_radius));
}

const float ROW = 4.0;       // pixels to a row of this picture, as in src/render/water_air.c
const float AVERAGED = 0.15; // of the length that a row covers: over n patches along it, a mean varies by 1 / sqrt(n)

// The gusts that a row sees. The last row before the horizon is taken at its middle: the water beyond it fills one
// pixel or two, and would show as a strip as high as the row.
float gusts_seen(vec3 direction, float width) {
    float h = max(eye_height, 0.3), angle = 0.5 * ROW * radians_per_pixel;
    vec3 place = mean_water(direction, earth_dip(h, earth_radius) + angle);
    float dist = length(place), over = h - earth_drop(dot(place.xy, place.xy), earth_radius);
    float row = 2.0 * angle * dist * dist / max(over, 1e-3 * dist);
    return gustiness(eye_wrapped_wide + place.xy, max(width, AVERAGED * row));
}
