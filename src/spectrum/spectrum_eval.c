// SPDX-License-Identifier: MIT
// Densities of a whole sea state. See spectrum_eval.h.
#include "spectrum/spectrum_eval.h"

#include "bolan/math.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"

spectrum_eval bolan_spectrum_eval_prepare(const bolan_sea_state *sea_state) {
    spectrum_eval eval = {.measured = sea_state->measured, .measured_level = 1.0, .depth = sea_state->depth};
    eval.current_x = sea_state->current_x;
    eval.current_y = sea_state->current_y;
    eval.frame = sea_state->frame;
    eval.on_current = eval.frame != BOLAN_FRAME_WATER && (eval.current_x != 0.0 || eval.current_y != 0.0);
    for (uint32_t i = 0; i < sea_state->system_count && i < BOLAN_MAX_WAVE_SYSTEMS; i++) {
        if (!(sea_state->systems[i].hs > 0.0)) continue;
        const spectrum_system system = bolan_spectrum_system_prepare(&sea_state->systems[i]);
        eval.any_depth_limited |= system.depth_limited;
        eval.systems[eval.system_count++] = system;
    }
    return eval;
}

void bolan_spectrum_eval_scale(spectrum_eval *eval, double factor) {
    for (uint32_t i = 0; i < eval->system_count; i++) eval->systems[i].level *= factor * factor;
    eval->measured_level *= factor * factor;
}

static double measured_density(const spectrum_eval *eval, double omega, double theta, bool with_tail) {
    return eval->measured_level * bolan_spectrum_measured_density(eval->measured, omega, theta, with_tail);
}

double bolan_spectrum_relative_depth(const spectrum_eval *eval, double omega) {
    return eval->any_depth_limited ? eval->depth * bolan_k_from_omega(omega, eval->depth) : 0.0;
}

// The sum over systems for a wave that goes along the unit vector (ux, uy).
static double systems_density(const spectrum_eval *eval, double omega, double kh, double ux, double uy) {
    double sum = 0.0;
    for (uint32_t i = 0; i < eval->system_count; i++) {
        const spectrum_system *system = &eval->systems[i];
        const double density = bolan_spectrum_system_density(system, omega, kh);
        if (density > 0.0)
            sum += density * bolan_spectrum_system_spreading(system, omega, ux * system->to_x + uy * system->to_y);
    }
    return sum;
}

double bolan_spectrum_eval_psi(const spectrum_eval *eval, double kx, double ky) {
    const double k = sqrt(kx * kx + ky * ky);
    if (!(k > 0.0)) return 0.0;
    // w and dw/dk as in dispersion.c, sharing the tanh.
    const double kh = k * eval->depth, t = portable_tanh(kh), tension = BOLAN_SURFACE_TENSION_SEA * k * k;
    const double omega = sqrt((BOLAN_GRAVITY + tension) * k * t);
    const double slope = (BOLAN_GRAVITY + 3.0 * tension) * t + (BOLAN_GRAVITY + tension) * kh * (1.0 - t * t);
    double seen = omega, factor = 1.0, seen_kh = kh;
    if (eval->on_current) {
        const spectrum_seen s = bolan_spectrum_seen(eval, omega, k, slope / (2.0 * omega), kx / k, ky / k);
        if (!(s.factor > 0.0)) return 0.0;
        seen = s.omega;
        factor = s.factor;
        seen_kh = bolan_spectrum_relative_depth(eval, seen);
    }
    double density = systems_density(eval, seen, seen_kh, kx / k, ky / k);
    if (eval->measured) density += measured_density(eval, seen, portable_angle(ky, kx), true);
    return density * factor * slope / (2.0 * omega * k);
}

double bolan_sea_state_wavenumber_density(const bolan_sea_state *sea_state, double kx, double ky) {
    const spectrum_eval eval = bolan_spectrum_eval_prepare(sea_state);
    return bolan_spectrum_eval_psi(&eval, kx, ky);
}

static double density_as_given(const spectrum_eval *eval, double omega, double ux, double uy) {
    double density = systems_density(eval, omega, bolan_spectrum_relative_depth(eval, omega), ux, uy);
    if (eval->measured) density += measured_density(eval, omega, portable_angle(uy, ux), false);
    return density;
}

double bolan_spectrum_eval_density(const spectrum_eval *eval, double omega, double ux, double uy) {
    if (!eval->on_current) return density_as_given(eval, omega, ux, uy);
    const double k = bolan_k_from_omega(omega, eval->depth);
    const spectrum_seen seen = bolan_spectrum_seen(eval, omega, k, bolan_group_speed(k, eval->depth), ux, uy);
    return seen.factor > 0.0 ? seen.factor * density_as_given(eval, seen.omega, ux, uy) : 0.0;
}

double bolan_sea_state_density(const bolan_sea_state *sea_state, double omega, double theta) {
    if (!(omega > 0.0)) return 0.0;
    const spectrum_eval eval = bolan_spectrum_eval_prepare(sea_state);
    double ux, uy;
    bolan_sincos(theta, &uy, &ux);
    return bolan_spectrum_eval_density(&eval, omega, ux, uy);
}

double bolan_system_density(const bolan_wave_system *system, double omega, double depth) {
    if (!(omega > 0.0)) return 0.0;
    const spectrum_system prepared = bolan_spectrum_system_prepare(system);
    return bolan_spectrum_system_density(&prepared, omega,
                                         prepared.depth_limited ? depth * bolan_k_from_omega(omega, depth) : 0.0);
}

double bolan_system_spreading(const bolan_wave_system *system, double omega, double theta) {
    if (!(omega > 0.0)) return 0.0;
    const spectrum_system prepared = bolan_spectrum_system_prepare(system);
    double sine, cosine;
    bolan_sincos(theta, &sine, &cosine);
    return bolan_spectrum_system_spreading(&prepared, omega, cosine);
}
