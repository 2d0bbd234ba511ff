// SPDX-License-Identifier: MIT
// Query points from CSV.
#include "io/file.h"
#include "formats/text.h"

#include <stdio.h>
#include <string.h>

enum { POINTS_FILE_LIMIT = 256 << 20 };

#define FARTHEST 1e8 // [m]

typedef struct field_list {
    text_word fields[4];
    int count; // up to 4; there may be more on the line
} field_list;

// Fields are separated by commas or semicolons, or by white space alone.
static field_list split(const char *begin, const char *end) {
    field_list list = {.count = 0};
    bool open = false, expected = true; // a field must come before the next comma
    for (const char *p = begin; p < end && list.count <= 4; p++) {
        const bool comma = *p == ',' || *p == ';', space = *p == ' ' || *p == '\t' || *p == '\r';
        if (comma && expected && list.count < 4)
            list.fields[list.count++] = (text_word){p, 0, 0}; // nothing between commas
        if (comma) expected = true;
        if (comma || space) {
            open = false;
            continue;
        }
        if (!open && list.count == 4) break;
        if (!open) list.fields[list.count++] = (text_word){p, 0, 0};
        list.fields[list.count - 1].length++;
        open = true;
        expected = false;
    }
    return list;
}

static bolan_result refuse(const char *name, uint32_t line, const text_word *field, const char *expected) {
    char found[32] = "the end of the line", word[32];
    if (field) {
        const size_t length = field->length < sizeof word - 1 ? field->length : sizeof word - 1;
        snprintf(word, sizeof word, "%.*s", (int)length, field->begin);
        const size_t shown = bolan_text_fit(word, 24);
        snprintf(found, sizeof found, "%s", "nothing");
        if (shown > 0) snprintf(found, sizeof found, "%.*s", (int)shown, word);
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_POINTS_SYNTAX, "%s:%u: found %s; expected %s", name, (unsigned)line, found,
              expected);
    return BOLAN_ERROR_FORMAT;
}

// A line of column names: it begins with x, quoted or not.
static bool is_header(const field_list *list) {
    const text_word *first = &list->fields[0];
    const size_t quote = first->length > 0 && first->begin[0] == '"';
    return first->length > quote && memchr("xX", first->begin[quote], 2);
}

// Programs that quote everything quote numbers too.
static bool read_number(text_word field, double *value) {
    const bool quoted = field.length > 2 && field.begin[0] == '"' && field.begin[field.length - 1] == '"';
    if (quoted) field = (text_word){field.begin + 1, field.length - 2, field.line};
    return bolan_parse_number(field.begin, field.length, value);
}

static bolan_result read_point(const char *name, uint32_t line, const field_list *list, bolan_dvec3 *point) {
    double values[3] = {0.0, 0.0, 0.0};
    static const char *const expected[3] = {"x, a number of metres within 1e8", "y, a number of metres within 1e8",
                                            "z, a number of metres within 1e8"};
    if (list->count > 3) return refuse(name, line, &list->fields[3], "x,y or x,y,z");
    for (int i = 0; i < list->count; i++)
        if (!read_number(list->fields[i], &values[i]) || fabs(values[i]) > FARTHEST)
            return refuse(name, line, &list->fields[i], expected[i]);
    if (list->count < 2) return refuse(name, line, NULL, expected[1]);
    *point = bolan_dv3(values[0], values[1], values[2]);
    return BOLAN_OK;
}

static bolan_result append(bolan_points *points, bolan_dvec3 point) {
    if (points->count == points->capacity) {
        const size_t larger = points->capacity ? 2 * points->capacity : 256;
        bolan_dvec3 *memory = larger > UINT32_MAX ? NULL : bolan_allocate(larger * sizeof *memory);
        if (!memory) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for %zu points", larger);
            return BOLAN_ERROR_MEMORY;
        }
        if (points->count) memcpy(memory, points->points, points->count * sizeof *memory);
        bolan_release(points->points, points->capacity * sizeof *memory);
        points->points = memory;
        points->capacity = larger;
    }
    points->points[points->count++] = point;
    return BOLAN_OK;
}

static bolan_result parse_lines(const char *name, const char *text, size_t size, bolan_points *points) {
    const char *end = text + size;
    bool first = true;
    uint32_t line = 1;
    for (const char *next = text; next < end; line++) {
        const char *newline = memchr(next, '\n', (size_t)(end - next));
        const char *stop = newline ? newline : end, *comment = memchr(next, '#', (size_t)(stop - next));
        const field_list list = split(next, comment ? comment : stop);
        next = newline ? newline + 1 : end;
        if (list.count == 0) continue;
        const bool header = first && is_header(&list);
        first = false;
        if (header) continue;
        bolan_dvec3 point = {0.0, 0.0, 0.0};
        bolan_result result = read_point(name, line, &list, &point);
        if (!result) result = append(points, point);
        if (result) return result;
    }
    return BOLAN_OK;
}

bolan_result bolan_points_parse(const char *name, const char *text, size_t size, bolan_points *out) {
    BOLAN_ASSERT(name && (text || size == 0) && out);
    *out = (bolan_points){0, NULL, 0};
    const size_t mark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0; // a byte-order mark
    bolan_result result = size ? parse_lines(name, text + mark, size - mark, out) : BOLAN_OK;
    if (!result && out->count == 0) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_POINTS_SYNTAX,
                  "%s: there is no point in it; expected lines of x,y or x,y,z", name);
        result = BOLAN_ERROR_FORMAT;
    }
    if (result) bolan_points_destroy(out);
    return result;
}

bolan_result bolan_points_load(const char *path, bolan_points *out) {
    BOLAN_ASSERT(path && out);
    *out = (bolan_points){0, NULL, 0};
    file_text text;
    bolan_result result = bolan_file_read(path, POINTS_FILE_LIMIT, &text);
    if (!result) result = bolan_points_parse(path, text.data, text.size, out);
    bolan_file_release(&text);
    return result;
}

void bolan_points_destroy(bolan_points *points) {
    if (!points) return;
    bolan_release(points->points, points->capacity * sizeof *points->points);
    *points = (bolan_points){0, NULL, 0};
}
