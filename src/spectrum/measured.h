// SPDX-License-Identifier: MIT
/// @file measured.h
/// The inside of a measured spectrum, and the way from a grid that was read to it. Private to the library.
#ifndef BOLAN_SPECTRUM_MEASURED_H
#define BOLAN_SPECTRUM_MEASURED_H

#include "bolan/spectrum.h"

#include "spectrum/notes.h"

#include <stdbool.h>

enum {
    SPECTRUM_MIN_FREQUENCIES = 2,
    SPECTRUM_MAX_FREQUENCIES = 1000,
    SPECTRUM_MIN_DIRECTIONS = 3,
    SPECTRUM_MAX_DIRECTIONS = 720,
};

#define SPECTRUM_MIN_HERTZ 1e-3     ///< of a file's frequencies: beyond the longest swell and infragravity waves
#define SPECTRUM_MAX_HERTZ 10.0     ///< well into the ripples
#define SPECTRUM_MAX_DENSITY 1e9    ///< [m2/Hz/rad]: far above any sea, far below overflow
#define SPECTRUM_MAX_HS 40.0        ///< twice the highest Hs that was ever measured [m]
#define SPECTRUM_PEAK_OMEGA_MIN 0.1 // of a wave system [rad/s]
#define SPECTRUM_PEAK_OMEGA_MAX 50.0

/// One allocation: this header, then the four arrays.
struct bolan_measured_spectrum {
    size_t bytes; ///< of the allocation
    uint32_t frequency_count, direction_count, record_count;
    double direction_step; ///< 2 pi / direction_count
    double *omega;         ///< [frequency] ascending [rad/s]
    double *theta;         ///< [direction] ascending, TO [rad]
    double *density;       ///< [frequency][direction] [m2 s/rad per rad]
    double *tail;          ///< [direction]: S(w, th) w^5 above the last frequency
    char time[32];
    bolan_measured_place place;
};

/// What a reader found: any direction order and step, hertz, and density per hertz and radian.
typedef struct spectrum_grid {
    uint32_t frequency_count, direction_count, record_count;
    double *hertz;  ///< [frequency]
    double *to;     ///< [direction] mathematical angle the waves go [rad]
    double *energy; ///< [frequency][direction] [m2/Hz/rad]
    char time[32];
    bolan_measured_place place;
    bool own_directions;  ///< the text has directions, so no default replaces them
    spectrum_notes notes; ///< warnings
} spectrum_grid;

/// Reserves the arrays of a grid whose counts are set; false (logged) when memory is short.
bool bolan_spectrum_grid_allocate(spectrum_grid *grid);
/// Like bolan_spectrum_grid_allocate(), for a text with directions: the counts, the frequencies and the angles (TO) are
/// copied.
bolan_result bolan_spectrum_grid_begin(spectrum_grid *grid, const double *hertz, uint32_t frequencies, const double *to,
                                       uint32_t directions);
void bolan_spectrum_grid_release(spectrum_grid *grid);

/// Sorts the directions, resamples them to a constant step, converts the units and adds the tail.
/// An impossible sea is refused; a spectrum without energy is a calm. @p name is for messages.
bolan_result bolan_spectrum_measured_build(const char *name, spectrum_grid *grid, bolan_measured_spectrum **out);

/// (1 - share) a + share b, in place of @p a. FORMAT (one sentence) where their frequencies or directions differ.
bolan_result bolan_spectrum_measured_blend(const char *name, bolan_measured_spectrum *a,
                                           const bolan_measured_spectrum *b, double share);

/// S(w, th) by bilinear interpolation; 0 outside the file's frequencies, or the tail above them when @p with_tail.
/// Integrated over th it is the rectangle rule of the grid, over w the trapezoid rule: it conserves the file's m0.
/// @p theta in [0, 2 pi).
double bolan_spectrum_measured_density(const bolan_measured_spectrum *measured, double omega, double theta,
                                       bool with_tail);

/// The weight of sample @p i of the trapezoid rule over ascending @p x.
double bolan_spectrum_trapezoid_weight(const double *x, uint32_t count, uint32_t i);

#endif
