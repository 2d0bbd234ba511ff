// SPDX-License-Identifier: MIT
// Light gathered on the bottom: each triangle of the surface carries its light to where its corners' refracted rays
// land. The light of a texel is the ratio of the two areas, summed over all sheets of the fold: none is lost, so the
// mean is 1.
#include "bolan/tiles.h"

#include <math.h>

#define FEWEST_TEXELS 12 // from which the area of a triangle is known well enough

typedef struct bottom {
    float *light;
    int n;
} bottom;

typedef struct landing {
    float x, y; // [texels]
} landing;

static int wrap(int i, int n) { return i & (n - 1); }

static void add(const bottom *b, int x, int y, float flux) { b->light[wrap(y, b->n) * b->n + wrap(x, b->n)] += flux; }

// A triangle smaller than a texel: its light goes to the four nearest.
static void splat(const bottom *b, float x, float y, float flux) {
    const float fx = floorf(x), fy = floorf(y), u = x - fx, v = y - fy;
    const int i = (int)fx, j = (int)fy;
    add(b, i, j, flux * (1.0f - u) * (1.0f - v));
    add(b, i + 1, j, flux * u * (1.0f - v));
    add(b, i, j + 1, flux * (1.0f - u) * v);
    add(b, i + 1, j + 1, flux * u * v);
}

// Splats at the centres of four sub-triangles, because a lattice of one point a triangle beats with the texels.
static void splat_quarters(const bottom *b, const landing t[3], float flux) {
    const float x = (t[0].x + t[1].x + t[2].x) / 3.0f, y = (t[0].y + t[1].y + t[2].y) / 3.0f;
    splat(b, x, y, 0.25f * flux);
    for (int i = 0; i < 3; i++) splat(b, 0.5f * (x + t[i].x), 0.5f * (y + t[i].y), 0.25f * flux);
}

static float edge(landing a, landing b, float x, float y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }

// Calls for each texel centre inside; with flux 0 it only counts.
static int cover(const bottom *b, const landing t[3], float sign, float flux) {
    const int x0 = (int)ceilf(fminf(t[0].x, fminf(t[1].x, t[2].x))),
              x1 = (int)floorf(fmaxf(t[0].x, fmaxf(t[1].x, t[2].x)));
    const int y0 = (int)ceilf(fminf(t[0].y, fminf(t[1].y, t[2].y))),
              y1 = (int)floorf(fmaxf(t[0].y, fmaxf(t[1].y, t[2].y)));
    int count = 0;
    for (int y = y0; y <= y1; y++)
        for (int x = x0; x <= x1; x++) {
            const float px = (float)x, py = (float)y;
            if (sign * edge(t[0], t[1], px, py) < 0.0f || sign * edge(t[1], t[2], px, py) < 0.0f ||
                sign * edge(t[2], t[0], px, py) < 0.0f)
                continue;
            count++;
            if (flux > 0.0f) add(b, x, y, flux);
        }
    return count;
}

// Shares the light of a triangle among the texels it covers: the area ratio, except for the raster.
static void carry(const bottom *b, landing p, landing q, landing r, float flux) {
    const landing t[3] = {p, q, r};
    const float sign = edge(p, q, r.x, r.y) < 0.0f ? -1.0f : 1.0f; // a fold turns it over
    const int count = cover(b, t, sign, 0.0f);
    if (count < FEWEST_TEXELS)
        splat_quarters(b, t, flux);
    else
        (void)cover(b, t, sign, flux / (float)count);
}

typedef struct sunlight {
    bolan_vec3 down;        // unit, as it travels
    float eta;              // 1 / index
    float shift_x, shift_y; // of flat water, a metre of depth
    float texel, depth;
} sunlight;

// Snell's law at a surface of that slope; horizontal travel a metre of descent.
static void refracted(const sunlight *s, float slope_x, float slope_y, float *tx, float *ty) {
    const float length = 1.0f / sqrtf(1.0f + slope_x * slope_x + slope_y * slope_y);
    const bolan_vec3 n = {-slope_x * length, -slope_y * length, length};
    const float c = fmaxf(-bolan_v3_dot(n, s->down), 0.02f); // a facet in its own shadow takes grazing light
    const float k = s->eta * c - sqrtf(1.0f - s->eta * s->eta * (1.0f - c * c));
    const float z = s->eta * s->down.z + k * n.z;
    *tx = (s->eta * s->down.x + k * n.x) / -z;
    *ty = (s->eta * s->down.y + k * n.y) / -z;
}

static sunlight sunlight_of(bolan_vec3 sun, double index, double texel, double depth) {
    sunlight s = {
        .down = bolan_v3_scale(sun, -1.0f), .eta = (float)(1.0 / index), .texel = (float)texel, .depth = (float)depth};
    refracted(&s, 0.0f, 0.0f, &s.shift_x, &s.shift_y);
    return s;
}

// Where the ray through texel (i, j) lands, and the light that a texel of plan area there takes, flat water's being 1.
static landing land(const float *height, int n, const sunlight *s, int i, int j, float *take) {
    const float *row = height + (size_t)(wrap(j, n) * n), two = 0.5f / s->texel;
    const float sx = (row[wrap(i + 1, n)] - row[wrap(i - 1, n)]) * two;
    const float sy = (height[wrap(j + 1, n) * n + wrap(i, n)] - height[wrap(j - 1, n) * n + wrap(i, n)]) * two;
    float tx, ty;
    refracted(s, sx, sy, &tx, &ty);
    const float fall = s->depth + row[wrap(i, n)];
    *take = fmaxf((sx * s->down.x + sy * s->down.y - s->down.z) / -s->down.z, 0.0f);
    return (landing){(float)i + (tx * fall - s->shift_x * s->depth) / s->texel,
                     (float)j + (ty * fall - s->shift_y * s->depth) / s->texel};
}

void bolan_tile_caustics(const float *height, uint32_t n, double length, double depth, bolan_vec3 sun, double index,
                         float *light) {
    BOLAN_ASSERT(height != NULL && light != NULL && n >= 8 && n <= 1024 && (n & (n - 1)) == 0 && sun.z > 0.0f);
    const bottom b = {light, (int)n};
    const sunlight s = sunlight_of(sun, index, length / n, depth);
    for (uint32_t i = 0; i < n * n; i++) light[i] = 0.0f;
    for (int j = 0; j < b.n; j++) {
        float w00, w10, w01, w11;
        landing p00 = land(height, b.n, &s, 0, j, &w00), p01 = land(height, b.n, &s, 0, j + 1, &w01);
        for (int i = 0; i < b.n; i++) {
            const landing p10 = land(height, b.n, &s, i + 1, j, &w10), p11 = land(height, b.n, &s, i + 1, j + 1, &w11);
            carry(&b, p00, p10, p11, 0.5f * (w00 + w10 + w11) / 3.0f);
            carry(&b, p00, p11, p01, 0.5f * (w00 + w11 + w01) / 3.0f);
            p00 = p10, p01 = p11, w00 = w10, w01 = w11;
        }
    }
}
