// SPDX-License-Identifier: MIT
// The fine waves of a sea (bolan_sea_fine()) as a surface for the reference path tracer: heights from the slopes of the
// tile, by a Fourier transform, h = -i (k . s) / k^2; and both at FINE_TIMES the samples a side, to be read
// linearly.
#ifndef BOLAN_REFERENCE_FINE_H
#define BOLAN_REFERENCE_FINE_H

#include "bolan/waves.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>

#ifndef FINE_TIMES
#define FINE_TIMES 4
#endif

typedef struct fine_point {
    float height, sx, sy; // [m]; slopes along the axes of the world
} fine_point;
typedef struct fine_waves {
    uint32_t n; // 0: none
    double length, cosine, sine;
    fine_point *samples;
} fine_waves;

// In place, n a power of two, `stride` values apart; sign -1: to wave numbers. Without a factor.
static inline void fourier(double complex *x, double complex *room, uint32_t n, uint32_t stride, int sign) {
    if (n == 1) return;
    for (uint32_t i = 0; i < n; ++i) room[i] = x[i * stride];
    for (uint32_t i = 0; i < n / 2; ++i) {
        x[i * stride] = room[2 * i];
        x[(i + n / 2) * stride] = room[2 * i + 1];
    }
    fourier(x, room, n / 2, stride, sign);
    fourier(x + n / 2 * stride, room, n / 2, stride, sign);
    for (uint32_t i = 0; i < n / 2; ++i) {
        const double complex a = x[i * stride];
        const double complex b = cexp(sign * 6.283185307179586 * I * i / n) * x[(i + n / 2) * stride];
        x[i * stride] = a + b;
        x[(i + n / 2) * stride] = a - b;
    }
}

static inline void fourier_plane(double complex *x, uint32_t n, int sign) {
    double complex *room = malloc(sizeof *room * n);
    for (uint32_t i = 0; i < n; ++i) fourier(x + i * n, room, n, 1, sign);
    for (uint32_t i = 0; i < n; ++i) fourier(x + i, room, n, n, sign);
    free(room);
}

// The tile's slopes are larger by what a linear reading of its n samples takes away; this takes it off.
static inline double fine_kept(int wave, uint32_t n) { return sqrt((2.0 + cos(6.283185307179586 * wave / n)) / 3.0); }

// One plane at FINE_TIMES the samples a side, in the real part. k: 0 height, 1 slope x, 2 slope y.
static inline double complex *fine_plane(const double complex *sx, const double complex *sy, const fine_waves *f,
                                         int k) {
    const uint32_t n = f->n / FINE_TIMES, m = f->n;
    double complex *out = calloc((size_t)m * m, sizeof *out);
    for (uint32_t j = 0; j < n; ++j)
        for (uint32_t i = 0; i < n; ++i) {
            const int p = i < n / 2 ? (int)i : (int)i - (int)n, q = j < n / 2 ? (int)j : (int)j - (int)n;
            const double unit = 6.283185307179586 / f->length;
            const double kx = unit * (f->cosine * p - f->sine * q), ky = unit * (f->sine * p + f->cosine * q);
            const double kept = fine_kept(p, n) * fine_kept(q, n) / ((double)n * n);
            const double complex x = kept * sx[j * n + i], y = kept * sy[j * n + i];
            const uint32_t at = (uint32_t)(q + (int)m) % m * m + (uint32_t)(p + (int)m) % m;
            out[at] = k == 0 ? -I * (kx * x + ky * y) / fmax(kx * kx + ky * ky, 1e-9) : k == 1 ? x : y;
        }
    fourier_plane(out, m, 1);
    return out;
}

static inline fine_waves fine_open(const bolan_sea_fine_view *view) {
    fine_waves f = {
        .n = FINE_TIMES * view->n, .length = view->length, .cosine = cos(view->angle), .sine = sin(view->angle)};
    if (view->n == 0) return f;
    const uint32_t n = view->n;
    double complex *sx = malloc(sizeof *sx * n * n), *sy = malloc(sizeof *sy * n * n);
    for (uint32_t i = 0; i < n * n; ++i) sx[i] = (double)view->slope_x[i], sy[i] = (double)view->slope_y[i];
    fourier_plane(sx, n, -1), fourier_plane(sy, n, -1);
    double complex *planes[3];
    for (int k = 0; k < 3; ++k) planes[k] = fine_plane(sx, sy, &f, k);
    f.samples = malloc(sizeof *f.samples * f.n * f.n);
    for (uint32_t i = 0; i < f.n * f.n; ++i)
        f.samples[i] = (fine_point){(float)creal(planes[0][i]), (float)creal(planes[1][i]), (float)creal(planes[2][i])};
    for (int k = 0; k < 3; ++k) free(planes[k]);
    free(sx), free(sy);
    return f;
}

static inline fine_point fine_at(const fine_waves *f, bolan_dvec2 at) {
    fine_point p = {0.0f, 0.0f, 0.0f};
    if (f->n == 0) return p;
    double u = (at.x * f->cosine + at.y * f->sine) / f->length, v = (at.y * f->cosine - at.x * f->sine) / f->length;
    u = (u - floor(u)) * f->n, v = (v - floor(v)) * f->n;
    const uint32_t i = (uint32_t)u % f->n, j = (uint32_t)v % f->n, i1 = (i + 1) % f->n, j1 = (j + 1) % f->n;
    const float a = (float)(u - floor(u)), b = (float)(v - floor(v));
    const float w[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
    const fine_point *s[4] = {&f->samples[j * f->n + i], &f->samples[j * f->n + i1], &f->samples[j1 * f->n + i],
                              &f->samples[j1 * f->n + i1]};
    for (int k = 0; k < 4; ++k) p.height += w[k] * s[k]->height, p.sx += w[k] * s[k]->sx, p.sy += w[k] * s[k]->sy;
    return p;
}

#endif
