// SPDX-License-Identifier: MIT
// The lift: what keeps the mean of the surface at fixed points at the water level.
//
// Parcels gather at crests, where they stand closer, but a parcel counts by the area that it covers: the Jacobian of
// the horizontal map. With eta = a cos th and choppiness * D = -c a coth(kh) sin th the mean at fixed points is
//
//     <eta J> = <eta (1 + c div D)> = -c k coth(kh) a^2 / 2                                                          (1)
//
// and of a spectrum -c int k coth(kh) S dw, exactly so while nothing folds: the second-order part of J is the product
// of three Gaussians with eta, whose mean is 0. That is the set-down of a "choppy" sea (Nouguier, Guerin & Chapron
// 2009). Every parcel is raised by its opposite.
//
// The surface that is asked and drawn interpolates samples h metres apart, and a coarse grid low-passes it. Of the
// linear interpolation of eta and D the mean (1) keeps, of its part along x,
//
//     sin(kx h) / (kx h) * (2 + cos(ky h)) / 3,                                                                      (2)
//
// and a square of two spacings s, averaged, leaves (sin(kx s)/(kx s) * sin(ky s)/(ky s))^2 of that. So the lift is a
// table over the logarithm of the spacing, one for each cascade. Waves of different lengths do not mix in (1): the
// lifts add.
#include "spectrum/portable.h"
#include "waves/sum.h"

#define FIRST_LEVEL 0.25 // of a cascade's sample distance, or of a sum's shortest wave: a finer grid fades nothing

static double level_spacing(const sea_lift *lift, int level) {
    return level > 0 ? lift->finest * portable_pow(2.0, level / LIFT_PER_OCTAVE) : 0.0;
}

double bolan_sea_lift_at(const sea_lift *lift, double spacing) {
    if (!(spacing > lift->finest) || !(lift->finest > 0.0)) return lift->level[0];
    const double x = LIFT_PER_OCTAVE * portable_log(spacing / lift->finest) / 0.69314718055994531;
    if (x >= LIFT_LEVELS - 1) return 0.0;
    const int i = (int)x;
    return lift->level[i] + (lift->level[i + 1] - lift->level[i]) * (x - i);
}

// ---- cascades -------------------------------------------------------------------------------------------------------

typedef struct pass {
    double interpolated[2]; // of (2): along the axis, and across it
    double averaged[LIFT_LEVELS];
} pass;

typedef struct gathering {
    sea_cascade *cascade;
    const pass *of; // by the wave number along an axis, 0 .. n/2
    double choppiness;
} gathering;

static double sinc(double x) {
    double s, c;
    bolan_sincos(x, &s, &c);
    return fabs(x) > 1e-9 ? s / x : 1.0;
}

static void set_pass(const sea_cascade *cascade, uint32_t index, pass *out) {
    const double k = 2.0 * BOLAN_PI * index / cascade->length, h = cascade->length / cascade->n;
    double s, c;
    bolan_sincos(k * h, &s, &c);
    out->interpolated[0] = sinc(k * h);
    out->interpolated[1] = (2.0 + c) / 3.0;
    for (int l = 0; l < LIFT_LEVELS; l++) {
        const double left = sinc(k * level_spacing(&cascade->lift, l));
        out->averaged[l] = left * left;
    }
}

// The energy is that of the realised amplitudes: one sea's mean is wanted, not that of all seas.
static void add_mode(void *context, const sea_mode *m) {
    const gathering *g = context;
    sea_cascade *c = g->cascade;
    const double u = m->kx * c->cosine + m->ky * c->sine, v = m->ky * c->cosine - m->kx * c->sine;
    const double scale = c->length / (2.0 * BOLAN_PI);
    const pass *x = &g->of[(uint32_t)(fabs(u) * scale + 0.5)], *y = &g->of[(uint32_t)(fabs(v) * scale + 0.5)];
    const double realised = m->re * m->re + m->im * m->im + m->back_re * m->back_re + m->back_im * m->back_im;
    const double variance = (m->paired ? 2.0 : 1.0) * realised;
    const double kept =
        u * u * x->interpolated[0] * y->interpolated[1] + v * v * y->interpolated[0] * x->interpolated[1];
    const double lift = g->choppiness * m->inverse_k * variance * kept;
    for (int l = 0; l < LIFT_LEVELS; l++) c->lift.level[l] += lift * x->averaged[l] * y->averaged[l];
}

static bool lift_cascade(sea_cascade *cascade, double choppiness) {
    const size_t bytes = (cascade->n / 2 + 1) * sizeof(pass);
    pass *of = bolan_sea_borrow(bytes);
    if (!of) return false;
    cascade->lift.finest = FIRST_LEVEL * cascade->length / cascade->n;
    for (uint32_t i = 0; i <= cascade->n / 2; i++) set_pass(cascade, i, &of[i]);
    gathering g = {cascade, of, choppiness};
    bolan_sea_each_mode(cascade, add_mode, &g);
    bolan_release(of, bytes);
    return true;
}

// ---- sums -----------------------------------------------------------------------------------------------------------

// What a grid leaves of a wave's amplitude: as sum_fields.kernel.c.
static double faded(double length, double spacing) {
    const double t = spacing > 0.0 ? 0.5 * length / spacing - 1.0 : 1.0, u = fmin(fmax(t, 0.0), 1.0);
    return u * u * (3.0 - 2.0 * u);
}

static void lift_sum(sea_sum *sum, double choppiness) {
    sea_lift *lift = &sum->lift;
    if (sum->tables.count == 0) return;
    lift->finest = FIRST_LEVEL * (double)sum->tables.wave[sum->tables.count - 1].length;
    for (uint32_t i = 0; i < sum->tables.count; i++) {
        const bolan_sea_component *c = &sum->component[i];
        const double k = sqrt(c->kx * c->kx + c->ky * c->ky), whole = 0.5 * choppiness * c->amplitude * c->drift * k;
        for (int l = 0; l < LIFT_LEVELS; l++) {
            const double keep = faded(2.0 * BOLAN_PI / k, level_spacing(lift, l));
            lift->level[l] += whole * keep * keep;
        }
    }
}

bool bolan_sea_lift_create(bolan_sea *sea) {
    if (sea->sum) lift_sum(sea->sum, sea->desc.choppiness);
    sea->lift = sea->sum ? sea->sum->lift.level[0] : 0.0;
    for (uint32_t i = 0; i < sea->count; i++) {
        if (!lift_cascade(&sea->cascade[i], sea->desc.choppiness)) return false;
        sea->lift += sea->cascade[i].lift.level[0];
    }
    return true;
}

double bolan_sea_lift(const bolan_sea *sea, uint32_t index, double spacing) {
    BOLAN_ASSERT(sea && (sea->sum ? index == 0 : index < sea->count));
    return bolan_sea_lift_at(sea->sum ? &sea->sum->lift : &sea->cascade[index].lift, spacing);
}
