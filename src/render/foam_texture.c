// SPDX-License-Identifier: MIT
// Foam on water is a net of thin walls round round holes, torn at larger scales. The walls are the borders of a
// cellular pattern (Worley 1996: distance to the second nearest point less that to the nearest) at three sizes,
// displaced by smooth noise. The histogram is then flattened by rank.
#include "foam_texture.h"
#include "foam_statistics.h"
#include "hash.h"
#include "memory.h"
#include "shared/foam.glsl"
#include "windrows.h"

#include <math.h>
#include <string.h>

#define SIZE FOAM_TEXTURE_SIZE
#define PIXELS ((size_t)SIZE * SIZE)
#define BINS 4096
_Static_assert(SIZE == WINDROWS_SIZE, "a sample of the windrows is a texel");
enum { WINDROWS_CHANNEL = 3 };

// Smooth value noise, periodic after `cells`.
static float value_noise(float x, float y, int cells, uint32_t salt) {
    int ix = (int)floorf(x), iy = (int)floorf(y);
    float fx = x - (float)ix, fy = y - (float)iy;
    fx = fx * fx * (3.0f - 2.0f * fx);
    fy = fy * fy * (3.0f - 2.0f * fy);
    float v[4];
    for (int i = 0; i < 4; ++i) {
        int cx = (ix + (i & 1)) % cells, cy = (iy + (i >> 1)) % cells;
        v[i] = hash_unit(
            cell_hash((uint32_t)(cx + cells) % (uint32_t)cells, (uint32_t)(cy + cells) % (uint32_t)cells, salt));
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
            uint32_t h = cell_hash(cx, cy, salt);
            float dx = (float)(ix + i) + hash_unit(h) - x, dy = (float)(iy + j) + hash_unit(cell_hash(h, cx, salt)) - y;
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

// The channels of the noise of foam but for the windrows: patches, nets of walls, bubbles.
static void noise_at(float u, float v, float out[4]) {
    float wx = value_noise(u * 8, v * 8, 8, 61) + 0.5f * value_noise(u * 19, v * 19, 19, 62);
    float wy = value_noise(u * 8, v * 8, 8, 71) + 0.5f * value_noise(u * 19, v * 19, 19, 72);
    float x = u + 0.035f * (wx - 0.75f) + 1.0f, y = v + 0.06f * (wy - 0.75f) + 1.0f;
    out[0] = 0.42f * value_noise(x * 6, y * 6, 6, 81) + 0.29f * value_noise(x * 14, y * 14, 14, 82) +
             0.18f * value_noise(x * 31, y * 31, 31, 83) + 0.11f * value_noise(x * 67, y * 67, 67, 84);
    out[1] = 0.50f * cell_walls(x * 13, y * 13, 13, 6) + 0.32f * cell_walls(x * 29, y * 29, 29, 7) +
             0.18f * cell_walls(x * 64, y * 64, 64, 8);
    out[2] = 0.55f * cell_walls(x * 31, y * 31, 31, 9) + 0.45f * cell_walls(x * 73, y * 73, 73, 10);
    out[WINDROWS_CHANNEL] = 0.0f;
}

typedef struct filling {
    void (*at)(float u, float v, float out[4]);
    float *out;
} filling;

static void fill_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const filling *f = context;
    for (uint32_t j = begin; j < end; ++j)
        for (uint32_t i = 0; i < SIZE; ++i)
            f->at((float)i / (float)SIZE, (float)j / (float)SIZE, f->out + 4 * ((size_t)j * SIZE + i));
}

static int bin_of(float value) {
    int bin = (int)(value * BINS);
    return bin < 0 ? 0 : bin >= BINS ? BINS - 1 : bin;
}

static double uniform_byte(double share) { return 255.0 * share; }

// One level of 8 bits is 0.024 of the standard deviation.
static double normal_byte(double share) {
    const double middle = share - 0.5 / (double)PIXELS; // of a rank
    return fmin(fmax(FOAM_NOISE_MIDDLE + 255.0 / FOAM_NOISE_RANGE * bolan_foam_quantile(middle) + 0.5, 0.0), 255.0);
}

// Each value becomes what the share of its channel that is not above it is mapped to.
static void flatten(const float *values, int channel, double (*byte_of)(double share), uint8_t *out) {
    uint32_t rank[BINS];
    uint8_t mapped[BINS];
    memset(rank, 0, sizeof rank);
    for (size_t i = 0; i < PIXELS; ++i) rank[bin_of(values[4 * i + channel])]++;
    for (int b = 1; b < BINS; ++b) rank[b] += rank[b - 1];
    for (int b = 0; b < BINS; ++b) mapped[b] = (uint8_t)byte_of(rank[b] / (double)PIXELS);
    for (size_t i = 0; i < PIXELS; ++i) out[4 * i + channel] = mapped[bin_of(values[4 * i + channel])];
}

static bolan_result fill(void (*at)(float u, float v, float out[4]), bool windrows, double (*byte_of)(double share),
                         uint8_t *out) {
    size_t bytes = sizeof(float) * 4 * PIXELS;
    filling f = {at, allocate_for("the texture of foam", bytes)};
    if (f.out == NULL) return BOLAN_ERROR_MEMORY;
    bolan_parallel(SIZE, 16, fill_rows, &f);
    const bolan_result result = windrows ? bolan_windrows_fill(f.out + WINDROWS_CHANNEL, 4) : BOLAN_OK;
    for (int channel = 0; channel < 4; ++channel) flatten(f.out, channel, byte_of, out);
    bolan_release(f.out, bytes);
    return result;
}

bolan_result bolan_foam_texture_fill(uint8_t *out) { return fill(foam_at, false, uniform_byte, out); }

bolan_result bolan_foam_noise_fill(uint8_t *out) { return fill(noise_at, true, normal_byte, out); }

// Sums of 2 x 2 texels: from `size` to half of it, in place.
static void halve(uint32_t *sums, uint32_t size) {
    const uint32_t n = size / 2;
    for (uint32_t j = 0; j < n; ++j)
        for (uint32_t i = 0; i < 4 * n; ++i) {
            const uint32_t *s = sums + 4 * (size_t)size * (2 * j) + 8 * (i / 4) + i % 4, *below = s + 4 * (size_t)size;
            sums[4 * (size_t)n * j + i] = s[0] + s[4] + below[0] + below[4];
        }
}

// The smaller levels. GL may round each level of bytes upwards, which in the end is a fifth of a standard deviation.
static bolan_result upload_levels(uint8_t *pixels, gl_texture *out) {
    const size_t bytes = 4 * PIXELS * sizeof(uint32_t);
    uint32_t *sums = allocate_for("the texture of foam", bytes);
    if (sums == NULL) return BOLAN_ERROR_MEMORY;
    for (size_t i = 0; i < 4 * PIXELS; ++i) sums[i] = pixels[i];
    for (uint32_t level = 1, size = SIZE; size > 1; ++level, size /= 2) {
        halve(sums, size);
        const uint32_t values = 4 * (size / 2) * (size / 2), count = 1u << (2 * level); // texels in a sum
        for (uint32_t i = 0; i < values; ++i) pixels[i] = (uint8_t)((sums[i] + count / 2) / count);
        bolan_gl_texture_upload(out, level, -1, pixels, false);
    }
    bolan_release(sums, bytes);
    return BOLAN_OK;
}

static bolan_result create(bolan_result (*fill_pixels)(uint8_t *out), bool own_levels, gl_texture *out) {
    size_t bytes = (size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE * 4;
    uint8_t *pixels = allocate_for("the texture of foam", bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result result = fill_pixels(pixels);
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_TEXTURE_SIZE,
                            .height = FOAM_TEXTURE_SIZE,
                            .filter = GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, out);
    if (result == BOLAN_OK) {
        bolan_gl_texture_upload(out, 0, -1, pixels, false);
        if (own_levels)
            result = upload_levels(pixels, out);
        else
            bolan_gl_texture_generate_mipmaps(out);
    }
    bolan_release(pixels, bytes);
    return result;
}

bolan_result bolan_foam_texture_create(gl_texture *out) { return create(bolan_foam_texture_fill, false, out); }

bolan_result bolan_foam_noise_create(gl_texture *out) { return create(bolan_foam_noise_fill, true, out); }
