// SPDX-License-Identifier: MIT
/// @file spectrum_eval.h
/// A sea state prepared for fast evaluation of Psi(kx, ky): every constant of the wave systems (normalisation, widths,
/// directions) is computed once, so that a call costs well under a microsecond and the synthesis can fill millions of
/// wave numbers. Private to the library; the public functions of spectrum.h are prepare + evaluate.
#ifndef BOLAN_SPECTRUM_EVAL_H
#define BOLAN_SPECTRUM_EVAL_H

#include "bolan/spectrum.h"

#include <stdbool.h>

#define SPREADING_S_MAX 200.0 ///< the largest exponent of cos-2s

/// Constants of the spectrum and the spreading of Elfouhaily et al. (1997). See elfouhaily.c.
typedef struct spectrum_elfouhaily {
    double peak_k, peak_speed; ///< kp [rad/m] and cp [m/s]
    double log_gamma, width;   ///< of the peak, in sqrt(k/kp)
    double decay;              ///< Omega / sqrt(10)
    double long_level;         ///< alpha_p / 2
    double short_level;        ///< alpha_m / 2
    double friction;           ///< 0.13 u* / cm
} spectrum_elfouhaily;

typedef struct spectrum_system {
    bolan_spectrum_kind kind;
    double level;                    ///< S = level w^-5 exp(...) gamma^r; of OCHI_HUBBLE the factor on (wp/w)^power
    double peak_omega;               ///< [rad/s]
    double power;                    ///< of the tail w^-power
    double steepness;                ///< m in exp(-m (wp/w)^4): power / 4, so that the peak lies at wp
    double log_gamma;                ///< 0 without a peak enhancement
    double width_below, width_above; ///< of that enhancement, below and above the peak
    bool depth_limited;              ///< TMA
    spectrum_elfouhaily elfouhaily;  ///< of the kind or spreading of this name
    double cut;                      ///< l / g of Phillips's e^{-k^2 l^2} with k = w^2 / g; 0 for the others
    bolan_spreading_kind spreading;
    double s;            ///< exponent of COS2S; of MITSUYASU that at the peak
    double s_tail_power; ///< of HASSELMANN and MITSUYASU the power of w/wp above the peak
    double swell_s;      ///< 16 xi^2, Horvath's exponent before the factor tanh(wp/w)
    double to_x, to_y;   ///< unit vector of the mean direction the waves go
} spectrum_system;

/// Immutable once prepared. Holds a pointer to the measured spectrum of the sea state, which must stay alive.
typedef struct spectrum_eval {
    uint32_t system_count;
    bool any_depth_limited;
    spectrum_system systems[BOLAN_MAX_WAVE_SYSTEMS];
    const bolan_measured_spectrum *measured; ///< or NULL
    double measured_level;                   ///< factor on its densities
    double depth;
    double current_x, current_y; ///< [m/s]
    bolan_spectrum_frame frame;
    bool on_current; ///< densities are brought from the frame to the water: current.c
} spectrum_eval;

/// Prepares a valid sea state (bolan_sea_state_validate()). Allocates nothing.
spectrum_eval bolan_spectrum_eval_prepare(const bolan_sea_state *sea_state);

/// Multiplies the height of all waves by @p factor.
void bolan_spectrum_eval_scale(spectrum_eval *eval, double factor);

/// Psi(kx, ky) [m4], tail included; 0 at k = 0. As bolan_sea_state_wavenumber_density(). Thread-safe.
double bolan_spectrum_eval_psi(const spectrum_eval *eval, double kx, double ky);

/// k h of a wave of @p omega in still water; 0 where no system needs it.
double bolan_spectrum_relative_depth(const spectrum_eval *eval, double omega);

/// A wave whose frequency in the water is sigma, as the frame of the sea state sees it.
typedef struct spectrum_seen {
    double omega;  ///< frequency there [rad/s]; 0: it is not seen
    double factor; ///< S(sigma, th) over S(omega, th)
} spectrum_seen;
/// Of a wave of frequency @p sigma, wave number @p k and group speed @p group that goes along the unit vector (ux, uy),
/// on the current of @p eval.
spectrum_seen bolan_spectrum_seen(const spectrum_eval *eval, double sigma, double k, double group, double ux,
                                  double uy);

/// S(w, th) [m2 s/rad per rad] for waves that go along the unit vector (ux, uy), without the tail of a measured
/// spectrum. As bolan_sea_state_density(). @p omega > 0. Thread-safe.
double bolan_spectrum_eval_density(const spectrum_eval *eval, double omega, double ux, double uy);

/// S(w) [m2 s/rad]: the former over all directions. @p omega > 0. Thread-safe.
double bolan_spectrum_eval_omnidirectional(const spectrum_eval *eval, double omega);

spectrum_system bolan_spectrum_system_prepare(const bolan_wave_system *system);
/// S(w) [m2 s/rad]; @p kh is the relative depth of that wave, used by TMA only.
double bolan_spectrum_system_density(const spectrum_system *system, double omega, double kh);
/// D(w, th) [1/rad] by the cosine of the angle from the mean direction, -1..1.
double bolan_spectrum_system_spreading(const spectrum_system *system, double omega, double cosine);
/// First moment of D: the mean of cos th, 0..1.
double bolan_spectrum_system_mean_cosine(const spectrum_system *system, double omega);

/// The constants of Elfouhaily et al. for a peak and a wind.
spectrum_elfouhaily bolan_spectrum_elfouhaily_prepare(double peak_omega, double wind_speed);
/// S(w) [m2 s/rad] as in the paper, at the deep-water wave number of @p omega.
double bolan_spectrum_elfouhaily_density(const spectrum_elfouhaily *e, double omega);
/// m0 of that [m2].
double bolan_spectrum_elfouhaily_variance(const spectrum_elfouhaily *e);
/// Delta(w) of the spreading, 0..1.
double bolan_spectrum_elfouhaily_delta(const spectrum_elfouhaily *e, double omega);

/// U/cp of a wave system with its peak at @p peak_omega; 1 without wind.
double bolan_spectrum_wave_age(double wind_speed, double peak_omega);
/// Peak enhancement 1.7 + 6 log10(U/cp) of Donelan, Hamilton & Hui, from 1.7, and its width 0.08 (1 + 4 (U/cp)^-3).
void bolan_spectrum_donelan_peak(double wave_age, double *gamma, double *width);
/// The integral of x^-4 exp(-x^-4) gamma^r(x) over x = w/wp: m0 = level / wp^3 times it for the tails w^-4.
double bolan_spectrum_tail4_integral(double log_gamma, double width_below, double width_above);

/// 1 / C(gamma) = the integral over x of 5 x^-5 exp(-1.25 x^-4) gamma^r(x), 1 <= gamma <= 10; error < 1e-9.
double bolan_spectrum_peak_integral(double log_gamma);
/// N(s) = 2^{2s-1} Gamma(s+1)^2 / (pi Gamma(2s+1)), s >= 0; relative error < 1e-9.
double bolan_spectrum_cos2s_norm(double s);
/// ln of the integral of cos^2 th cos^{2s}(th/2) over +-90 degrees, 0 <= s <= 16; error < 1e-7.
double bolan_spectrum_cos2_swell_log_norm(double s);

#endif
