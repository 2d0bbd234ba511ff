// SPDX-License-Identifier: MIT
/// @file ndbc_table.h
/// Tables of the US National Data Buoy Center (NDBC, "Measurement descriptions and units"), in both of their layouts:
///
///   history     YYYY MM DD hh [mm]  .030  .040 ...            frequencies in the header; r1, r2 in hundredths
///               2000 01 01 00        .00   .12 ...
///   real time   #YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >
///               2020 06 08 03 50 0.225 0.000 (0.033) ...      newest first; r1, r2 as fractions
///
/// 999 is a missing value everywhere. Private to src/formats.
#ifndef BOLAN_FORMATS_NDBC_TABLE_H
#define BOLAN_FORMATS_NDBC_TABLE_H

#include "formats/records.h"
#include "spectrum/measured.h"

/// The quantity of a table, as its header states it.
typedef enum ndbc_quantity { NDBC_UNNAMED, NDBC_SPEC, NDBC_ALPHA1, NDBC_ALPHA2, NDBC_R1, NDBC_R2 } ndbc_quantity;
extern const char *const bolan_ndbc_quantity_names[]; ///< in words, by ndbc_quantity

/// One table, opened at its header.
typedef struct ndbc_table {
    text_cursor rows; ///< after the header
    text_cursor header;
    int date_words;  ///< 4 or 5
    bool pairs;      ///< "value (frequency)": real time
    bool separation; ///< a Sep_Freq column
    ndbc_quantity quantity;
} ndbc_table;

/// One row: the values at frequencies.
typedef struct ndbc_row {
    uint32_t count;
    double hertz[SPECTRUM_MAX_FREQUENCIES], value[SPECTRUM_MAX_FREQUENCIES];
} ndbc_row;

#define NDBC_MISSING 999.0

/// Does a text begin as NDBC's tables do: "YY", "YYYY", "#YY" or "#YYYY"?
bool bolan_ndbc_is_header(text_word first);
/// Reads the header; a table of another quantity is refused with its name.
bolan_result bolan_ndbc_open(const bolan_spectrum_text *text, ndbc_table *table);
/// The next row; false at the end.
bool bolan_ndbc_next_row(ndbc_table *table, text_cursor *line);
/// Reads the date at the start of a row; the rest of the row stays in @p line. Impossible dates are refused.
bolan_result bolan_ndbc_read_date(const ndbc_table *table, text_cursor *line, record_date *date);
/// A whole row.
bolan_result bolan_ndbc_read_row(const ndbc_table *table, text_cursor line, ndbc_row *row);

#endif
