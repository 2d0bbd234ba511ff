// SPDX-License-Identifier: MIT
/// @file measured.h
/// The inside of a measured spectrum, and the way from a parsed grid to it. Private to src/spectrum.
#ifndef BOLAN_SPECTRUM_MEASURED_H
#define BOLAN_SPECTRUM_MEASURED_H

#include "bolan/spectrum.h"

#include <stdbool.h>

enum {
    SPECTRUM_MIN_FREQUENCIES = 2,
    SPECTRUM_MAX_FREQUENCIES = 1000,
    SPECTRUM_MIN_DIRECTIONS = 3,
    SPECTRUM_MAX_DIRECTIONS = 720,
};

#define SPECTRUM_MIN_HERTZ 1e-5 ///< of a file's frequencies: a day
#define SPECTRUM_MAX_HERTZ 100.0

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
};

/// What a parser found: any direction order and step, hertz, and density per hertz and radian.
typedef struct spectrum_grid {
    uint32_t frequency_count, direction_count, record_count;
    double *hertz;  ///< [frequency]
    double *to;     ///< [direction] mathematical angle the waves go [rad]
    double *energy; ///< [frequency][direction] [m2/Hz/rad]
    char time[32];
} spectrum_grid;

/// Reserves the arrays of a grid whose counts are set; false (logged) when memory is short.
bool spectrum_grid_allocate(spectrum_grid *grid);
void spectrum_grid_release(spectrum_grid *grid);

/// Sorts the directions, brings them to a constant step, changes the units and adds the tail. @p name is for messages.
bolan_result spectrum_measured_build(const char *name, const spectrum_grid *grid, bolan_measured_spectrum **out);

/// S(w, th) by bilinear interpolation; 0 outside the file's frequencies, or the tail above them when @p with_tail.
/// Integrated over th it is the rectangle rule of the grid, over w the trapezoid rule: it conserves the file's m0.
/// @p theta in [0, 2 pi).
double spectrum_measured_density(const bolan_measured_spectrum *measured, double omega, double theta, bool with_tail);

/// The parsers: one record of one text to a grid, which the caller releases, also after failure.
bolan_result spectrum_parse_swan(const bolan_spectrum_texts *texts, uint32_t record, spectrum_grid *grid);
bolan_result spectrum_parse_ndbc(const bolan_spectrum_texts *texts, uint32_t record, spectrum_grid *grid);

#endif
