// SPDX-License-Identifier: MIT
/// @file file.h
/// Whole files in memory, and files that are being written. Private to src/io.
#ifndef BOLAN_IO_FILE_H
#define BOLAN_IO_FILE_H

#include "bolan/io.h"
#include "io/unfinished.h"

#include <stdio.h>

typedef struct file_text {
    char *data;  ///< a NUL follows the last byte
    size_t size; ///< [bytes]
} file_text;

/// Reads at most @p limit bytes; a longer file, a folder or an unreadable one is refused with a sentence.
bolan_result bolan_file_read(const char *path, size_t limit, file_text *out);
void bolan_file_release(file_text *text);
/// Opens a file to be read piece by piece; @p size receives its size, 0 of a device or pipe. IO with a sentence.
bolan_result bolan_file_open(const char *path, FILE **out, uint64_t *size);
/// Logs "PATH: cannot be read: REASON" by errno, and returns IO.
bolan_result bolan_file_cannot_read(const char *path);

enum { FILE_NAME_CAPACITY = BOLAN_PATH_MAX + 32 };

/// A file that is being written. A regular file is written under a temporary name beside its target and renamed at the
/// end; a device or pipe cannot be replaced and is written straight.
typedef struct file_output {
    char path[BOLAN_PATH_MAX];          ///< as the caller wrote it, for messages
    char target[BOLAN_PATH_MAX];        ///< the same with symbolic links followed to the end
    char temporary[FILE_NAME_CAPACITY]; ///< the file that is written now; "" for a device or pipe
    int file;                           ///< open for writing, or -1
    unfinished entry;
} file_output;

/// Finds the target, makes the temporary file and opens it. The new file gets the mode and the owner of the file that
/// it replaces. IO with a sentence: a folder, a file without write permission, a folder that cannot be written to.
bolan_result bolan_file_output_open(const char *path, file_output *out);
/// Closes the file and renames it to its target (@p keep), or removes it. IO with a sentence on failure; then no file
/// is left.
bolan_result bolan_file_output_finish(file_output *out, bool keep);

/// Writes everything; false with errno. A signal for a closed pipe (SIGPIPE) or a file that grows too large (SIGXFSZ)
/// would end the program: the signal is blocked in this thread, and errno states the cause.
bool bolan_file_write_all(int file, const void *data, size_t size);
/// The temporary name number @p attempt beside @p target, in the same folder: NAME.partPID. A long name is shortened to
/// what a folder can hold.
void bolan_file_temporary_name(const char *target, int attempt, char out[FILE_NAME_CAPACITY]);
/// Logs "PATH: cannot be written: REASON" by errno, and returns IO.
bolan_result bolan_file_cannot_write(const char *path);

/// @p name as seen from the folder of the file @p beside, into @p out; false when that is too long.
bool bolan_file_resolve(const char *beside, const char *name, char out[BOLAN_PATH_MAX]);

/// The part of a raster's name that is a file: all of it, or what stands behind a prefix of GDAL's, as in
/// NETCDF:f.nc:z, NETCDF:"f.nc":z or GTIFF_DIR:2:f.tif. Its first character; @p length receives how many.
const char *bolan_file_of_raster(const char *name, size_t *length);
/// Puts the folder of the file @p beside before that part, where it is a relative path; false when that is too long.
bool bolan_file_resolve_raster(const char *beside, char name[BOLAN_PATH_MAX]);

#endif
