// SPDX-License-Identifier: MIT
// What the uniform block of the water says of the sea. See sea_gpu.h.
#include "foam_statistics.h"
#include "sea_gpu.h"

#include "shared/cascade.glsl"
#include "shared/constants.glsl"
#include "wave_layers.h"
#include "waves/sum/exp_cosine.h"

#include <math.h>

// ---- cascades -------------------------------------------------------------------------------------------------------

enum { LIFT_OCTAVES = sizeof((water_block *)0)->cascade_lift / sizeof(vec4) }; // from a quarter of a texel up

static void set_lift(water_block *b, const bolan_sea *sea) {
    for (int i = 0; i < LIFT_OCTAVES; ++i) {
        float lift[BOLAN_MAX_CASCADES] = {0};
        for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
            const bolan_cascade_view v = bolan_sea_cascade_layout(sea, c);
            lift[c] = (float)bolan_sea_lift(sea, c, v.length / v.n * exp2(i - 2.0));
        }
        b->cascade_lift[i] = (vec4){lift[0], lift[1], lift[2], lift[3]};
    }
}

// The waves of the warp with their phases at an origin; returns how many.
uint32_t bolan_warp_waves_at(const bolan_sea_warp *warp, bolan_dvec3 origin, vec4 out[BOLAN_WARP_WAVES]) {
    for (uint32_t i = 0; i < warp->count; ++i) {
        const double kx = warp->wave[i].kx, ky = warp->wave[i].ky,
                     turns = kx * origin.x + ky * origin.y + warp->wave[i].phase;
        const double amplitude = (warp->wave[i].ay * kx - warp->wave[i].ax * ky) / (kx * kx + ky * ky);
        out[i] = (vec4){(float)kx, (float)ky, (float)(turns - floor(turns)), (float)amplitude};
    }
    return warp->count;
}

// Where a place stands in a tile, reduced in double so that the GPU never sees a large coordinate. Sample (0, 0) lies
// at the tile's corner, a texture's first texel half a texel inside.
static vec4 place_in_tile(bolan_dvec2 at, double angle, double length, uint32_t n) {
    const double c = cos(angle), s = sin(angle);
    const double u = along_tile(at.x, at.y, c, s) / length, w = across_tile(at.x, at.y, c, s) / length;
    return (vec4){(float)(u - floor(u) + 0.5 / n), (float)(w - floor(w) + 0.5 / n), (float)(c / length),
                  (float)(s / length)};
}

#define FINE_WIDTH 0.6 // of the longest fine wave: a pixel that wide shows none

fine_values bolan_fine_values(const render_view *v) {
    const bolan_sea_fine_view fine = bolan_sea_fine_layout(v->frame->sea);
    if (fine.n == 0) return (fine_values){.widest = 0.0f};
    double unused[4];
    const bolan_dvec2 eye = bolan_sea_place_read(v->frame->sea, v->eye.x, v->eye.y, unused);
    return (fine_values){.tile = place_in_tile(eye, fine.angle, fine.length, fine.n),
                         .slopes = {(float)fine.slopes[0], (float)fine.slopes[1], (float)fine.slopes[2]},
                         .widest = (float)(FINE_WIDTH * 2.0 * BOLAN_PI / fine.k_min),
                         .texel = (float)log2(fine.length / fine.n)};
}

static void set_cascades(water_block *b, const render_view *view) {
    const bolan_sea_warp warp = bolan_sea_get_warp(view->frame->sea);
    double unused[4];
    const bolan_dvec2 eye = bolan_sea_place_read(view->frame->sea, view->eye.x, view->eye.y, unused);
    const bolan_cascade_view first = bolan_sea_cascade_layout(view->frame->sea, 0);
    const bolan_dvec3 still = {view->eye.x - first.origin_x, view->eye.y - first.origin_y, 0.0}; // the water drifts
    b->warp_count = (int)bolan_warp_waves_at(&warp, still, b->warp_wave_of);
    b->warp_at_eye = (bolan_vec2){(float)(eye.x - still.x), (float)(eye.y - still.y)};
    b->cascade_count = (int)bolan_sea_cascade_count(view->frame->sea);
    for (int c = 0; c < b->cascade_count; ++c) {
        bolan_cascade_view v = bolan_sea_cascade_layout(view->frame->sea, (uint32_t)c);
        const double texel = v.length / v.n;
        b->cascade_tile[c] = place_in_tile(eye, v.angle, v.length, v.n);
        b->cascade_band[c] = (vec4){(float)(4.0 * sqrt(v.variance)), (float)texel,
                                    (float)(v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length), (float)log2(texel)};
        b->cascade_bound[c] =
            (vec4){(float)v.bound.height, (float)v.bound.drift, (float)v.bound.height_long, (float)v.bound.drift_long};
    }
    b->foam_weights = bolan_foam_weights(view->frame->sea);
    set_lift(b, view->frame->sea);
}

// ---- sums -----------------------------------------------------------------------------------------------------------

// The phase is reduced in double.
void bolan_sea_wave_at(const render_view *v, uint32_t index, double amplitude_factor, float out[4]) {
    bolan_sea_component w = bolan_sea_get_component(v->frame->sea, index);
    double turns = (w.kx * v->eye.x + w.ky * v->eye.y - w.omega * v->frame->time + w.phase) / (2.0 * BOLAN_PI);
    out[0] = (float)(w.kx / (2.0 * BOLAN_PI));
    out[1] = (float)(w.ky / (2.0 * BOLAN_PI));
    out[2] = (float)(w.amplitude * amplitude_factor);
    out[3] = (float)(turns - floor(turns + 0.5));
}

enum { SLOPE_TERMS = 8 };

// factor * exp(-2 s t) for t in 0..1 as a polynomial through Chebyshev's points, by Newton's divided differences: to
// 1e-5 of the factor at s = 2.
static void fit_slope(double s, double factor, double out[SLOPE_TERMS]) {
    double at[SLOPE_TERMS], difference[SLOPE_TERMS];
    for (int i = 0; i < SLOPE_TERMS; ++i) {
        at[i] = 0.5 - 0.5 * cos(BOLAN_PI * (i + 0.5) / SLOPE_TERMS);
        difference[i] = factor * exp(-2.0 * s * at[i]);
    }
    for (int n = 1; n < SLOPE_TERMS; ++n)
        for (int i = SLOPE_TERMS - 1; i >= n; --i)
            difference[i] = (difference[i] - difference[i - 1]) / (at[i] - at[i - n]);
    for (int i = 0; i < SLOPE_TERMS; ++i) out[i] = 0.0;
    for (int n = SLOPE_TERMS - 1; n >= 0; --n) { // out = out * (t - at[n]) + difference[n]
        for (int i = SLOPE_TERMS - 1; i > 0; --i) out[i] = out[i - 1] - at[n] * out[i];
        out[0] = difference[n] - at[n] * out[0];
    }
}

// What the shader's sum knows of the covariance of slopes. `square`: of a wave of amplitude 1, by its phase [rad], the
// mean square of the derivative.
static void set_sum_slopes(water_block *b, const render_view *view, double amplitude_factor, double square) {
    float total[3];
    bolan_sea_unresolved_slopes(view->frame->sea, 0.0, 0.0, 0.0, total); // what is no part of the waves
    for (uint32_t i = 0; i < bolan_sea_component_count(view->frame->sea); ++i) {
        bolan_sea_component w = bolan_sea_get_component(view->frame->sea, i);
        const double a = w.amplitude * amplitude_factor, v = a * a * square;
        total[0] += (float)(v * w.kx * w.kx);
        total[1] += (float)(v * w.kx * w.ky);
        total[2] += (float)(v * w.ky * w.ky);
    }
    b->wave_slopes = (vec3){total[0], total[1], total[2]};
    b->wave_slope_share = (float)(square * 4.0 * BOLAN_PI * BOLAN_PI);
}

// Liu & Xie 2010, in zero-mean, unit-range form: amplitude * 2 / (1 - e^-2s) * (e^{s (cos th - 1)} - e^-s I0(s)).
static void set_exp_waves(water_block *b, const render_view *v) {
    const double s = bolan_sea_get_desc(v->frame->sea)->exp_cosine.sharpness, range = exp_cosine_scale(s) * exp(s);
    double c[SLOPE_TERMS];
    b->wave_count = (int)bolan_sea_component_count(v->frame->sea);
    for (int i = 0; i < b->wave_count; ++i) {
        float wave[4];
        bolan_sea_wave_at(v, (uint32_t)i, range, wave);
        b->wave_component[i] = (vec4){wave[0], wave[1], wave[2], wave[3]};
    }
    fit_slope(s, -4.0 * BOLAN_PI * s, c);
    for (int i = 0; i < SLOPE_TERMS / 4; ++i)
        b->exp_slope[i] = (vec4){(float)c[4 * i], (float)c[4 * i + 1], (float)c[4 * i + 2], (float)c[4 * i + 3]};
    b->exp_sharpness = (float)s;
    b->exp_mean = (float)(exp(-s) * exp_cosine_mean(s));
    set_sum_slopes(b, v, range, exp(-2.0 * s) * exp_cosine_slope_variance(s));
}

static void set_sum(water_block *b, const render_view *v) {
    b->wave_count = (int)bolan_sea_component_count(v->frame->sea);
    set_sum_slopes(b, v, 1.0, 0.5);
}

// ---- all ------------------------------------------------------------------------------------------------------------

#define EVERY_WAVE 1e6 // standard deviation of a footprint that resolves none [m]

static void set_statistics(water_block *b, const bolan_sea *sea) {
    const bolan_sea_summary *s = bolan_sea_get_summary(sea);
    float total[3];
    bolan_sea_unresolved_slopes(sea, EVERY_WAVE, EVERY_WAVE, 0.0, total);
    b->slope_total = (vec3){total[0], total[1], total[2]};
    b->height_deviation = (float)fmax(0.25 * s->hs, 1e-3);
    b->significant_height = (float)s->hs;
    b->peak_length = (float)bolan_sea_peak_length(s);
    b->shore_height = (float)bolan_sea_surf_height(s);
    b->choppiness = (float)bolan_sea_get_desc(sea)->choppiness;
}

void bolan_sea_gpu_fill(water_block *b, const render_view *v, water_waves waves) {
    set_statistics(b, v->frame->sea);
    b->layer_count = bolan_wave_layers_fill(&v->frame->water, v->eye, b->layer_wave, b->layer_area, b->layer_extent);
    if (v->shore->present) bolan_shore_map_fill(v->shore, b);
    if (waves == WATER_CASCADES) set_cascades(b, v);
    if (waves == WATER_EXP) set_exp_waves(b, v);
    if (bolan_water_waves_have_table(waves)) set_sum(b, v);
    if (waves == WATER_MESH) b->mesh_lift = (float)bolan_sea_lift(v->frame->sea, 0, 0.0);
}
