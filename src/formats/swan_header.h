// SPDX-License-Identifier: MIT
/// @file swan_header.h
/// The header of a SWAN spectral file ("SWAN 1"; SWAN user manual, appendix D):
///
///     SWAN 1 / TIME code / LONLAT or LOCATIONS n, n points / AFREQ or RFREQ n, n values
///     2-D:  NDIR or CDIR n, n values / QUANT 1, then VaDens or EnDens, unit, exception
///     1-D:  QUANT n, then for each quantity: name, unit, exception
///
/// Words matter, lines only where a remark may follow a value. Private to src/formats.
#ifndef BOLAN_FORMATS_SWAN_HEADER_H
#define BOLAN_FORMATS_SWAN_HEADER_H

#include "formats/text.h"
#include "spectrum/measured.h"

enum { SWAN_MAX_QUANTITIES = 8 };

typedef enum swan_role { SWAN_DENSITY, SWAN_FROM, SWAN_TO, SWAN_SPREAD } swan_role;

typedef struct swan_quantity {
    swan_role role;
    double exception; ///< marks a missing value
} swan_quantity;

typedef struct swan_header {
    text_cursor text;   ///< after the header
    text_cursor places; ///< at the first location
    bool spherical;     ///< locations are longitudes and latitudes
    bool has_times, ready;
    uint32_t time_code; ///< 1: ISO notation
    uint32_t locations, frequencies, quantities;
    uint32_t directions; ///< 0: a 1-D spectrum
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS];
    swan_quantity quantity[SWAN_MAX_QUANTITIES];
    double scale; ///< from the file's unit to m2/Hz/rad (2-D) or m2/Hz (1-D)
} swan_header;

/// The next word that is not in a $ comment.
bool bolan_swan_next_word(text_cursor *text, text_word *word);
/// Reads the header at the start of @p text. FORMAT.
bolan_result bolan_swan_read_header(const bolan_spectrum_text *text, swan_header *header);
/// The coordinates of the location at @p places, which moves on to the next.
bolan_result bolan_swan_read_place(text_cursor *places, double place[2]);

#endif
