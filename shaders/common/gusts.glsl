// SPDX-License-Identifier: MIT
// Gusts: patches of rougher and smoother water, a few hundred metres to kilometres wide.

float gust_lattice(ivec2 p, int period) {
    p = ivec2(p.x & (period - 1), p.y & (period - 1));
    uint h = uint(p.x) * 0x9E3779B1u ^ uint(p.y) * 0x85EBCA77u;
    h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12u)) * 0x297A2D39u;
    return float(h >> 8u) * (1.0 / 16777216.0);
}

float gust_noise(vec2 p, int period) {
    ivec2 i = ivec2(floor(p));
    vec2 f = p - vec2(i);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(gust_lattice(i, period), gust_lattice(i + ivec2(1, 0), period), f.x),
               mix(gust_lattice(i + ivec2(0, 1), period), gust_lattice(i + ivec2(1, 1), period), f.x), f.y);
}

// Below this wind the short waves stand in patches, cat's paws, with glass between them: they need 1 to 2 m/s to arise
// (Kahma & Donelan 1988) and the wind of a gust differs from the mean by as much. [m/s]
const float LIGHT_WIND = 4.0, LIGHTEST_WIND = 1.5;

// Shares of large, middle and small patches in the variance of their sum.
const vec3 PAWS_VARIANCE = vec3(0.199, 0.448, 0.353);

// Factor on the rms slope of short waves at p [m] modulo 131072, about 1 in the mean, of its square in light winds;
// `width`: size of the patches that are left out [m]. The patches go with the wind.
float gustiness(vec2 p, float width) {
    p -= gust_travel;
    p += 700.0 * (vec2(gust_noise(p / 2048.0, 64), gust_noise(p.yx / 2048.0 + 17.0, 64)) - 0.5);
    vec3 kept = clamp(2.0 - width / vec3(2000.0, 500.0, 120.0), 0.0, 1.0);
    float large = (gust_noise(p / 4096.0, 32) - 0.5) * kept.x;
    float middle = (gust_noise(p / 1024.0, 128) - 0.5) * kept.y;
    float small = (gust_noise(p / 256.0, 512) - 0.5) * kept.z;
    float paws = 0.15 + 1.35 * smoothstep(-0.15, 0.15, 0.3 * large + 0.45 * middle + 0.4 * small);
    paws = mix(1.0, paws, dot(kept * kept, PAWS_VARIANCE));
    return mix(1.0 + 0.26 * large + 0.24 * middle + 0.16 * small, paws,
               clamp((LIGHT_WIND - wind_speed) / (LIGHT_WIND - LIGHTEST_WIND), 0.0, 1.0));
}
