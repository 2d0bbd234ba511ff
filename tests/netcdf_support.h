// SPDX-License-Identifier: MIT
/// @file netcdf_support.h
/// A writer of small NetCDF files of the classic layout, for tests: what is written here is read by Bolan's reader.
#ifndef BOLAN_TESTS_NETCDF_SUPPORT_H
#define BOLAN_TESTS_NETCDF_SUPPORT_H

#include "spectrum_support.h"

typedef struct nc_dimension {
    const char *name;
    uint32_t length; ///< 0: the record dimension
} nc_dimension;

/// A variable of doubles or of shorts, with up to two texts and a number as attributes.
typedef struct nc_variable {
    const char *name;
    int rank, axes[4];
    const double *values; ///< in the order of the axes
    const char *text_name, *text, *second_name, *second;
    const char *number_name;
    double number;
    bool shorts;
} nc_variable;

typedef struct nc_bytes {
    uint8_t data[1 << 16];
    size_t size;
} nc_bytes;

static inline void nc_word(nc_bytes *b, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) b->data[b->size++] = (uint8_t)(value >> shift);
}

static inline void nc_text(nc_bytes *b, const char *text) {
    nc_word(b, (uint32_t)strlen(text));
    memcpy(b->data + b->size, text, strlen(text));
    b->size += (strlen(text) + 3) / 4 * 4;
}

static inline void nc_double(nc_bytes *b, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    nc_word(b, (uint32_t)(bits >> 32));
    nc_word(b, (uint32_t)bits);
}

// One record of a variable, or all of it.
static inline void nc_values(nc_bytes *b, const nc_variable *v, const double *values, size_t count) {
    for (size_t k = 0; k < count; k++) {
        if (!v->shorts) nc_double(b, values[k]);
        if (v->shorts) nc_word(b, (uint32_t)(int32_t)values[k] << 16), b->size -= 2;
    }
}

static inline void nc_attributes(nc_bytes *b, const nc_variable *v) {
    const uint32_t count = (v->text_name != NULL) + (v->second_name != NULL) + (v->number_name != NULL);
    nc_word(b, count ? 12 : 0);
    nc_word(b, count);
    if (v->text_name) nc_text(b, v->text_name), nc_word(b, 2), nc_text(b, v->text);
    if (v->second_name) nc_text(b, v->second_name), nc_word(b, 2), nc_text(b, v->second);
    if (v->number_name) nc_text(b, v->number_name), nc_word(b, 6), nc_word(b, 1), nc_double(b, v->number);
}

/// The file as CDF-1 or CDF-2 bytes. @p records: of the record dimension, which only a first axis may be.
static inline void nc_write(nc_bytes *b, int version, uint32_t records, const nc_dimension *dimensions, uint32_t axes,
                            const nc_variable *variables, uint32_t count) {
    size_t begin_at[16], sizes[16];
    memset(b, 0, sizeof *b);
    memcpy(b->data, "CDF", 3);
    b->data[3] = (uint8_t)version;
    b->size = 4;
    nc_word(b, records);
    nc_word(b, 10);
    nc_word(b, axes);
    for (uint32_t i = 0; i < axes; i++) nc_text(b, dimensions[i].name), nc_word(b, dimensions[i].length);
    nc_word(b, 0), nc_word(b, 0); // global attributes
    nc_word(b, 11);
    nc_word(b, count);
    for (uint32_t i = 0; i < count; i++) {
        const nc_variable *v = &variables[i];
        sizes[i] = 1;
        nc_text(b, v->name);
        nc_word(b, (uint32_t)v->rank);
        for (int a = 0; a < v->rank; a++) {
            nc_word(b, (uint32_t)v->axes[a]);
            if (dimensions[v->axes[a]].length) sizes[i] *= dimensions[v->axes[a]].length;
        }
        nc_attributes(b, v);
        nc_word(b, v->shorts ? 3 : 6);
        nc_word(b, (uint32_t)((v->shorts ? 2 : 8) * sizes[i]));
        begin_at[i] = b->size;
        b->size += version == 2 ? 8 : 4;
    }
    uint32_t alone = 0; // a lone variable with records is not padded
    for (uint32_t i = 0; i < count; i++) alone += variables[i].rank > 0 && dimensions[variables[i].axes[0]].length == 0;
    for (uint32_t pass = 0; pass < 2; pass++) // variables without records, then the first record of the others
        for (uint32_t i = 0; i < count; i++) {
            const nc_variable *v = &variables[i];
            const bool record = v->rank > 0 && dimensions[v->axes[0]].length == 0;
            if (record != (pass == 1)) continue;
            nc_bytes at = {.size = 0};
            nc_word(&at, (uint32_t)b->size);
            memcpy(b->data + begin_at[i] + (version == 2 ? 4 : 0), at.data, 4);
            nc_values(b, v, v->values, sizes[i]);
            if (!record || alone != 1) b->size = (b->size + 3) / 4 * 4;
        }
    for (uint32_t r = 1; r < records; r++)
        for (uint32_t i = 0; i < count; i++) {
            const nc_variable *v = &variables[i];
            if (v->rank == 0 || dimensions[v->axes[0]].length) continue;
            nc_values(b, v, v->values + r * sizes[i], sizes[i]);
            if (alone != 1) b->size = (b->size + 3) / 4 * 4;
        }
}

static inline bolan_spectrum_texts nc_texts(const nc_bytes *b) {
    bolan_spectrum_texts texts = bolan_spectrum_texts_default();
    texts.density = (bolan_spectrum_text){"file.nc", (const char *)b->data, b->size};
    return texts;
}

#endif
