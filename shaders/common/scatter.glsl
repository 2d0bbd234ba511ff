// SPDX-License-Identifier: MIT
// Light scattered towards the eye along a ray through the air: single scattering by air and haze, all higher orders
// by the table of sky_multiple.glsl (Hillaire 2020, section 5.5). Only the passes that fill tables include this.
#include "common/air.glsl"

uniform sampler2D multiple_table;
#pragma unit multiple_table 15
const vec2 MULTIPLE_SIZE = vec2(SKY_MULTIPLE_WIDTH, SKY_MULTIPLE_HEIGHT);

// Finer near the horizon, where the sky changes fast in twilight.
vec2 multiple_uv(float h, float mu_sun) {
    vec2 x = vec2(0.5 + 0.5 * sign(mu_sun) * sqrt(abs(mu_sun)), sqrt(clamp(h / AIR_TOP, 0.0, 1.0)));
    return (clamp(x, 0.0, 1.0) * (MULTIPLE_SIZE - 1.0) + 0.5) / MULTIPLE_SIZE;
}

vec3 multiple_scattering(float h, float mu_sun) { return textureLod(multiple_table, multiple_uv(h, mu_sun), 0.0).rgb; }

// Clouds shade the air under them, and scatter part of the sunlight into it as diffuse light. x: direct share,
// y: diffuse.
vec2 light_under_clouds(float h) {
    float cover = smoothstep(0.1, 1.0, cloud_cover) * smoothstep(cloud_base + 600.0, cloud_base, h);
    return vec2(1.0 - cover, 0.22 * cover);
}

// Radiance from the first `reach` metres of the ray from height h along dir; air_left: what the ray lets through.
vec3 scattered_light(float h, vec3 dir, float reach, int steps, out vec3 air_left) {
    float c = dot(dir, sun_direction), r = earth_radius;
    float phase_air = rayleigh_phase(c), phase_haze = mie_phase(c);
    vec3 haze_scattering = mie_extinction() * MIE_ALBEDO, light = vec3(0.0);
    air_left = vec3(1.0);
    float start = 0.0;
    for (int i = 0; i < steps; ++i) {
        float s = float(i + 1) / float(steps), end = reach * s * s * s; // fine near the eye, where the air is dense
        float d = 0.5 * (start + end);
        float height = max(air_height(h, dir.z, d), 0.0);
        float mu_sun = ((r + h) * sun_direction.z + d * c) / (r + height);
        vec3 density = air_density(height);
        vec3 by_air = RAYLEIGH * density.x, by_haze = haze_scattering * density.y;
        vec3 extinction = air_extinction(density);
        vec2 cloudy = light_under_clouds(height);
        vec3 direct = sun_transmittance_at(height, mu_sun);
        float diffuse = dot(direct, vec3(0.2126, 0.7152, 0.0722)) * max(mu_sun, 0.0) * cloudy.y / (2.0 * PI);
        vec3 source = direct * (cloudy.x * (by_air * phase_air + by_haze * phase_haze)) + diffuse * (by_air + by_haze) +
                      multiple_scattering(height, mu_sun) * (by_air + by_haze) * (cloudy.x + 0.5 * cloudy.y);
        vec3 through = exp(-extinction * (end - start));
        light += air_left * source * (1.0 - through) / max(extinction, vec3(1e-12));
        air_left *= through;
        start = end;
    }
    return light * solar_irradiance() + night_radiance() * (1.0 - air_left);
}
