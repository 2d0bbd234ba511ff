// SPDX-License-Identifier: MIT
// The fine waves: capillary-gravity waves shorter than those of the last cascade, down to 1 cm, in one more tile. They
// have no part in heights and in queries: theirs is a millimetre. Pixels near the eye read their slopes.
//
// Cox & Munk (1954) state the slope variance of a wind. The cascades hold a part of it; slopes.c leaves the rest to the
// roughness of pixels. The fine waves have FINE_SHARE of that rest. It is spread evenly over log k, the law of waves
// that break (Phillips 1958: Psi ~ k^-4), and about the wind so that the up- and crosswind parts keep their ratio:
//
//     k^4 Psi = a (1 + m cos 2 theta) / pi   for |theta| < pi / 2,   theta being the angle to the wind,
//     slope variance a ln(k_max / k_min), of which (1/2 + m / 4) along the wind and (1/2 - m / 4) across.
#include "spectrum/portable.h"
#include "waves/cascades/synth.h"

#define FINE_SHARE 0.9     // of the rest
#define FINE_SHORTEST 0.01 // [m]
#define FINE_LEAST 1.2     // ratio of the ends of a ring that is worth a tile
#define FINE_EDGE 6.0      // modes below the first wave, at least
#define FINE_ANGLE 201.35  // [degrees] from the first tile: no multiple of what lies between the others

// The ring begins where that of the last cascade ends. There is no tile where that is beyond the shortest fine wave.
void bolan_cascade_lay_fine(cascade_tables *t, uint32_t count) {
    const sea_cascade *last = &t->cascade[count - 1];
    sea_cascade *c = &t->fine;
    c->band = &t->fine_band;
    const double ring_end = CASCADE_RING_END * BOLAN_PI * last->n, shortest = 2.0 * BOLAN_PI / FINE_SHORTEST;
    c->k_min = last->k_max;
    c->length = fmax(2.0 * BOLAN_PI * FINE_EDGE / c->k_min, ring_end / shortest);
    c->k_max = fmin(ring_end / c->length, shortest);
    c->angle = t->cascade[0].angle + bolan_radians(FINE_ANGLE);
    bolan_sincos(c->angle, &c->sine, &c->cosine);
    c->n = c->k_max > FINE_LEAST * c->k_min ? last->n : 0;
}

// Up- and crosswind parts of a slope covariance xx, xy, yy.
static void along_wind(const double covariance[3], double c, double s, double *up, double *cross) {
    *up = c * c * covariance[0] + 2.0 * c * s * covariance[1] + s * s * covariance[2];
    *cross = s * s * covariance[0] - 2.0 * c * s * covariance[1] + c * c * covariance[2];
}

static cascade_fine_spectrum spectrum_of(const sea_shared *shared, const sea_cascade *c) {
    cascade_fine_spectrum out = {.a = 0.0};
    double up, cross;
    bolan_sincos(bolan_compass_from_to_math(shared->desc.sea_state.wind_from_deg), &out.sine, &out.cosine);
    along_wind(shared->rest_slope, out.cosine, out.sine, &up, &cross);
    const double rest = up + cross, range = portable_log(c->k_max / c->k_min);
    if (!(rest > 1e-9)) return out;
    const double whole = portable_log(2.0 * BOLAN_PI / FINE_SHORTEST / c->k_min), m = 2.0 * (up - cross) / rest;
    out.m = fmin(fmax(m, -1.0), 1.0);
    const double along = 0.5 + 0.25 * out.m; // neither part may be more than there is
    const double most = fmin(up / along, cross / (1.0 - along));
    out.a = FINE_SHARE * fmin(rest * fmin(range / whole, 1.0), most) / range;
    return out;
}

double bolan_cascade_fine_density(const cascade_fine_spectrum *f, double kx, double ky) {
    const double k2 = kx * kx + ky * ky, along = kx * f->cosine + ky * f->sine;
    if (along <= 0.0) return 0.0;
    return f->a * (1.0 + f->m * (2.0 * along * along / k2 - 1.0)) / (BOLAN_PI * k2 * k2);
}

bool bolan_cascades_create_fine(sea_shared *shared) {
    cascade_tables *t = shared->tables;
    sea_cascade *c = &t->fine;
    if (c->n == 0) return true;
    const cascade_fine_spectrum spectrum = spectrum_of(shared, c);
    return bolan_cascade_fill(shared, c, BOLAN_MAX_CASCADES, NULL, NULL, &spectrum);
}

void bolan_cascades_each_fine(const sea_shared *shared, sea_visit *visit, void *context) {
    const sea_cascade *c = &cascade_tables_of(shared)->fine;
    if (c->n > 0) bolan_sea_each_mode(c, visit, context);
}

// ---- fields ---------------------------------------------------------------------------------------------------------

typedef struct pass {
    const cascade_tables *tables;
    const cascade_fields *fields;
    sea_moment moment;
} pass;

// Tasks: slots [begin, end), each of which has scratch memory of its own and takes every `slots`th strip or block.
static void do_columns(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const pass *p = context;
    const cascade_tables *t = p->tables;
    for (uint32_t slot = begin; slot < end; slot++)
        for (uint32_t strip = slot; strip < t->fine.strips; strip += p->fields->slots)
            t->kernels->columns(&t->columns, &t->fine, &p->fields->fine, &p->moment, SEA_SLOPES, strip,
                                p->fields->scratch + slot * p->fields->scratch_floats);
}

static void do_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const pass *p = context;
    const cascade_tables *t = p->tables;
    for (uint32_t slot = begin; slot < end; slot++)
        for (uint32_t block = slot; block < t->fine.n / SEA_ROWS; block += p->fields->slots)
            t->kernels->rows(t, &t->fine, &p->fields->fine, &p->moment, SEA_SLOPES, block,
                             p->fields->scratch + slot * p->fields->scratch_floats);
}

void bolan_cascades_step_fine(const bolan_sea *sea) {
    const cascade_tables *t = cascade_tables_of(sea->shared);
    if (t->fine.n == 0) return;
    pass p = {t, cascade_fields_of(sea), .moment = {.at = {.shown = sea->shown}, .alone = true}};
    bolan_parallel(p.fields->slots, 1, do_columns, &p);
    bolan_parallel(p.fields->slots, 1, do_rows, &p);
}

bolan_sea_fine_view bolan_cascades_fine(const bolan_sea *sea) {
    const sea_cascade *c = &cascade_tables_of(sea->shared)->fine;
    const sea_planes *p = &cascade_fields_of(sea)->fine;
    bolan_sea_fine_view v = {.n = c->n};
    if (c->n == 0) return v;
    v.length = c->length, v.angle = c->angle;
    v.k_min = c->k_min, v.k_max = c->k_max;
    for (int i = 0; i < 3; i++) v.slopes[i] = c->slope[i];
    v.slope_x = p->slope[0], v.slope_y = p->slope[1];
    v.slope_half = p->slope_half;
    return v;
}
