// SPDX-License-Identifier: MIT
// Lattice noise for the ground's detail: a hash, gradient noise (Perlin 2002 with Quilez's analytic derivatives) and a
// directed noise whose ridges run down a given slope. Only + - * / and sqrt are used, so that the same seed makes the
// same bits on every machine.
#ifndef BOLAN_SHORE_NOISE_H
#define BOLAN_SHORE_NOISE_H

#include <math.h>
#include <stdint.h>

// A value and its gradient per lattice cell.
typedef struct noise_value {
    float v, dx, dy;
} noise_value;

static inline float clamp01(float x) { return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x; }
static inline float lerpf(float a, float b, float t) { return a + (b - a) * t; }
static inline float smoothstepf(float a, float b, float x) {
    float t = clamp01((x - a) / (b - a));
    return t * t * (3.0f - 2.0f * t);
}
// Polynomial minimum and maximum: differ from the true ones only where |a - b| < k.
static inline float smooth_min(float a, float b, float k) {
    float h = clamp01(0.5f + 0.5f * (b - a) / k);
    return lerpf(b, a, h) - k * h * (1.0f - h);
}
static inline float smooth_max(float a, float b, float k) { return -smooth_min(-a, -b, k); }

static inline uint32_t hash_cell(int32_t x, int32_t y, uint32_t seed) {
    uint32_t h = seed ^ ((uint32_t)x * 0x8da6b343u) ^ ((uint32_t)y * 0xd8163841u);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}
// Uniform in [0, 1): a stream of values for one seed.
static inline float hash_unit(uint32_t seed, uint32_t index) {
    return (float)(hash_cell((int32_t)index, 77, seed) >> 8) * 0x1p-24f;
}

// Splits a lattice coordinate; a cast and a compare, since floor() is a call on plain x86-64. |x| < 2^31.
static inline int32_t split_cell(double x, float *fraction) {
    int32_t i = (int32_t)x;
    i -= x < (double)i;
    *fraction = (float)(x - (double)i);
    return i;
}

// The four corners of a cell side by side, as vectors that GCC and Clang map to any machine's registers: the same
// operations in the same order, so the same bits as plain C.
typedef float corners __attribute__((vector_size(16)));
typedef int32_t corners_int __attribute__((vector_size(16)));
typedef uint32_t corners_bits __attribute__((vector_size(16)));

static const corners corner_x = {0.0f, 1.0f, 0.0f, 1.0f}, corner_y = {0.0f, 0.0f, 1.0f, 1.0f};

static inline corners_bits hash_corners(int32_t x, int32_t y, uint32_t seed) {
    const uint32_t x0 = (uint32_t)x * 0x8da6b343u, x1 = x0 + 0x8da6b343u, y0 = (uint32_t)y * 0xd8163841u,
                   y1 = y0 + 0xd8163841u;
    corners_bits h = {seed ^ x0 ^ y0, seed ^ x1 ^ y0, seed ^ x0 ^ y1, seed ^ x1 ^ y1};
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}

static inline corners to_floats(corners_bits bits) { return __builtin_convertvector((corners_int)bits, corners); }
static inline corners magnitude(corners v) { return (corners)((corners_bits)v & 0x7fffffffu); }
static inline float sum_corners(corners v) { return (v[0] + v[1]) + (v[2] + v[3]); }

// Cosine of a full turn per unit; error < 2e-4, which is not visible in a landscape.
static inline corners cosines_of_turns(corners turns) {
    corners x = magnitude(
        turns - __builtin_convertvector(__builtin_convertvector(turns, corners_int), corners)); // even: [0, 1)
    corners y = (magnitude(x - 0.5f) - 0.25f) * 6.28318531f; // cos(2 pi x) = sin(y), |y| <= pi/2
    corners y2 = y * y;
    return y * (1.0f - y2 * (1.0f / 6.0f - y2 * (1.0f / 120.0f - y2 * (1.0f / 5040.0f))));
}

// Gradient noise, about -0.7..0.7, with its gradient.
static inline noise_value gradient_noise(double x, double y, uint32_t seed) {
    float fx, fy;
    int32_t ix = split_cell(x, &fx), iy = split_cell(y, &fy);
    float ux = fx * fx * fx * (fx * (fx * 6.0f - 15.0f) + 10.0f),
          uy = fy * fy * fy * (fy * (fy * 6.0f - 15.0f) + 10.0f);
    float px = 30.0f * fx * fx * (fx * (fx - 2.0f) + 1.0f), py = 30.0f * fy * fy * (fy * (fy - 2.0f) + 1.0f);
    corners_bits h = hash_corners(ix, iy, seed);
    corners gx = to_floats(h & 0xffffu) * (1.0f / 32768.0f) - 1.0f, gy = to_floats(h >> 16) * (1.0f / 32768.0f) - 1.0f;
    corners d = gx * (fx - corner_x) + gy * (fy - corner_y);
    corners wx = {1.0f - ux, ux, 1.0f - ux, ux}, wy = {1.0f - uy, 1.0f - uy, uy, uy}, w = wx * wy;
    corners along_x = {-px, px, -px, px}, along_y = {-py, -py, py, py};
    noise_value n;
    n.v = sum_corners(w * d);
    n.dx = sum_corners(w * gx + along_x * wy * d);
    n.dy = sum_corners(w * gy + along_y * wx * d);
    return n;
}

// Directed noise: each lattice corner sends out a plane wave of one period per cell with a random phase; the waves are
// faded into each other and their variance is kept. (across_x, across_y) is the unit direction along which they vary,
// so the crests run at right angles to it: give it the level direction of a hillside, and ridges and gullies run down
// the hill and branch where phases meet. Value -1..1; the gradient is that of the waves, which is enough to steer the
// next octave.
static inline noise_value directed_noise(double x, double y, float across_x, float across_y, uint32_t seed) {
    float fx, fy;
    int32_t ix = split_cell(x, &fx), iy = split_cell(y, &fy);
    float ux = fx * fx * (3.0f - 2.0f * fx), uy = fy * fy * (3.0f - 2.0f * fy);
    corners wx = {1.0f - ux, ux, 1.0f - ux, ux}, wy = {1.0f - uy, 1.0f - uy, uy, uy}, w = wx * wy;
    corners phase = to_floats(hash_corners(ix, iy, seed) >> 8) * 0x1p-24f;
    corners turns = across_x * (fx - corner_x) + across_y * (fy - corner_y) + phase;
    float cosine = sum_corners(w * cosines_of_turns(turns)), sine = sum_corners(w * cosines_of_turns(turns - 0.25f));
    float scale = 1.0f / sqrtf(sum_corners(w * w) + 0.12f); // below full compensation, so that some places stay smooth
    noise_value n = {cosine * scale, -6.2831853f * across_x * sine * scale, -6.2831853f * across_y * sine * scale};
    return n;
}

// Sum of gradient noise over octaves; about -1..1.
static inline float fractal_noise(double x, double y, int octaves, uint32_t seed) {
    float sum = 0.0f, amplitude = 1.0f;
    for (int o = 0; o < octaves; o++) {
        sum += amplitude * gradient_noise(x, y, seed + (uint32_t)o * 0x9e3779b9u).v;
        // Turning each octave hides the lattice.
        double rx = 1.6 * x - 1.2 * y, ry = 1.2 * x + 1.6 * y;
        x = rx + 17.3, y = ry - 9.1;
        amplitude *= 0.5f;
    }
    return sum;
}

#endif
