// SPDX-License-Identifier: MIT
// NetCDF-4 files, by netCDF-C. Its copy in the classic layout, made in memory, is what the core reads.
#include "io/unpack.h"

#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdlib.h>

enum { MOST_VARIABLES = 256, MOST_DIMENSIONS = 64 };

// Dimensions, all of a fixed length. Their numbers in both files are equal, since only the root group is read.
static int copy_frame(int from, int to) {
    int dimensions = 0, code = nc_inq_ndims(from, &dimensions);
    if (!code && dimensions > MOST_DIMENSIONS) code = NC_EMAXDIMS;
    for (int i = 0; i < dimensions && !code; i++) {
        char name[NC_MAX_NAME + 1];
        size_t length;
        int made;
        code = nc_inq_dim(from, i, name, &length);
        if (!code) code = nc_def_dim(to, name, length, &made);
    }
    return code;
}

// A variable whose type the classic layout has; the others (strings, 64-bit integers) become doubles or are left out.
static nc_type classic_type(nc_type type) {
    switch (type) {
    case NC_BYTE:
    case NC_CHAR:
    case NC_SHORT:
    case NC_INT:
    case NC_FLOAT:
    case NC_DOUBLE: return type;
    case NC_UBYTE:
    case NC_USHORT: return NC_INT;
    case NC_UINT:
    case NC_INT64:
    case NC_UINT64: return NC_DOUBLE;
    default: return NC_NAT;
    }
}

static int copy_attributes(int from, int variable, int to, int made) {
    int count = 0, code = nc_inq_varnatts(from, variable, &count);
    for (int i = 0; i < count && !code; i++) {
        char name[NC_MAX_NAME + 1];
        nc_type type;
        double value;
        size_t length;
        code = nc_inq_attname(from, variable, i, name);
        if (!code) code = nc_inq_att(from, variable, name, &type, &length);
        if (code || length == 0) continue;
        if (type == NC_CHAR) {
            code = nc_copy_att(from, variable, name, to, made);
        } else if (length == 1 && classic_type(type) != NC_NAT) {
            code = nc_get_att_double(from, variable, name, &value);
            if (!code) code = nc_put_att_double(to, made, name, NC_DOUBLE, 1, &value);
        }
    }
    return code;
}

static int define_variable(int from, int variable, int to, int *made) {
    char name[NC_MAX_NAME + 1];
    int rank, dimensions[NC_MAX_VAR_DIMS], code;
    nc_type type;
    *made = -1;
    code = nc_inq_var(from, variable, name, &type, &rank, dimensions, NULL);
    if (code || classic_type(type) == NC_NAT) return code;
    code = nc_def_var(to, name, classic_type(type), rank, dimensions, made);
    return code ? code : copy_attributes(from, variable, to, *made);
}

static int variable_size(int from, int variable, size_t *count) {
    int rank, dimensions[NC_MAX_VAR_DIMS];
    int code = nc_inq_var(from, variable, NULL, NULL, &rank, dimensions, NULL);
    *count = 1;
    for (int i = 0; i < rank && !code; i++) {
        size_t length;
        code = nc_inq_dimlen(from, dimensions[i], &length);
        if (!code && length > 0 && *count > SIZE_MAX / 16 / length) code = NC_EVARSIZE;
        *count *= length;
    }
    return code;
}

// The values, whole: as text, or as doubles that the library converts.
static int copy_values(int from, int variable, int to, int made, size_t limit) {
    size_t count;
    int code = variable_size(from, variable, &count);
    nc_type type;
    if (!code) code = nc_inq_vartype(from, variable, &type);
    if (code || count == 0) return code;
    if (count > limit) return NC_EVARSIZE;
    const size_t bytes = count * sizeof(double);
    void *values = bolan_allocate(bytes);
    if (!values) return NC_ENOMEM;
    if (type == NC_CHAR) {
        code = nc_get_var_text(from, variable, values);
        if (!code) code = nc_put_var_text(to, made, values);
    } else {
        code = nc_get_var_double(from, variable, values);
        if (!code) code = nc_put_var_double(to, made, values);
    }
    bolan_release(values, bytes);
    return code;
}

static int copy_all(int from, int to, size_t limit) {
    int count = 0, made[MOST_VARIABLES], code = nc_inq_nvars(from, &count);
    if (!code && count > MOST_VARIABLES) code = NC_EMAXVARS;
    if (!code) code = copy_frame(from, to);
    for (int i = 0; i < count && !code; i++) code = define_variable(from, i, to, &made[i]);
    if (!code) code = nc_enddef(to);
    for (int i = 0; i < count && !code; i++)
        if (made[i] >= 0) code = copy_values(from, i, to, made[i], limit);
    return code;
}

static bolan_result refuse(const char *path, int code) {
    if (code == NC_ENOMEM) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read it", path);
        return BOLAN_ERROR_MEMORY;
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_UNPACK, "%s: cannot be read as NetCDF-4: %s", path, nc_strerror(code));
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_unpack_netcdf4(const char *path, size_t limit, file_text *file) {
    if (!unpack_is_hdf5(file)) return BOLAN_OK;
    int from = -1, to = -1;
    NC_memio copy = {0, NULL, 0};
    int code = nc_open_mem(path, NC_NOWRITE, file->size, (void *)file->data, &from);
    if (!code) code = nc_create_mem("classic", NC_64BIT_OFFSET, 1 << 16, &to);
    if (!code) code = nc_set_fill(to, NC_NOFILL, NULL);
    if (!code) code = copy_all(from, to, limit / sizeof(float));
    if (to >= 0 && !code) code = nc_close_memio(to, &copy), to = -1;
    if (to >= 0) nc_abort(to);
    if (from >= 0) nc_close(from);
    char *exact = code ? NULL : bolan_allocate(copy.size + 1);
    if (exact) memcpy(exact, copy.memory, copy.size);
    if (!code && !exact) code = NC_ENOMEM;
    const size_t size = copy.size;
    free(copy.memory);
    if (code) return refuse(path, code);
    bolan_file_release(file);
    *file = (file_text){exact, size};
    return BOLAN_OK;
}
