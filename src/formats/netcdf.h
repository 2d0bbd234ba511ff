// SPDX-License-Identifier: MIT
/// @file netcdf.h
/// NetCDF of the classic layouts, CDF-1 and CDF-2 (64-bit offsets), from bytes in memory ("The NetCDF Classic Format
/// Specification", Unidata). The header is read once; every value that it promises lies inside the bytes. NetCDF-4 is
/// HDF5, which src/io rewrites. Private to src/formats.
#ifndef BOLAN_FORMATS_NETCDF_H
#define BOLAN_FORMATS_NETCDF_H

#include "formats/records.h"
#include "formats/text.h"

enum { NETCDF_MOST_DIMENSIONS = 64, NETCDF_MOST_VARIABLES = 256, NETCDF_MOST_AXES = 8 };

typedef enum netcdf_type {
    NETCDF_BYTE = 1,
    NETCDF_CHAR,
    NETCDF_SHORT,
    NETCDF_INT,
    NETCDF_FLOAT,
    NETCDF_DOUBLE
} netcdf_type;

typedef struct netcdf_dimension {
    text_word name;
    uint32_t length; ///< of the record dimension: the number of records
    bool record;
} netcdf_dimension;

typedef struct netcdf_variable {
    text_word name;
    netcdf_type type;
    uint32_t rank, axes[NETCDF_MOST_AXES]; ///< indices of the dimensions, the slowest first
    size_t attributes;                     ///< offset of its list of attributes
    uint64_t begin;                        ///< offset of its values
    uint64_t block;                        ///< values in a record, or all where it has none
    uint64_t step;                         ///< bytes from record to record; 0: it has none
    uint64_t count;                        ///< of all values; 0 where they do not lie inside the bytes
    double scale, offset;                  ///< value = number * scale + offset
    double fill, missing;                  ///< numbers that mark a missing value; NAN: none
} netcdf_variable;

typedef struct netcdf_file {
    const char *name; ///< for messages
    const uint8_t *data;
    size_t size;
    uint32_t dimension_count, variable_count;
    netcdf_dimension dimensions[NETCDF_MOST_DIMENSIONS];
    netcdf_variable variables[NETCDF_MOST_VARIABLES];
} netcdf_file;

/// Do the bytes begin as NetCDF of any kind does?
bool bolan_netcdf_is(const bolan_spectrum_text *text);
/// Reads the header. FORMAT (one sentence) for what is damaged, too large for the limits, or CDF-5.
bolan_result bolan_netcdf_open(const bolan_spectrum_text *text, netcdf_file *out);
/// The variable of a name; NULL where there is none.
const netcdf_variable *bolan_netcdf_find(const netcdf_file *file, const char *name);
/// Its axis with one of the names, which NULL ends; -1 where it has none.
int bolan_netcdf_axis(const netcdf_file *file, const netcdf_variable *variable, const char *const *names);
/// The length of an axis.
uint32_t bolan_netcdf_length(const netcdf_file *file, const netcdf_variable *variable, int axis);
/// Value @p index, in the order of the axes, unpacked; NAN where it is missing. @p index < count.
double bolan_netcdf_value(const netcdf_file *file, const netcdf_variable *variable, uint64_t index);
/// The text of an attribute; length 0 where there is none.
text_word bolan_netcdf_text(const netcdf_file *file, const netcdf_variable *variable, const char *name);
/// The characters of a variable of type CHAR in row @p row of its last axis, without what pads them.
text_word bolan_netcdf_row(const netcdf_file *file, const netcdf_variable *variable, uint64_t row);

/// A variable that must be there, numbers, and inside the file: FORMAT (one sentence) where it is not.
bolan_result bolan_netcdf_need(const netcdf_file *file, const char *name, const netcdf_variable **out);
/// Logs "NAME: variable V: expected WHAT" and returns FORMAT.
bolan_result bolan_netcdf_unexpected(const netcdf_file *file, const netcdf_variable *variable, const char *what);

/// Appends the times of a variable with CF units ("hours since 1900-01-01 00:00:00") to @p list. FORMAT, MEMORY.
bolan_result bolan_netcdf_times(const netcdf_file *file, const netcdf_variable *time, record_list *list);

#endif
