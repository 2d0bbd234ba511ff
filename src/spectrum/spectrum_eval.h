// SPDX-License-Identifier: MIT
/// @file spectrum_eval.h
/// A sea state prepared for fast evaluation of Psi(kx, ky): every constant of the wave systems (normalisation, widths,
/// directions) is computed once, so that a call costs well under a microsecond and the synthesis can fill millions of
/// wave numbers. Private to the library; the public functions of spectrum.h are prepare + evaluate.
#ifndef BOLAN_SPECTRUM_EVAL_H
#define BOLAN_SPECTRUM_EVAL_H

#include "bolan/spectrum.h"

#include <stdbool.h>

typedef struct spectrum_system {
    double level;       ///< (5/16) Hs^2 wp^4 C(gamma): S = level w^-5 exp(...) gamma^r
    double peak_omega;  ///< [rad/s]
    double log_gamma;   ///< 0 for Pierson-Moskowitz
    bool depth_limited; ///< TMA
    double cut;         ///< l / g of Phillips's e^{-k^2 l^2} with k = w^2 / g; 0 for the others
    bolan_spreading_kind spreading;
    double s;            ///< exponent of COS2S
    double s_tail_power; ///< Hasselmann's exponent of w/wp above the peak
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
} spectrum_eval;

/// Prepares a valid sea state (bolan_sea_state_validate()). Allocates nothing.
spectrum_eval bolan_spectrum_eval_prepare(const bolan_sea_state *sea_state);

/// Multiplies the height of all waves by @p factor.
void bolan_spectrum_eval_scale(spectrum_eval *eval, double factor);

/// Psi(kx, ky) [m4], tail included; 0 at k = 0. As bolan_sea_state_wavenumber_density(). Thread-safe.
double bolan_spectrum_eval_psi(const spectrum_eval *eval, double kx, double ky);

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

/// 1 / C(gamma) = the integral over x of 5 x^-5 exp(-1.25 x^-4) gamma^r(x), 1 <= gamma <= 10; error < 1e-9.
double bolan_spectrum_peak_integral(double log_gamma);
/// N(s) = 2^{2s-1} Gamma(s+1)^2 / (pi Gamma(2s+1)), s >= 0; relative error < 1e-9.
double bolan_spectrum_cos2s_norm(double s);
/// ln of the integral of cos^2 th cos^{2s}(th/2) over +-90 degrees, 0 <= s <= 16; error < 1e-7.
double bolan_spectrum_cos2_swell_log_norm(double s);

#endif
