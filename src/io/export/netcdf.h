// SPDX-License-Identifier: MIT
/// @file netcdf.h
/// NetCDF-3 with 64-bit offsets, as a stream: a header, variables without time, then a record for each time (NetCDF
/// Users' Guide, appendix B). Needs no library. Private to src/io/export.
#ifndef BOLAN_IO_EXPORT_NETCDF_H
#define BOLAN_IO_EXPORT_NETCDF_H

#include "io/export/writer.h"

enum { NC_MOST_DIMENSIONS = 16, NC_MOST_VARIABLES = 64, NC_MOST_ATTRIBUTES = 16, NC_TIME = 0 };

typedef struct nc_attribute {
    const char *name;
    const char *text; ///< NULL: the number
    double number;
} nc_attribute;

typedef struct nc_variable {
    char name[40];
    int dimension[3]; ///< with NC_TIME first where it has a record; -1: none
    bool is_double;   ///< else float
    nc_attribute attribute[NC_MOST_ATTRIBUTES];
    uint32_t attributes;
} nc_variable;

/// Dimension 0 is time.
typedef struct nc_file {
    char dimension[NC_MOST_DIMENSIONS][16];
    uint32_t length[NC_MOST_DIMENSIONS]; ///< [NC_TIME]: records
    uint32_t dimensions;
    nc_variable *variable;
    uint32_t variables;
    nc_attribute attribute[NC_MOST_ATTRIBUTES];
    uint32_t attributes;
} nc_file;

/// Adds text, or where it is NULL a number.
void bolan_nc_describe(nc_variable *v, const char *name, const char *text, double number);
/// Bytes of one variable, of one record where it has records.
uint64_t bolan_nc_size(const nc_file *f, const nc_variable *v);
/// Writes the header. Next come the variables without time, in their order, and then of each record those with time;
/// numbers are big-endian.
void bolan_nc_write_header(const nc_file *f, export_writer *w);

#endif
