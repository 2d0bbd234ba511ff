// SPDX-License-Identifier: MIT
// The lift of a cascade, by equation (1) of waves/lift.c, less the mean of its bound waves.
#include "waves/cascades/cascades.h"

typedef struct pass {
    double averaged[LIFT_LEVELS];
} pass;

typedef struct gathering {
    const sea_cascade *cascade;
    const pass *of; // by the wave number along an axis, 0 .. n/2
    double choppiness;
    const bolan_bound_weights *bound;
} gathering;

static double sinc(double x) {
    double s, c;
    bolan_sincos(x, &s, &c);
    return fabs(x) > 1e-9 ? s / x : 1.0;
}

static void set_pass(const sea_cascade *cascade, uint32_t index, pass *out) {
    const sea_lift *lift = &cascade->band->lift;
    const double k = 2.0 * BOLAN_PI * index / cascade->length;
    for (int l = 0; l < LIFT_LEVELS; l++) {
        const double left = sinc(k * bolan_sea_lift_spacing(lift, l));
        out->averaged[l] = left * left;
    }
}

// The energy is that of the realised amplitudes, because the lift corrects the mean of this sea, not of all seas.
static void add_mode(void *context, const sea_mode *m) {
    const gathering *g = context;
    const sea_cascade *c = g->cascade;
    const double u = m->kx * c->cosine + m->ky * c->sine, v = m->ky * c->cosine - m->kx * c->sine;
    const double scale = c->length / (2.0 * BOLAN_PI);
    const pass *x = &g->of[(uint32_t)(fabs(u) * scale + 0.5)], *y = &g->of[(uint32_t)(fabs(v) * scale + 0.5)];
    const double realised = m->re * m->re + m->im * m->im + m->back_re * m->back_re + m->back_im * m->back_im;
    const double variance = (m->paired ? 2.0 : 1.0) * realised;
    const double square = u * u + v * v, drift = m->inverse_k * sqrt(square);
    const double lift =
        g->choppiness * m->inverse_k * variance * square - variance * bolan_sea_bound_mean(g->bound, drift);
    for (int l = 0; l < LIFT_LEVELS; l++) c->band->lift.level[l] += lift * x->averaged[l] * y->averaged[l];
}

bool bolan_cascade_lift(const sea_cascade *cascade, double choppiness, const bolan_bound_weights *bound) {
    const size_t bytes = (cascade->n / 2 + 1) * sizeof(pass);
    pass *of = bolan_sea_borrow(bytes);
    if (!of) return false;
    cascade->band->lift.finest = LIFT_FIRST_LEVEL * cascade->length / cascade->n;
    for (uint32_t i = 0; i <= cascade->n / 2; i++) set_pass(cascade, i, &of[i]);
    gathering g = {cascade, of, choppiness, bound};
    bolan_sea_each_mode(cascade, add_mode, &g);
    bolan_release(of, bytes);
    return true;
}
