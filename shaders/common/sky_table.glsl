// SPDX-License-Identifier: MIT
// How directions lie in the tables of sky radiance. Azimuth is taken from the sun's, the sky being symmetric about
// it, and elevation from the true horizon: both finer where the sky changes fast.
#include "common/air.glsl"

const vec2 SKY_VIEW_SIZE = vec2(SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT);
// Row 32 of the elevations is the horizon.
const vec3 AERIAL_SIZE = vec3(SKY_AERIAL_AZIMUTHS, SKY_AERIAL_ELEVATIONS, SKY_AERIAL_SLICES);
const float AERIAL_REACH = 600000.0, AERIAL_NEAR = 400.0;

float sun_azimuth_coordinate(vec2 direction) {
    vec2 s = sun_direction.xy / max(length(sun_direction.xy), 1e-6);
    float c = dot(direction, s) / max(length(direction), 1e-6);
    return sqrt(acos(clamp(c, -1.0, 1.0)) / PI);
}

float angle_above_horizon(vec3 dir, float h) { return asin(clamp(dir.z, -1.0, 1.0)) + horizon_dip(max(h, 0.0)); }

// The direction at an azimuth coordinate and an angle above the horizon, on one side of the sun.
vec3 sky_direction(float azimuth_coordinate, float above, float h) {
    float azimuth = azimuth_coordinate * azimuth_coordinate * PI, elevation = above - horizon_dip(max(h, 0.0));
    vec2 s = length(sun_direction.xy) > 1e-6 ? normalize(sun_direction.xy) : vec2(1.0, 0.0);
    vec2 across = vec2(-s.y, s.x);
    vec2 flat_direction = s * cos(azimuth) + across * sin(azimuth);
    return vec3(flat_direction * cos(elevation), sin(elevation));
}

vec2 to_texel_centres(vec2 x, vec2 size) { return (clamp(x, 0.0, 1.0) * (size - 1.0) + 0.5) / size; }
vec3 to_texel_centres3(vec3 x, vec3 size) { return (clamp(x, 0.0, 1.0) * (size - 1.0) + 0.5) / size; }

vec2 sky_view_uv(vec3 dir, float h) {
    float above = max(angle_above_horizon(dir, h), 0.0);
    float y = sqrt(above / (0.5 * PI + horizon_dip(h)));
    return to_texel_centres(vec2(sun_azimuth_coordinate(dir.xy), y), SKY_VIEW_SIZE);
}

float aerial_slice(float d) { return log(1.0 + d / AERIAL_NEAR) / log(1.0 + AERIAL_REACH / AERIAL_NEAR); }
float aerial_distance(float slice) { return AERIAL_NEAR * (exp(slice * log(1.0 + AERIAL_REACH / AERIAL_NEAR)) - 1.0); }

vec3 aerial_uv(vec3 dir, float h, float d) {
    float above = angle_above_horizon(dir, h), dip = horizon_dip(max(h, 0.0));
    float range = above > 0.0 ? 0.5 * PI + dip : 0.5 * PI - dip;
    float y = 0.5 + 0.5 * sign(above) * sqrt(abs(above) / range);
    return to_texel_centres3(vec3(sun_azimuth_coordinate(dir.xy), y, aerial_slice(d)), AERIAL_SIZE);
}
