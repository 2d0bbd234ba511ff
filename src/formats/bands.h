// SPDX-License-Identifier: MIT
/// @file bands.h
/// A spectrum by frequency bands, as a buoy or a 1-D file gives it, and the replacement of missing values. Private to
/// src/spectrum.
#ifndef BOLAN_FORMATS_BANDS_H
#define BOLAN_FORMATS_BANDS_H

#include "bolan/formats.h"

#include "spectrum/measured.h"

/// NAN marks what is missing.
typedef struct spectrum_bands {
    uint32_t count;
    double hertz[SPECTRUM_MAX_FREQUENCIES];
    double density[SPECTRUM_MAX_FREQUENCIES];                                  ///< [m2/Hz]
    double alpha1[SPECTRUM_MAX_FREQUENCIES], alpha2[SPECTRUM_MAX_FREQUENCIES]; ///< compass FROM [deg]
    double r1[SPECTRUM_MAX_FREQUENCIES], r2[SPECTRUM_MAX_FREQUENCIES];         ///< 0..1
} spectrum_bands;

/// A set of bands, which is too large for a stack; MEMORY (logged).
bolan_result bolan_spectrum_bands_create(spectrum_bands **out);
/// NULL-safe; NULLs the pointer.
void bolan_spectrum_bands_destroy(spectrum_bands **bands);
/// Every value missing; @ref count and hertz stay.
void bolan_spectrum_bands_clear(spectrum_bands *bands);
/// Fills the gaps and spreads each band over direction, into the arrays of the grid, which it allocates.
/// Each kind of replacement is one warning. @p why says why directions are missing ("has no table of directions beside
/// it").
/// Errors: FORMAT where no band has a density; MEMORY.
bolan_result bolan_spectrum_bands_to_grid(spectrum_bands *bands, const char *name, const char *why,
                                          const bolan_spectrum_options *options, spectrum_grid *grid);

#endif
