// SPDX-License-Identifier: MIT
/// @file writer.h
/// A file of an export, written piece by piece through a buffer. Private to src/io/export.
///
/// Errors are kept: after one nothing more is written, and export_close() reports it.
#ifndef BOLAN_IO_EXPORT_WRITER_H
#define BOLAN_IO_EXPORT_WRITER_H

#include "bolan/io.h"

#include <stdarg.h>

typedef struct export_writer {
    const char *path;
    bolan_file_stream *stream;
    uint8_t *buffer;
    size_t used;
    bolan_result result;
    bool big_endian; ///< of the numbers; default false
} export_writer;

/// Begins the file. On failure, which is logged, the writer needs no close.
bolan_result bolan_export_open(const char *path, export_writer *out);
void bolan_export_bytes(export_writer *w, const void *bytes, size_t size);
void bolan_export_u8(export_writer *w, uint8_t value);
void bolan_export_u32(export_writer *w, uint32_t value);
void bolan_export_u64(export_writer *w, uint64_t value);
void bolan_export_f32(export_writer *w, float value);
void bolan_export_f64(export_writer *w, double value);
/// As printf(), at most 1023 bytes; for words and whole numbers, which no locale changes.
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void bolan_export_text(export_writer *w, const char *format, ...);
/// A number in the C locale: 9 digits read back as the same float.
void bolan_export_number(export_writer *w, double value, int digits);
/// Flushes, and gives the file its name; or removes it where @p keep is false or something failed. Returns the first
/// error of the writer, else OK.
bolan_result bolan_export_close(export_writer *w, bool keep);

/// Whether a path ends in a suffix and has something before it.
bool bolan_export_has_suffix(const char *path, const char *suffix);

#endif
