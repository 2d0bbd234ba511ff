// SPDX-License-Identifier: MIT
// Sea-state tables and the empirical laws of the short waves.
#include "bolan/math.h"
#include "bolan/spectrum.h"
#include "spectrum/portable.h"

// WMO Manual on Codes, code table 3700 "state of the sea".
const bolan_douglas_row bolan_douglas_table[10] = {
    {0, 0.00, 0.00, "calm (glassy)"},  {1, 0.00, 0.10, "calm (rippled)"}, {2, 0.10, 0.50, "smooth (wavelets)"},
    {3, 0.50, 1.25, "slight"},         {4, 1.25, 2.50, "moderate"},       {5, 2.50, 4.00, "rough"},
    {6, 4.00, 6.00, "very rough"},     {7, 6.00, 9.00, "high"},           {8, 9.00, 14.0, "very high"},
    {9, 14.0, HUGE_VAL, "phenomenal"},
};

// WMO Beaufort scale: wind at 10 m, probable wave height in the open sea.
const bolan_beaufort_row bolan_beaufort_table[13] = {
    {0, 0.0, 0.2, 0.0, "calm"},
    {1, 0.3, 1.5, 0.1, "light air"},
    {2, 1.6, 3.3, 0.2, "light breeze"},
    {3, 3.4, 5.4, 0.6, "gentle breeze"},
    {4, 5.5, 7.9, 1.0, "moderate breeze"},
    {5, 8.0, 10.7, 2.0, "fresh breeze"},
    {6, 10.8, 13.8, 3.0, "strong breeze"},
    {7, 13.9, 17.1, 4.0, "near gale"},
    {8, 17.2, 20.7, 5.5, "gale"},
    {9, 20.8, 24.4, 7.0, "strong gale"},
    {10, 24.5, 28.4, 9.0, "storm"},
    {11, 28.5, 32.6, 11.5, "violent storm"},
    {12, 32.7, HUGE_VAL, 14.0, "hurricane"},
};

int bolan_douglas_from_hs(double hs) {
    int degree = 0;
    while (degree < 9 && hs > bolan_douglas_table[degree].hs_max) degree++;
    return degree;
}

int bolan_beaufort_from_wind(double wind_speed) {
    int force = 0;
    // The classes are stated to a tenth of a metre per second, so a bound lies half a tenth below the next class.
    while (force < 12 && wind_speed >= bolan_beaufort_table[force + 1].wind_min - 0.05) force++;
    return force;
}

// Cox & Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", J. Opt. Soc. Am.
// 44 (1954): the clean-surface regressions. That across the wind does not vanish in a calm, within its scatter of
// 0.002; a calm mirrors, so its constant fades below the winds that were measured.
#define LEAST_MEASURED_WIND 0.72 // [m/s]
void bolan_cox_munk(double wind_speed, double *mss_up, double *mss_cross) {
    const double known = wind_speed < LEAST_MEASURED_WIND ? wind_speed / LEAST_MEASURED_WIND : 1.0;
    *mss_up = 3.16e-3 * wind_speed;
    *mss_cross = 0.003 * known + 1.92e-3 * wind_speed;
}

// Monahan & O'Muircheartaigh, "Optimal power-law description of oceanic whitecap coverage dependence on wind speed",
// J. Phys. Oceanogr. 10 (1980), the robust fit.
#define MOST_COVER 0.95
double bolan_monahan_cover(double wind_speed) {
    if (!(wind_speed > 0.0)) return 0.0;
    const double cover = 3.84e-6 * portable_pow(wind_speed, 3.41);
    return cover < MOST_COVER ? cover : MOST_COVER;
}

// Callaghan, de Leeuw, Cohen & O'Dowd, "Relationship of oceanic whitecap coverage to wind speed and wind history",
// Geophys. Res. Lett. 35 (2008): two overlapping regressions. On either side of their crossing, the smaller one holds.
double bolan_callaghan_cover(double wind_speed) {
    const double over = wind_speed - 3.70, past = wind_speed + 1.98;
    if (!(over > 0.0)) return 0.0;
    const double cover = fmin(3.18e-5 * over * over * over, 4.82e-6 * past * past * past);
    return cover < MOST_COVER ? cover : MOST_COVER;
}

// Monahan, "Occurrence and evolution of acoustically relevant sub-surface bubble plumes and their associated, remotely
// monitorable, surface whitecaps" (1993): stage A. No more than all whitecaps together.
double bolan_breaker_cover(double wind_speed) {
    if (!(wind_speed > 0.0)) return 0.0;
    return fmin(3.16e-7 * portable_pow(wind_speed, 3.2), bolan_callaghan_cover(wind_speed));
}
