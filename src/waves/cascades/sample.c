// SPDX-License-Identifier: MIT
// The fields of cascades at rest points: bilinear from the planes, filtered for a grid, and from the modes themselves
// as the oracle.
#include "shared/cascade.glsl"
#include "waves/cascades/cascades.h"

// The four samples around a point, and their weights.
typedef struct corners {
    size_t at[4];
    double weight[4];
} corners;

static double fraction(double x) {
    const double f = x - floor(x);
    return f < 1.0 ? f : 0.0; // also 0 for what is not finite
}

static corners corners_of(const sea_cascade *c, double x, double y) {
    const double u = fraction(along_tile(x, y, c->cosine, c->sine) / c->length) * c->n;
    const double v = fraction(across_tile(x, y, c->cosine, c->sine) / c->length) * c->n;
    const uint32_t mask = c->n - 1, i = (uint32_t)u & mask, j = (uint32_t)v & mask;
    const double fu = u - floor(u), fv = v - floor(v);
    const size_t row0 = (size_t)j * c->n, row1 = (size_t)((j + 1) & mask) * c->n;
    const uint32_t next = (i + 1) & mask;
    return (corners){{row0 + i, row0 + next, row1 + i, row1 + next},
                     {(1.0 - fu) * (1.0 - fv), fu * (1.0 - fv), (1.0 - fu) * fv, fu * fv}};
}

static double blend(const float *plane, const corners *k) {
    return (k->weight[0] * plane[k->at[0]] + k->weight[1] * plane[k->at[1]]) +
           (k->weight[2] * plane[k->at[2]] + k->weight[3] * plane[k->at[3]]);
}

// `weight` scales the displacement and slopes; the foam of what is averaged away stays.
static void add_cascade(const sea_cascade *c, const sea_planes *p, double x, double y, double weight,
                        double foam_weight, sea_sums *v) {
    const corners k = corners_of(c, x, y);
    double *const out[SEA_FIELDS] = {&v->height, &v->dx, &v->dy, &v->sx, &v->sy, &v->dxx, &v->dyy, &v->dxy};
    for (int f = 0; f < SEA_FIELDS; f++) *out[f] += weight * blend(p->field[f], &k);
    v->foam += foam_weight * blend(p->foam, &k);
}

void bolan_cascades_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count,
                                bolan_sea_sample *out) {
    const sea_shared *shared = sea->shared;
    const cascade_tables *t = cascade_tables_of(shared);
    const cascade_fields *f = cascade_fields_of(sea);
    const bolan_dvec2 drift = bolan_sea_drift(shared, sea->time);
    for (uint32_t p = 0; p < count; p++) {
        sea_sums v = {.height = shared->lift};
        for (uint32_t i = 0; i < shared->cascades; i++)
            add_cascade(&t->cascade[i], &f->planes[i], points[p].x - drift.x, points[p].y - drift.y, 1.0, 1.0, &v);
        out[p] = bolan_sea_displaced(&v, shared->desc.choppiness);
    }
}

// ---- as a grid can carry it -----------------------------------------------------------------------------------------

enum { MOST_TAPS = 4, FOAM_TAPS = 2, GRAIN_POINTS = 256 }; // taps along a side of the square

// A square of two spacings, averaged, takes a wave of two spacings out and leaves one of four at 0.64. Of a cascade
// that has faded away its foam is left.
static void add_filtered(const sea_cascade *c, const sea_planes *p, bolan_dvec2 at, double spacing, sea_sums *v) {
    const double longest = c->k_min > 0.0 ? 2.0 * BOLAN_PI / c->k_min : c->length;
    const double t = fmin(fmax(spacing > 0.0 ? 0.5 * longest / spacing - 1.0 : 1.0, 0.0), 1.0);
    const double fade = t * t * (3.0 - 2.0 * t), width = 2.0 * spacing;
    const int taps = (int)fmin(fmax(ceil(width * c->n / c->length), 1.0), fade > 0.0 ? MOST_TAPS : FOAM_TAPS);
    const double share = 1.0 / (taps * taps);
    v->height += fade * fade * bolan_sea_lift_at(&c->band->lift, spacing); // a product of two that fade
    for (int j = 0; j < taps; j++) {
        for (int i = 0; i < taps; i++) {
            const double x = at.x + ((i + 0.5) / taps - 0.5) * width, y = at.y + ((j + 0.5) / taps - 0.5) * width;
            if (fade > 0.0) {
                add_cascade(c, p, x, y, fade * share, share, v);
            } else {
                const corners k = corners_of(c, x, y);
                v->foam += share * blend(p->foam, &k);
            }
        }
    }
}

typedef struct grid {
    const bolan_sea *sea;
    const bolan_dvec2 *points;
    const float *spacing;
    bolan_sea_sample *out;
} grid;

// Task: points [begin, end).
static void sample_grid_points(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const grid *g = context;
    const cascade_tables *t = cascade_tables_of(g->sea->shared);
    const cascade_fields *f = cascade_fields_of(g->sea);
    const bolan_dvec2 drift = bolan_sea_drift(g->sea->shared, g->sea->time);
    for (uint32_t p = begin; p < end; p++) {
        const bolan_dvec2 at = {g->points[p].x - drift.x, g->points[p].y - drift.y};
        sea_sums v = {0};
        const double spacing = g->spacing ? (double)g->spacing[p] : 0.0;
        for (uint32_t i = 0; i < g->sea->shared->cascades; i++)
            add_filtered(&t->cascade[i], &f->planes[i], at, spacing, &v);
        g->out[p] = bolan_sea_displaced(&v, g->sea->shared->desc.choppiness);
    }
}

void bolan_cascades_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                                bolan_sea_sample *out) {
    grid g = {sea, points, spacing, out};
    if (count <= GRAIN_POINTS) {
        sample_grid_points(&g, 0, count, 0); // not worth waking anybody
    } else {
        bolan_parallel(count, GRAIN_POINTS, sample_grid_points, &g);
    }
}

// ---- the oracle -----------------------------------------------------------------------------------------------------

typedef struct direct {
    double x, y, time;
    sea_sums *v;
} direct;

static double reduced(double turns) { return 2.0 * BOLAN_PI * (turns - floor(turns + 0.5)); }

// One mode: h e^{i k.x}, to which a paired mode adds its conjugate.
static void add_mode(void *context, const sea_mode *m) {
    direct *d = context;
    double s, c, ps, pc;
    bolan_sincos(reduced(m->turns * d->time), &s, &c);
    bolan_sincos(reduced((m->kx * d->x + m->ky * d->y) / (2.0 * BOLAN_PI)), &ps, &pc);
    const double hr = m->re * c + m->im * s + m->back_re * c - m->back_im * s;
    const double hi = m->im * c - m->re * s + m->back_im * c + m->back_re * s;
    const double twice = m->paired ? 2.0 : 1.0;
    const double re = twice * (hr * pc - hi * ps), im = twice * (hr * ps + hi * pc); // real part, and that of -i
                                                                                     // times it
    const double g = m->inverse_k;
    d->v->height += re;
    d->v->dx -= im * m->kx * g;
    d->v->dy -= im * m->ky * g;
    d->v->sx -= im * m->kx;
    d->v->sy -= im * m->ky;
    d->v->dxx -= re * m->kx * m->kx * g;
    d->v->dyy -= re * m->ky * m->ky * g;
    d->v->dxy -= re * m->kx * m->ky * g;
}

void bolan_cascades_sample_direct(const sea_shared *shared, double x, double y, double shown, sea_sums *out) {
    direct d = {.x = x, .y = y, .time = shown, .v = out};
    bolan_cascades_each_wave(shared, add_mode, &d);
}
