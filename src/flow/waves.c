// SPDX-License-Identifier: MIT
// The flow of a sum of waves, wave by wave. With th = k.x - omega t + phase and C, S the two sides of (3) in tables.h
//
//     Phi = a C / k cos th
//     displacement = a (-k/|k| C sin th, S cos th),  velocity = omega a (k/|k| C cos th, S sin th)
//
// The waves of EXP_COSINE, e^{s cos th} = I0(s) + 2 sum In(s) cos n th (Abramowitz & Stegun 1964, 9.6.34), are sums of
// harmonics that travel with the first: each decays with its own n k.
#include "flow/tables.h"
#include "spectrum/portable.h"
#include "waves/sum/exp_cosine.h"
#include "waves/sum/sum.h"

enum { HARMONICS = 10 };    // of a wave exp(s cos): I10(2) / I1(2) is 2e-8
#define LEAST_HARMONIC 1e-6 // of the first

static void add_wave(bolan_flow *flow, const bolan_sea_desc *desc, const bolan_sea_component *c, double turns, int n,
                     double amplitude) {
    flow_wave *w = &flow->waves[flow->wave_count++];
    w->kx = n * c->kx;
    w->ky = n * c->ky;
    w->k = sqrt(w->kx * w->kx + w->ky * w->ky);
    w->turns = n * turns;
    w->omega = 2.0 * BOLAN_PI * w->turns - w->kx * desc->sea_state.current_x - w->ky * desc->sea_state.current_y;
    w->amplitude = amplitude;
    w->phase = n * c->phase;
    w->norm = 1.0 / (1.0 - portable_exp(-2.0 * w->k * flow->depth));
}

static void add_harmonics(bolan_flow *flow, const bolan_sea_desc *desc, const bolan_sea_component *c, double turns) {
    const double s = desc->exp_cosine.sharpness, scale = 2.0 * c->amplitude * exp_cosine_scale(s);
    const double first = exp_cosine_bessel(1, s);
    for (int n = 1; n <= HARMONICS; n++) {
        const double in = exp_cosine_bessel(n, s);
        if (in < LEAST_HARMONIC * first) break;
        add_wave(flow, desc, c, turns, n, scale * in);
    }
}

bool bolan_flow_create_waves(bolan_flow *flow, const bolan_sea *sea) {
    const sea_sum *sum = sea_sum_of(sea->shared);
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    const uint32_t count = sum->tables.count, each = sum->tables.exponential ? HARMONICS : 1;
    if (count == 0) return true; // a flat calm
    flow->waves = bolan_sea_reserve(&flow->memory, (size_t)count * each * sizeof *flow->waves);
    if (!flow->waves) return false;
    for (uint32_t i = 0; i < count; i++) {
        if (sum->tables.exponential) {
            add_harmonics(flow, desc, &sum->component[i], sum->turns[i]);
        } else {
            add_wave(flow, desc, &sum->component[i], sum->turns[i], 1, sum->component[i].amplitude);
        }
    }
    return true;
}

static double fraction(double x) { return x - floor(x); }

void bolan_flow_evolve_waves(bolan_flow *flow, double shown) {
    for (uint32_t i = 0; i < flow->wave_count; i++) {
        flow_wave *w = &flow->waves[i];
        w->base = fraction(w->phase / (2.0 * BOLAN_PI) - fraction(w->turns * shown));
    }
}

// a C, a S, and the sine and cosine of a wave.
typedef struct motion {
    double across, up, sine, cosine;
} motion;

static motion motion_of(const bolan_flow *flow, const flow_wave *w, const flow_depth *at, double x, double y) {
    motion m;
    const double turns = fraction((w->kx * x + w->ky * y) / (2.0 * BOLAN_PI) + w->base);
    bolan_sincos(2.0 * BOLAN_PI * turns, &m.sine, &m.cosine);
    const double a = w->amplitude * w->norm * bolan_flow_kept(w->k, at->smoothing);
    const double direct = a * portable_exp(-w->k * at->below);
    const double image = a * portable_exp(-w->k * (2.0 * flow->depth - at->below));
    m.across = direct + image;
    m.up = direct - image;
    return m;
}

void bolan_flow_bend_waves(const bolan_flow *flow, const flow_depth *at, double x, double y, flow_bend *out) {
    for (uint32_t i = 0; i < flow->wave_count; i++) {
        const flow_wave *w = &flow->waves[i];
        const motion m = motion_of(flow, w, at, x, y);
        const double ux = w->kx / w->k, uy = w->ky / w->k;
        out->dx -= ux * m.across * m.sine;
        out->dy -= uy * m.across * m.sine;
        out->dxx -= ux * w->kx * m.across * m.cosine;
        out->dyy -= uy * w->ky * m.across * m.cosine;
        out->dxy -= ux * w->ky * m.across * m.cosine;
    }
}

void bolan_flow_motion_waves(const bolan_flow *flow, const flow_depth *at, double x, double y, flow_motion *out) {
    for (uint32_t i = 0; i < flow->wave_count; i++) {
        const flow_wave *w = &flow->waves[i];
        const motion m = motion_of(flow, w, at, x, y);
        const double ux = w->kx / w->k, uy = w->ky / w->k, o = w->omega, o2 = o * o;
        out->height += m.up * m.cosine;
        out->slope_x -= w->kx * m.up * m.sine;
        out->slope_y -= w->ky * m.up * m.sine;
        out->vx += o * ux * m.across * m.cosine;
        out->vy += o * uy * m.across * m.cosine;
        out->vz += o * m.up * m.sine;
        out->ax += o2 * ux * m.across * m.sine;
        out->ay += o2 * uy * m.across * m.sine;
        out->az -= o2 * m.up * m.cosine;
        out->potential -= o2 / w->k * m.across * m.cosine;
    }
}
