// SPDX-License-Identifier: MIT
// The sky for the other passes: radiance towards a direction, the sky for reflections, haze between the eye and a
// point, sunlight and cloud shadow. Reads the tables of the sky pass, in the unit of common/air.glsl.
#include "common/environment.glsl"
#include "common/level.glsl"
#include "common/sky_table.glsl"

uniform sampler2D sky_view_table;
uniform sampler2D environment_map;
uniform sampler2DArray cloud_map; // layer 0: panorama of the clouds, premultiplied; layer 1: their shadow on the sea
uniform sampler3D aerial_table;
#pragma unit sky_view_table 1
#pragma unit environment_map 2
#pragma unit cloud_map 13
#pragma unit aerial_table 14

// Clear sky without the sun's disc; below the horizon, the horizon's.
vec3 sky_radiance(vec3 dir) { return textureLod(sky_view_table, sky_view_uv(dir, max(eye_height, 0.0)), 0.0).rgb; }

// ---- the environment map

// Sky and clouds towards a reflected direction, blurred as by facets of that rms slope: the ray turns by twice the
// slope. Below the horizon, the radiance of the horizon.
vec3 environment_radiance(vec3 dir, float roughness) {
    return textureLod(environment_map, environment_uv(dir), fetched_level(environment_level(2.0 * roughness))).rgb;
}

// ---- the sun

vec3 sun_transmittance(float height_m) { return sun_transmittance_at(max(height_m, 0.0), sun_direction.z); }

// ---- clouds

const float CLOUD_SHADOW_SIZE = 100000.0; // side of the square round the eye [m]

// Share of the sun that passes the clouds to a point of the sea, eye-relative xy [m].
float cloud_shadow(vec2 position) {
    vec2 p = (position + cloud_offset) / CLOUD_SHADOW_SIZE;
    float inside = 1.0 - smoothstep(0.42, 0.5, max(abs(p.x), abs(p.y)));
    float average = 1.0 - 0.85 * cloud_cover;
    return mix(average, textureLod(cloud_map, vec3(clamp(p + 0.5, 0.001, 0.999), 1.0), 0.0).r, inside);
}

// The panorama of the clouds round the eye. Below the clouds it covers the sky (eye_above_clouds = 0), above them the
// whole sphere, most of it what lies below the horizon. Rows are closest at the horizon.
const float CLOUD_HORIZON = 0.625; // the horizon's place in the whole sphere's map; cirrus above needs its rows too

vec2 cloud_uv(vec3 dir, float h) {
    float above = angle_above_horizon(dir, h), dip = horizon_dip(h);
    float up = sqrt(max(above, 0.0) / (0.5 * PI + dip));
    float down = pow(max(-above, 0.0) / (0.5 * PI - dip), 2.0 / 3.0);
    float row = eye_above_clouds > 0.5 ? CLOUD_HORIZON + (1.0 - CLOUD_HORIZON) * up - CLOUD_HORIZON * down : up;
    return vec2(atan(dir.y, dir.x) / (2.0 * PI), row);
}

vec4 cloud_radiance(vec3 dir) { return textureLod(cloud_map, vec3(cloud_uv(dir, max(eye_height, 0.0)), 0.0), 0.0); }

// ---- the air between the eye and a point

// Share of the light that passes, along a ray of length d: five-point Gauss-Legendre of the density on the round earth.
vec3 air_transmittance(float h, float mu, float d) {
    const vec3 at = vec3(0.5, 0.7692346551, 0.9530899230), weight = vec3(0.2844444444, 0.2393143352, 0.1184634425);
    vec3 near = d * (1.0 - at), far = d * at;
    vec2 sum = weight.x * air_density(air_height(h, mu, far.x)).xy;
    sum += weight.y * (air_density(air_height(h, mu, far.y)).xy + air_density(air_height(h, mu, near.y)).xy);
    sum += weight.z * (air_density(air_height(h, mu, far.z)).xy + air_density(air_height(h, mu, near.z)).xy);
    return exp(-d * (RAYLEIGH * sum.x + mie_extinction() * sum.y));
}

#include "common/given_haze.glsl"

// Haze between the eye and an eye-relative position: color * transmittance + inscatter. Clouds below a high
// eye are laid over the picture at its end (sky_over.glsl).
void aerial_perspective(vec3 position, out vec3 transmittance, out vec3 inscatter) {
    float d = max(length(position), 1e-3), h = max(eye_height, 0.0);
    if (haze_given > 0.5) {
        given_haze(d, transmittance, inscatter);
        return;
    }
    vec3 dir = position / d;
    transmittance = air_transmittance(h, dir.z, d);
    inscatter = textureLod(aerial_table, aerial_uv(dir, h, d), 0.0).rgb;
}
