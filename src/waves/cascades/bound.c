// SPDX-License-Identifier: MIT
// The bound waves of second order: the weights of bolan_bound_weights (bolan/waves.h).
//
// Parcels that move sideways by choppiness 1 have, to second order at fixed points, the surface
//
//     eta - D . grad eta = eta + 1/4 sum_i sum_j a_i a_j (g_i k_j + g_j k_i) cos(angle) [cos(sum) - cos(difference)]
//
// with g = coth(k depth), the phases of a pair added or subtracted. Theory has other kernels, S for the sum and T for
// the difference (waves/second_order.h). What they have more, s and t, is made of products of the fields that every
// reader has at hand:
//
//     p eta_c eta_l + q D_c . D_l = 1/2 sum_i sum_j a_i a_j [(p - q u) cos(sum) + (p + q u) cos(difference)],      (1)
//     u = g_i g_j cos(angle),  i of cascade c, j of l.
//
// Along a line in deep water s = 0 and t = 2 min(k_i, k_j): p = q, and where the ring l holds longer waves than c they
// are the mean wave number of l. So the weights of two cascades are those of the longer one.
//
// p and q are fitted by least squares to s and t, with the weight m_i m_j of the variances. For p that says that the
// third moment of the surface, 3/2 sum_i sum_j m_i m_j (S + T), is the exact one, whatever the depth and the
// directions: that of (1) does not depend on q, and that of the displacement is 0 at any choppiness.
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"
#include "waves/second_order.h"

enum { BINS = 12, TURNS = 64 }; // of wave number and of direction, of a cascade
#define OCTAVES 4.0             // that the bins of the first cascade reach down from its end
#define APART 0.577             // mean distance of two members of a bin is twice so many standard deviations
#define NEGLIGIBLE 1e-7         // share of a pair of bins in the product of the variances of their cascades
#define STEEPEST 0.5            // of the sum kernel times sigma: see limit_weights()

typedef struct bin {
    double m, mk, mk2; // variance, and with k and k^2
    double direction[TURNS];
    double k, spread, coth; // mean wave number, its relative standard deviation, coth(k depth)
} bin;

// Sums over the pairs of waves of two bins or two cascades, with m_i m_j.
typedef struct pair_sums {
    double all, height;   // 1, s + t
    double square, drift; // u^2, u (t - s)
    double kernel;        // S
} pair_sums;

typedef struct gathering {
    const sea_cascade *cascade;
    double low; // [rad/m] of the first bin
    bin *bins;
} gathering;

static void add_wave(const gathering *g, double kx, double ky, double m) {
    const double k = sqrt(kx * kx + ky * ky), turn = portable_angle(ky, kx) / (2.0 * BOLAN_PI);
    const double x = portable_log(k / g->low) / portable_log(g->cascade->k_max / g->low) * BINS;
    bin *b = &g->bins[(int)fmin(fmax(x, 0.0), BINS - 1.0)];
    b->m += m;
    b->mk += m * k;
    b->mk2 += m * k * k;
    b->direction[(int)((turn - floor(turn)) * TURNS) % TURNS] += m;
}

static void add_mode(void *context, const sea_mode *m) {
    add_wave(context, m->kx, m->ky, m->expected);
    if (m->paired) add_wave(context, -m->kx, -m->ky, m->expected_back);
}

static void fill_bins(const sea_cascade *c, double depth, bin bins[BINS]) {
    const double low = c->k_min > 0.0 ? c->k_min : c->k_max * portable_pow(2.0, -OCTAVES);
    gathering g = {c, low, bins};
    bolan_sea_each_mode(c, add_mode, &g);
    for (int b = 0; b < BINS; b++) {
        if (!(bins[b].m > 0.0)) continue;
        const double k = bins[b].mk / bins[b].m;
        bins[b].k = k;
        bins[b].spread = sqrt(fmax(bins[b].mk2 / (bins[b].m * k * k) - 1.0, 1e-6));
        bins[b].coth = 1.0 / portable_tanh(k * depth);
    }
}

// Adds the pairs of waves with wave numbers ka and kb that run `turns` apart.
static void add_pair(const bin *a, const bin *b, double ka, double kb, double turns, double depth, double weight,
                     pair_sums *sums) {
    double sine, cosine;
    bolan_sincos(2.0 * BOLAN_PI * turns, &sine, &cosine);
    const second_order exact = bolan_second_order((bolan_dvec2){ka, 0.0}, (bolan_dvec2){kb * cosine, kb * sine}, depth);
    const double moved = (a->coth * kb + b->coth * ka) * cosine, u = a->coth * b->coth * cosine;
    const double s = exact.sum - moved, t = exact.difference + moved;
    sums->all += weight;
    sums->height += weight * (s + t);
    sums->square += weight * u * u;
    sums->drift += weight * u * (t - s);
    sums->kernel += weight * exact.sum;
}

// All pairs of a wave of a and one of b.
static void add_bins(const bin *a, const bin *b, double depth, pair_sums *sums) {
    const double apart = a == b ? APART * a->spread : 0.0, ka = a->k * (1.0 + apart), kb = b->k * (1.0 - apart);
    double together[TURNS / 2 + 1] = {0.0}; // m_i m_j by the angle between them
    for (int d = 0; d < TURNS; d++) {
        double sum = 0.0;
        for (int i = 0; i < TURNS; i++) sum += a->direction[i] * b->direction[(i + d) % TURNS];
        together[d <= TURNS / 2 ? d : TURNS - d] += sum;
    }
    for (int d = 0; d <= TURNS / 2; d++) // two directions of one bin are a third of it apart in the mean
        if (together[d] > 0.0)
            add_pair(a, b, ka, kb, (d > 0 ? (double)d : 1.0 / 3.0) / TURNS, depth, together[d], sums);
}

static double variance_of(const bin *bins) {
    double sum = 0.0;
    for (int i = 0; i < BINS; i++) sum += bins[i].m;
    return sum;
}

static void add_cascades(const bin *a, const bin *b, double depth, pair_sums *sums) {
    const double least = NEGLIGIBLE * variance_of(a) * variance_of(b);
    for (int i = 0; i < BINS; i++)
        for (int j = 0; j < BINS; j++)
            if (a[i].m * b[j].m > least) add_bins(&a[i], &b[j], depth, sums);
}

// (1) counts a pair of one cascade twice.
static double share(double sum, double of, double pairs) { return of > 0.0 ? 0.5 * sum / (of * pairs) : 0.0; }

// A regular wave whose height is Hs has a second crest in its trough where S sigma > 1/2: beyond, the expansion means
// nothing. There the weights are lowered, with one warning.
static void limit_weights(sea_shared *shared, double kernel, double variance) {
    const double steep = kernel * sqrt(variance);
    if (!(steep > STEEPEST)) return;
    const double keep = shared->bound_keep = STEEPEST / steep;
    for (uint32_t c = 0; c < shared->cascades; c++) {
        bolan_bound_weights *w = &shared->bound[c];
        w->height *= keep, w->drift *= keep, w->height_long *= keep, w->drift_long *= keep;
    }
    bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_SEA_BOUND_LIMITED,
              "the waves are too high for second order in %.4g m of water: their bound waves are lowered to %.2g of "
              "what theory has",
              shared->desc.sea_state.depth, keep);
}

void bolan_cascades_bound(sea_shared *shared) {
    if (shared->desc.order < 2) return;
    const double depth = shared->desc.sea_state.depth;
    bin bins[BOLAN_MAX_CASCADES][BINS] = {{{0}}};
    double variance = 0.0, kernel = 0.0;
    for (uint32_t c = 0; c < shared->cascades; c++) {
        fill_bins(&cascade_tables_of(shared)->cascade[c], depth, bins[c]);
        variance += variance_of(bins[c]);
    }
    for (uint32_t c = 0; c < shared->cascades; c++) {
        pair_sums own = {0}, shorter = {0};
        add_cascades(bins[c], bins[c], depth, &own);
        for (uint32_t s = c + 1; s < shared->cascades; s++) add_cascades(bins[s], bins[c], depth, &shorter);
        shared->bound[c] = (bolan_bound_weights){.height = share(own.height, own.all, 2.0),
                                                 .drift = share(own.drift, own.square, 2.0),
                                                 .height_long = share(shorter.height, shorter.all, 1.0),
                                                 .drift_long = share(shorter.drift, shorter.square, 1.0)};
        kernel += own.kernel + 2.0 * shorter.kernel;
    }
    shared->bound_keep = 1.0;
    if (variance > 0.0) limit_weights(shared, kernel / (variance * variance), variance);
}
