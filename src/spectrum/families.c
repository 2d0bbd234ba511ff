// SPDX-License-Identifier: MIT
// Sea states whose systems follow from a wind and a fetch, or from a height and a period: the laws of Donelan et al.
// and Elfouhaily et al., and the two-peak families of Ochi & Hubble and Torsethaugen & Haver.
#include "bolan/math.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

// ---- by wind and fetch ----------------------------------------------------------------------------------------------

// A sea of @p wind_speed with one system whose peak is that of the wave age @p age and whose height is still 0; no
// system where the peak would be a ripple.
static bolan_sea_state sea_of_age(double wind_speed, double from_deg, double age, bolan_spectrum_kind kind,
                                  bolan_spreading_kind spreading) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.wind_speed = wind_speed;
    sea_state.wind_from_deg = from_deg;
    const double peak_omega = age * BOLAN_GRAVITY / wind_speed;
    if (!(wind_speed > 0.0 && peak_omega <= SPECTRUM_PEAK_OMEGA_MAX)) return sea_state;
    bolan_wave_system system = bolan_wave_system_default();
    system.kind = kind;
    system.peak_omega = peak_omega;
    system.from_deg = from_deg;
    system.spreading = spreading;
    system.wind_speed = wind_speed;
    sea_state.systems[sea_state.system_count++] = system;
    return sea_state;
}

static void set_variance(bolan_sea_state *sea_state, double variance) {
    sea_state->systems[0].hs = fmin(4.0 * sqrt(variance), SPECTRUM_MAX_HS);
}

// g F / U^2; 0 where nothing grows.
static double fetch_of(double wind_speed, double fetch) {
    return wind_speed > 0.0 && fetch > 0.0 ? BOLAN_GRAVITY * fetch / (wind_speed * wind_speed) : 0.0;
}

// Not portable_pow() of HUGE_VAL, which has no logarithm.
static double power_of(double x, double y) { return x < 1e300 ? portable_pow(x, y) : HUGE_VAL; }

bolan_sea_state bolan_sea_state_from_donelan(double wind_speed, double from_deg, double fetch) {
    const double x = fetch_of(wind_speed, fetch);
    const double age = x > 0.0 ? fmax(11.6 / power_of(x, 0.23), 0.83) : HUGE_VAL;
    bolan_sea_state sea_state =
        sea_of_age(wind_speed, from_deg, age, BOLAN_SPECTRUM_DONELAN, BOLAN_SPREADING_DONELAN_BANNER);
    if (sea_state.system_count == 0) return sea_state;
    double gamma, width;
    bolan_spectrum_donelan_peak(age, &gamma, &width);
    const double wp = sea_state.systems[0].peak_omega, speed = BOLAN_GRAVITY / wp;
    const double alpha = 0.006 * portable_pow(age, 0.55);
    set_variance(&sea_state,
                 alpha * speed * speed / (wp * wp) * bolan_spectrum_tail4_integral(portable_log(gamma), width, width));
    return sea_state;
}

bolan_sea_state bolan_sea_state_from_elfouhaily(double wind_speed, double from_deg, double fetch) {
    const double x = fetch_of(wind_speed, fetch);
    const double growth = portable_tanh(power_of(x / 2.2e4, 0.4));
    const double age = x > 0.0 ? 0.84 * portable_pow(growth, -0.75) : HUGE_VAL;
    bolan_sea_state sea_state =
        sea_of_age(wind_speed, from_deg, age, BOLAN_SPECTRUM_ELFOUHAILY, BOLAN_SPREADING_ELFOUHAILY);
    if (sea_state.system_count == 0) return sea_state;
    const spectrum_elfouhaily e = bolan_spectrum_elfouhaily_prepare(sea_state.systems[0].peak_omega, wind_speed);
    set_variance(&sea_state, bolan_spectrum_elfouhaily_variance(&e));
    return sea_state;
}

// ---- two peaks ------------------------------------------------------------------------------------------------------

// Adds both systems or, with the sentence of the first that is wrong, none.
static bolan_result add_pair(bolan_sea_state *sea_state, const bolan_wave_system pair[2]) {
    bolan_sea_state next = *sea_state;
    for (int i = 0; i < 2; i++) {
        const bolan_result result = bolan_sea_state_add_system(&next, &pair[i]);
        if (result != BOLAN_OK) return result;
    }
    *sea_state = next;
    return BOLAN_OK;
}

static bolan_result refuse(const char *function, const char *what, double value, double low, double high,
                           const char *unit) {
    bolan_log(BOLAN_LOG_ERROR, isfinite(value) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE,
              "%s: %s is %g; expected %g to %g%s", function, what, value, low, high, unit);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_sea_state_add_ochi_hubble(bolan_sea_state *sea_state, double hs, uint32_t member, double from_deg) {
    // Of each peak: height over hs; wp = a exp(-b hs); lambda = c exp(-d hs).
    static const double table[BOLAN_OCHI_HUBBLE_MEMBERS][2][5] = {
        {{0.84, 0.70, 0.046, 3.00, 0}, {0.54, 1.15, 0.039, 1.54, 0.062}},
        {{0.95, 0.70, 0.046, 1.35, 0}, {0.31, 1.50, 0.046, 2.48, 0.102}},
        {{0.65, 0.61, 0.039, 4.95, 0}, {0.76, 0.94, 0.036, 2.48, 0.102}},
        {{0.84, 0.93, 0.056, 3.00, 0}, {0.54, 1.50, 0.046, 2.77, 0.112}},
        {{0.84, 0.41, 0.016, 2.55, 0}, {0.54, 0.88, 0.026, 1.82, 0.089}},
        {{0.90, 0.81, 0.052, 1.80, 0}, {0.44, 1.60, 0.033, 2.95, 0.105}},
        {{0.77, 0.54, 0.039, 4.50, 0}, {0.64, 0.61, 0.000, 1.95, 0.082}},
        {{0.73, 0.70, 0.046, 6.40, 0}, {0.68, 0.99, 0.039, 1.78, 0.069}},
        {{0.92, 0.70, 0.046, 0.70, 0}, {0.39, 1.37, 0.039, 1.78, 0.069}},
        {{0.84, 0.74, 0.052, 2.65, 0}, {0.54, 1.30, 0.039, 3.90, 0.085}},
        {{0.62, 0.62, 0.039, 2.60, 0}, {0.79, 1.03, 0.030, 0.53, 0.069}},
    };
    BOLAN_ASSERT(sea_state);
    const char *const name = "bolan_sea_state_add_ochi_hubble";
    if (member >= BOLAN_OCHI_HUBBLE_MEMBERS)
        return refuse(name, "member", member, 0.0, BOLAN_OCHI_HUBBLE_MEMBERS - 1, "");
    if (!(hs >= 0.0 && hs <= SPECTRUM_MAX_HS)) return refuse(name, "hs", hs, 0.0, SPECTRUM_MAX_HS, " m");
    const double a = table[member][0][0], b = table[member][1][0];
    bolan_wave_system pair[2];
    for (int i = 0; i < 2; i++) {
        const double *row = table[member][i];
        pair[i] = bolan_wave_system_default();
        pair[i].kind = BOLAN_SPECTRUM_OCHI_HUBBLE;
        pair[i].hs = hs * row[0] / sqrt(a * a + b * b);
        pair[i].peak_omega = fmax(row[1] * portable_exp(-row[2] * hs), SPECTRUM_PEAK_OMEGA_MIN);
        pair[i].lambda = fmax(row[3] * portable_exp(-row[4] * hs), 0.1);
        pair[i].from_deg = from_deg;
        pair[i].spreading = BOLAN_SPREADING_COS2S;
    }
    return add_pair(sea_state, pair);
}

static bolan_wave_system torsethaugen_peak(double hs, double tp, double gamma, double from_deg, bool swell) {
    bolan_wave_system system = bolan_wave_system_default();
    system.kind = BOLAN_SPECTRUM_TORSETHAUGEN;
    system.hs = hs;
    system.peak_omega = 2.0 * BOLAN_PI / tp;
    system.gamma = fmin(fmax(gamma, 1.0), 10.0);
    system.from_deg = from_deg;
    system.spreading = BOLAN_SPREADING_COS2S;
    system.spread_s = swell ? 30.0 : 10.0;
    return system;
}

// Table 1 of the paper.
bolan_result bolan_sea_state_add_torsethaugen(bolan_sea_state *sea_state, double hs, double tp, double from_deg) {
    BOLAN_ASSERT(sea_state);
    const char *const name = "bolan_sea_state_add_torsethaugen";
    if (!(hs >= 0.0 && hs <= SPECTRUM_MAX_HS)) return refuse(name, "hs", hs, 0.0, SPECTRUM_MAX_HS, " m");
    if (hs == 0.0) return BOLAN_OK;
    if (!(tp >= 1.0 && tp <= 60.0)) return refuse(name, "tp", tp, 1.0, 60.0, " s");
    const double steepness = 2.0 * BOLAN_PI / BOLAN_GRAVITY, longest = 25.0;
    const double between = 6.6 * portable_pow(hs, 1.0 / 3.0), shortest = 2.0 * sqrt(hs); // periods [s]
    bolan_wave_system pair[2];
    if (tp <= between) { // the wind sea is the higher one
        const double e = tp < shortest ? 1.0 : (between - tp) / (between - shortest);
        const double share = 0.7 + 0.3 * portable_exp(-4.0 * e * e), first = share * hs;
        const double gamma = 35.0 * portable_pow(steepness * first / (tp * tp), 6.0 / 7.0);
        pair[0] = torsethaugen_peak(first, tp, gamma, from_deg, false);
        pair[1] = torsethaugen_peak(sqrt(1.0 - share * share) * hs, between + 2.0, 1.0, from_deg, true);
    } else {
        const double e = tp > longest ? 1.0 : (tp - between) / (longest - between);
        const double share = 0.6 + 0.4 * portable_exp(-e * e / 0.09), second = sqrt(1.0 - share * share) * hs;
        const double gamma = 35.0 * portable_pow(steepness * hs / (between * between), 6.0 / 7.0) * (1.0 + 6.0 * e);
        pair[0] = torsethaugen_peak(share * hs, tp, gamma, from_deg, true);
        pair[1] = torsethaugen_peak(second, fmax(6.6 * portable_pow(second, 1.0 / 3.0), 0.2), 1.0, from_deg, false);
    }
    return add_pair(sea_state, pair);
}
