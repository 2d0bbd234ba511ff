// SPDX-License-Identifier: MIT
// See netcdf.h. The header in the specification's notation:
//
//     'CDF' version  numrecs  dim_list  att_list  var_list
//     dim_list, att_list, var_list = 0 0 | tag count entries; names and values are padded to 4 bytes
//     var = name rank dimids att_list type vsize begin
//
// vsize is not believed: it follows from the dimensions.
#include "formats/netcdf.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TAG_DIMENSION = 10, TAG_VARIABLE = 11, TAG_ATTRIBUTE = 12, STREAMING = -1 };

static const uint8_t type_bytes[7] = {0, 1, 1, 2, 4, 4, 8};

// A place in the header; once bad it stays so, and reads zeros.
typedef struct cursor {
    const uint8_t *data;
    size_t size, at;
    bool bad;
} cursor;

// ---- numbers of big-endian bytes ------------------------------------------------------------------------------------

static uint64_t big_endian(const uint8_t *p, uint32_t bytes) {
    uint64_t value = 0;
    for (uint32_t i = 0; i < bytes; i++) value = value << 8 | p[i];
    return value;
}

static double number_at(const uint8_t *p, netcdf_type type) {
    const uint64_t bits = big_endian(p, type_bytes[type]);
    const uint32_t low = (uint32_t)bits;
    float narrow;
    double wide;
    switch (type) {
    case NETCDF_BYTE:
    case NETCDF_CHAR: return (int8_t)bits;
    case NETCDF_SHORT: return (int16_t)bits;
    case NETCDF_INT: return (int32_t)bits;
    case NETCDF_FLOAT: memcpy(&narrow, &low, sizeof narrow); return narrow;
    default: memcpy(&wide, &bits, sizeof wide); return wide;
    }
}

static uint64_t take(cursor *c, uint32_t bytes) {
    if (c->bad || c->size - c->at < bytes) {
        c->bad = true;
        return 0;
    }
    c->at += bytes;
    return big_endian(c->data + c->at - bytes, bytes);
}

static uint32_t take_word(cursor *c) { return (uint32_t)take(c, 4); }

static void skip(cursor *c, uint64_t bytes) {
    const uint64_t padded = (bytes + 3) / 4 * 4;
    if (c->bad || padded < bytes || c->size - c->at < padded) {
        c->bad = true;
    } else {
        c->at += (size_t)padded;
    }
}

static text_word take_name(cursor *c) {
    const uint32_t length = take_word(c);
    const size_t at = c->at;
    skip(c, length);
    return c->bad ? (text_word){"", 0, 1} : (text_word){(const char *)c->data + at, length, 1};
}

// The count of a list; 0 where it is absent.
static uint32_t take_list(cursor *c, uint32_t tag) {
    const uint32_t found = take_word(c), count = take_word(c);
    if (found != tag && (found != 0 || count != 0)) c->bad = true;
    return c->bad ? 0 : count;
}

// ---- attributes -----------------------------------------------------------------------------------------------------

typedef struct attribute {
    text_word name;
    netcdf_type type;
    uint32_t count;
    const uint8_t *values;
} attribute;

static attribute take_attribute(cursor *c) {
    attribute a = {.name = take_name(c)};
    const uint32_t type = take_word(c);
    a.count = take_word(c);
    if (type < NETCDF_BYTE || type > NETCDF_DOUBLE) c->bad = true;
    a.type = c->bad ? NETCDF_BYTE : (netcdf_type)type;
    a.values = c->data + c->at;
    skip(c, (uint64_t)a.count * type_bytes[a.type]);
    if (c->bad) a.count = 0;
    return a;
}

static void skip_attributes(cursor *c) {
    for (uint32_t n = take_list(c, TAG_ATTRIBUTE); n > 0 && !c->bad; n--) take_attribute(c);
}

static attribute find_attribute(const netcdf_file *file, const netcdf_variable *v, const char *name) {
    cursor c = {file->data, file->size, v->attributes, false};
    for (uint32_t n = take_list(&c, TAG_ATTRIBUTE); n > 0 && !c.bad; n--) {
        const attribute a = take_attribute(&c);
        if (bolan_text_equals(a.name, name)) return a;
    }
    return (attribute){.count = 0};
}

static double number_attribute(const netcdf_file *file, const netcdf_variable *v, const char *name, double otherwise) {
    const attribute a = find_attribute(file, v, name);
    return a.count > 0 && a.type != NETCDF_CHAR ? number_at(a.values, a.type) : otherwise;
}

text_word bolan_netcdf_text(const netcdf_file *file, const netcdf_variable *v, const char *name) {
    const attribute a = find_attribute(file, v, name);
    if (a.count == 0 || a.type != NETCDF_CHAR) return (text_word){"", 0, 1};
    return (text_word){(const char *)a.values, strnlen((const char *)a.values, a.count), 1};
}

// ---- the header -----------------------------------------------------------------------------------------------------

static bolan_result refuse(const netcdf_file *file, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s: %s", file->name, what);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result read_dimensions(netcdf_file *file, cursor *c, uint32_t records) {
    const uint32_t count = take_list(c, TAG_DIMENSION);
    if (count > NETCDF_MOST_DIMENSIONS) return refuse(file, "a NetCDF header of more than 64 dimensions");
    for (uint32_t i = 0; i < count; i++) {
        netcdf_dimension *d = &file->dimensions[i];
        d->name = take_name(c);
        d->length = take_word(c);
        d->record = d->length == 0;
        if (d->record) d->length = records;
    }
    file->dimension_count = count;
    return BOLAN_OK;
}

static void read_variable(netcdf_file *file, cursor *c, bool wide, netcdf_variable *v) {
    v->name = take_name(c);
    v->rank = take_word(c);
    if (v->rank > NETCDF_MOST_AXES) c->bad = true;
    for (uint32_t i = 0; i < v->rank && !c->bad; i++) {
        v->axes[i] = take_word(c);
        if (v->axes[i] >= file->dimension_count || (i > 0 && file->dimensions[v->axes[i]].record)) c->bad = true;
    }
    v->attributes = c->at;
    skip_attributes(c);
    const uint32_t type = take_word(c);
    if (type < NETCDF_BYTE || type > NETCDF_DOUBLE) c->bad = true;
    v->type = c->bad ? NETCDF_BYTE : (netcdf_type)type;
    take_word(c); // vsize
    v->begin = take(c, wide ? 8 : 4);
}

static bool has_records(const netcdf_file *file, const netcdf_variable *v) {
    return v->rank > 0 && file->dimensions[v->axes[0]].record;
}

// Values in a record, or all; 0 where that is beyond any file.
static uint64_t block_of(const netcdf_file *file, const netcdf_variable *v) {
    uint64_t block = 1;
    for (uint32_t i = has_records(file, v); i < v->rank; i++) {
        block *= file->dimensions[v->axes[i]].length; // below 2^40 times below 2^32
        if (block > (uint64_t)1 << 31) return 0;
    }
    return block;
}

// Where the values lie. Each record holds all record variables in turn, padded to 4 bytes unless there is but one.
static void lay_out(netcdf_file *file) {
    uint64_t step = 0, only = 0;
    uint32_t with_records = 0;
    for (uint32_t i = 0; i < file->variable_count; i++) {
        netcdf_variable *v = &file->variables[i];
        v->block = block_of(file, v);
        if (!has_records(file, v)) continue;
        with_records++;
        only = v->block * type_bytes[v->type];
        step += (only + 3) / 4 * 4;
    }
    if (with_records == 1) step = only;
    for (uint32_t i = 0; i < file->variable_count; i++) {
        netcdf_variable *v = &file->variables[i];
        const uint64_t bytes = v->block * type_bytes[v->type], room = file->size - v->begin;
        uint64_t records = 1;
        if (has_records(file, v)) {
            v->step = step;
            records = file->dimensions[v->axes[0]].length;
        }
        if (v->begin > file->size || bytes > room || records == 0) continue;
        if (v->step > 0 && (records - 1) > (room - bytes) / v->step) continue;
        v->count = v->block * records;
    }
}

static void read_scales(netcdf_file *file) {
    for (uint32_t i = 0; i < file->variable_count; i++) {
        netcdf_variable *v = &file->variables[i];
        v->scale = number_attribute(file, v, "scale_factor", 1.0);
        v->offset = number_attribute(file, v, "add_offset", 0.0);
        v->fill = number_attribute(file, v, "_FillValue", (double)NAN);
        v->missing = number_attribute(file, v, "missing_value", (double)NAN);
    }
}

bool bolan_netcdf_is(const bolan_spectrum_text *text) {
    return text->data && text->size >= 4 && memcmp(text->data, "CDF", 3) == 0;
}

bolan_result bolan_netcdf_open(const bolan_spectrum_text *text, netcdf_file *file) {
    *file = (netcdf_file){
        .name = text->name ? text->name : "spectrum", .data = (const uint8_t *)text->data, .size = text->size};
    const uint8_t version = bolan_netcdf_is(text) ? file->data[3] : 0;
    if (version != 1 && version != 2)
        return refuse(file, version == 5 ? "NetCDF of the layout CDF-5; expected CDF-1 or CDF-2 (nccopy -k classic)"
                                         : "not NetCDF of the classic layout; expected CDF-1 or CDF-2");
    cursor c = {file->data, file->size, 4, false};
    const uint32_t records = take_word(&c);
    if (read_dimensions(file, &c, (int32_t)records == STREAMING ? 0 : records)) return BOLAN_ERROR_FORMAT;
    skip_attributes(&c);
    const uint32_t count = take_list(&c, TAG_VARIABLE);
    if (count > NETCDF_MOST_VARIABLES) return refuse(file, "a NetCDF header of more than 256 variables");
    for (uint32_t i = 0; i < count && !c.bad; i++) read_variable(file, &c, version == 2, &file->variables[i]);
    if (c.bad) return refuse(file, "the NetCDF header is damaged or cut off");
    file->variable_count = count;
    lay_out(file);
    read_scales(file);
    return BOLAN_OK;
}

// ---- variables ------------------------------------------------------------------------------------------------------

const netcdf_variable *bolan_netcdf_find(const netcdf_file *file, const char *name) {
    for (uint32_t i = 0; i < file->variable_count; i++)
        if (bolan_text_equals(file->variables[i].name, name)) return &file->variables[i];
    return NULL;
}

int bolan_netcdf_axis(const netcdf_file *file, const netcdf_variable *v, const char *const *names) {
    for (uint32_t i = 0; i < v->rank; i++)
        for (const char *const *name = names; *name; name++)
            if (bolan_text_equals(file->dimensions[v->axes[i]].name, *name)) return (int)i;
    return -1;
}

uint32_t bolan_netcdf_length(const netcdf_file *file, const netcdf_variable *v, int axis) {
    return file->dimensions[v->axes[axis]].length;
}

double bolan_netcdf_value(const netcdf_file *file, const netcdf_variable *v, uint64_t index) {
    const uint64_t record = v->block > 0 ? index / v->block : 0, inside = index - record * v->block;
    const double number = number_at(file->data + v->begin + record * v->step + inside * type_bytes[v->type], v->type);
    if (number == v->fill || number == v->missing || !isfinite(number)) return (double)NAN;
    return number * v->scale + v->offset;
}

text_word bolan_netcdf_row(const netcdf_file *file, const netcdf_variable *v, uint64_t row) {
    const uint64_t width = v->rank > 0 ? bolan_netcdf_length(file, v, (int)v->rank - 1) : 0;
    if (v->type != NETCDF_CHAR || v->step > 0 || width == 0 || (row + 1) * width > v->count)
        return (text_word){"", 0, 1};
    const char *text = (const char *)file->data + v->begin + row * width;
    return (text_word){text, strnlen(text, (size_t)width), 1};
}

bolan_result bolan_netcdf_unexpected(const netcdf_file *file, const netcdf_variable *v, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s: variable %.*s: expected %s", file->name,
              (int)(v->name.length < 64 ? v->name.length : 64), v->name.begin, what);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_netcdf_need(const netcdf_file *file, const char *name, const netcdf_variable **out) {
    *out = bolan_netcdf_find(file, name);
    if (!*out) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s: there is no variable %s; expected one", file->name,
                  name);
        return BOLAN_ERROR_FORMAT;
    }
    if ((*out)->type == NETCDF_CHAR) return bolan_netcdf_unexpected(file, *out, "numbers, not characters");
    if ((*out)->count > 0) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TRUNCATED,
              "%s: the file holds no values of the variable %s, or ends before them; is it cut off?", file->name, name);
    return BOLAN_ERROR_FORMAT;
}

// ---- times ----------------------------------------------------------------------------------------------------------

// "hours since 1900-01-01 00:00:00.0", "days since 1990-01-01T00:00:00Z": the length of a unit [s] and the origin.
static bool read_units(text_word units, double *length, record_date *origin) {
    static const struct {
        const char *name;
        double seconds;
    } known[] = {{"seconds", 1.0}, {"second", 1.0}, {"minutes", 60.0}, {"hours", 3600.0}, {"days", 86400.0}};
    text_cursor c = {"", units.begin, units.begin + units.length, 1, true};
    text_word unit, since, date, time;
    if (!bolan_text_next_word(&c, &unit) || !bolan_text_next_word(&c, &since) || !bolan_text_equals(since, "since") ||
        !bolan_text_next_word(&c, &date))
        return false;
    *length = 0.0;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (bolan_text_equals(unit, known[i].name)) *length = known[i].seconds;
    const bool has_time = bolan_text_next_word(&c, &time) && time.begin[0] >= '0' && time.begin[0] <= '9';
    char text[64];
    snprintf(text, sizeof text, "%.*s%s%.*s", (int)(date.length < 24 ? date.length : 24), date.begin,
             has_time ? "T" : "", has_time ? (int)(time.length < 24 ? time.length : 24) : 0, time.begin);
    char *dot = strchr(text, '.');
    if (dot) *dot = '\0';
    return *length > 0.0 && bolan_record_date_from_text(text, origin);
}

bolan_result bolan_netcdf_times(const netcdf_file *file, const netcdf_variable *time, record_list *list) {
    double length;
    record_date origin;
    const text_word calendar = bolan_netcdf_text(file, time, "calendar");
    const bool gregorian = calendar.length == 0 || bolan_text_equals(calendar, "gregorian") ||
                           bolan_text_equals(calendar, "standard") ||
                           bolan_text_equals(calendar, "proleptic_gregorian");
    if (!gregorian) return bolan_netcdf_unexpected(file, time, "the Gregorian calendar");
    if (!read_units(bolan_netcdf_text(file, time, "units"), &length, &origin))
        return bolan_netcdf_unexpected(file, time, "units such as \"hours since 1900-01-01 00:00:00\"");
    *list = (record_list){.timed = true, .style = RECORD_UTC_MINUTES};
    for (uint64_t i = 0; i < time->count; i++) {
        const double seconds = (double)bolan_record_date_seconds(&origin) + bolan_netcdf_value(file, time, i) * length;
        record_date date;
        if (!bolan_record_date_from_seconds(seconds, &date))
            return bolan_netcdf_unexpected(file, time, "times of the years 1900 to 2999");
        const bolan_result result = bolan_record_list_add(list, &date, (text_cursor){file->name, NULL, NULL, 1, false});
        if (result) return result;
    }
    return BOLAN_OK;
}
