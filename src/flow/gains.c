// SPDX-License-Identifier: MIT
// The gains of second.h: phi2 by Q as a function of K, from pairs of waves that are drawn by their energy.
//
// A pair has, for the sine of its phases' sum (+) or difference (-), with w the frequencies, u the angle's cosine times
// both coth(kH) and b = w^3 bed,
//
//     horizontal part of Q   -(w1 +- w2) w1 w2 u
//     vertical part of Q     +-(w1 +- w2) w1 w2 - (b1 +- b2) / 2
//
// In each octave's part of K the two gains minimise the sum of m1 m2 (gain . Q - Q / (g K tanh KH - W^2))^2.
#include "flow/second.h"
#include "spectrum/portable.h"

#include <string.h>

enum { DRAWS = 40000, BINS = 20, SIGNS = 2 };
#define G BOLAN_GRAVITY
#define RIDGE 0.02   // keeps the two gains alike where pairs do not tell them apart
#define CLOSEST 0.02 // least 1 - W^2 / (g K tanh KH): the theory ends near resonance

// Sums over the pairs of one range of K. Gains here are in units of 1 / (g K tanh KH).
typedef struct sums {
    double hh, hw, ww, h, w; // products of the parts of Q with each other and with the exact answer
    double motion;           // of phi2's velocity
} sums;

typedef struct fit {
    const flow_second *s;
    double depth, unit; // 2 pi / length
    double *upto;       // energies of the waves up to each
    sums bin[SIGNS][BINS];
    double gain[SIGNS][BINS][2];
} fit;

static double highest_k(const fit *f) { return f->unit * f->s->reach * 1.4142135623730951; }

// Position of K among the bins.
static double bin_of(const fit *f, double k) {
    return portable_log(k / f->unit) / portable_log(highest_k(f) / f->unit) * BINS;
}

static double edge_of(const fit *f, double index) {
    return f->unit * portable_pow(highest_k(f) / f->unit, index / BINS);
}

// ---- pairs ----------------------------------------------------------------------------------------------------------

static double energy_of(const second_wave *w) {
    const double re = (double)w->re, im = (double)w->im;
    return 0.5 * (re * re + im * im);
}

// Waves are drawn by the variance of their velocity.
static double share_of(const second_wave *w) { return energy_of(w) * (double)w->omega * (double)w->omega; }

static uint32_t draw(const fit *f, double at) {
    uint32_t low = 0, high = f->s->wave_count - 1;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (f->upto[middle] < at) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static void add_pair(fit *f, const second_wave *a, const second_wave *b, int sign) {
    const int32_t i = a->i + sign * b->i, j = a->j + sign * b->j;
    const int32_t ai = i < 0 ? -i : i, aj = j < 0 ? -j : j;
    if ((i == 0 && j == 0) || ai > f->s->reach || aj > f->s->reach) return;
    const double k = f->unit * sqrt((double)(i * i + j * j)), free = G * k * portable_tanh(k * f->depth);
    const double w1 = (double)a->omega, w2 = (double)b->omega, w = w1 + sign * w2;
    const double u = (double)a->across[0] * (double)b->across[0] + (double)a->across[1] * (double)b->across[1];
    const double b1 = w1 * w1 * w1 * (double)a->bed, b2 = w2 * w2 * w2 * (double)b->bed;
    const double h = -w * w1 * w2 * u, v = sign * w * w1 * w2 - 0.5 * (b1 + sign * b2);
    double below = 1.0 - w * w / free;
    if (fabs(below) < CLOSEST) below = below < 0.0 ? -CLOSEST : CLOSEST;
    const double exact = (h + v) / below, weight = 1.0 / (w1 * w1 * w2 * w2); // m1 m2 over the share that was drawn
    sums *s = &f->bin[sign > 0][(int)fmin(fmax(bin_of(f, k), 0.0), BINS - 1.0)];
    s->hh += weight * h * h, s->hw += weight * h * v, s->ww += weight * v * v;
    s->h += weight * h * exact, s->w += weight * v * exact;
    s->motion += weight * exact * exact * (k / free) * (k / free);
}

// Additive recurrences by the plastic number are evenly spread over pairs.
static void add_pairs(fit *f) {
    const double all = f->upto[f->s->wave_count - 1];
    for (int n = 1; n <= DRAWS; n++) {
        const double x = n * 0.7548776662466927, y = n * 0.5698402909980532;
        const second_wave *a = &f->s->waves[draw(f, all * (x - floor(x)))];
        const second_wave *b = &f->s->waves[draw(f, all * (y - floor(y)))];
        if (a == b) continue;
        add_pair(f, a, b, 1);
        add_pair(f, a, b, -1);
    }
}

// ---- gains ----------------------------------------------------------------------------------------------------------

static bool solve(const sums *s, double gain[2]) {
    const double total = s->hh + 2.0 * s->hw + s->ww, ridge = RIDGE * (s->hh + s->ww);
    if (!(s->hh + s->ww > 0.0)) return false;
    const double one = total > 0.0 ? (s->h + s->w) / total : 1.0; // that of Q as a whole
    const double hh = s->hh + ridge, ww = s->ww + ridge, h = s->h + ridge * one, w = s->w + ridge * one;
    const double determinant = hh * ww - s->hw * s->hw;
    gain[0] = (ww * h - s->hw * w) / determinant;
    gain[1] = (hh * w - s->hw * h) / determinant;
    return true;
}

// Ranges of K without pairs have the gains of their neighbour.
static void set_gains(fit *f) {
    for (int sign = 0; sign < SIGNS; sign++) {
        int first = -1;
        for (int b = 0; b < BINS; b++) {
            if (solve(&f->bin[sign][b], f->gain[sign][b])) {
                if (first < 0) first = b;
            } else if (b > 0) {
                memcpy(f->gain[sign][b], f->gain[sign][b - 1], sizeof f->gain[sign][b]);
            }
        }
        for (int b = 0; b < first; b++) memcpy(f->gain[sign][b], f->gain[sign][first], sizeof f->gain[sign][b]);
    }
}

static double gain_at(const fit *f, int sign, int part, double k) {
    const double x = fmin(fmax(bin_of(f, k) - 0.5, 0.0), BINS - 1.001), at = floor(x);
    const int b = (int)at;
    return f->gain[sign][b][part] * (1.0 - (x - at)) + f->gain[sign][b + 1][part] * (x - at);
}

// ---- depths ---------------------------------------------------------------------------------------------------------

// A half of the range of K, whose bins of motion are those of the pairs.
static void set_half(fit *f, flow_levels *levels, int half) {
    const double first = half * 0.5 * BINS, width = 0.5 * BINS / FLOW_BINS;
    levels->k_low = edge_of(f, first);
    levels->k_high = edge_of(f, first + 0.5 * BINS);
    for (int b = 0; b < FLOW_BINS; b++) {
        const int from = (int)(first + b * width);
        levels->bin[b].k = edge_of(f, first + (b + 0.5) * width);
        levels->bin[b].motion = f->bin[0][from].motion + f->bin[1][from].motion;
    }
    bolan_flow_fit(levels, f->depth);
}

static double sinc4(const fit *f, int32_t index) {
    const double x = BOLAN_PI * index / f->s->frame.n;
    double sine, cosine;
    bolan_sincos(x, &sine, &cosine);
    const double sinc = index == 0 ? 1.0 : sine / x;
    return sinc * sinc * sinc * sinc;
}

static void set_cell(const fit *f, int32_t i, int32_t j, double keep, second_cell *out) {
    const double k = f->unit * sqrt((double)(i * i + j * j)), tanh = portable_tanh(k * f->depth);
    const int half = bin_of(f, k) < 0.5 * BINS ? 0 : 1;
    const flow_levels *levels = &f->s->half[half];
    const double all = 1.0 - portable_exp(-2.0 * k * f->depth), scale = tanh / (all * sinc4(f, i) * sinc4(f, j));
    for (int g = 0; g < 4; g++) out->gain[g] = (float)(keep * gain_at(f, g / 2, g % 2, k) / (G * k * tanh));
    for (int l = 0; l < FLOW_LEVELS; l++)
        out->level[half * FLOW_LEVELS + l] = (float)(scale * portable_exp(-k * levels->depth[l]));
}

void bolan_flow_second_gains(flow_second *s, double sea_depth, double keep) {
    fit f = {.s = s, .depth = sea_depth, .unit = 2.0 * BOLAN_PI / s->frame.length};
    double upto = 0.0;
    f.upto = (double *)(void *)s->texels; // not yet in use; as many waves fit
    for (uint32_t i = 0; i < s->wave_count; i++) f.upto[i] = upto += share_of(&s->waves[i]);
    if (upto > 0.0) add_pairs(&f);
    set_gains(&f);
    for (int half = 0; half < SECOND_HALVES; half++) set_half(&f, &s->half[half], half);
    for (int32_t i = 0; i <= s->reach; i++)
        for (int32_t j = 0; j <= s->reach; j++)
            if (i > 0 || j > 0) set_cell(&f, i, j, keep, &s->cells[i * (s->reach + 1) + j]);
    memset(s->texels, 0, s->wave_count * sizeof *f.upto);
}
