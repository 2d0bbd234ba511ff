// SPDX-License-Identifier: MIT
// Billows are the folded halves of gradient noise (Perlin 1985's "turbulence" turned over): round tops, sharp creases.
#include "ground_texture.h"
#include "memory.h"

#include <math.h>

#define SIZE TERRAIN_TEXTURE_SIZE

static uint32_t hash(uint32_t x, uint32_t y, uint32_t salt) {
    uint32_t h = x * 0x8da6b343u ^ y * 0xd8163841u ^ salt * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}

static float slope_to(uint32_t h, float x, float y) {
    float gx = (float)(h & 0xffffu) * (1.0f / 32768.0f) - 1.0f, gy = (float)(h >> 16) * (1.0f / 32768.0f) - 1.0f;
    return gx * x + gy * y;
}

// Gradient noise of `cells` lattice cells per side, periodic.
static float periodic_noise(uint32_t i, uint32_t j, uint32_t cells, uint32_t salt) {
    float x = (float)i * (float)cells / SIZE, y = (float)j * (float)cells / SIZE;
    uint32_t ix = (uint32_t)x, iy = (uint32_t)y, jx = (ix + 1) % cells, jy = (iy + 1) % cells;
    float fx = x - (float)ix, fy = y - (float)iy;
    float ux = fx * fx * fx * (fx * (fx * 6.0f - 15.0f) + 10.0f),
          uy = fy * fy * fy * (fy * (fy * 6.0f - 15.0f) + 10.0f);
    float a = slope_to(hash(ix, iy, salt), fx, fy), b = slope_to(hash(jx, iy, salt), fx - 1.0f, fy);
    float c = slope_to(hash(ix, jy, salt), fx, fy - 1.0f), d = slope_to(hash(jx, jy, salt), fx - 1.0f, fy - 1.0f);
    return (1.0f - uy) * (a + ux * (b - a)) + uy * (c + ux * (d - c));
}

static uint8_t to_byte(float x) { return (uint8_t)(x <= 0.0f ? 0.0f : x >= 1.0f ? 255.0f : x * 255.0f + 0.5f); }

// Brings values to a mean of 0.5 and a standard deviation of `spread`, so that the shader may rely on them.
static void level_out(float *v, float spread) {
    double sum = 0.0, squares = 0.0;
    for (uint32_t n = 0; n < SIZE * SIZE; n++) {
        sum += v[n], squares += (double)v[n] * v[n];
    }
    double mean = sum / (SIZE * SIZE), deviation = sqrt(squares / (SIZE * SIZE) - mean * mean);
    for (uint32_t n = 0; n < SIZE * SIZE; n++) {
        v[n] = (float)(0.5 + (v[n] - mean) * (spread / deviation));
    }
}

static void fill_fields(float *billow, float *patch) {
    for (uint32_t n = 0; n < SIZE * SIZE; n++) {
        uint32_t i = n % SIZE, j = n / SIZE;
        float amplitude = 0.5f;
        billow[n] = patch[n] = 0.0f;
        for (uint32_t o = 0; o < 5; o++, amplitude *= 0.6f) {
            billow[n] -= amplitude * fabsf(periodic_noise(i, j, 8u << o, o));
            patch[n] += amplitude * periodic_noise(i, j, 8u << o, 40 + o);
        }
    }
    level_out(billow, 0.17f);
    level_out(patch, 0.17f);
}

bolan_result bolan_ground_texture_fill(uint8_t *rgba) {
    const size_t bytes = (size_t)2 * SIZE * SIZE * sizeof(float);
    float *billow = allocate_for("the texture of the ground", bytes);
    if (!billow) {
        return BOLAN_ERROR_MEMORY;
    }
    float *patch = billow + (size_t)SIZE * SIZE;
    fill_fields(billow, patch);
    for (uint32_t n = 0; n < SIZE * SIZE; n++) {
        uint32_t i = n % SIZE, j = n / SIZE;
        float dx = billow[j * SIZE + (i + 1) % SIZE] - billow[j * SIZE + (i + SIZE - 1) % SIZE];
        float dy = billow[(j + 1) % SIZE * SIZE + i] - billow[(j + SIZE - 1) % SIZE * SIZE + i];
        rgba[4 * n] = to_byte(billow[n]);
        rgba[4 * n + 1] = to_byte(0.5f + 2.0f * dx); // dx: over two texels
        rgba[4 * n + 2] = to_byte(0.5f + 2.0f * dy);
        rgba[4 * n + 3] = to_byte(patch[n]);
    }
    bolan_release(billow, bytes);
    return BOLAN_OK;
}
