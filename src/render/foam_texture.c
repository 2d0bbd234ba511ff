// SPDX-License-Identifier: MIT
// Foam on water is a net of thin walls round round holes, torn at larger scales. The walls are the borders of a
// cellular pattern (Worley 1996: distance to the second nearest point less that to the nearest) at three sizes,
// displaced by smooth noise. The histogram is then flattened by rank.
#include "foam_texture.h"
#include "memory.h"

#include <math.h>
#include <string.h>

#define SIZE FOAM_TEXTURE_SIZE
#define PIXELS ((size_t)SIZE * SIZE)
#define BINS 4096

static uint32_t hash(uint32_t x, uint32_t y, uint32_t salt) {
    uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ salt * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

static float unit(uint32_t h) { return (float)(h >> 8) * (1.0f / 16777216.0f); }

// Smooth value noise, periodic after `cells`.
static float value_noise(float x, float y, int cells, uint32_t salt) {
    int ix = (int)floorf(x), iy = (int)floorf(y);
    float fx = x - (float)ix, fy = y - (float)iy;
    fx = fx * fx * (3.0f - 2.0f * fx);
    fy = fy * fy * (3.0f - 2.0f * fy);
    float v[4];
    for (int i = 0; i < 4; ++i) {
        int cx = (ix + (i & 1)) % cells, cy = (iy + (i >> 1)) % cells;
        v[i] = unit(hash((uint32_t)(cx + cells) % (uint32_t)cells, (uint32_t)(cy + cells) % (uint32_t)cells, salt));
    }
    float low = v[0] + (v[1] - v[0]) * fx, high = v[2] + (v[3] - v[2]) * fx;
    return low + (high - low) * fy;
}

// 1 on the walls between cells, falling into them. `cells` per side, periodic.
static float cell_walls(float x, float y, int cells, uint32_t salt) {
    int ix = (int)floorf(x), iy = (int)floorf(y);
    float nearest = 9.0f, second = 9.0f;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            uint32_t cx = (uint32_t)(ix + i + cells) % (uint32_t)cells,
                     cy = (uint32_t)(iy + j + cells) % (uint32_t)cells;
            uint32_t h = hash(cx, cy, salt);
            float dx = (float)(ix + i) + unit(h) - x, dy = (float)(iy + j) + unit(hash(h, cx, salt)) - y;
            float d = sqrtf(dx * dx + dy * dy);
            if (d < nearest)
                second = nearest, nearest = d;
            else if (d < second)
                second = d;
        }
    return 1.0f - fminf(1.0f, (second - nearest) * 1.6f);
}

// The four channels at (u, v) in [0, 1): a coarse net, a fine net, and two smooth noises.
static void foam_at(float u, float v, float out[4]) {
    float wx = value_noise(u * 8, v * 8, 8, 11) + 0.5f * value_noise(u * 16, v * 16, 16, 12);
    float wy = value_noise(u * 8, v * 8, 8, 21) + 0.5f * value_noise(u * 16, v * 16, 16, 22);
    float x = u + 0.05f * (wx - 0.75f) + 1.0f, y = v + 0.05f * (wy - 0.75f) + 1.0f;
    float lace = 0.45f * cell_walls(x * 12, y * 12, 12, 1) + 0.33f * cell_walls(x * 27, y * 27, 27, 2) +
                 0.22f * cell_walls(x * 64, y * 64, 64, 3);
    float fine = 0.6f * cell_walls(x * 40, y * 40, 40, 4) + 0.4f * cell_walls(x * 90, y * 90, 90, 5);
    float torn = 0.6f * value_noise(u * 5, v * 5, 5, 31) + 0.4f * value_noise(u * 13, v * 13, 13, 32);
    out[0] = 0.62f * lace + 0.38f * torn;
    out[1] = fine;
    out[2] = 0.6f * value_noise(u * 4, v * 4, 4, 41) + 0.4f * value_noise(u * 9, v * 9, 9, 42);
    out[3] = 0.6f * value_noise(u * 3, v * 3, 3, 51) + 0.4f * value_noise(u * 7, v * 7, 7, 52);
}

static void fill_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    float *out = context;
    for (uint32_t j = begin; j < end; ++j)
        for (uint32_t i = 0; i < SIZE; ++i)
            foam_at((float)i / (float)SIZE, (float)j / (float)SIZE, out + 4 * ((size_t)j * SIZE + i));
}

static int bin_of(float value) {
    int bin = (int)(value * BINS);
    return bin < 0 ? 0 : bin >= BINS ? BINS - 1 : bin;
}

// Each value becomes its rank among all of its channel.
static void flatten(const float *values, int channel, uint8_t *out) {
    uint32_t rank[BINS];
    memset(rank, 0, sizeof rank);
    for (size_t i = 0; i < PIXELS; ++i) rank[bin_of(values[4 * i + channel])]++;
    for (int b = 1; b < BINS; ++b) rank[b] += rank[b - 1];
    for (size_t i = 0; i < PIXELS; ++i)
        out[4 * i + channel] = (uint8_t)(255.0 * rank[bin_of(values[4 * i + channel])] / (double)PIXELS);
}

bolan_result bolan_foam_texture_fill(uint8_t *out) {
    size_t bytes = sizeof(float) * 4 * PIXELS;
    float *values = allocate_for("the texture of foam", bytes);
    if (values == NULL) return BOLAN_ERROR_MEMORY;
    bolan_parallel(SIZE, 16, fill_rows, values);
    for (int channel = 0; channel < 4; ++channel) flatten(values, channel, out);
    bolan_release(values, bytes);
    return BOLAN_OK;
}

bolan_result bolan_foam_texture_create(gl_texture *out) {
    size_t bytes = (size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE * 4;
    uint8_t *pixels = allocate_for("the texture of foam", bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result result = bolan_foam_texture_fill(pixels);
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_TEXTURE_SIZE,
                            .height = FOAM_TEXTURE_SIZE,
                            .filter = GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, out);
    if (result == BOLAN_OK) {
        bolan_gl_texture_upload(out, 0, -1, pixels, false);
        bolan_gl_texture_generate_mipmaps(out);
    }
    bolan_release(pixels, bytes);
    return result;
}
