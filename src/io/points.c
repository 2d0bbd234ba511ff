// SPDX-License-Identifier: MIT
// Query points from CSV.
#include "formats/text.h"
#include "io/file.h"

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

// A number may be quoted, since some programs quote every field.
static bool read_number(text_word field, double *value) {
    const bool quoted = field.length > 2 && field.begin[0] == '"' && field.begin[field.length - 1] == '"';
    if (quoted) field = (text_word){field.begin + 1, field.length - 2, field.line};
    return bolan_parse_number(field.begin, field.length, value);
}

// z is NAN where it is not there.
static bolan_result read_point(const char *name, uint32_t line, const field_list *list, bolan_dvec3 *point) {
    double values[3] = {0.0, 0.0, (double)NAN};
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
        bolan_dvec3 *memory = NULL;
        if (larger <= UINT32_MAX)
            memory = bolan_enlarge(points->points, points->capacity * sizeof *memory, larger * sizeof *memory);
        if (!memory) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for %zu points", larger);
            return BOLAN_ERROR_MEMORY;
        }
        points->points = memory;
        points->capacity = larger;
    }
    points->points[points->count++] = point;
    return BOLAN_OK;
}

// Where a text is read.
typedef struct cursor {
    const char *name;
    uint32_t line;  // the last that was read, from 1
    bool not_first; // a line with fields was there
} cursor;

// The line between `begin` and `end`; *is_point: it holds one.
static bolan_result parse_line(cursor *c, const char *begin, const char *end, bolan_dvec3 *point, bool *is_point) {
    const char *comment = memchr(begin, '#', (size_t)(end - begin));
    const field_list list = split(begin, comment ? comment : end);
    c->line++;
    *is_point = false;
    if (list.count == 0) return BOLAN_OK;
    const bool header = !c->not_first && is_header(&list);
    c->not_first = true;
    if (header) return BOLAN_OK;
    *is_point = true;
    return read_point(c->name, c->line, &list, point);
}

static bolan_result parse_lines(const char *name, const char *text, size_t size, bolan_points *points) {
    const char *end = text + size;
    cursor c = {.name = name};
    for (const char *next = text; next < end;) {
        const char *newline = memchr(next, '\n', (size_t)(end - next));
        bolan_dvec3 point;
        bool is_point;
        bolan_result result = parse_line(&c, next, newline ? newline : end, &point, &is_point);
        if (!result && is_point) {
            if (isnan(point.z)) point.z = 0.0;
            result = append(points, point);
        }
        if (result) return result;
        next = newline ? newline + 1 : end;
    }
    return BOLAN_OK;
}

static size_t mark_length(const char *text, size_t size) { // of a byte-order mark
    return size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

static bolan_result no_point(const char *name) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_POINTS_SYNTAX, "%s: there is no point in it; expected lines of x,y or x,y,z",
              name);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_points_parse(const char *name, const char *text, size_t size, bolan_points *out) {
    BOLAN_ASSERT(name && (text || size == 0) && out);
    *out = (bolan_points){0, NULL, 0};
    const size_t mark = mark_length(text, size);
    bolan_result result = size ? parse_lines(name, text + mark, size - mark, out) : BOLAN_OK;
    if (!result && out->count == 0) result = no_point(name);
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

// ---- piece by piece -------------------------------------------------------------------------------------------------

enum { LONGEST_LINE = 1 << 16, BUFFER = 4 * LONGEST_LINE };

struct bolan_points_reader {
    char path[BOLAN_PATH_MAX];
    FILE *file;
    cursor at;
    uint64_t position, size; // [bytes]
    bool ended, any;         // the file; a point was there
    size_t begin, end;       // what is not yet parsed, in text
    char text[BUFFER];
};

bolan_result bolan_points_open(const char *path, bolan_points_reader **out) {
    BOLAN_ASSERT(path && out);
    *out = NULL;
    bolan_points_reader *r = bolan_allocate(sizeof *r);
    if (!r) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to read it", path);
        return BOLAN_ERROR_MEMORY;
    }
    snprintf(r->path, sizeof r->path, "%s", path);
    r->at.name = r->path;
    const bolan_result result = bolan_file_open(path, &r->file, &r->size);
    if (result) {
        bolan_release(r, sizeof *r);
    } else {
        *out = r;
    }
    return result;
}

// Moves what is left to the front and reads on behind it.
static bolan_result refill(bolan_points_reader *r) {
    const bool is_start = r->position == 0;
    memmove(r->text, r->text + r->begin, r->end - r->begin);
    r->end -= r->begin;
    r->begin = 0;
    const size_t got = fread(r->text + r->end, 1, BUFFER - r->end, r->file);
    if (ferror(r->file)) return bolan_file_cannot_read(r->path);
    r->ended = got < BUFFER - r->end;
    r->end += got;
    r->position += got;
    if (is_start) r->begin = mark_length(r->text, r->end);
    return BOLAN_OK;
}

static bolan_result too_long(const bolan_points_reader *r) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_POINTS_SYNTAX, "%s:%u: found a line of more than %d bytes; expected x,y",
              r->path, (unsigned)r->at.line + 1, LONGEST_LINE - 1);
    return BOLAN_ERROR_FORMAT;
}

// The next line, without its end; *begin is NULL where there is none.
static bolan_result next_line(bolan_points_reader *r, const char **begin, const char **end) {
    *begin = NULL;
    for (;;) {
        const char *from = r->text + r->begin, *newline = memchr(from, '\n', r->end - r->begin);
        if (newline || (r->ended && r->begin < r->end)) {
            *begin = from;
            *end = newline ? newline : r->text + r->end;
            r->begin = (size_t)(*end - r->text) + (newline != NULL);
            return *end - from < LONGEST_LINE ? BOLAN_OK : too_long(r);
        }
        if (r->ended) return BOLAN_OK;
        if (r->end - r->begin >= LONGEST_LINE) return too_long(r);
        const bolan_result result = refill(r);
        if (result) return result;
    }
}

bolan_result bolan_points_next(bolan_points_reader *r, bolan_dvec3 *points, uint32_t capacity, uint32_t *count) {
    BOLAN_ASSERT(r && points && count);
    *count = 0;
    while (*count < capacity) {
        const char *begin, *end;
        bool is_point;
        bolan_result result = next_line(r, &begin, &end);
        if (!result && !begin) return r->any ? BOLAN_OK : no_point(r->path);
        if (!result) result = parse_line(&r->at, begin, end, &points[*count], &is_point);
        if (result) {
            *count = 0;
            r->ended = true;
            r->begin = r->end;
            return result;
        }
        *count += is_point;
        r->any |= is_point;
    }
    return BOLAN_OK;
}

void bolan_points_progress(const bolan_points_reader *reader, uint64_t *position, uint64_t *size) {
    BOLAN_ASSERT(reader && position && size);
    *position = reader->position;
    *size = reader->size;
}

void bolan_points_close(bolan_points_reader **reader) {
    if (!reader || !*reader) return;
    fclose((*reader)->file);
    bolan_release(*reader, sizeof **reader);
    *reader = NULL;
}
