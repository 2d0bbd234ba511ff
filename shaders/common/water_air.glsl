// SPDX-License-Identifier: MIT
// What varies slowly over the picture of the water, from the small picture that water_air.glsl has made.
#include "common/given_haze.glsl"
#include "shared/earth.glsl"
#pragma unit air_map 18
uniform sampler2DArray air_map; // outputs of water_air.glsl: transmittance, inscatter, bed

struct water_air {
    vec3 transmittance, inscatter; // of the air to the eye
    float gust;                    // factor on the slope of short waves
    float shade;                   // share of the sun that passes the clouds
};

// uv: of the pixel; dist: of the water there [m]; down: sine of the angle of the ray below the horizontal.
water_air air_at(vec2 uv, float dist, float down) {
    vec4 through = textureLod(air_map, vec3(uv, 0.0), 0.0), from = textureLod(air_map, vec3(uv, 1.0), 0.0);
    // a crest before the horizon is nearer than the mean water on its ray
    float above = max(eye_height, 0.3), sinks = max(down, 0.5 * earth_dip(above, earth_radius));
    float share = min(dist * sinks / above, 1.0);
    vec3 left = mix(vec3(1.0), through.rgb, share), light = from.rgb * share;
    if (haze_given > 0.5) given_haze(dist, left, light); // that of a host may be dense
    return water_air(left, light, through.w, from.w);
}

// Depth of the mean water, and distance to shore by the slope of the bed [m].
vec2 bed_at(vec2 uv) { return textureLod(air_map, vec3(uv, 2.0), 0.0).xy; }
