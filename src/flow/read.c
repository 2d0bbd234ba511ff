// SPDX-License-Identifier: MIT
// The flow at a point: weights of the levels at its depth, and the gradients of the potentials.
#include "flow/point.h"
#include "spectrum/portable.h"

#include <string.h>

#define NEGLIGIBLE 2e-5f // of a weight, as a share of what the surface has
#define DEAD 14.0        // k d beyond which e^{-kd} is less than that

#define FLOW_DECLARE(set)                                                                             \
    void bolan_flow_bends_##set(const float *, uint32_t, double, double, const flow_weights *, float, \
                                float[FLOW_SUMS]);                                                    \
    void bolan_flow_whole_##set(const float *, uint32_t, double, double, const flow_weights *, float, \
                                float[FLOW_SUMS]);                                                    \
    void bolan_flow_full_##set(const float *, uint32_t, double, double, float[12][FLOW_BENT]);        \
    void bolan_flow_slopes_##set(const float *, uint32_t, double, double, float[6][FLOW_BENT]);
#define FLOW_SET(set) \
    { bolan_flow_bends_##set, bolan_flow_whole_##set, bolan_flow_full_##set, bolan_flow_slopes_##set }

FLOW_DECLARE(scalar)
FLOW_DECLARE(generic4)
#ifdef BOLAN_KERNELS_X86
FLOW_DECLARE(avx2)
FLOW_DECLARE(avx512)
#endif

static const flow_kernels table[] = {
    [BOLAN_CPU_SCALAR] = FLOW_SET(scalar),
    [BOLAN_CPU_GENERIC4] = FLOW_SET(generic4),
#ifdef BOLAN_KERNELS_X86
    [BOLAN_CPU_AVX2] = FLOW_SET(avx2),
    [BOLAN_CPU_AVX512] = FLOW_SET(avx512),
#endif
};

const flow_kernels *bolan_flow_kernels_for(bolan_cpu cpu) {
    const bolan_cpu best = bolan_cpu_best();
    return &table[cpu == BOLAN_CPU_AUTO || cpu > best ? best : cpu];
}

// ---- depths ---------------------------------------------------------------------------------------------------------

// Coefficients of 1 - (1 - e)^4 in e, e^2, e^3, e^4.
static const double binomial[FLOW_ORDER] = {4.0, -6.0, 4.0, -1.0};

double bolan_flow_kept(double k, double smoothing) {
    if (!(smoothing > 0.0)) return 1.0;
    const double e = portable_exp(-k * smoothing);
    return e * (4.0 + e * (-6.0 + e * (4.0 - e)));
}

// Adds `share` of the weights of e^{-kd}; `mirror` is the sign of those of k e^{-kd}: -1 for what the bed mirrors.
static void add_weights(const flow_levels *t, double d, float share, float mirror, flow_weights *out) {
    if (d < 0.0) { // along the tangent at the mean level
        const flow_node *top = &t->node[0];
        for (int l = 0; l < FLOW_LEVELS; l++) {
            out->across[l] += share * (top->across[l] + (float)d * top->across_slope[l]);
            out->up[l] += share * mirror * (top->up[l] + (float)d * top->up_slope[l]);
        }
        return;
    }
    const double x = d / t->finest + 1.0;
    if (!(x < (double)(1 << FLOW_OCTAVES))) return;
    int octave;
    const double mantissa = 2.0 * frexp(x, &octave); // 1..2
    const double cell = (mantissa - 1.0) * FLOW_CELLS;
    const int within = cell < FLOW_CELLS - 1 ? (int)cell : FLOW_CELLS - 1;
    const flow_node *a = &t->node[(octave - 1) * FLOW_CELLS + within], *b = a + 1;
    // Hermite's basis.
    const float f = (float)(cell - within), width = (float)(t->finest * ldexp(1.0 / FLOW_CELLS, octave - 1));
    const float b0 = (1.0f + 2.0f * f) * (1.0f - f) * (1.0f - f), b1 = f * f * (3.0f - 2.0f * f);
    const float s0 = f * (1.0f - f) * (1.0f - f) * width, s1 = f * f * (f - 1.0f) * width;
    for (int l = 0; l < FLOW_LEVELS; l++) {
        out->across[l] +=
            share * (b0 * a->across[l] + b1 * b->across[l] + s0 * a->across_slope[l] + s1 * b->across_slope[l]);
        out->up[l] += share * mirror * (b0 * a->up[l] + b1 * b->up[l] + s0 * a->up_slope[l] + s1 * b->up_slope[l]);
    }
}

// (3) of tables.h: the surface's e^{-kd}, and that of its image below the bed.
static void add_depth(const flow_levels *t, double sea_depth, double d, double farther, float share,
                      flow_weights *out) {
    add_weights(t, d + farther, share, 1.0f, out);
    add_weights(t, 2.0 * sea_depth - d + farther, share, -1.0f, out);
}

static void lay_out(flow_weights *w) {
    for (int l = 0; l < FLOW_LEVELS; l++) {
        w->across_row[FLOW_LEVELS + l] = w->across[l];
        w->up_row[FLOW_LEVELS + l] = w->up[l];
        w->across_deep[FLOW_LEVELS + l] = l > 0 ? w->across[l] : 0.0f;
        w->up_deep[FLOW_LEVELS + l] = l > 0 ? w->up[l] : 0.0f;
    }
    w->across_top[FLOW_ZERO] = w->across[0];
    w->up_top[FLOW_ZERO] = w->up[0];
}

void bolan_flow_weights(const flow_levels *t, double sea_depth, double d, double smoothing, flow_weights *out) {
    memset(out, 0, sizeof *out);
    if (d * t->k_low > DEAD) return;
    if (smoothing > 0.0) {
        for (int i = 0; i < FLOW_ORDER; i++) add_depth(t, sea_depth, d, (i + 1) * smoothing, (float)binomial[i], out);
    } else {
        add_depth(t, sea_depth, d, 0.0, 1.0f, out);
    }
    const float unit = (float)(t->k_low * NEGLIGIBLE);
    for (int l = 0; l < FLOW_LEVELS; l++) {
        if (fabsf(out->across[l]) > NEGLIGIBLE || fabsf(out->up[l]) > unit) out->used = true;
    }
    if (out->used) lay_out(out);
}

void bolan_flow_depth(const bolan_flow *flow, double below, double smoothing, flow_depth *out) {
    out->below = below > 0.0 ? fmin(below, flow->depth) : 0.0;
    out->smoothing = smoothing;
    for (uint32_t i = 0; i < flow->tiles; i++)
        bolan_flow_weights(&flow->tile[i].levels, flow->depth, out->below, smoothing, &out->weights[i]);
}

void bolan_flow_lifts(const bolan_flow *flow, double smoothing, float out[BOLAN_MAX_CASCADES]) {
    for (uint32_t i = 0; i < flow->bands; i++) out[i] = 0.0f;
    for (uint32_t i = 0; i < flow->tiles; i++) {
        double sum = 0.0;
        for (int b = 0; b < FLOW_BINS; b++) {
            const double kept = bolan_flow_kept(flow->tile[i].levels.bin[b].k, smoothing);
            sum += flow->tile[i].levels.bin[b].lift * kept * kept;
        }
        out[flow->tile[i].band] += (float)sum;
    }
    for (uint32_t i = 0; i < flow->wave_count; i++) {
        const flow_wave *w = &flow->waves[i];
        const double kept = bolan_flow_kept(w->k, smoothing), a = w->amplitude * kept;
        out[0] += (float)(0.5 * (double)flow->choppiness * w->k * a * a * (2.0 * w->norm - 1.0)); // coth kH
    }
}

void bolan_flow_shares(const bolan_flow *flow, double smoothing, float out[BOLAN_MAX_CASCADES]) {
    double whole[BOLAN_MAX_CASCADES] = {0.0}, left[BOLAN_MAX_CASCADES] = {0.0};
    for (uint32_t i = 0; i < flow->tiles; i++) {
        const flow_tile *t = &flow->tile[i];
        for (int b = 0; b < FLOW_BINS; b++) {
            const double kept = bolan_flow_kept(t->levels.bin[b].k, smoothing);
            whole[t->band] += t->levels.bin[b].energy;
            left[t->band] += t->levels.bin[b].energy * kept * kept;
        }
    }
    for (uint32_t i = 0; i < flow->bands; i++) out[i] = whole[i] > 0.0 ? (float)sqrt(left[i] / whole[i]) : 1.0f;
}

// ---- points ---------------------------------------------------------------------------------------------------------

// From derivatives by the place read to derivatives by the rest point. The solver takes the mean of the two that differ
// by the warp.
static void unwarp(const double g[4], flow_bend *b) {
    const double xx = b->dxx, xy = b->dxy, yy = b->dyy;
    b->dxx = xx * g[0] + xy * g[2];
    b->dxy = 0.5 * (xx * g[1] + xy * g[3] + xy * g[0] + yy * g[2]);
    b->dyy = xy * g[1] + yy * g[3];
}

static void add_bend(const flow_tile *t, double keep, const float f[FLOW_SUMS], flow_bend *out) {
    const double c = t->frame.cosine, s = t->frame.sine;
    const double uu = keep * (double)f[FLOW_SUM_UU], uv = keep * (double)f[FLOW_SUM_UV];
    const double vv = keep * (double)f[FLOW_SUM_VV];
    add_turned(&t->frame, keep * (double)f[FLOW_SUM_U], keep * (double)f[FLOW_SUM_V], &out->dx, &out->dy);
    out->dxx += uu * c * c - 2.0 * uv * c * s + vv * s * s;
    out->dyy += uu * s * s + 2.0 * uv * c * s + vv * c * c;
    out->dxy += (uu - vv) * c * s + uv * (c * c - s * s);
}

static void add_motion(const flow_tile *t, double keep, const float f[FLOW_SUMS], flow_motion *out) {
    const float *v = f + FLOW_SUM_VELOCITY, *a = f + FLOW_SUM_ACCELERATION;
    out->height += keep * (double)f[FLOW_SUM_HEIGHT];
    add_turned(&t->frame, keep * (double)f[FLOW_SUM_SLOPE_U], keep * (double)f[FLOW_SUM_SLOPE_V], &out->slope_x,
               &out->slope_y);
    add_turned(&t->frame, keep * (double)v[0], keep * (double)v[1], &out->vx, &out->vy);
    out->vz += keep * (double)v[2];
    add_turned(&t->frame, keep * (double)a[0], keep * (double)a[1], &out->ax, &out->ay);
    out->az += keep * (double)a[2];
    out->potential += keep * (double)f[FLOW_SUM_POTENTIAL];
}

static void scale_bend(flow_bend *b, double f) {
    b->dx *= f, b->dy *= f;
    b->dxx *= f, b->dxy *= f, b->dyy *= f;
}

static void scale_motion(flow_motion *m, double f) {
    m->height *= f, m->slope_x *= f, m->slope_y *= f;
    m->vx *= f, m->vy *= f, m->vz *= f;
    m->ax *= f, m->ay *= f, m->az *= f;
    m->potential *= f;
}

static void read_waves(const bolan_flow *flow, const flow_depth *at, double x, double y, double weight, flow_bend *bend,
                       flow_motion *motion) {
    bolan_flow_bend_waves(flow, at, x, y, bend);
    scale_bend(bend, weight);
    if (!motion) return;
    bolan_flow_motion_waves(flow, at, x, y, motion);
    scale_motion(motion, weight);
}

void bolan_flow_spot(const bolan_flow *flow, double x, double y, flow_spot *out) {
    out->at = (bolan_dvec2){x, y};
    out->read = bolan_sea_warped(&flow->warp, x - flow->origin.x, y - flow->origin.y, out->gradient);
}

// Asks for the texels around a place: there are more than a cache holds, and the next tile's are read meanwhile.
static void prefetch_texels(const flow_tile *t, bolan_dvec2 p) {
    const uint32_t mask = t->frame.n - 1, column = (uint32_t)p.x + mask, row = (uint32_t)p.y + mask;
    for (uint32_t j = 0; j < 4; j++)
        for (uint32_t i = 0; i < 4; i++)
            __builtin_prefetch(t->texels +
                               ((size_t)((row + j) & mask) * t->frame.n + ((column + i) & mask)) * FLOW_TEXEL);
}

// The place of the warped plane of a rest point near a spot.
static bolan_dvec2 read_at(const flow_spot *spot, double x, double y) {
    const double *g = spot->gradient, ox = x - spot->at.x, oy = y - spot->at.y;
    return (bolan_dvec2){spot->read.x + (g[0] * ox + g[1] * oy), spot->read.y + (g[2] * ox + g[3] * oy)};
}

void bolan_flow_prefetch(const bolan_flow *flow, const flow_depth *at, const flow_spot *spot, double x, double y) {
    const bolan_dvec2 read = read_at(spot, x, y);
    for (uint32_t i = 0; i < flow->tiles; i++)
        if (at->weights[i].used) prefetch_texels(&flow->tile[i], place(&flow->tile[i].frame, read.x, read.y));
}

static void read_tiles(const bolan_flow *flow, const flow_depth *at, bolan_dvec2 read, const float *weight,
                       flow_bend *bend, flow_motion *motion) {
    bolan_dvec2 p[FLOW_MAX_TILES];
    uint32_t used[FLOW_MAX_TILES], count = 0;
    for (uint32_t i = 0; i < flow->tiles; i++) {
        if (!at->weights[i].used || weight[flow->tile[i].band] == 0.0f) continue;
        p[count] = place(&flow->tile[i].frame, read.x, read.y);
        prefetch_texels(&flow->tile[i], p[count]);
        used[count++] = i;
    }
    for (uint32_t i = 0; i < count; i++) {
        const flow_tile *t = &flow->tile[used[i]];
        const flow_weights *w = &at->weights[used[i]];
        const double keep = (double)weight[t->band];
        const float per = (float)(t->frame.n / t->frame.length);
        float f[FLOW_SUMS];
        if (motion) {
            flow->kernels->whole(t->texels, t->frame.n, p[i].x, p[i].y, w, per, f);
            add_motion(t, keep, f, motion);
        } else {
            flow->kernels->bends(t->texels, t->frame.n, p[i].x, p[i].y, w, per, f);
        }
        add_bend(t, keep, f, bend);
    }
}

void bolan_flow_read(const bolan_flow *flow, const flow_depth *at, const flow_spot *spot, double x, double y,
                     const float *weight, flow_bend *bend, flow_motion *motion) {
    *bend = (flow_bend){0};
    if (motion) *motion = (flow_motion){0};
    if (flow->wave_count > 0) read_waves(flow, at, x, y, (double)weight[0], bend, motion);
    if (flow->tiles == 0) return;
    const double *g = spot->gradient;
    read_tiles(flow, at, read_at(spot, x, y), weight, bend, motion);
    unwarp(g, bend);
    if (!motion) return;
    const double sx = motion->slope_x, sy = motion->slope_y;
    motion->slope_x = sx * g[0] + sy * g[2];
    motion->slope_y = sx * g[1] + sy * g[3];
}
