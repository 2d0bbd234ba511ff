// SPDX-License-Identifier: MIT
// A wave train as a layer. Formula: shaders/shared/wave_train.glsl; drawn by shaders/common/layers.glsl.
#include "water/layer.h"

#include "shared/wave_train.glsl"
#include "spectrum/portable.h"

#include <math.h>

#define MICHE 0.142 // greatest steepness of a wave in deep water: Miche 1944

// A place from the centre [m], and in the train's own axes over the half extents.
typedef struct train_place {
    double x, y, along, across;
} train_place;

static train_place place_in(const bolan_wave_layer *w, double x, double y) {
    const bolan_wave_train_desc *d = &w->train;
    const double px = x - d->centre.x, py = y - d->centre.y;
    const double along = (px * w->c + py * w->s) / d->half_length, across = (py * w->c - px * w->s) / d->half_width;
    return (train_place){px, py, along, across};
}

static void sample(const bolan_wave_layer *w, double time, uint32_t count, const double *x, const double *y,
                   bolan_wave_layer_sample *out) {
    const bolan_wave_train_desc *d = &w->train;
    const double amplitude = 0.5 * d->height;
    for (uint32_t i = 0; i < count; ++i) {
        const train_place p = place_in(w, x[i], y[i]);
        const double e = train_edge(p.along, d->edge), f = train_edge(p.across, d->edge);
        double sine, cosine;
        bolan_sincos(remainder(w->kx * p.x + w->ky * p.y - w->omega * time + w->phase, 2.0 * BOLAN_PI), &sine, &cosine);
        // The gradient of the envelope, in the axes of the train.
        const double ea = train_edge_slope(p.along, d->edge) * f / d->half_length;
        const double ec = train_edge_slope(p.across, d->edge) * e / d->half_width;
        out[i].height = (float)(amplitude * e * f * cosine);
        out[i].slope_x = (float)(amplitude * ((ea * w->c - ec * w->s) * cosine - e * f * w->kx * sine));
        out[i].slope_y = (float)(amplitude * ((ea * w->s + ec * w->c) * cosine - e * f * w->ky * sine));
    }
}

// e^{-ka} / (1 - e^{-2kH}): two of these are cosh k(H - d) / sinh kH and sinh k(H - d) / sinh kH, as in flow/tables.h.
static double decayed(double k, double depth, double a) {
    return portable_exp(-k * a) / (1.0 - portable_exp(-2.0 * k * depth));
}

// Linear theory with the period that the train was given, its edges as constants.
static void flow(const bolan_wave_layer *w, double time, double x, double y, double below, wave_layer_flow *out) {
    const bolan_wave_train_desc *d = &w->train;
    const double k = 2.0 * BOLAN_PI / d->length, o = w->omega;
    const train_place p = place_in(w, x, y);
    const double a = 0.5 * d->height * train_edge(p.along, d->edge) * train_edge(p.across, d->edge);
    const double deep = fmin(below, d->depth);
    const double direct = decayed(k, d->depth, deep), image = decayed(k, d->depth, 2.0 * d->depth - deep);
    const double level = a * (direct + image), upright = a * (direct - image);
    double s, c;
    bolan_sincos(remainder(w->kx * p.x + w->ky * p.y - o * time + w->phase, 2.0 * BOLAN_PI), &s, &c);
    *out = (wave_layer_flow){
        .vx = o * level * w->c * c,
        .vy = o * level * w->s * c,
        .vz = o * upright * s,
        .ax = o * o * level * w->c * s,
        .ay = o * o * level * w->s * s,
        .az = -o * o * upright * c,
        .potential = -o * o / k * level * c,
    };
}

static const wave_layer_kind train_kind = {.sample = sample, .flow = flow};

static bolan_result check(const bolan_wave_train_desc *d) {
    const bolan_result result = bolan_params_validate(&bolan_wave_train_params, d, "bolan_wave_train_desc");
    if (result != BOLAN_OK) return result;
    const double most = MICHE * d->length * tanh(2.0 * BOLAN_PI * d->depth / d->length);
    if (d->height <= most) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_LAYER_STEEP,
              "bolan_wave_train_desc: height is %g m; waves of %g m in %g m of water break above %.3g m (Miche 1944)",
              d->height, d->length, d->depth, most);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_wave_layer_create_train(const bolan_wave_train_desc *desc, bolan_wave_layer **out) {
    BOLAN_ASSERT(desc && out);
    *out = NULL;
    const bolan_result result = check(desc);
    if (result != BOLAN_OK) return result;
    bolan_wave_layer *w = bolan_allocate(sizeof *w);
    if (w == NULL) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a wave layer");
        return BOLAN_ERROR_MEMORY;
    }
    const double k = 2.0 * BOLAN_PI / desc->length;
    *w =
        (bolan_wave_layer){.kind = &train_kind, .bound = 0.5 * desc->height, .hs = (float)desc->height, .train = *desc};
    w->omega = desc->period > 0.0 ? 2.0 * BOLAN_PI / desc->period : bolan_omega_from_k(k, desc->depth);
    w->train.period = 2.0 * BOLAN_PI / w->omega;
    w->phase = bolan_radians(desc->phase_deg);
    bolan_sincos(bolan_compass_from_to_math(desc->from_deg), &w->s, &w->c);
    w->kx = k * w->c;
    w->ky = k * w->s;
    *out = w;
    return BOLAN_OK;
}
