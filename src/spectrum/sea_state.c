// SPDX-License-Identifier: MIT
// Sea states from a wind, a table or a swell, and their validation.
#include "bolan/math.h"
#include "bolan/spectrum.h"
#include "spectrum/measured.h"
#include "spectrum/portable.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define HS_MAX SPECTRUM_MAX_HS
#define SWELL_PERIOD_MIN (2.0 * BOLAN_PI / SPECTRUM_PEAK_OMEGA_MAX) // [s]
#define SWELL_PERIOD_MAX (2.0 * BOLAN_PI / SPECTRUM_PEAK_OMEGA_MIN)

#define WIND_KINDS "pierson-moskowitz", "jonswap", "tma", "phillips", "donelan", "elfouhaily"
const char *const bolan_spectrum_kind_names[BOLAN_SPECTRUM_KINDS + 1] = {WIND_KINDS, "ochi-hubble", "torsethaugen",
                                                                         NULL};
const char *const bolan_wind_spectrum_names[BOLAN_WIND_SPECTRUM_KINDS + 1] = {WIND_KINDS, NULL};
const char *const bolan_spreading_kind_names[BOLAN_SPREADING_KINDS + 1] = {
    "cos2", "cos2s", "hasselmann", "mitsuyasu", "donelan-banner", "elfouhaily", NULL};

const char *const bolan_spectrum_frame_names[BOLAN_SPECTRUM_FRAMES + 1] = {"water", "ground", "still", NULL};

bolan_sea_state bolan_sea_state_default(void) {
    const bolan_sea_state calm = {.depth = BOLAN_DEEP};
    return calm;
}

bolan_wave_system bolan_wave_system_default(void) {
    bolan_wave_system system;
    memset(&system, 0, sizeof system); // also the padding, so that equal systems have equal bytes
    bolan_params_default(&bolan_wave_system_params, &system);
    return system;
}

static bolan_wave_system wind_sea(double hs, double peak_omega, double gamma, double wind_speed, double from_deg) {
    const bolan_wave_system system = {
        .kind = gamma > 1.0 ? BOLAN_SPECTRUM_JONSWAP : BOLAN_SPECTRUM_PIERSON_MOSKOWITZ,
        .hs = hs > HS_MAX ? HS_MAX : hs,
        .peak_omega = peak_omega,
        .gamma = gamma,
        .from_deg = from_deg,
        .spreading = BOLAN_SPREADING_HASSELMANN,
        .spread_s = 10.0,
        .wind_speed = wind_speed,
    };
    return system;
}

// The fully developed sea: Pierson & Moskowitz (1964) by the wind at 19.5 m, which is 1.026 U10 over the sea.
#define PM_WIND_RATIO 1.026
#define PM_PEAK 0.87716   // wp U / g
#define PM_HEIGHT 0.20925 // Hs g / U^2

// Significant height of JONSWAP by its alpha: alpha g^2 = (5/16) Hs^2 wp^4 C(gamma); C(3.3) = 0.65576.
static double jonswap_height(double wind_speed, double fetch, double peak_omega) {
    const double g = BOLAN_GRAVITY;
    const double alpha = 0.076 * portable_pow(wind_speed * wind_speed / (g * fetch), 0.22);
    return 4.0 * g / (peak_omega * peak_omega) * sqrt(alpha / (5.0 * 0.65576));
}

bolan_sea_state bolan_sea_state_from_wind(double wind_speed, double from_deg, double fetch) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.wind_speed = wind_speed;
    sea_state.wind_from_deg = from_deg;
    if (!(wind_speed > 0.0 && fetch > 0.0)) return sea_state;
    const double g = BOLAN_GRAVITY, wind_pm = PM_WIND_RATIO * wind_speed;
    const double peak_pm = PM_PEAK * g / wind_pm;
    double peak = 22.0 * portable_pow(g * g / (wind_speed * fetch), 1.0 / 3.0), hs = PM_HEIGHT * wind_pm * wind_pm / g,
           gamma = 1.0;
    if (peak > peak_pm) {
        // JONSWAP's height reaches that of the fully developed sea before its peak does: from there on only the peak
        // moves. Over the last tenth of the peak frequency the enhancement fades, so that the shape has no jump.
        hs = fmin(jonswap_height(wind_speed, fetch, peak), hs);
        gamma += fmin((peak / peak_pm - 1.0) / 0.1, 1.0) * 2.3;
    } else {
        peak = peak_pm;
    }
    if (peak <= SPECTRUM_PEAK_OMEGA_MAX) // shorter peaks are ripples: the sea is calm
        sea_state.systems[sea_state.system_count++] = wind_sea(hs, peak, gamma, wind_speed, from_deg);
    return sea_state;
}

// A exp(-1/(kL)^2) k^-4 cos^2 in w: k = w^2/g makes it 2 pi A g^2 w^-5 exp(-(g/U)^4 w^-4) / 2, Pierson-Moskowitz's
// shape with alpha g^2 before it and (5/4) wp^4 = (g/U)^4.
bolan_sea_state bolan_sea_state_from_phillips(double wind_speed, double from_deg) {
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.wind_speed = wind_speed;
    sea_state.wind_from_deg = from_deg;
    if (!(wind_speed > 0.0)) return sea_state;
    const double g = BOLAN_GRAVITY, peak = 0.945741609003176 * g / wind_speed; // (4/5)^(1/4)
    if (!(peak <= SPECTRUM_PEAK_OMEGA_MAX)) return sea_state;
    bolan_wave_system system = wind_sea(0.18 * wind_speed * wind_speed / g, peak, 1.0, wind_speed, from_deg);
    system.kind = BOLAN_SPECTRUM_PHILLIPS;
    system.spreading = BOLAN_SPREADING_COS2;
    sea_state.systems[sea_state.system_count++] = system;
    return sea_state;
}

bolan_sea_state bolan_sea_state_from_beaufort(double beaufort, double from_deg) {
    BOLAN_ASSERT(beaufort >= 0.0 && beaufort <= 12.0);
    const double force = fmin(fmax(beaufort, 0.0), 12.0);
    return bolan_sea_state_from_wind(0.836 * force * sqrt(force), from_deg, HUGE_VAL);
}

bolan_sea_state bolan_sea_state_from_douglas(int degree, double from_deg) {
    static const double middle[10] = {0.0, 0.05, 0.3, 0.875, 1.875, 3.25, 5.0, 7.5, 11.5, 16.0};
    BOLAN_ASSERT(degree >= 0 && degree <= 9);
    const double hs = middle[degree < 0 ? 0 : degree > 9 ? 9 : degree];
    const double wind_speed = sqrt(hs * BOLAN_GRAVITY / PM_HEIGHT) / PM_WIND_RATIO;
    return bolan_sea_state_from_wind(wind_speed, from_deg, HUGE_VAL);
}

// ---- validation -----------------------------------------------------------------------------------------------------

static bolan_result validate_system(const bolan_wave_system *system, uint32_t index) {
    char where[48];
    snprintf(where, sizeof where, "bolan_sea_state: systems[%u].", (unsigned)index);
    return bolan_params_validate(&bolan_wave_system_params, system, where);
}

bolan_result bolan_sea_state_validate(const bolan_sea_state *sea_state) {
    BOLAN_ASSERT(sea_state);
    if (sea_state->system_count > BOLAN_MAX_WAVE_SYSTEMS) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "bolan_sea_state: system_count is %u; expected 0 to %d",
                  (unsigned)sea_state->system_count, BOLAN_MAX_WAVE_SYSTEMS);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (bolan_params_validate(&bolan_sea_state_params, sea_state, "bolan_sea_state: ")) return BOLAN_ERROR_ARGUMENT;
    for (uint32_t i = 0; i < sea_state->system_count; i++)
        if (validate_system(&sea_state->systems[i], i)) return BOLAN_ERROR_ARGUMENT;
    return BOLAN_OK;
}

bolan_result bolan_sea_state_add_system(bolan_sea_state *sea_state, const bolan_wave_system *system) {
    BOLAN_ASSERT(sea_state && system);
    if (sea_state->system_count >= BOLAN_MAX_WAVE_SYSTEMS) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE,
                  "bolan_sea_state: another system does not fit, the sea has %u systems; expected fewer than %d",
                  (unsigned)sea_state->system_count, BOLAN_MAX_WAVE_SYSTEMS);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (validate_system(system, sea_state->system_count)) return BOLAN_ERROR_ARGUMENT;
    sea_state->systems[sea_state->system_count++] = *system;
    return BOLAN_OK;
}

bolan_result bolan_sea_state_add_swell(bolan_sea_state *sea_state, double hs, double tp, double from_deg,
                                       double spread_s) {
    BOLAN_ASSERT(sea_state);
    if (sea_state->system_count < BOLAN_MAX_WAVE_SYSTEMS && !(tp >= SWELL_PERIOD_MIN && tp <= SWELL_PERIOD_MAX)) {
        bolan_log(BOLAN_LOG_ERROR, isfinite(tp) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE,
                  "bolan_sea_state: swell tp is %g; expected %g to %g s", tp, SWELL_PERIOD_MIN, SWELL_PERIOD_MAX);
        return BOLAN_ERROR_ARGUMENT;
    }
    bolan_wave_system swell = bolan_wave_system_default();
    swell.hs = hs;
    swell.peak_omega = 2.0 * BOLAN_PI / tp;
    swell.gamma = 5.0; // a swell that has travelled is narrower than a wind sea: 3 to 10 (Goda 2010, section 2.3)
    swell.from_deg = from_deg;
    swell.spreading = BOLAN_SPREADING_COS2S;
    swell.spread_s = spread_s;
    return bolan_sea_state_add_system(sea_state, &swell);
}
