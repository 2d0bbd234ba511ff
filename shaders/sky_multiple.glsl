// SPDX-License-Identifier: MIT
// Table: radiance that all orders of scattering above the first bring to a point, per unit of solar irradiance and of
// its scattering coefficient (Hillaire 2020, eq. 5-10: the second order is traced, each further one is a constant
// times the last).
#include "common/fullscreen.glsl"
#ifdef VERTEX
void main() { fullscreen(0.5); }
#endif
#ifdef FRAGMENT
#include "common/scatter.glsl"
out vec4 color;

const int DIRECTIONS = 8; // along each of two angles
const int STEPS = 20;

// Second-order light and the transfer factor along one direction.
void trace(float h, vec3 dir, vec3 to_sun, inout vec3 second, inout vec3 transfer) {
    float to_sea = distance_to_sea(h, dir.z), r = earth_radius;
    float reach = to_sea >= 0.0 ? to_sea : distance_to_top(h, dir.z), c = dot(dir, to_sun), start = 0.0;
    vec3 left = vec3(1.0), haze_scattering = mie_extinction() * MIE_ALBEDO;
    for (int i = 0; i < STEPS; ++i) {
        float s = float(i + 1) / float(STEPS), end = reach * s * s, d = 0.5 * (start + end);
        float height = max(air_height(h, dir.z, d), 0.0), mu_sun = ((r + h) * to_sun.z + d * c) / (r + height);
        vec3 density = air_density(height), extinction = air_extinction(density);
        vec3 scattering = RAYLEIGH * density.x + haze_scattering * density.y;
        vec3 through = exp(-extinction * (end - start));
        vec3 gained = left * scattering * (1.0 - through) / max(extinction, vec3(1e-12));
        second += gained * sun_transmittance_at(height, mu_sun) / (4.0 * PI);
        transfer += gained;
        left *= through;
        start = end;
    }
    if (to_sea >= 0.0) {
        float mu_sun = ((r + h) * to_sun.z + to_sea * c) / r;
        second += left * sun_transmittance_at(0.0, mu_sun) * max(mu_sun, 0.0) * SEA_ALBEDO / PI;
    }
}

void main() {
    vec2 x = (uv * MULTIPLE_SIZE - 0.5) / (MULTIPLE_SIZE - 1.0);
    float side = 2.0 * x.x - 1.0, mu_sun = sign(side) * side * side, h = x.y * x.y * AIR_TOP;
    vec3 to_sun = vec3(sqrt(max(1.0 - mu_sun * mu_sun, 0.0)), 0.0, mu_sun), second = vec3(0.0), transfer = vec3(0.0);
    for (int i = 0; i < DIRECTIONS; ++i) {
        float z = 1.0 - 2.0 * (float(i) + 0.5) / float(DIRECTIONS), across = sqrt(1.0 - z * z);
        for (int j = 0; j < DIRECTIONS; ++j) {
            float azimuth = 2.0 * PI * (float(j) + 0.5) / float(DIRECTIONS);
            trace(h, vec3(across * cos(azimuth), across * sin(azimuth), z), to_sun, second, transfer);
        }
    }
    float n = float(DIRECTIONS * DIRECTIONS);
    color = vec4(second / n / (1.0 - min(transfer / n, vec3(0.99))), 1.0);
}
#endif
