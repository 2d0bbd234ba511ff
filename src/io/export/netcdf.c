// SPDX-License-Identifier: MIT
// See netcdf.h.
#include "io/export/netcdf.h"

#include <string.h>

enum { TAG_DIMENSIONS = 10, TAG_VARIABLES = 11, TAG_ATTRIBUTES = 12, TYPE_CHAR = 2, TYPE_FLOAT = 5, TYPE_DOUBLE = 6 };

void bolan_nc_describe(nc_variable *v, const char *name, const char *text, double number) {
    BOLAN_ASSERT(v->attributes < NC_MOST_ATTRIBUTES);
    if (v->attributes < NC_MOST_ATTRIBUTES) v->attribute[v->attributes++] = (nc_attribute){name, text, number};
}

uint64_t bolan_nc_size(const nc_file *f, const nc_variable *v) {
    uint64_t count = 1;
    for (int i = 0; i < 3; i++)
        if (v->dimension[i] > NC_TIME) count *= f->length[v->dimension[i]];
    return count * (v->is_double ? 8 : 4);
}

static uint64_t padded(uint64_t size) { return (size + 3) / 4 * 4; }

static void put_text(export_writer *w, const char *text) {
    const size_t length = strlen(text);
    bolan_export_u32(w, (uint32_t)length);
    bolan_export_bytes(w, text, length);
    for (size_t i = length; i % 4; i++) bolan_export_u8(w, 0);
}

static void put_attributes(export_writer *w, const nc_attribute *a, uint32_t count) {
    bolan_export_u32(w, count ? TAG_ATTRIBUTES : 0);
    bolan_export_u32(w, count);
    for (uint32_t i = 0; i < count; i++) {
        put_text(w, a[i].name);
        bolan_export_u32(w, a[i].text ? TYPE_CHAR : TYPE_DOUBLE);
        if (a[i].text) {
            put_text(w, a[i].text);
        } else {
            bolan_export_u32(w, 1);
            bolan_export_f64(w, a[i].number);
        }
    }
}

static uint64_t attributes_size(const nc_attribute *a, uint32_t count) {
    uint64_t size = 8;
    for (uint32_t i = 0; i < count; i++)
        size += 4 + padded(strlen(a[i].name)) + 8 + (a[i].text ? padded(strlen(a[i].text)) : 8);
    return size;
}

static int rank_of(const nc_variable *v) {
    int rank = 0;
    while (rank < 3 && v->dimension[rank] >= 0) rank++;
    return rank;
}

static uint64_t header_size(const nc_file *f) {
    uint64_t size = 8 + 8 + attributes_size(f->attribute, f->attributes) + 8;
    for (uint32_t i = 0; i < f->dimensions; i++) size += 4 + padded(strlen(f->dimension[i])) + 4;
    for (uint32_t i = 0; i < f->variables; i++) {
        const nc_variable *v = &f->variable[i];
        size += 4 + padded(strlen(v->name)) + 4 + 4 * (uint64_t)rank_of(v) +
                attributes_size(v->attribute, v->attributes) + 4 + 4 + 8;
    }
    return size;
}

static bool has_records(const nc_variable *v) { return v->dimension[0] == NC_TIME; }

// Where variable i begins; those with records stand behind all others.
static uint64_t begin_of(const nc_file *f, uint32_t i) {
    uint64_t at = header_size(f);
    for (uint32_t k = 0; k < f->variables; k++) {
        const bool before = has_records(&f->variable[i]) ? !has_records(&f->variable[k]) || k < i
                                                         : !has_records(&f->variable[k]) && k < i;
        if (before) at += bolan_nc_size(f, &f->variable[k]);
    }
    return at;
}

void bolan_nc_write_header(const nc_file *f, export_writer *w) {
    w->big_endian = true;
    bolan_export_bytes(w, "CDF\2", 4);
    bolan_export_u32(w, f->length[NC_TIME]);
    bolan_export_u32(w, TAG_DIMENSIONS);
    bolan_export_u32(w, f->dimensions);
    for (uint32_t i = 0; i < f->dimensions; i++) {
        put_text(w, f->dimension[i]);
        bolan_export_u32(w, i == NC_TIME ? 0 : f->length[i]);
    }
    put_attributes(w, f->attribute, f->attributes);
    bolan_export_u32(w, TAG_VARIABLES);
    bolan_export_u32(w, f->variables);
    for (uint32_t i = 0; i < f->variables; i++) {
        const nc_variable *v = &f->variable[i];
        put_text(w, v->name);
        bolan_export_u32(w, (uint32_t)rank_of(v));
        for (int k = 0; k < rank_of(v); k++) bolan_export_u32(w, (uint32_t)v->dimension[k]);
        put_attributes(w, v->attribute, v->attributes);
        bolan_export_u32(w, v->is_double ? TYPE_DOUBLE : TYPE_FLOAT);
        bolan_export_u32(w, (uint32_t)bolan_nc_size(f, v));
        bolan_export_u64(w, begin_of(f, i));
    }
}
