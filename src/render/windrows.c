// SPDX-License-Identifier: MIT
// Windrows as a Gaussian field: a sum of plane waves of random phases. Its lines end, and join in Y junctions at the
// dislocations of the phase, as windrows do (Farmer & Li 1995). Distances of windrows are spread over about two decades
// in a log-normal distribution (Thorpe 2004). A smooth displacement across the wind lets the lines wander.
#include "windrows.h"
#include "hash.h"
#include "memory.h"
#include "shared/foam.glsl"

#include "bolan/math.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIZE WINDROWS_SIZE

enum {
    FEWEST = 5,  // waves across the tile
    MOST = 160,  // samples are a third of a wave apart
    REACH = 200, // most waves along the tile
    WAVES = 2 * REACH + 1,
};
#define MEDIAN 40.0    // of the waves across the tile
#define DEVIATION 0.9  // of their logarithm: WINDROWS waves are one below the median
#define ALONG 0.42     // waves along the tile for one across: e-folding number of their exponential distribution
#define ALONG_MOST 3.0 // of them

// Of the displacement: the rise of a line across the wind is WANDER WINDROW_STRETCH^-1, 10 degrees.
#define WANDER 1.06
enum { BENDS_ACROSS = 4, BENDS_LEAST = 3, BENDS_MOST = 24, BENDS_SALT = 2, WINDROWS_SALT = 1 };

// Amplitudes of plane waves: of j - REACH along the wind and i across it.
typedef struct wave_field {
    float cosine[WAVES][MOST], sine[WAVES][MOST];
} wave_field;

typedef struct windrow_scratch {
    float cosine[MOST][SIZE], sine[MOST][SIZE]; // of 2 pi i u / SIZE
    wave_field lines, bends;
    float *out;
    uint32_t stride;
} windrow_scratch;

static double line_variance(int i, int j) {
    if (i < FEWEST || abs(j) > ALONG_MOST * ALONG * i) return 0.0;
    const double octaves = log(i / MEDIAN) / DEVIATION;
    return exp(-0.5 * octaves * octaves - abs(j) / (ALONG * i)) / ((double)i * i);
}

static double bend_variance(int i, int j) {
    const bool twice = i == 0 && j < 0; // the wave of j > 0
    if (i >= BENDS_ACROSS || abs(j) < BENDS_LEAST || abs(j) > BENDS_MOST || twice) return 0.0;
    return exp(-0.1 * i * i) / ((double)j * j);
}

// `steep`: `deviation` is that of the derivative along the tile, not of the field.
static void fill_waves(double (*variance_of)(int i, int j), bool steep, double deviation, uint32_t salt,
                       wave_field *out) {
    double variance = 0.0;
    for (int j = -REACH; j <= REACH; ++j)
        for (int i = 0; i < MOST; ++i) {
            const double rise = steep ? 2.0 * BOLAN_PI * j : 1.0, own = variance_of(i, j);
            const uint32_t h = cell_hash((uint32_t)i, (uint32_t)(j + REACH), salt);
            double sine, cosine;
            bolan_sincos(2.0 * BOLAN_PI * (double)hash_unit(h), &sine, &cosine);
            variance += 0.5 * own * rise * rise;
            out->cosine[j + REACH][i] = (float)(sqrt(own) * cosine);
            out->sine[j + REACH][i] = (float)(sqrt(own) * sine);
        }
    const float scale = (float)(deviation / sqrt(variance));
    for (int j = 0; j < WAVES; ++j)
        for (int i = 0; i < MOST; ++i) out->cosine[j][i] *= scale, out->sine[j][i] *= scale;
}

// The field at v and every u.
static void field_row(const windrow_scratch *s, const wave_field *waves, uint32_t v, uint32_t across, int reach,
                      float out[SIZE]) {
    float re[MOST] = {0}, im[MOST] = {0};
    for (int j = -reach; j <= reach; ++j) {
        const uint32_t turn = (uint32_t)(j + SIZE) * v % SIZE;
        const float c = s->cosine[1][turn], d = s->sine[1][turn];
        const float *a = waves->cosine[j + REACH], *b = waves->sine[j + REACH];
        for (uint32_t i = 0; i < across; ++i) re[i] += a[i] * c - b[i] * d, im[i] += a[i] * d + b[i] * c;
    }
    memset(out, 0, SIZE * sizeof *out);
    for (uint32_t i = 0; i < across; ++i)
        for (uint32_t u = 0; u < SIZE; ++u) out[u] += re[i] * s->cosine[i][u] - im[i] * s->sine[i][u];
}

static void fill_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const windrow_scratch *s = context;
    float lines[SIZE], bends[SIZE];
    for (uint32_t v = begin; v < end; ++v) {
        field_row(s, &s->lines, v, MOST, REACH, lines);
        field_row(s, &s->bends, v, BENDS_ACROSS, BENDS_MOST, bends);
        for (uint32_t u = 0; u < SIZE; ++u) {
            const float at = (float)u + bends[u] * (float)SIZE, whole = floorf(at), part = at - whole;
            const uint32_t left = (uint32_t)((int)whole + 16 * SIZE) % SIZE, right = (left + 1) % SIZE;
            s->out[s->stride * ((size_t)v * SIZE + u)] = 0.5f + lines[left] + part * (lines[right] - lines[left]);
        }
    }
}

bolan_result bolan_windrows_fill(float *out, uint32_t stride) {
    windrow_scratch *s = allocate_for("the texture of foam", sizeof *s);
    if (s == NULL) return BOLAN_ERROR_MEMORY;
    for (uint32_t i = 0; i < MOST; ++i)
        for (uint32_t u = 0; u < SIZE; ++u)
            bolan_sincosf((float)(2.0 * BOLAN_PI / SIZE * (i * u % SIZE)), &s->sine[i][u], &s->cosine[i][u]);
    fill_waves(line_variance, false, WINDROWS_DEVIATION, WINDROWS_SALT, &s->lines);
    fill_waves(bend_variance, true, WANDER, BENDS_SALT, &s->bends);
    s->out = out;
    s->stride = stride;
    bolan_parallel(SIZE, 16, fill_rows, s);
    bolan_release(s, sizeof *s);
    return BOLAN_OK;
}
