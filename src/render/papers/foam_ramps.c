// SPDX-License-Identifier: MIT
// Three densities of one net of bubbles: the thin one shows its thickest walls, the dense one lets only its holes
// through, so that a mix of neighbours looks like a density between them. The tiles are those of foam_texture.c, added,
// flattened again by rank, and cut where the wanted share is left.
#include "render/papers/foam_ramps.h"
#include "render/memory.h"
#include "shared/foam.glsl"

#include <math.h>
#include <string.h>

#define PIXELS ((size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE)
#define BINS 4096
#define SOFT 0.35 // width of the cut's edge, in rank

static const double densities[3] = {FOAM_THIN, FOAM_MIDDLING, FOAM_DENSE};

// Coarse net, fine net, noise: weights of thin, middling and dense foam.
static int value_of(const uint8_t *texel, int density) {
    static const int weights[3][3] = {{11, 4, 1}, {9, 5, 2}, {7, 6, 3}};
    const int *w = weights[density];
    return w[0] * texel[0] + w[1] * texel[1] + w[2] * texel[3]; // 0..4080
}

static void cut(const uint8_t *tiles, int density, uint8_t *out) {
    uint32_t rank[BINS];
    memset(rank, 0, sizeof rank);
    for (size_t i = 0; i < PIXELS; ++i) rank[value_of(tiles + 4 * i, density)]++;
    for (int b = 1; b < BINS; ++b) rank[b] += rank[b - 1];
    // a soft edge must not reach beyond the ranks there are, or the mean would not be the share
    const double share = densities[density], soft = fmin(SOFT, 2.0 * fmin(share, 1.0 - share));
    for (size_t i = 0; i < PIXELS; ++i) {
        const double at = rank[value_of(tiles + 4 * i, density)] / (double)PIXELS;
        out[4 * i + density] =
            (uint8_t)(255.0 * smoothstep(1.0 - share - 0.5 * soft, 1.0 - share + 0.5 * soft, at) + 0.5);
    }
}

bolan_result bolan_foam_densities_fill(uint8_t *out) {
    uint8_t *tiles = allocate_for("the densities of foam", 4 * PIXELS);
    if (tiles == NULL) return BOLAN_ERROR_MEMORY;
    const bolan_result result = bolan_foam_texture_fill(tiles);
    for (int density = 0; result == BOLAN_OK && density < 3; ++density) cut(tiles, density, out);
    for (size_t i = 0; i < PIXELS; ++i) out[4 * i + 3] = tiles[4 * i + 1];
    bolan_release(tiles, 4 * PIXELS);
    return result;
}

// Shares of the densities whose mean is t: between neighbours of (nothing, thin, middling, dense, everything).
static void shares_of_mean(double t, double out[4]) {
    const double at[5] = {0.0, densities[0], densities[1], densities[2], 1.0};
    memset(out, 0, 4 * sizeof *out);
    int upper = 1;
    while (upper < 4 && t > at[upper]) upper++;
    const double x = fmin(fmax((t - at[upper - 1]) / (at[upper] - at[upper - 1]), 0.0), 1.0);
    if (upper > 1) out[upper - 2] = 1.0 - x;
    out[upper - 1] = x;
}

// The shore's foam thickens faster: thin foam at a small intensity, dense at a large one, by smooth thresholds.
static void shares_of_shore(double t, double thin, double middling, double dense, double out[4]) {
    const double a = smoothstep(0.0, thin, t), b = smoothstep(thin, middling, t), c = smoothstep(middling, dense, t);
    out[0] = a * (1.0 - b);
    out[1] = b * (1.0 - c);
    out[2] = c;
    out[3] = 0.35 * smoothstep(dense, 1.0, t);
}

void bolan_foam_ramps_fill(uint8_t out[FOAM_RAMP_ROWS][FOAM_RAMP_SIZE][4]) {
    for (int row = 0; row < FOAM_RAMP_ROWS; ++row)
        for (int i = 0; i < FOAM_RAMP_SIZE; ++i) {
            const double t = i / (FOAM_RAMP_SIZE - 1.0);
            double shares[4];
            if (row == 0)
                shares_of_shore(t, 0.2, 0.6, 1.0, shares);
            else if (row == 1)
                shares_of_shore(t, 0.12, 0.45, 0.8, shares);
            else
                shares_of_mean(t, shares);
            for (int k = 0; k < 4; ++k) out[row][i][k] = (uint8_t)(255.0 * shares[k] + 0.5);
        }
}
