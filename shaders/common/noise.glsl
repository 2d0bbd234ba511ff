// SPDX-License-Identifier: MIT
// Noise from an integer hash, the same on every GPU: gradient and cellular noise that repeat after a whole number of
// cells.

uint noise_hash(uvec3 p) { // two rounds of a 32-bit mixer (constants of Jarzynski & Olano 2020, pcg)
    uint h = p.x * 747796405u + p.y * 2891336453u + p.z * 277803737u + 2891336453u;
    h = ((h >> ((h >> 28) + 4u)) ^ h) * 277803737u;
    h = (h >> 22) ^ h;
    h = h * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28) + 4u)) ^ h) * 277803737u;
    return (h >> 22) ^ h;
}

vec3 noise_vector(ivec3 cell, int period) { // three values in 0..1
    uvec3 c = uvec3((cell % period + period) % period);
    uint h = noise_hash(c);
    return vec3(float(h & 1023u), float((h >> 10) & 1023u), float((h >> 20) & 1023u)) / 1023.0;
}

// Gradient noise, about -1..1, `period` cells to a repeat.
float gradient_noise(vec3 p, int period) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - floor(p), u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float corner[8];
    for (int i = 0; i < 8; ++i) {
        ivec3 o = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        corner[i] = dot(noise_vector(cell + o, period) * 2.0 - 1.0, f - vec3(o));
    }
    vec4 low = vec4(corner[0], corner[2], corner[4], corner[6]);
    vec4 high = vec4(corner[1], corner[3], corner[5], corner[7]);
    vec4 x = mix(low, high, u.x);
    vec2 y = mix(x.xz, x.yw, u.y);
    return mix(y.x, y.y, u.z);
}

// 1 at the feature points, 0 about a cell away from any.
float cellular_noise(vec3 p, int period) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - floor(p);
    float nearest = 4.0;
    for (int i = 0; i < 27; ++i) {
        ivec3 o = ivec3(i % 3, (i / 3) % 3, i / 9) - 1;
        vec3 d = vec3(o) + noise_vector(cell + o, period) - f;
        nearest = min(nearest, dot(d, d));
    }
    return 1.0 - clamp(sqrt(nearest), 0.0, 1.0);
}
