// SPDX-License-Identifier: MIT
// Frequency spectra by height and peak. Sources:
// - Pierson & Moskowitz, J. Geophys. Res. 69 (1964).
// - Hasselmann et al., "Measurements of wind-wave growth and swell decay during JONSWAP", Deutsche Hydrogr. Z. A8(12)
//   (1973).
// - Bouws et al., "Similarity of the wind wave spectrum in finite depth water", J. Geophys. Res. 90 (1985), with the
//   depth factor of Kitaigorodskii (1975).
// - Tessendorf, "Simulating ocean water", SIGGRAPH course (2001), eq. 40-41, for Phillips's spectrum, which in w is
//   Pierson & Moskowitz's but for its cut.
// - Donelan, Hamilton & Hui, "Directional spectra of wind-generated waves", Phil. Trans. R. Soc. A 315 (1985).
// - Ochi & Hubble, "Six-parameter wave spectra", 15th Coastal Engineering Conference (1976), eq. 2.
// - Torsethaugen & Haver, "Simplified double peak spectral model for ocean waves", ISOPE (2004).
// elfouhaily.c has the one of Elfouhaily et al. (1997).
#include "bolan/math.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

// Clenshaw's recurrence for a Chebyshev series on t in [-1, 1].
static double chebyshev(const double *coefficients, int count, double t) {
    double b1 = 0.0, b2 = 0.0;
    for (int i = count - 1; i > 0; i--) {
        const double b0 = coefficients[i] + 2.0 * t * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return coefficients[0] + t * b1 - b2;
}

double bolan_spectrum_peak_integral(double log_gamma) {
    // The integral is a moment-generating function in ln gamma, hence very smooth: fitted to Gauss-Legendre quadrature.
    static const double fit[13] = {0.454354892778,     0.504184369265,     0.0507810089733,   0.00061513142298,
                                   -0.000350868493041, -1.05977506168e-05, 4.11365485825e-06, 1.93428701766e-07,
                                   -5.47863732414e-08, -3.54478677295e-09, 7.68999884414e-10, 6.47614073818e-11,
                                   -1.10567481033e-11};
    const double log_gamma_max = 2.30258509299404568402; // gamma = 10
    return log_gamma > 0.0 ? portable_exp(chebyshev(fit, 13, 2.0 * log_gamma / log_gamma_max - 1.0)) : 1.0;
}

double bolan_spectrum_cos2_swell_log_norm(double s) {
    static const double fit[13] = {0.0508712402438,   -0.337307176922,    0.05177098672,     -0.00953588559423,
                                   0.00175260097392,  -0.000297334790586, 4.31411836554e-05, -4.49676462364e-06,
                                   3.58177928861e-08, 1.37956892052e-07,  -4.4860571666e-08, 9.41673852462e-09,
                                   -1.4045012837e-09};
    return chebyshev(fit, 13, s / 8.0 - 1.0);
}

double bolan_spectrum_cos2s_norm(double s) {
    // By Legendre's duplication N(s) = Gamma(s+1) / (2 sqrt(pi) Gamma(s+1/2)). The ratio is asymptotic in 1/x; eight
    // steps of the recurrence bring x = s + 8 where five terms are enough.
    double up = 1.0, down = 1.0;
    for (int i = 1; i <= 8; i++) {
        up *= s + i - 0.5;
        down *= s + i;
    }
    const double x = s + 8.0, y = 1.0 / x;
    const double ratio =
        1.0 + y * (1.0 / 8 + y * (1.0 / 128 + y * (-5.0 / 1024 + y * (-21.0 / 32768 + y * 399.0 / 262144))));
    return up / down * sqrt(x) * ratio * 0.28209479177387814; // 1 / (2 sqrt(pi))
}

double bolan_spectrum_wave_age(double wind_speed, double peak_omega) {
    return wind_speed > 0.0 ? wind_speed * peak_omega / BOLAN_GRAVITY : 1.0;
}

void bolan_spectrum_donelan_peak(double wave_age, double *gamma, double *width) {
    const double age = fmin(fmax(wave_age, 0.83), 5.0); // the waves that were measured
    *gamma = 1.7 + (age > 1.0 ? 6.0 / PORTABLE_LN10 * portable_log(age) : 0.0);
    *width = 0.08 * (1.0 + 4.0 / (age * age * age));
}

// By the trapezoid rule over ln x, which converges exponentially for functions that fade at both ends. The kink of the
// peak's width falls on a node.
double bolan_spectrum_tail4_integral(double log_gamma, double width_below, double width_above) {
    enum { BELOW = 60, ABOVE = 350 };
    const double step = 0.02;
    double sum = 0.0;
    for (int i = -BELOW; i <= ABOVE; i++) {
        const double x = portable_exp(step * i), x3 = 1.0 / (x * x * x);
        const double d = (x - 1.0) / (i <= 0 ? width_below : width_above);
        sum += x3 * portable_exp(log_gamma * portable_exp(-0.5 * d * d) - x3 / x);
    }
    return sum * step;
}

// ln Gamma(x), x > 0, by Stirling's series at x + 8; error < 1e-13.
static double log_gamma_function(double x) {
    double product = 1.0;
    for (int i = 0; i < 8; i++) product *= x + i;
    const double z = x + 8.0, y = 1.0 / z, y2 = y * y;
    return (z - 0.5) * portable_log(z) - z + 0.91893853320467274178 +
           y * (1.0 / 12 - y2 * (1.0 / 360 - y2 * (1.0 / 1260 - y2 / 1680))) - portable_log(product);
}

// The horizontal unit vector that the waves follow.
static void mean_direction(const bolan_wave_system *from, spectrum_system *to) {
    bolan_sincos(bolan_compass_from_to_math(from->from_deg), &to->to_y, &to->to_x);
}

static void prepare_jonswap(const bolan_wave_system *system, spectrum_system *p) {
    const bool peaked = system->kind == BOLAN_SPECTRUM_JONSWAP || system->kind == BOLAN_SPECTRUM_TMA;
    const double wp2 = system->peak_omega * system->peak_omega;
    p->log_gamma = peaked && system->gamma > 1.0 ? portable_log(system->gamma) : 0.0;
    p->level = 5.0 / 16.0 * system->hs * system->hs * wp2 * wp2 / bolan_spectrum_peak_integral(p->log_gamma);
    p->depth_limited = system->kind == BOLAN_SPECTRUM_TMA;
    // L = U^2 / g = (4/5)^(1/2) g / wp^2, l = L / 1000. The cut takes 1e-6 of m0, so the level stays.
    if (system->kind == BOLAN_SPECTRUM_PHILLIPS) p->cut = 0.89442719099991588e-3 / wp2;
}

static void prepare_tail4(const bolan_wave_system *system, double wave_age, spectrum_system *p) {
    const double wp = system->peak_omega;
    double gamma = system->gamma;
    if (system->kind == BOLAN_SPECTRUM_DONELAN) {
        bolan_spectrum_donelan_peak(wave_age, &gamma, &p->width_below);
        p->width_above = p->width_below;
    }
    p->power = 4.0;
    p->log_gamma = gamma > 1.0 ? portable_log(gamma) : 0.0;
    p->level = system->hs * system->hs / 16.0 * (wp * wp * wp) /
               bolan_spectrum_tail4_integral(p->log_gamma, p->width_below, p->width_above);
}

// S = (Hs^2/4) ((lambda + 1/4) wp^4)^lambda / Gamma(lambda) w^-(4 lambda + 1) exp(-(lambda + 1/4) (wp/w)^4).
static void prepare_ochi_hubble(const bolan_wave_system *system, spectrum_system *p) {
    const double lambda = system->lambda > 0.0 ? system->lambda : 1.0;
    p->power = 4.0 * lambda + 1.0;
    p->level = 0.25 * system->hs * system->hs / system->peak_omega *
               portable_exp(lambda * portable_log(lambda + 0.25) - log_gamma_function(lambda));
}

static void prepare_elfouhaily(const bolan_wave_system *system, spectrum_system *p) {
    const bool shape = system->kind == BOLAN_SPECTRUM_ELFOUHAILY;
    if (!shape && system->spreading != BOLAN_SPREADING_ELFOUHAILY) return;
    p->elfouhaily = bolan_spectrum_elfouhaily_prepare(system->peak_omega, system->wind_speed);
    if (shape) p->level = system->hs * system->hs / 16.0 / bolan_spectrum_elfouhaily_variance(&p->elfouhaily);
}

// Hasselmann, Dunckel & Ewing, J. Phys. Oceanogr. 10 (1980); Mitsuyasu et al., J. Phys. Oceanogr. 5 (1975).
static void prepare_spreading(const bolan_wave_system *system, double wave_age, spectrum_system *p) {
    p->spreading = system->spreading;
    p->s = system->spread_s;
    p->s_tail_power = -2.33 - 1.45 * (wave_age - 1.17);
    if (system->spreading == BOLAN_SPREADING_MITSUYASU) {
        p->s = fmin(11.5 * portable_pow(wave_age, -2.5), SPREADING_S_MAX);
        p->s_tail_power = -2.5;
    }
    p->swell_s = 16.0 * system->swell * system->swell;
    mean_direction(system, p);
}

spectrum_system bolan_spectrum_system_prepare(const bolan_wave_system *system) {
    spectrum_system p = {.kind = system->kind, .peak_omega = system->peak_omega, .power = 5.0};
    const double wave_age = bolan_spectrum_wave_age(system->wind_speed, system->peak_omega);
    p.width_below = 0.07;
    p.width_above = 0.09;
    switch (system->kind) {
    case BOLAN_SPECTRUM_PIERSON_MOSKOWITZ:
    case BOLAN_SPECTRUM_JONSWAP:
    case BOLAN_SPECTRUM_TMA:
    case BOLAN_SPECTRUM_PHILLIPS: prepare_jonswap(system, &p); break;
    case BOLAN_SPECTRUM_DONELAN:
    case BOLAN_SPECTRUM_TORSETHAUGEN: prepare_tail4(system, wave_age, &p); break;
    case BOLAN_SPECTRUM_OCHI_HUBBLE: prepare_ochi_hubble(system, &p); break;
    case BOLAN_SPECTRUM_ELFOUHAILY: break;
    }
    p.steepness = 0.25 * p.power;
    prepare_elfouhaily(system, &p);
    prepare_spreading(system, wave_age, &p);
    return p;
}

// Kitaigorodskii's factor: the ratio of k^-3 dk/dw in water of the depth to that in deep water.
static double depth_factor(double kh) {
    if (kh > 15.0) return 1.0;
    if (kh < 1e-4) return 0.5 * kh * kh;
    const double t = portable_tanh(kh), e = portable_exp(2.0 * kh);
    return t * t / (1.0 + 4.0 * kh / (e - 1.0 / e));
}

// (wp/w)^power of the kinds whose tail is not w^-5, in the units of their level.
static double tail(const spectrum_system *system, double omega, double x) {
    if (system->kind == BOLAN_SPECTRUM_OCHI_HUBBLE) return portable_pow(x, system->power);
    const double w2 = omega * omega;
    return 1.0 / (w2 * w2);
}

double bolan_spectrum_system_density(const spectrum_system *system, double omega, double kh) {
    if (system->kind == BOLAN_SPECTRUM_ELFOUHAILY)
        return system->level * bolan_spectrum_elfouhaily_density(&system->elfouhaily, omega);
    const double x = system->peak_omega / omega;
    const double x4 = x * x * x * x;
    if (!(x4 < 500.0)) return 0.0;
    double exponent = -system->steepness * x4;
    if (system->log_gamma > 0.0) {
        const double width = omega <= system->peak_omega ? system->width_below : system->width_above;
        const double d = (omega / system->peak_omega - 1.0) / width;
        exponent += system->log_gamma * portable_exp(-0.5 * d * d);
    }
    if (system->kind > BOLAN_SPECTRUM_PHILLIPS) return system->level * tail(system, omega, x) * portable_exp(exponent);
    const double w2 = omega * omega, kl = system->cut * w2;
    if (!(kl < 20.0)) return 0.0;
    exponent -= kl * kl;
    const double density = system->level / (w2 * w2 * omega) * portable_exp(exponent);
    return system->depth_limited ? density * depth_factor(kh) : density;
}
