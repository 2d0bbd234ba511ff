// SPDX-License-Identifier: MIT
// The unified spectrum of Elfouhaily, Chapron, Katsaros & Vandemark, "A unified directional spectrum for long and short
// wind-driven waves", J. Geophys. Res. 102 (1997), eq. 30 to 57: the curvature spectrum B(k) = k^3 S(k) is the sum of
// that of gravity waves about the peak and that of gravity-capillary waves about 370 rad/m.
//
//     long waves    (alpha_p / 2) (cp / c) L J exp(-Omega/sqrt(10) (sqrt(k/kp) - 1)),   L = exp(-1.25 (kp/k)^2)
//     short waves   (alpha_m / 2) (cm / c) exp(-(k/km - 1)^2 / 4) L
//
// The paper's short waves have no L. Then their m0 grows without end toward k = 0, so the authors' programs multiply
// by it. The friction velocity is that of a logarithmic wind whose roughness follows the wave age,
// z0 = 3.7e-5 (U^2/g) Omega^0.9 (Donelan et al. 1993, eq. 66 of the paper).
#include "bolan/math.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

#define SHORT_K 370.0    // km [rad/m]: least phase speed
#define SHORT_SPEED 0.23 // cm [m/s]: the phase speed there
#define KARMAN 0.41

static double friction_velocity(double wind_speed, double omega) {
    const double roughness = 3.7e-5 * wind_speed * wind_speed / BOLAN_GRAVITY * portable_pow(omega, 0.9);
    return KARMAN * wind_speed / portable_log(10.0 / roughness);
}

spectrum_elfouhaily bolan_spectrum_elfouhaily_prepare(double peak_omega, double wind_speed) {
    const double omega = fmin(fmax(bolan_spectrum_wave_age(wind_speed, peak_omega), 0.84), 5.0); // Omega = U/cp
    const double wind = wind_speed > 0.0 ? wind_speed : BOLAN_GRAVITY / peak_omega;
    const double ratio = friction_velocity(wind, omega) / SHORT_SPEED, log_ratio = portable_log(ratio);
    const double alpha_m = 0.01 * (1.0 + (ratio > 1.0 ? 3.0 : 1.0) * log_ratio);
    const double age = fmax(omega, 1.0); // the enhancement of the peak is constant below
    spectrum_elfouhaily e = {.decay = omega * 0.31622776601683794, .friction = 0.13 * ratio};
    e.peak_k = bolan_k_from_omega(peak_omega, BOLAN_DEEP);
    e.peak_speed = peak_omega / e.peak_k;
    e.log_gamma = portable_log(1.7 + 6.0 / PORTABLE_LN10 * portable_log(age));
    e.width = 0.08 * (1.0 + 4.0 / (omega * omega * omega));
    e.long_level = 0.5 * 0.006 * sqrt(omega);
    e.short_level = 0.5 * fmax(alpha_m, 0.0);
    return e;
}

// B(k) of waves of phase speed @p c.
static double curvature(const spectrum_elfouhaily *e, double k, double c) {
    const double r = k / e->peak_k, root = sqrt(r);
    if (!(r > 0.04)) return 0.0; // e^-781
    const double cut = -1.25 / (r * r), d = (root - 1.0) / e->width, s = k / SHORT_K - 1.0;
    const double peak = e->log_gamma * portable_exp(-0.5 * d * d);
    const double long_waves = e->long_level * e->peak_speed * portable_exp(cut + peak - e->decay * (root - 1.0));
    const double short_waves = e->short_level * SHORT_SPEED * portable_exp(cut - 0.25 * s * s);
    return (long_waves + short_waves) / c;
}

double bolan_spectrum_elfouhaily_density(const spectrum_elfouhaily *e, double omega) {
    const double k = bolan_k_from_omega(omega, BOLAN_DEEP);
    return curvature(e, k, omega / k) / (k * k * k * bolan_group_speed(k, BOLAN_DEEP));
}

// The integral of B k^-2 over ln k, by the trapezoid rule.
double bolan_spectrum_elfouhaily_variance(const spectrum_elfouhaily *e) {
    enum { BELOW = 32, ABOVE = 200 };
    const double step = 0.05;
    double sum = 0.0;
    for (int i = -BELOW; i <= ABOVE; i++) {
        const double k = e->peak_k * portable_exp(step * i);
        sum += curvature(e, k, bolan_omega_from_k(k, BOLAN_DEEP) / k) / (k * k);
    }
    return sum * step;
}

double bolan_spectrum_elfouhaily_delta(const spectrum_elfouhaily *e, double omega) {
    const double c = omega / bolan_k_from_omega(omega, BOLAN_DEEP), x = c / e->peak_speed, y = SHORT_SPEED / c;
    return portable_tanh(0.25 * PORTABLE_LN2 + 4.0 * x * x * sqrt(x) + e->friction * y * y * sqrt(y));
}
