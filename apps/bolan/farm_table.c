// SPDX-License-Identifier: MIT
// See farm_table.h. Cells are those of RFC 4180, without line breaks in quotes. Blank lines and # comments are skipped.
#include "farm_table.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COLUMNS = 64, MOST_BYTES = 64 << 20 };

typedef struct columns {
    const char *names[MOST_COLUMNS]; // "scene", or that of an option
    int count;
} columns;

// ---- the file -------------------------------------------------------------------------------------------------------

static int read_text(const char *path, char **text) {
    FILE *file = fopen(path, "rb");
    if (!file) return failure("%s: cannot be read: %s", path, strerror(errno));
    size_t size = 0, capacity = 4096;
    char *data = malloc(capacity + 1);
    while (data) {
        size += fread(data + size, 1, capacity - size, file);
        if (size < capacity || capacity > MOST_BYTES) break;
        char *larger = realloc(data, (capacity *= 2) + 1);
        if (!larger) free(data);
        data = larger;
    }
    const bool failed = ferror(file) != 0, holds_nul = data && memchr(data, '\0', size) != NULL;
    fclose(file);
    if (data) data[size] = '\0';
    *text = data;
    if (!data) return failure("%s: no memory to read it", path);
    if (failed) return failure("%s: cannot be read", path);
    if (size > MOST_BYTES) return failure("%s: more than %d MiB", path, MOST_BYTES >> 20);
    return holds_nul ? failure("%s: holds a NUL byte; expected CSV text", path) : EXIT_OK;
}

// Cuts the next cell off a line in place, and its blanks. *next: what follows, NULL at the end. NULL: quotes that do
// not end, or text behind them.
static char *cut_cell(char *at, char **next) {
    at += strspn(at, " \t");
    const bool quoted = *at == '"';
    char *cell = quoted ? ++at : at, *end = cell;
    if (quoted) {
        for (; *at && (at[0] != '"' || at[1] == '"'); at++) {
            if (at[0] == '"') at++;
            *end++ = *at;
        }
        if (*at++ != '"') return NULL;
        at += strspn(at, " \t");
        if (*at && *at != ',') return NULL;
    } else {
        at += strcspn(at, ",");
        for (end = at; end > cell && strchr(" \t", end[-1]); end--) continue;
    }
    *next = *at ? at + 1 : NULL;
    *end = '\0';
    return cell;
}

static int cut_line(const farm_table *t, uint32_t line, char *text, const char *cells[MOST_COLUMNS], int *count) {
    for (*count = 0; text; (*count)++) {
        if (*count == MOST_COLUMNS)
            return usage_error("%s:%u: more than %d cells", t->path, (unsigned)line, MOST_COLUMNS);
        char *cell = cut_cell(text, &text);
        if (!cell) return usage_error("%s:%u: a quote is wrong in cell %d", t->path, (unsigned)line, *count + 1);
        cells[*count] = cell;
    }
    return EXIT_OK;
}

// ---- columns and rows -----------------------------------------------------------------------------------------------

static bool is_column(const char *name) {
    if (strcmp(name, "scene") == 0) return true;
    const option_info *info = options_find(name, strlen(name));
    if (!info || !(info->commands & ON_FARM) || !info->argument) return false;
    if (info->kind == OPTION_PARAM || info->kind == OPTION_NUMBERS) return true;
    return strcmp(name, "spectrum") == 0 || strcmp(name, "terrain") == 0;
}

static int check_columns(const farm_table *t, uint32_t line, const columns *c) {
    char word[SHORT_WORD];
    for (int i = 0; i < c->count; i++) {
        if (!is_column(c->names[i]))
            return usage_error("%s:%u: the column %s; expected scene, or an option of a scene such as wind, sea-state, "
                               "seed, time, camera, sun",
                               t->path, (unsigned)line, shorten(c->names[i], word));
        for (int k = 0; k < i; k++)
            if (strcmp(c->names[i], c->names[k]) == 0)
                return usage_error("%s:%u: the column %s stands twice", t->path, (unsigned)line, c->names[i]);
    }
    return EXIT_OK;
}

// Writes the arguments of a row; *used grows by the words' bytes, *arguments by their number.
static int add_row(farm_table *t, const columns *c, uint32_t line, char *text, size_t *used, uint32_t *arguments) {
    const char *cells[MOST_COLUMNS];
    int count;
    const int result = cut_line(t, line, text, cells, &count);
    if (result) return result;
    if (count != c->count)
        return usage_error("%s:%u: %d cells; expected %d, as in the first line", t->path, (unsigned)line, count,
                           c->count);
    farm_row *row = &t->rows[t->count++];
    *row = (farm_row){.line = line, .first = *arguments};
    for (int i = 0; i < count; i++) {
        if (!*cells[i]) continue;
        const bool scene = strcmp(c->names[i], "scene") == 0;
        char *word = t->words + *used;
        *used +=
            (size_t)sprintf(word, "%s%s%s%s", scene ? "" : "--", scene ? "" : c->names[i], scene ? "" : "=", cells[i]) +
            1;
        t->arguments[(*arguments)++] = word;
        row->count++;
    }
    return EXIT_OK;
}

static int reserve(farm_table *t) {
    size_t lines = 1, cells = 1;
    for (const char *p = t->text; *p; p++) lines += *p == '\n', cells += *p == '\n' || *p == ',';
    // A word is a cell, its column's name of at most 32 bytes, and "--=" with a NUL.
    t->words = malloc(strlen(t->text) + cells * 40);
    t->arguments = malloc(cells * sizeof *t->arguments);
    t->rows = malloc(lines * sizeof *t->rows);
    return t->words && t->arguments && t->rows ? EXIT_OK : failure("%s: no memory to read it", t->path);
}

int farm_table_read(const char *path, farm_table *t) {
    *t = (farm_table){.path = path};
    int result = read_text(path, &t->text);
    if (!result) result = reserve(t);
    columns c = {.count = 0};
    uint32_t line = 0, arguments = 0;
    size_t used = 0;
    char *next = t->text;
    if (!result && strncmp(next, "\xef\xbb\xbf", 3) == 0) next += 3;
    while (!result && *next) {
        char *text = next, *end = text + strcspn(text, "\n");
        next = *end ? end + 1 : end;
        line++;
        *end = '\0';
        if (end > text && end[-1] == '\r') end[-1] = '\0';
        if (text[strspn(text, " \t")] == '\0' || text[0] == '#') continue;
        if (c.count == 0) {
            result = cut_line(t, line, text, c.names, &c.count);
            if (!result) result = check_columns(t, line, &c);
        } else {
            result = add_row(t, &c, line, text, &used, &arguments);
        }
    }
    if (!result && t->count == 0)
        result = usage_error("%s: no row; expected a line of columns, and a line a frame", path);
    return result;
}

void farm_table_free(farm_table *t) {
    free(t->text), free(t->words), free(t->arguments), free(t->rows);
    *t = (farm_table){.count = 0};
}
