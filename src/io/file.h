// SPDX-License-Identifier: MIT
/// @file file.h
/// Whole files in memory, and names for files that are being written. Private to src/io.
#ifndef BOLAN_IO_FILE_H
#define BOLAN_IO_FILE_H

#include "bolan/io.h"

typedef struct file_text {
    char *data;  ///< a NUL follows the last byte
    size_t size; ///< [bytes]
} file_text;

/// Reads at most @p limit bytes; a longer file, a folder or an unreadable one is refused with a sentence.
bolan_result file_read(const char *path, size_t limit, file_text *out);
void file_release(file_text *text);

enum { FILE_NAME_CAPACITY = BOLAN_PATH_MAX + 32 };
/// Where to write what shall stand at @p path in the end: a name beside it, or @p path itself when that is a device or
/// pipe, which cannot be replaced. IO with a sentence when @p path is a folder or too long.
bolan_result file_temporary_name(const char *path, char out[FILE_NAME_CAPACITY]);
/// Moves the finished file to its name (@p keep), or removes it.
bolan_result file_finish(const char *temporary, const char *path, bool keep);
/// Logs "PATH: cannot be written: REASON" by errno, and returns IO.
bolan_result file_cannot_write(const char *path);

/// @p name as seen from the folder of the file @p beside, into @p out; false when that is too long.
bool file_resolve(const char *beside, const char *name, char out[BOLAN_PATH_MAX]);

/// The part of a raster's name that is a file: all of it, or what stands behind a prefix of GDAL's, as in
/// NETCDF:f.nc:z, NETCDF:"f.nc":z or GTIFF_DIR:2:f.tif. Its first character; @p length receives how many.
const char *file_of_raster(const char *name, size_t *length);
/// Puts the folder of the file @p beside before that part, where it is a relative path; false when that is too long.
bool file_resolve_raster(const char *beside, char name[BOLAN_PATH_MAX]);

#endif
