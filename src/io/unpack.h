// SPDX-License-Identifier: MIT
/// @file unpack.h
/// Bytes of a file that are packed in a way that the core does not read. Each way is one optional library; without it,
/// src/io/without says so. Private to src/io.
#ifndef BOLAN_IO_UNPACK_H
#define BOLAN_IO_UNPACK_H

#include "io/file.h"

#include <string.h>

/// Unpacks gzip in place; bytes that are not gzip stay as they are. FORMAT for damaged or endless bytes, IO beyond
/// @p limit bytes, MEMORY, UNSUPPORTED in a build without zlib.
bolan_result bolan_unpack_gzip(const char *path, size_t limit, file_text *file);

/// Rewrites NetCDF-4 (HDF5) as NetCDF of 64-bit offsets, in place; other bytes stay. FORMAT, IO beyond @p limit bytes,
/// MEMORY, UNSUPPORTED in a build without netCDF-C.
bolan_result bolan_unpack_netcdf4(const char *path, size_t limit, file_text *file);

/// The first bytes of both.
static inline bool unpack_is_gzip(const file_text *file) {
    return file->size >= 2 && (uint8_t)file->data[0] == 0x1f && (uint8_t)file->data[1] == 0x8b;
}
static inline bool unpack_is_hdf5(const file_text *file) {
    return file->size >= 8 && memcmp(file->data, "\x89HDF\r\n\x1a\n", 8) == 0;
}

#endif
