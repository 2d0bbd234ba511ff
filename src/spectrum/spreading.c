// SPDX-License-Identifier: MIT
// Directional spreading. cos-2s: Longuet-Higgins, Cartwright & Smith (1963); its exponent: Hasselmann, Dunckel & Ewing,
// J. Phys. Oceanogr. 10 (1980); the swell parameter: C. Horvath, "Empirical directional wave spectra for computer
// graphics", DigiPro (2015), eq. 44-45, renormalised here over the whole circle.
#include "bolan/math.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

// Horvath's factor |cos(th/2)|^{2 s_xi} has the form of cos-2s, so there the exponents just add.
static double swell_exponent(const spectrum_system *system, double omega) {
    return system->swell_s > 0.0 ? system->swell_s * portable_tanh(system->peak_omega / omega) : 0.0;
}

static double cos2s_exponent(const spectrum_system *system, double omega) {
    double s = system->s;
    if (system->spreading == BOLAN_SPREADING_HASSELMANN) {
        const double r = omega / system->peak_omega;
        s = r <= 1.0 ? 6.97 * portable_pow(r, 4.06) : 9.77 * portable_pow(r, system->s_tail_power);
    }
    return s + swell_exponent(system, omega);
}

// cos^{2s}(th/2) by cos^2(th/2) = (1 + cos th) / 2.
static double half_angle_power(double cosine, double s) {
    const double base = 0.5 * (1.0 + cosine);
    return base > 1e-300 ? portable_exp(s * portable_log(base)) : (s > 0.0 ? 0.0 : 1.0);
}

static double cos2_spreading(double cosine, double swell_s) {
    if (cosine <= 0.0) return 0.0;
    if (!(swell_s > 0.0)) return 2.0 / BOLAN_PI * cosine * cosine;
    return cosine * cosine * half_angle_power(cosine, swell_s) *
           portable_exp(-bolan_spectrum_cos2_swell_log_norm(swell_s));
}

double bolan_spectrum_system_spreading(const spectrum_system *system, double omega, double cosine) {
    if (system->spreading == BOLAN_SPREADING_COS2) return cos2_spreading(cosine, swell_exponent(system, omega));
    const double s = cos2s_exponent(system, omega);
    return bolan_spectrum_cos2s_norm(s) * half_angle_power(cosine, s);
}

double bolan_spectrum_system_mean_cosine(const spectrum_system *system, double omega) {
    if (system->spreading != BOLAN_SPREADING_COS2) {
        const double s = cos2s_exponent(system, omega);
        return s / (s + 1.0);
    }
    const double swell_s = swell_exponent(system, omega);
    if (!(swell_s > 0.0)) return 8.0 / (3.0 * BOLAN_PI);
    enum { STEPS = 64 }; // the midpoint rule: the integrand and its slope vanish at both ends
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double sine, cosine;
        bolan_sincos(((i + 0.5) / STEPS - 0.5) * BOLAN_PI, &sine, &cosine);
        sum += cosine * cos2_spreading(cosine, swell_s);
    }
    return sum * BOLAN_PI / STEPS;
}
