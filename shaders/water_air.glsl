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
#include "common/mean_water.glsl"
#ifdef LAND
#include "common/shore.glsl"
#endif
layout(location = 0) out vec4 out_transmittance; // of the air to the eye; w: gust factor
layout(location = 1) out vec4 out_inscatter;     // of the air to the eye; w: share of the sun that passes the clouds
layout(location = 2) out vec4 out_bed;           // depth of the mean water, distance to shore by the bed's slope [m]
uniform vec4 air_size;                           // of this picture: 1 / width, 1 / height

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
