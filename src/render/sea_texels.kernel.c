// SPDX-License-Identifier: MIT
// See sea_texels.h.
#include "waves/cascades/wide_half.h"

#include <stddef.h>

#include "render/sea_texels.h"

// Four vectors as WIDE texels of four halfs.
static inline void put(uint16_t *out, wide a, wide b, wide c, wide d) {
    wide words[2];
    wide_interleave(wide_half_pair(a, b), wide_half_pair(c, d), words);
    memcpy(out, words, sizeof words);
}

static inline wide load(const float *p) {
    wide v;
    memcpy(&v, p, sizeof v);
    return v;
}

void KERNEL(bolan_texel_pack)(size_t count, const float *a, const float *b, const float *c0, const float *c1,
                              const float *d, float *sum, uint16_t *out);
void KERNEL(bolan_texel_pack)(size_t count, const float *a, const float *b, const float *c0, const float *c1,
                              const float *d, float *sum, uint16_t *out) {
    for (size_t i = 0; i < count; i += WIDE) {
        const wide c = load(c0 + i) + load(c1 + i);
        memcpy(sum + i, &c, sizeof c);
        put(out + 4 * i, load(a + i), load(b + i), c, load(d + i));
    }
}

#if WIDE == 16
#define EVEN 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30
#define ODD 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31
#elif WIDE == 8
#define EVEN 0, 2, 4, 6, 8, 10, 12, 14
#define ODD 1, 3, 5, 7, 9, 11, 13, 15
#elif WIDE == 4
#define EVEN 0, 2, 4, 6
#define ODD 1, 3, 5, 7
#endif

// Rows are added first, then columns: in every set, so that all give the same bits.
static inline wide mean_wide(const float *low, const float *high) {
#if WIDE > 1
    const wide a = load(low) + load(high), b = load(low + WIDE) + load(high + WIDE);
    return 0.25f * (WIDE_SHUFFLE(a, b, EVEN) + WIDE_SHUFFLE(a, b, ODD));
#else
    return 0.25f * ((low[0] + high[0]) + (low[1] + high[1]));
#endif
}

static inline float mean_one(const float *low, const float *high) {
    return 0.25f * ((low[0] + high[0]) + (low[1] + high[1]));
}

static void narrow_row(uint32_t n, const float *const low[TEXEL_PLANES], float *const to[TEXEL_PLANES], uint16_t *out) {
    for (uint32_t x = 0; x < n / 2; x++)
        for (int p = 0; p < TEXEL_PLANES; p++) {
            const float m = mean_one(low[p] + 2 * x, low[p] + n + 2 * x);
            to[p][x] = m;
            out[4 * x + p] = half_from_float(m);
        }
}

static void wide_row(uint32_t n, const float *const low[TEXEL_PLANES], float *const to[TEXEL_PLANES], uint16_t *out) {
    for (uint32_t x = 0; x < n / 2; x += WIDE) {
        wide m[TEXEL_PLANES];
        for (int p = 0; p < TEXEL_PLANES; p++) {
            m[p] = mean_wide(low[p] + 2 * x, low[p] + n + 2 * x);
            memcpy(to[p] + x, &m[p], sizeof m[p]);
        }
        put(out + 4 * x, m[0], m[1], m[2], m[3]);
    }
}

void KERNEL(bolan_texel_halve)(uint32_t n, const float *const from[TEXEL_PLANES], float *const to[TEXEL_PLANES],
                               uint16_t *out);
void KERNEL(bolan_texel_halve)(uint32_t n, const float *const from[TEXEL_PLANES], float *const to[TEXEL_PLANES],
                               uint16_t *out) {
    for (uint32_t y = 0; y < n / 2; y++) {
        const float *low[TEXEL_PLANES];
        float *row[TEXEL_PLANES];
        for (int p = 0; p < TEXEL_PLANES; p++) {
            low[p] = from[p] + (size_t)2 * y * n;
            row[p] = to[p] + (size_t)y * (n / 2);
        }
        if (n / 2 < WIDE)
            narrow_row(n, low, row, out + (size_t)y * (n / 2) * 4);
        else
            wide_row(n, low, row, out + (size_t)y * (n / 2) * 4);
    }
}

static void halfs_of(uint32_t count, const float *from, uint16_t *out) {
    if (count < WIDE)
        for (uint32_t i = 0; i < count; i++) out[i] = half_from_float(from[i]);
    else
        for (uint32_t i = 0; i < count; i += WIDE) wide_half_store(out + i, load(from + i));
}

void KERNEL(bolan_texel_halve_texels)(uint32_t n, size_t pitch, const float *from, float *to, uint16_t *out);
void KERNEL(bolan_texel_halve_texels)(uint32_t n, size_t pitch, const float *from, float *to, uint16_t *out) {
    const size_t row = TEXEL_PLANES * (size_t)(n / 2);
    for (uint32_t y = 0; y < n / 2; y++, to += row, out += row) {
        const float *low = from + 2 * y * TEXEL_PLANES * pitch, *high = low + TEXEL_PLANES * pitch;
        for (uint32_t x = 0; x < n / 2; x++)
            for (int p = 0; p < TEXEL_PLANES; p++) {
                const size_t a = (size_t)2 * TEXEL_PLANES * x + (size_t)p, b = a + TEXEL_PLANES;
                to[TEXEL_PLANES * x + (uint32_t)p] = 0.25f * ((low[a] + high[a]) + (low[b] + high[b]));
            }
        halfs_of((uint32_t)row, to, out);
    }
}
