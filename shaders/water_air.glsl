// SPDX-License-Identifier: MIT
// Quantities of the water that vary slowly over the image, at low resolution: air, gusts, cloud shadows, depth. Each
// pixel is a ray that meets the mean water; a ray above the horizon is taken as the horizon.
#include "common/frame.glsl"
#include "common/fullscreen.glsl"

#ifdef VERTEX
void main() { fullscreen(0.0); }
#endif

#ifdef FRAGMENT
#include "common/atmosphere.glsl"
#include "common/gusts.glsl"
#include "shared/earth.glsl"
#ifdef LAND
#include "common/shore.glsl"
#endif
layout(location = 0) out vec4 out_transmittance; // of the air to the eye; w: gust factor
layout(location = 1) out vec4 out_inscatter;     // of the air to the eye; w: share of the sun that passes the clouds
layout(location = 2) out vec4 out_bed;           // depth of the mean water, distance to shore by the bed's slope [m]
uniform vec4 air_size;                           // of this picture: 1 / width, 1 / height

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

void main() {
    vec3 direction = frame_ray(gl_FragCoord.xy * air_size.xy), position = mean_water(direction, 0.0);
    vec3 transmittance, inscatter;
    aerial_perspective(position, transmittance, inscatter);
    float width = length(position) * radians_per_pixel * 8.0;
    out_transmittance = vec4(transmittance, gusts_seen(direction, width));
    out_inscatter = vec4(inscatter, cloud_shadow(position.xy));
    out_bed = vec4(1000.0, 1e4, 0.0, 0.0);
#ifdef LAND
    vec2 x = vec2(max(25.0, width), 0.0);
    float depth = -shore_elevation(position.xy);
    vec2 rise = vec2(shore_elevation(position.xy + x) - shore_elevation(position.xy - x),
                     shore_elevation(position.xy + x.yx) - shore_elevation(position.xy - x.yx));
    out_bed.xy = vec2(depth, depth * 2.0 * x.x * inversesqrt(max(dot(rise, rise), 1e-4)));
#endif
}
#endif
