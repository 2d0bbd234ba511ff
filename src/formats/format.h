// SPDX-License-Identifier: MIT
/// @file format.h
/// The interface of a file format, one constant a .c file. A format only lists and reads: formats.c chooses the record
/// and the location, for all formats alike.
///
///     probe ──► records ──► (choice by number or time) ──► locations ──► (choice by number or place) ──► read
///
/// Private to src/formats.
#ifndef BOLAN_FORMATS_FORMAT_H
#define BOLAN_FORMATS_FORMAT_H

#include "formats/locations.h"
#include "formats/records.h"
#include "spectrum/measured.h"

/// What read() is to read.
typedef struct format_choice {
    const record_entry *record;
    const location_list *locations;
    uint32_t location; ///< index in them
} format_choice;

typedef struct spectrum_format {
    const char *name;  ///< one word
    const char *title; ///< for people
    /// Is the text of this format, by its first bytes? Text that no other format claims is cheap to refuse later.
    bool (*probe)(const bolan_spectrum_text *text);
    /// Lists the records in the order of the text. FORMAT, MEMORY.
    bolan_result (*records)(const bolan_spectrum_texts *texts, record_list *list);
    /// Lists the locations of one record; it adds none where the file is of one place that it does not give.
    bolan_result (*locations)(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list);
    /// One record at one location. The grid has its time and count of records already.
    bolan_result (*read)(const bolan_spectrum_texts *texts, const format_choice *choice,
                         const bolan_spectrum_options *options, spectrum_grid *grid);
} spectrum_format;

extern const spectrum_format bolan_format_swan, bolan_format_ww3, bolan_format_ndbc, bolan_format_datawell,
    bolan_format_triaxys, bolan_format_spotter, bolan_format_octopus;
extern const spectrum_format bolan_format_ww3_netcdf, bolan_format_era5, bolan_format_cdip, bolan_format_ndbc_netcdf;

/// All formats, in the order in which they are probed; NULL at the end.
extern const spectrum_format *const bolan_formats[];
/// The format of a text; NULL, with a sentence, where none claims it or it is empty.
const spectrum_format *bolan_format_of(const bolan_spectrum_text *text);

/// Texts whose format is known, and their records.
typedef struct format_file {
    const spectrum_format *format;
    const bolan_spectrum_texts *texts;
    const char *name; ///< for messages
    record_list records;
} format_file;

/// Finds the format and lists the records, in the order of time. FORMAT, MEMORY; bolan_format_close() is due in any
/// case.
bolan_result bolan_format_open(const bolan_spectrum_texts *texts, format_file *out);
void bolan_format_close(format_file *file);
/// Reads one record at one location. @p own_directions, unless NULL, receives whether the file has directions.
bolan_result bolan_format_read(const format_file *file, const format_choice *choice,
                               const bolan_spectrum_options *options, spectrum_notes *notes, bool *own_directions,
                               bolan_measured_spectrum **out);

/// Reads @p count ascending frequencies [Hz].
bolan_result bolan_format_read_frequencies(text_cursor *text, double *hertz, uint32_t count);

#endif
