// SPDX-License-Identifier: MIT
// The ground under the water, for any stage. shore_map holds nested square levels of elevation above the water level
// around the eye, snapped to their texels so that nothing swims; src/render/shore_map.c fills it.
#include "shared/attenuation.glsl"
#include "common/water_block.glsl"
#pragma unit shore_map 5
uniform highp sampler2DArray shore_map;

const float SHORE_NONE = -1000.0; // no ground within reach

// Share of level l in the blend at this place: 1 inside, 0 from the border outward. Half a texel of the border cannot
// be interpolated.
float shore_share(int l, vec2 position) {
    vec4 s = shore_level[l];
    vec2 from_border = min(position - s.xy, s.xy + s.zz - position);
    return clamp((min(from_border.x, from_border.y) - s.w) / (0.08 * s.z), 0.0, 1.0);
}

float shore_look_up(int l, vec2 position) {
    vec4 s = shore_level[l];
    return textureLod(shore_map, vec3((position - s.xy) / s.z, float(l)), 0.0).x;
}

// Elevation above the water level [m] at eye-relative xy [m]; SHORE_NONE where there is no terrain.
float shore_elevation(vec2 position) {
    if (shore_present == 0) return SHORE_NONE;
    float elevation = 0.0, rest = 1.0;
    for (int l = 0; l < 4; ++l) {
        float share = rest * shore_share(l, position);
        if (share > 0.0) elevation += share * shore_look_up(l, position);
        rest -= share;
        if (rest <= 0.0) return elevation;
    }
    return elevation + rest * SHORE_NONE;
}

// Gradient of the depth of the mean water. A texel to either side: elevations are half floats.
vec2 shore_fall(vec2 position) {
    vec2 step = vec2(shore_level[0].w, 0.0);
    vec2 east = position + step, west = position - step, north = position + step.yx, south = position - step.yx;
    return vec2(shore_elevation(west) - shore_elevation(east), shore_elevation(south) - shore_elevation(north)) /
           (2.0 * step.x);
}

const float LEAN_STEP = 0.05; // of depth to either side, for the difference that the lean of a shelving bed is [m]

// False: waves of that significant height are those of deep water, and do not lean.
bool feels_bed(float depth, float hs) { return abs(depth) < COAST_DEEP * hs + LEAN_STEP; }

// coast_attenuation() of four bands that make one sea, 0 for a band that is not there; together they keep what one sea
// of their height does. Twin of bolan_coast_attenuations() in src/coast/attenuation.c.
vec4 coast_attenuations(float depth, vec4 hs) {
    vec4 alone = vec4(coast_attenuation(depth, hs.x), coast_attenuation(depth, hs.y), coast_attenuation(depth, hs.z),
                      coast_attenuation(depth, hs.w));
    vec4 left = alone * hs;
    float deep = dot(hs, hs), local = dot(left, left), whole = coast_attenuation(depth, sqrt(deep));
    return local > 0.0 ? alone * sqrt(coast_share2(whole, deep, local)) : alone;
}
