// SPDX-License-Identifier: MIT
// Variance and slope variance of a sea state over |k|, and the roll-off of its short waves.
//
// The w^-5 tail of the wind-sea spectra holds for the waves near the peak. Continued to centimetres it has a slope
// variance that grows with log k without end, more than Cox & Munk (1954) measured in a light wind. So beyond k1, which
// is 10 k_peak and at least the last wave number of a measured spectrum, the power is multiplied by
//
//     keep(k) = exp(-(M(k) - M1) / (B - M1)),
//
// M(k) being the slope variance of the waves longer than k, M1 that at k1, and B Cox & Munk's total for the
// wind. The kept slope variance adds up to M1 + (B - M1)(1 - keep) < B however short the waves get, without a visible
// edge. Where the long waves alone reach B (a swell in a calm) the short ones get a tenth of B, and so are few. A sea
// with a system of Elfouhaily keeps all: its short waves are those of that system and end by themselves.
#include "spectrum/portable.h"
#include "waves/cascades/cascades.h"

enum { DIRECTIONS = 96 };

// Psi summed over the circle times k: variance per unit of k [m3].
static double ring_density(const spectrum_eval *eval, double k) {
    double sum = 0.0;
    for (int d = 0; d < DIRECTIONS; d++) {
        double s, c;
        bolan_sincos(2.0 * BOLAN_PI * d / DIRECTIONS, &s, &c);
        sum += bolan_spectrum_eval_psi(eval, k * c, k * s);
    }
    return sum * k * (2.0 * BOLAN_PI / DIRECTIONS);
}

static double at_k(const double *values, double k) {
    const double step = portable_log(RADIAL_K_MAX / RADIAL_K_MIN) / (RADIAL_COUNT - 1);
    const double x = k > RADIAL_K_MIN ? portable_log(k / RADIAL_K_MIN) / step : 0.0;
    if (x >= RADIAL_COUNT - 1) return values[RADIAL_COUNT - 1];
    const int i = (int)x;
    return values[i] + (values[i + 1] - values[i]) * (x - i);
}

static void integrate(const spectrum_eval *eval, sea_radial *out) {
    const double step = portable_log(RADIAL_K_MAX / RADIAL_K_MIN) / (RADIAL_COUNT - 1);
    double previous = 0.0;
    for (int i = 0; i < RADIAL_COUNT; i++) {
        const double k = RADIAL_K_MIN * portable_exp(step * i);
        const double density = ring_density(eval, k) * k; // per unit of log k
        out->k[i] = k;
        if (i > 0) {
            const double mid = 0.5 * (previous + density) * step, k_mid2 = k * out->k[i - 1];
            out->variance[i] = out->variance[i - 1] + mid;
            out->mss[i] = out->mss[i - 1] + mid * k_mid2;
        }
        previous = density;
    }
}

static bool ends_by_itself(const spectrum_eval *eval) {
    for (uint32_t i = 0; i < eval->system_count; i++)
        if (eval->systems[i].kind == BOLAN_SPECTRUM_ELFOUHAILY) return true;
    return false;
}

void bolan_sea_radial_prepare(const spectrum_eval *eval, double k1, double budget, sea_radial *out) {
    out->variance[0] = out->mss[0] = 0.0;
    integrate(eval, out);
    const double m1 = at_k(out->mss, k1);
    const double room = fmax(fmax(budget - m1, 0.1 * budget), 1e-6);
    const bool all = ends_by_itself(eval);
    for (int i = 0; i < RADIAL_COUNT; i++) {
        const double beyond = out->mss[i] - m1;
        out->keep[i] = beyond > 0.0 && !all ? portable_exp(-beyond / room) : 1.0;
    }
}

double bolan_sea_radial_keep(const sea_radial *radial, double k) { return at_k(radial->keep, k); }

double bolan_sea_radial_quantile(const sea_radial *radial, double share) {
    const double total = radial->variance[RADIAL_COUNT - 1];
    if (!(total > 0.0)) return 0.0;
    for (int i = 0; i < RADIAL_COUNT; i++)
        if (radial->variance[i] >= share * total) return radial->k[i];
    return radial->k[RADIAL_COUNT - 1];
}

double bolan_sea_asked_end(const bolan_sea_state *state, const bolan_sea_summary *summary) {
    double omega = 0.0, last = 0.0;
    for (uint32_t i = 0; i < state->system_count; i++)
        if (state->systems[i].hs > 0.0) omega = fmax(omega, state->systems[i].peak_omega);
    if (omega == 0.0 && summary->tp > 0.0) omega = 2.0 * BOLAN_PI / summary->tp;
    const double peak_k = omega > 0.0 ? bolan_k_from_omega(omega, state->depth) : 0.0;
    if (state->measured) {
        const bolan_measured_view v = bolan_measured_spectrum_view(state->measured);
        last = bolan_k_from_omega(v.omega[v.frequency_count - 1], state->depth);
    }
    return fmax(10.0 * peak_k, last);
}
