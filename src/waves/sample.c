// SPDX-License-Identifier: MIT
// The fields at rest points: bilinear from the planes, filtered for a grid, and from the modes themselves as the oracle.
#include "waves/sum.h"

#define STEEPEST 0.1 // smallest |Jacobian| that a slope is divided by: where the surface folds it is vertical

bolan_sea_sample bolan_sea_displaced(const sea_sums *v, double choppiness) {
    const double xx = 1.0 + choppiness * v->dxx, yy = 1.0 + choppiness * v->dyy, xy = choppiness * v->dxy;
    const double jacobian = xx * yy - xy * xy;
    const double divisor = fabs(jacobian) > STEEPEST ? jacobian : jacobian < 0.0 ? -STEEPEST : STEEPEST;
    return (bolan_sea_sample){
        .height = (float)v->height,
        .dx = (float)(choppiness * v->dx),
        .dy = (float)(choppiness * v->dy),
        .slope_x = (float)((v->sx * yy - v->sy * xy) / divisor),
        .slope_y = (float)((v->sy * xx - v->sx * xy) / divisor),
        .jacobian = (float)jacobian,
        .foam = (float)v->foam,
    };
}

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
    const double u = fraction((x * c->cosine + y * c->sine) / c->length) * c->n;
    const double v = fraction((y * c->cosine - x * c->sine) / c->length) * c->n;
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
static void add_cascade(const sea_cascade *c, double x, double y, double weight, double foam_weight, sea_sums *v) {
    const corners k = corners_of(c, x, y);
    double *const out[SEA_FIELDS] = {&v->height, &v->dx, &v->dy, &v->sx, &v->sy, &v->dxx, &v->dyy, &v->dxy};
    for (int f = 0; f < SEA_FIELDS; f++) *out[f] += weight * blend(c->field[f], &k);
    v->foam += foam_weight * blend(c->foam, &k);
}

void bolan_sea_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count, bolan_sea_sample *out) {
    BOLAN_ASSERT(sea && (count == 0 || (points && out)));
    if (sea->sum) {
        bolan_sea_sum_sample(sea, points, NULL, count, out);
        return;
    }
    for (uint32_t p = 0; p < count; p++) {
        sea_sums v = {.height = sea->lift};
        for (uint32_t i = 0; i < sea->count; i++) add_cascade(&sea->cascade[i], points[p].x, points[p].y, 1.0, 1.0, &v);
        out[p] = bolan_sea_displaced(&v, sea->desc.choppiness);
    }
}

// ---- as a grid can carry it -----------------------------------------------------------------------------------------

enum { MOST_TAPS = 4, FOAM_TAPS = 2, GRAIN_POINTS = 256 }; // taps along a side of the square

// A square of two spacings, averaged, takes a wave of two spacings out and leaves one of four at 0.64. Of a cascade that has
// faded away its foam is left.
static void add_filtered(const sea_cascade *c, bolan_dvec2 at, double spacing, sea_sums *v) {
    const double longest = c->k_min > 0.0 ? 2.0 * BOLAN_PI / c->k_min : c->length;
    const double t = fmin(fmax(spacing > 0.0 ? 0.5 * longest / spacing - 1.0 : 1.0, 0.0), 1.0);
    const double fade = t * t * (3.0 - 2.0 * t), width = 2.0 * spacing;
    const int taps = (int)fmin(fmax(ceil(width * c->n / c->length), 1.0), fade > 0.0 ? MOST_TAPS : FOAM_TAPS);
    const double share = 1.0 / (taps * taps);
    v->height += fade * fade * bolan_sea_lift_at(&c->lift, spacing); // a product of two that fade
    for (int j = 0; j < taps; j++) {
        for (int i = 0; i < taps; i++) {
            const double x = at.x + ((i + 0.5) / taps - 0.5) * width, y = at.y + ((j + 0.5) / taps - 0.5) * width;
            if (fade > 0.0) {
                add_cascade(c, x, y, fade * share, share, v);
            } else {
                const corners k = corners_of(c, x, y);
                v->foam += share * blend(c->foam, &k);
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
    for (uint32_t p = begin; p < end; p++) {
        sea_sums v = {0};
        for (uint32_t i = 0; i < g->sea->count; i++)
            add_filtered(&g->sea->cascade[i], g->points[p], g->spacing ? (double)g->spacing[p] : 0.0, &v);
        g->out[p] = bolan_sea_displaced(&v, g->sea->desc.choppiness);
    }
}

void bolan_sea_sample_grid(const bolan_sea *sea, const bolan_dvec2 *points, const float *spacing, uint32_t count,
                           bolan_sea_sample *out) {
    BOLAN_ASSERT(sea && (count == 0 || (points && out)));
    if (sea->sum) {
        bolan_sea_sum_sample(sea, points, spacing, count, out);
        return;
    }
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
    sea_sums v;
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
    d->v.height += re;
    d->v.dx -= im * m->kx * g;
    d->v.dy -= im * m->ky * g;
    d->v.sx -= im * m->kx;
    d->v.sy -= im * m->ky;
    d->v.dxx -= re * m->kx * m->kx * g;
    d->v.dyy -= re * m->ky * m->ky * g;
    d->v.dxy -= re * m->kx * m->ky * g;
}

bolan_sea_sample bolan_sea_sample_direct(const bolan_sea *sea, double x, double y, double time) {
    BOLAN_ASSERT(sea && isfinite(time));
    direct d = {.x = x, .y = y, .time = bolan_sea_shown_time(sea, time, NULL), .v.height = sea->lift};
    if (sea->sum) bolan_sea_sum_direct(sea, x, y, d.time, &d.v);
    for (uint32_t i = 0; i < sea->count; i++) bolan_sea_each_mode(&sea->cascade[i], add_mode, &d);
    return bolan_sea_displaced(&d.v, sea->desc.choppiness);
}
