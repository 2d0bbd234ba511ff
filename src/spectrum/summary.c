// SPDX-License-Identifier: MIT Integral parameters. The moments of wave systems are integrated over ln w (Simpson),
// those of a measured spectrum on its own frequencies (trapezoid rule), so that they can be compared with the
// values that the maker of the file prints.
#include "bolan/math.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

#include <math.h>

typedef struct moments {
    double minus1, m0, m1, m2; // of w
    double cosine, sine;       // m0 times the mean unit vector
} moments;

static void add_sample(moments *sum, double density, double omega, double weight) {
    const double d = density * weight;
    sum->minus1 += d / omega;
    sum->m0 += d;
    sum->m1 += d * omega;
    sum->m2 += d * omega * omega;
}

// S(w) of one row of the grid, with its direction sums.
static double row_density(const bolan_measured_spectrum *measured, uint32_t row, double *cosine_sum, double *sine_sum) {
    double sum = 0.0, c = 0.0, s = 0.0;
    for (uint32_t j = 0; j < measured->direction_count; j++) {
        const double density = measured->density[row * measured->direction_count + j];
        sum += density;
        double sine, cosine;
        bolan_sincos(measured->theta[j], &sine, &cosine);
        c += density * cosine;
        s += density * sine;
    }
    *cosine_sum = c * measured->direction_step;
    *sine_sum = s * measured->direction_step;
    return sum * measured->direction_step;
}

static void add_measured(moments *sum, const bolan_measured_spectrum *measured) {
    for (uint32_t i = 0; i < measured->frequency_count; i++) {
        double cosine, sine;
        const double weight = bolan_spectrum_trapezoid_weight(measured->omega, measured->frequency_count, i);
        add_sample(sum, row_density(measured, i, &cosine, &sine), measured->omega[i], weight);
        sum->cosine += cosine * weight;
        sum->sine += sine * weight;
    }
}

// ---- wave systems ---------------------------------------------------------------------------------------------------

// Frequencies wp e^u with u from -1.4 (S < e^-300 of the peak) to 7. The kink of JONSWAP at the peak falls on an even
// node.
enum { STEPS_BELOW = 280, STEPS = 1680 };
#define STEP 0.005

static double node_omega(const spectrum_system *system, int node) {
    return system->peak_omega * portable_exp((node - STEPS_BELOW) * STEP);
}

static void add_system(moments *sum, const spectrum_eval *eval, const spectrum_system *system) {
    for (int i = 0; i <= STEPS; i++) {
        const double omega = node_omega(system, i);
        const double density = bolan_spectrum_system_density(system, omega, bolan_spectrum_relative_depth(eval, omega));
        const double simpson = i == 0 || i == STEPS ? 1.0 : i % 2 ? 4.0 : 2.0;
        const double weight = simpson * STEP / 3.0 * omega; // dw = w du
        const double along = density * weight * bolan_spectrum_system_mean_cosine(system, omega);
        add_sample(sum, density, omega, weight);
        sum->cosine += along * system->to_x;
        sum->sine += along * system->to_y;
    }
}

// ---- on a current ---------------------------------------------------------------------------------------------------

// The frames of a spectrum differ by direction, so nothing separates: a sum over log w and the circle.
enum { CIRCLE = 72 }; // 5 degrees resolve cos-2s up to s = 200
#define CURRENT_STEP 0.005

// S(w) on the current; adds m0 times the mean unit vector per unit of frequency to `along`.
static double circle_density(const spectrum_eval *eval, double omega, double along[2]) {
    double sum = 0.0;
    for (int j = 0; j < CIRCLE; j++) {
        double sine, cosine;
        bolan_sincos(2.0 * BOLAN_PI * j / CIRCLE, &sine, &cosine);
        const double density = bolan_spectrum_eval_density(eval, omega, cosine, sine) * (2.0 * BOLAN_PI / CIRCLE);
        sum += density;
        along[0] += density * cosine;
        along[1] += density * sine;
    }
    return sum;
}

// Frequencies in the water between which a sea lies: 5 m/s take waves of 50 rad/s down to 9 rad/s, and no wave that a
// current does not block has more than twice its frequency in still water.
static void current_range(const spectrum_eval *eval, double *low, double *high) {
    *low = 1e30;
    *high = 0.0;
    for (uint32_t i = 0; i < eval->system_count; i++) {
        *low = fmin(*low, 0.03 * eval->systems[i].peak_omega);
        *high = fmax(*high, 1e3 * eval->systems[i].peak_omega);
    }
    if (!eval->measured) return;
    *low = fmin(*low, 0.1 * eval->measured->omega[0]);
    *high = fmax(*high, 2.0 * eval->measured->omega[eval->measured->frequency_count - 1]);
}

// Adds the moments, and returns the frequency of the peak; 0 without waves.
static double add_on_current(moments *sum, const spectrum_eval *eval) {
    double low, high, peak = 0.0, best = 0.0;
    current_range(eval, &low, &high);
    const double growth = portable_exp(CURRENT_STEP);
    for (double omega = low; omega < high; omega *= growth) {
        double along[2] = {0.0, 0.0};
        const double density = circle_density(eval, omega, along), weight = CURRENT_STEP * omega;
        add_sample(sum, density, omega, weight);
        sum->cosine += along[0] * weight;
        sum->sine += along[1] * weight;
        if (!(density > best)) continue;
        best = density;
        peak = omega;
    }
    return peak;
}

// ---- the peak -------------------------------------------------------------------------------------------------------

static double measured_density_at(const bolan_measured_spectrum *measured, double omega) {
    double sum = 0.0;
    for (uint32_t j = 0; measured && j < measured->direction_count; j++)
        sum += bolan_spectrum_measured_density(measured, omega, measured->theta[j], false) * measured->direction_step;
    return sum;
}

double bolan_spectrum_eval_omnidirectional(const spectrum_eval *eval, double omega) {
    double along[2] = {0.0, 0.0};
    if (eval->on_current) return circle_density(eval, omega, along);
    double sum = eval->measured_level * measured_density_at(eval->measured, omega);
    for (uint32_t i = 0; i < eval->system_count; i++)
        sum += bolan_spectrum_system_density(&eval->systems[i], omega, bolan_spectrum_relative_depth(eval, omega));
    return sum;
}

static void keep_larger(const spectrum_eval *eval, double omega, double *best_omega, double *best) {
    const double density = bolan_spectrum_eval_omnidirectional(eval, omega);
    if (density > *best) {
        *best = density;
        *best_omega = omega;
    }
}

static double find_peak(const spectrum_eval *eval) {
    double best_omega = 0.0, best = 0.0;
    for (uint32_t i = 0; eval->measured && i < eval->measured->frequency_count; i++)
        keep_larger(eval, eval->measured->omega[i], &best_omega, &best);
    for (uint32_t s = 0; s < eval->system_count; s++)
        for (int node = 0; node <= 2 * STEPS_BELOW; node++) // up to four times the peak: TMA moves it upwards
            keep_larger(eval, node_omega(&eval->systems[s], node), &best_omega, &best);
    return best_omega;
}

// Adds the moments of a sea, and returns the frequency of its peak; 0 without waves.
static double add_sea(moments *sum, const spectrum_eval *eval) {
    if (eval->on_current) return add_on_current(sum, eval);
    if (eval->measured) add_measured(sum, eval->measured);
    for (uint32_t i = 0; i < eval->system_count; i++) add_system(sum, eval, &eval->systems[i]);
    return sum->m0 > 0.0 ? find_peak(eval) : 0.0;
}

// ---- limits ---------------------------------------------------------------------------------------------------------

#define DEPTH_SHARE 0.6 // Hs over the depth
#define MICHE 0.142     // H over L tanh kd

// The square of Hs over what its peak lets it have; 0 for no waves.
static double steepness_share(const moments *sum, double peak_omega, double depth) {
    if (!(sum->m0 > 0.0)) return 0.0;
    const double k = bolan_k_from_omega(peak_omega, depth);
    const double highest = MICHE * 2.0 * BOLAN_PI / k * tanh(k * depth);
    return 16.0 * sum->m0 / (highest * highest);
}

bolan_sea_limit bolan_sea_state_limit(const bolan_sea_state *sea_state) {
    BOLAN_ASSERT(sea_state);
    const spectrum_eval eval = bolan_spectrum_eval_prepare(sea_state);
    double m0 = 0.0, steepness = 0.0;
    for (uint32_t i = 0; i <= eval.system_count; i++) { // the last is the measured spectrum
        spectrum_eval one = eval;
        moments sum = {0};
        one.system_count = i < eval.system_count;
        if (one.system_count) {
            one.systems[0] = eval.systems[i];
            one.measured = NULL;
        }
        const double peak_omega = add_sea(&sum, &one);
        m0 += sum.m0;
        steepness += steepness_share(&sum, peak_omega, eval.depth);
    }
    const double hs = 4.0 * sqrt(m0);
    return (bolan_sea_limit){.by_depth = hs > 0.0 ? fmin(DEPTH_SHARE * eval.depth / hs, 1.0) : 1.0,
                             .by_steepness = steepness > 1.0 ? 1.0 / sqrt(steepness) : 1.0};
}

bolan_sea_summary bolan_sea_state_summary(const bolan_sea_state *sea_state) {
    bolan_sea_summary summary = {.from_deg = sea_state->wind_from_deg};
    const spectrum_eval eval = bolan_spectrum_eval_prepare(sea_state);
    moments sum = {0};
    const double peak_omega = add_sea(&sum, &eval);
    if (!(sum.m0 > 0.0)) return summary;
    const double turn = 2.0 * BOLAN_PI, r1 = fmin(sqrt(sum.cosine * sum.cosine + sum.sine * sum.sine) / sum.m0, 1.0);
    summary.m0 = sum.m0;
    summary.hs = 4.0 * sqrt(sum.m0);
    summary.tp = turn / peak_omega;
    summary.tm01 = turn * sum.m0 / sum.m1;
    summary.tm02 = turn * sqrt(sum.m0 / sum.m2);
    summary.te = turn * sum.minus1 / sum.m0;
    summary.from_deg = bolan_math_to_compass_from(portable_angle(sum.sine, sum.cosine));
    summary.spread_deg = bolan_degrees(sqrt(2.0 * (1.0 - r1)));
    return summary;
}
