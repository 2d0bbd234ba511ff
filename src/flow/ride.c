// SPDX-License-Identifier: MIT
// The water at a point to second order.
//
// A pair of a long wave l and a much shorter one s has a potential of second order that tends to -X_l . grad phi_s,
// with X_l the displacement of the long wave: the short wave is carried along. In deep water that is exact for every
// pair along one line, where X_l grows upwards as e^{-kz} instead of downwards. Near the surface k_s X_l is not small,
// so that an expansion in it fails. So each cascade is read where the longer ones have carried it,
//
//     phi = sum over cascades c of  phi_c(x - X_c) + phi2_c(x - X_c),   X_c = displacement of the longer cascades,  (1)
//
// longest first, and phi2_c holds the pairs within the cascade (second.h). The rest follows from (1) to second order:
//
//     velocity       grad phi
//     pressure       -dphi/dt - |grad phi|^2 / 2, and a constant that keeps the mean level
//     acceleration   d/dt grad phi + (velocity . grad) velocity
//
// Above the mean level all is continued along the tangent there.
#include "flow/point.h"
#include "flow/second.h"

// A symmetric tensor, of gradients of a gradient.
typedef struct tensor {
    double xx, xy, yy, xz, yz, zz;
} tensor;

// Displacement and velocity of a band, their gradients, acceleration, and d2Phi/dt2.
typedef struct band_flow {
    double shift[3], velocity[3], acceleration[3], rate;
    tensor strain, shear; // of displacement, of velocity
} band_flow;

static void add_times(const tensor *t, const double v[3], double out[3]) {
    out[0] += t->xx * v[0] + t->xy * v[1] + t->xz * v[2];
    out[1] += t->xy * v[0] + t->yy * v[1] + t->yz * v[2];
    out[2] += t->xz * v[0] + t->yz * v[1] + t->zz * v[2];
}

// The same for a tensor of what grows as e^{-kz}: its derivatives along z have the other sign.
static void take_carried(const tensor *t, const double v[3], double out[3]) {
    double sum[3] = {0.0};
    add_times(t, v, sum);
    out[0] -= sum[0];
    out[1] -= sum[1];
    out[2] += sum[2];
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void add_tensor(const tensor *t, tensor *sum) {
    sum->xx += t->xx, sum->xy += t->xy, sum->yy += t->yy;
    sum->xz += t->xz, sum->yz += t->yz, sum->zz += t->zz;
}

// From derivatives uu, uv, vv along the tile's axes and those of the vertical component, which a potential has.
static void add_turned_tensor(const tile_frame *f, double uu, double uv, double vv, double uz, double vz, tensor *sum) {
    const double c = f->cosine, s = f->sine;
    tensor t = {.xx = uu * c * c - 2.0 * uv * c * s + vv * s * s,
                .xy = (uu - vv) * c * s + uv * (c * c - s * s),
                .yy = uu * s * s + 2.0 * uv * c * s + vv * c * c,
                .zz = -uu - vv};
    add_turned(f, uz, vz, &t.xz, &t.yz);
    add_tensor(&t, sum);
}

// `f` and `g` as flow_kernels.full() has the halves of a texel.
static void add_tile(const flow_tile *t, const flow_weights *w, double keep, float f[6][FLOW_BENT],
                     float g[6][FLOW_BENT], band_flow *out) {
    enum { RATE = FLOW_RATE - FLOW_SPEED };
    const double per = t->frame.n / t->frame.length, k = keep, kper = keep * per, kper2 = kper * per;
    const float *a = w->across, *u = w->up;
    add_turned(&t->frame, k * blend(a, per, f[1], f[0][FLOW_DRIFT]), k * blend(a, per, f[2], f[0][FLOW_DRIFT + 1]),
               &out->shift[0], &out->shift[1]);
    out->shift[2] += k * weigh(u, f[0]);
    add_turned_tensor(&t->frame, kper * blend(a, per, f[3], f[1][FLOW_DRIFT]),
                      kper * blend(a, per, f[4], f[2][FLOW_DRIFT]), kper * blend(a, per, f[5], f[2][FLOW_DRIFT + 1]),
                      k * blend(u, per, f[1], f[0][FLOW_DRIFT]), k * blend(u, per, f[2], f[0][FLOW_DRIFT + 1]),
                      &out->strain);
    add_turned(&t->frame, kper * weigh(a, g[1]), kper * weigh(a, g[2]), &out->velocity[0], &out->velocity[1]);
    out->velocity[2] += k * weigh(u, g[0]);
    add_turned_tensor(&t->frame, kper2 * weigh(a, g[3]), kper2 * weigh(a, g[4]), kper2 * weigh(a, g[5]),
                      kper * weigh(u, g[1]), kper * weigh(u, g[2]), &out->shear);
    add_turned(&t->frame, k * blend(a, per, g[1] + RATE, f[0][FLOW_PUSH]),
               k * blend(a, per, g[2] + RATE, f[0][FLOW_PUSH + 1]), &out->acceleration[0], &out->acceleration[1]);
    out->acceleration[2] += k * weigh(u, g[0] + RATE);
    out->rate += k * weigh(a, g[0] + RATE);
}

// The longer cascades: displacement and velocity as short waves feel them, and the velocity at the point itself.
typedef struct carrier {
    double shift[3], felt[3], velocity[3];
    tensor strain, felt_shear, shear;
} carrier;

typedef struct ride {
    const bolan_flow *flow;
    flow_spot spot;
    double below, smoothing;
    bool rides;
    carrier long_waves;
} ride;

// Where a cascade is read: carried by the longer ones.
static bolan_dvec2 read_at(const ride *r) {
    const double *g = r->spot.gradient, ox = -r->long_waves.shift[0], oy = -r->long_waves.shift[1];
    return (bolan_dvec2){r->spot.read.x + (g[0] * ox + g[1] * oy), r->spot.read.y + (g[2] * ox + g[3] * oy)};
}

static double depth_of(const ride *r) {
    return fmin(r->below + (r->rides ? r->long_waves.shift[2] : 0.0), r->flow->depth);
}

// A band as it is at the depth, and with e^{kz} for e^{-kz}, as shorter waves feel it. False: nothing reaches there.
static bool read_band(const ride *r, uint32_t band, double keep, band_flow *here, band_flow *above) {
    const bolan_dvec2 read = read_at(r);
    const double depth = depth_of(r);
    bool any = false;
    *here = *above = (band_flow){0};
    for (uint32_t i = 0; i < r->flow->tiles; i++) {
        const flow_tile *t = &r->flow->tile[i];
        if (t->band != band) continue;
        flow_weights w, up;
        bolan_flow_weights(&t->levels, r->flow->depth, depth, r->smoothing, &w);
        if (!w.used) continue;
        bolan_flow_weights(&t->levels, r->flow->depth, -depth, r->smoothing, &up);
        const bolan_dvec2 p = place(&t->frame, read.x, read.y);
        float f[12][FLOW_BENT];
        r->flow->kernels->full(t->texels, t->frame.n, p.x, p.y, f);
        add_tile(t, &w, keep, f, f + 6, here);
        add_tile(t, &up, keep, f, f + 6, above);
        any = true;
    }
    return any;
}

static void add_band(const carrier *l, const band_flow *b, flow_water *out) {
    for (int e = 0; e < 3; e++) out->velocity[e] += b->velocity[e], out->acceleration[e] += b->acceleration[e];
    take_carried(&l->strain, b->velocity, out->velocity);
    take_carried(&l->strain, b->acceleration, out->acceleration);
    double slip[3]; // of the short waves' frame beside the water
    for (int e = 0; e < 3; e++) slip[e] = l->velocity[e] - l->felt[e] + b->velocity[e];
    add_times(&b->shear, slip, out->acceleration);
    add_times(&l->shear, b->velocity, out->acceleration);
    take_carried(&l->felt_shear, b->velocity, out->acceleration);
    out->pressure += dot(l->felt, b->velocity) - b->rate;
}

static void carry(const band_flow *here, const band_flow *above, bool rides, carrier *l) {
    for (int e = 0; e < 3; e++) {
        if (e == 2 && !rides) break; // stretching takes its place
        l->shift[e] += above->shift[e];
        l->felt[e] += above->velocity[e];
    }
    for (int e = 0; e < 3; e++) l->velocity[e] += here->velocity[e];
    add_tensor(&above->strain, &l->strain);
    add_tensor(&above->shear, &l->felt_shear);
    add_tensor(&here->shear, &l->shear);
}

// phi2 of a cascade.
static void add_second(const ride *r, const flow_second *s, double keep, flow_water *out) {
    const bolan_dvec2 read = read_at(r), p = place(&s->frame, read.x, read.y);
    const double per = keep * s->frame.n / s->frame.length, depth = depth_of(r);
    float f[6][FLOW_BENT];
    flow_weights w[SECOND_HALVES];
    bool used = false;
    out->pressure += keep * s->head;
    for (int h = 0; h < SECOND_HALVES; h++) {
        bolan_flow_weights(&s->half[h], r->flow->depth, depth, 0.0, &w[h]);
        used |= w[h].used;
    }
    if (!used) return;
    r->flow->kernels->slopes(s->texels, s->frame.n, p.x, p.y, f);
    for (int h = 0; h < SECOND_HALVES; h++) {
        const int l = h * FLOW_LEVELS;
        const float *across = w[h].across, *up = w[h].up;
        add_turned(&s->frame, per * weigh(across, f[1] + l), per * weigh(across, f[2] + l), &out->velocity[0],
                   &out->velocity[1]);
        out->velocity[2] += keep * weigh(up, f[0] + l);
        add_turned(&s->frame, per * weigh(across, f[4] + l), per * weigh(across, f[5] + l), &out->acceleration[0],
                   &out->acceleration[1]);
        out->acceleration[2] += keep * weigh(up, f[3] + l);
        out->pressure -= keep * weigh(across, f[3] + l);
    }
}

static double square(double x) { return x * x; }

void bolan_flow_ride(const bolan_flow *flow, double x, double y, double below, bool rides, double smoothing,
                     const float *keep, const float *share, flow_water *out) {
    ride r = {.flow = flow, .below = below, .smoothing = smoothing, .rides = rides};
    uint32_t second = 0;
    *out = (flow_water){0};
    bolan_flow_spot(flow, x, y, &r.spot);
    for (uint32_t band = 0; band < flow->bands; band++) {
        const double k = (double)keep[band];
        band_flow here, above;
        if (second < flow->seconds && flow->second[second].band == band)
            add_second(&r, &flow->second[second++], square(k * (double)share[band]), out);
        if (k == 0.0 || !read_band(&r, band, k, &here, &above)) continue;
        add_band(&r.long_waves, &here, out);
        carry(&here, &above, rides, &r.long_waves);
    }
    double velocity[3]; // of first order
    for (int e = 0; e < 3; e++) velocity[e] = r.long_waves.velocity[e];
    out->pressure -= 0.5 * dot(velocity, velocity);
}
