// SPDX-License-Identifier: MIT
/// @file spectrum_plot.h
/// A polar plot of a spectrum as PNG. Private to src/io.
#ifndef BOLAN_IO_SPECTRUM_PLOT_H
#define BOLAN_IO_SPECTRUM_PLOT_H

#include "bolan/io.h"

/// Draws @p spectrum, which is bolan_measured_spectrum_sample() of @p sea_state: frequency outwards, compass directions
/// that waves come FROM, density as colour, rings and spokes with their values, height and period, and the systems of
/// bolan_sea_state_partition() by numbers. Errors: IO, MEMORY.
bolan_result bolan_spectrum_plot(const char *path, const bolan_sea_state *sea_state,
                                 const bolan_measured_spectrum *spectrum, const char *title);

#endif
