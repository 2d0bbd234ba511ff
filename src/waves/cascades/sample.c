// SPDX-License-Identifier: MIT
// The fields of cascades at rest points: by cubic splines from the planes, filtered for a grid, and from the modes
// themselves as the oracle.
#include "shared/cascade.glsl"
#include "waves/cascades/cascades.h"
#include "waves/cascades/spline.h"

static double fraction(double x) {
    const double f = x - floor(x);
    return f < 1.0 ? f : 0.0; // also 0 for what is not finite
}

// A place among the samples of a cascade.
typedef struct cell {
    uint32_t i, j;
    double u, v; // fractions
} cell;

static cell cell_of(const sea_cascade *c, double x, double y) {
    const double u = fraction(along_tile(x, y, c->cosine, c->sine) / c->length) * c->n;
    const double v = fraction(across_tile(x, y, c->cosine, c->sine) / c->length) * c->n;
    return (cell){(uint32_t)u & (c->n - 1), (uint32_t)v & (c->n - 1), u - floor(u), v - floor(v)};
}

// The texels around a place, and their weights for the value and for its derivatives along the tile's axes, by metres.
typedef struct spline_taps {
    const bolan_sea_texel *at[16];
    double weight[16], along[16], across[16];
} spline_taps;

static spline_taps taps_of(const sea_cascade *c, const bolan_sea_texel *texels, const cell *at) {
    spline_taps t;
    double wu[4], du[4], wv[4], dv[4];
    SPLINE_WEIGHTS(double, at->u, wu, du);
    SPLINE_WEIGHTS(double, at->v, wv, dv);
    const double scale = c->n / c->length;
    const uint32_t mask = c->n - 1, pitch = c->n + BOLAN_CASCADE_GUARD;
    const bolan_sea_texel *first = texels + (size_t)((at->j - 1) & mask) * pitch + ((at->i - 1) & mask);
    for (uint32_t j = 0; j < 4; j++) {
        for (uint32_t i = 0; i < 4; i++) {
            t.at[4 * j + i] = first + (size_t)j * pitch + i;
            t.weight[4 * j + i] = wu[i] * wv[j];
            t.along[4 * j + i] = du[i] * wv[j] * scale;
            t.across[4 * j + i] = wu[i] * dv[j] * scale;
        }
    }
    return t;
}

// Adds weight times the value to `sum`, and its gradient in world axes to `gradient`. `field`: its offset in a texel.
static void add_spline(const sea_cascade *c, size_t field, const spline_taps *t, double weight, double *sum,
                       double gradient[2]) {
    double value = 0.0, along = 0.0, across = 0.0;
    for (int k = 0; k < 16; k++) {
        const double sample = (double)*(const float *)(const void *)((const char *)t->at[k] + field);
        value += t->weight[k] * sample;
        along += t->along[k] * sample;
        across += t->across[k] * sample;
    }
    *sum += weight * value;
    gradient[0] += weight * (along * c->cosine - across * c->sine);
    gradient[1] += weight * (along * c->sine + across * c->cosine);
}

static double linear(const float *plane, uint32_t n, const cell *at) {
    const size_t row0 = (size_t)at->j * n, row1 = (size_t)((at->j + 1) & (n - 1)) * n;
    const uint32_t next = (at->i + 1) & (n - 1);
    return mix(mix(plane[row0 + at->i], plane[row0 + next], at->u), mix(plane[row1 + at->i], plane[row1 + next], at->u),
               at->v);
}

// What is summed over the cascades at a place of the warped plane; gradients by that place.
typedef struct spline_sums {
    double height, dx, dy, foam;
    double slope[2], east[2], north[2]; // gradients of height, dx, dy
} spline_sums;

// ---- bound waves ----------------------------------------------------------------------------------------------------

// bolan_bound_weights: height and gradient so far, and the weighted sums over the longer cascades.
typedef struct bound_sums {
    double height, slope[2];
    spline_sums longer;
} bound_sums;

// Adds those of a cascade whose fields are `f`; cascades come longest first.
static void add_bound(const bolan_bound_weights *w, const spline_sums *f, bound_sums *b) {
    spline_sums *l = &b->longer;
    const double height = w->height * f->height + l->height, dx = w->drift * f->dx + l->dx,
                 dy = w->drift * f->dy + l->dy;
    b->height += f->height * height + (f->dx * dx + f->dy * dy);
    for (int e = 0; e < 2; e++) {
        b->slope[e] += f->slope[e] * (height + w->height * f->height) + f->height * l->slope[e];
        b->slope[e] += f->east[e] * (dx + w->drift * f->dx) + f->dx * l->east[e];
        b->slope[e] += f->north[e] * (dy + w->drift * f->dy) + f->dy * l->north[e];
    }
    l->height += w->height_long * f->height;
    l->dx += w->drift_long * f->dx;
    l->dy += w->drift_long * f->dy;
    for (int e = 0; e < 2; e++) {
        l->slope[e] += w->height_long * f->slope[e];
        l->east[e] += w->drift_long * f->east[e];
        l->north[e] += w->drift_long * f->north[e];
    }
}

// Adds the fields of a cascade to `sum`, with their bound waves to `b`.
static void add_fields(const sea_shared *shared, uint32_t cascade, const spline_sums *f, bound_sums *b,
                       spline_sums *sum) {
    add_bound(&shared->bound[cascade], f, b);
    sum->height += f->height;
    sum->dx += f->dx;
    sum->dy += f->dy;
    sum->foam += f->foam;
    for (int e = 0; e < 2; e++) {
        sum->slope[e] += f->slope[e];
        sum->east[e] += f->east[e];
        sum->north[e] += f->north[e];
    }
}

static void add_bound_waves(const bound_sums *b, spline_sums *sum) {
    sum->height += b->height;
    sum->slope[0] += b->slope[0];
    sum->slope[1] += b->slope[1];
}

// `weight` scales the displacement; the foam of what is averaged away stays.
static void add_cascade(const sea_cascade *c, const sea_planes *p, bolan_dvec2 place, double weight, double foam_weight,
                        spline_sums *v) {
    const cell at = cell_of(c, place.x, place.y);
    v->foam += foam_weight * linear(p->foam, c->n, &at);
    if (weight == 0.0) return;
    const spline_taps t = taps_of(c, p->displacement, &at);
    add_spline(c, offsetof(bolan_sea_texel, height), &t, weight, &v->height, v->slope);
    add_spline(c, offsetof(bolan_sea_texel, dx), &t, weight, &v->dx, v->east);
    add_spline(c, offsetof(bolan_sea_texel, dy), &t, weight, &v->dy, v->north);
}

// The chain rule: from gradients by the place read to gradients by the rest point.
static sea_sums unwarped(const spline_sums *v, const double g[4]) {
    return (sea_sums){.height = v->height,
                      .dx = v->dx,
                      .dy = v->dy,
                      .foam = v->foam,
                      .sx = v->slope[0] * g[0] + v->slope[1] * g[2],
                      .sy = v->slope[0] * g[1] + v->slope[1] * g[3],
                      .dxx = v->east[0] * g[0] + v->east[1] * g[2],
                      .dxy = v->east[0] * g[1] + v->east[1] * g[3],
                      .dyx = v->north[0] * g[0] + v->north[1] * g[2],
                      .dyy = v->north[0] * g[1] + v->north[1] * g[3]};
}

void bolan_cascades_sample_rest(const bolan_sea *sea, const bolan_dvec2 *points, uint32_t count,
                                bolan_sea_sample *out) {
    const sea_shared *shared = sea->shared;
    const cascade_tables *t = cascade_tables_of(shared);
    const cascade_fields *f = cascade_fields_of(sea);
    const bolan_dvec2 drift = bolan_sea_drift(shared, sea->time);
    for (uint32_t p = 0; p < count; p++) {
        double gradient[4];
        const bolan_dvec2 place =
            bolan_sea_warped(&shared->warp, points[p].x - drift.x, points[p].y - drift.y, gradient);
        spline_sums v = {.height = shared->lift};
        bound_sums b = {0};
        for (uint32_t i = 0; i < shared->cascades; i++) {
            spline_sums one = {0};
            add_cascade(&t->cascade[i], &f->planes[i], place, 1.0, 1.0, &one);
            add_fields(shared, i, &one, &b, &v);
        }
        add_bound_waves(&b, &v);
        const sea_sums sums = unwarped(&v, gradient);
        out[p] = bolan_sea_displaced(&sums, shared->desc.choppiness);
    }
}

void bolan_sea_bound_at(const bolan_sea *sea, bolan_dvec2 rest, const float *keep, double *height, double slope[2]) {
    bolan_sea_fields(sea);
    const cascade_fields *f = cascade_fields_of(sea);
    const bolan_dvec2 drift = bolan_sea_drift(sea->shared, sea->time);
    double gradient[4];
    const bolan_dvec2 place = bolan_sea_warped(&sea->shared->warp, rest.x - drift.x, rest.y - drift.y, gradient);
    bound_sums b = {0};
    spline_sums all = {0};
    for (uint32_t i = 0; i < sea->shared->cascades; i++) {
        spline_sums one = {0};
        add_cascade(&cascade_tables_of(sea->shared)->cascade[i], &f->planes[i], place, (double)keep[i], 0.0, &one);
        add_bound(&sea->shared->bound[i], &one, &b);
    }
    add_bound_waves(&b, &all);
    const sea_sums sums = unwarped(&all, gradient);
    *height = sums.height;
    slope[0] = sums.sx;
    slope[1] = sums.sy;
}

// ---- as a grid can carry it -----------------------------------------------------------------------------------------

enum { MOST_TAPS = 4, FOAM_TAPS = 2, GRAIN_POINTS = 256 }; // taps along a side of the square

double bolan_cascade_fade(double k_min, double length, double spacing) {
    const double longest = k_min > 0.0 ? 2.0 * BOLAN_PI / k_min : length;
    const double t = fmin(fmax(spacing > 0.0 ? 0.5 * longest / spacing - 1.0 : 1.0, 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// A square of two spacings, averaged, takes a wave of two spacings out and leaves one of four at 0.64. Of a cascade
// that has faded away its foam is left.
static void add_filtered(const sea_cascade *c, const sea_planes *p, bolan_dvec2 at, double spacing, double *lift,
                         spline_sums *v) {
    const double fade = bolan_cascade_fade(c->k_min, c->length, spacing), width = 2.0 * spacing;
    const int taps = (int)fmin(fmax(ceil(width * c->n / c->length), 1.0), fade > 0.0 ? MOST_TAPS : FOAM_TAPS);
    const double share = 1.0 / (taps * taps);
    *lift += fade * fade * bolan_sea_lift_at(&c->band->lift, spacing); // a product of two that fade
    for (int j = 0; j < taps; j++) {
        for (int i = 0; i < taps; i++) {
            const bolan_dvec2 tap = {at.x + ((i + 0.5) / taps - 0.5) * width, at.y + ((j + 0.5) / taps - 0.5) * width};
            add_cascade(c, p, tap, fade * share, share, v);
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
    const sea_shared *shared = g->sea->shared;
    const cascade_tables *t = cascade_tables_of(shared);
    const cascade_fields *f = cascade_fields_of(g->sea);
    const bolan_dvec2 drift = bolan_sea_drift(shared, g->sea->time);
    for (uint32_t p = begin; p < end; p++) {
        double gradient[4];
        const bolan_dvec2 place =
            bolan_sea_warped(&shared->warp, g->points[p].x - drift.x, g->points[p].y - drift.y, gradient);
        spline_sums v = {0};
        const double spacing = g->spacing ? (double)g->spacing[p] : 0.0;
        bound_sums b = {0};
        for (uint32_t i = 0; i < shared->cascades; i++) {
            spline_sums one = {0};
            add_filtered(&t->cascade[i], &f->planes[i], place, spacing, &v.height, &one);
            add_fields(shared, i, &one, &b, &v);
        }
        add_bound_waves(&b, &v);
        const sea_sums sums = unwarped(&v, gradient);
        g->out[p] = bolan_sea_displaced(&sums, shared->desc.choppiness);
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
    spline_sums *v;
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
    d->v->slope[0] -= im * m->kx;
    d->v->slope[1] -= im * m->ky;
    d->v->east[0] -= re * m->kx * m->kx * g;
    d->v->east[1] -= re * m->kx * m->ky * g;
    d->v->north[0] -= re * m->ky * m->kx * g;
    d->v->north[1] -= re * m->ky * m->ky * g;
}

void bolan_cascades_sample_direct(const sea_shared *shared, bolan_dvec2 at, bolan_dvec2 drift, double shown,
                                  sea_sums *out) {
    double gradient[4];
    const bolan_dvec2 place = bolan_sea_warped(&shared->warp, at.x - drift.x, at.y - drift.y, gradient);
    spline_sums v = {.height = out->height};
    bound_sums b = {0};
    for (uint32_t i = 0; i < shared->cascades; i++) {
        spline_sums one = {0};
        direct d = {.x = place.x, .y = place.y, .time = shown, .v = &one};
        bolan_sea_each_mode(&cascade_tables_of(shared)->cascade[i], add_mode, &d);
        add_fields(shared, i, &one, &b, &v);
    }
    add_bound_waves(&b, &v);
    *out = unwarped(&v, gradient);
}
