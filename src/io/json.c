// SPDX-License-Identifier: MIT
// See json.h. No recursion: the depth is that of a small stack.
#include "io/json.h"

#include <string.h>

typedef struct reader {
    const char *name, *text;
    size_t size, at;
    int open[JSON_DEEPEST], depth; // indices of the values that are not closed yet
    json_text *out;
} reader;

static bolan_result refuse(const reader *r, bolan_log_id id, const char *what) {
    size_t line = 1;
    for (size_t i = 0; i < r->at && i < r->size; i++) line += r->text[i] == '\n';
    bolan_log(BOLAN_LOG_ERROR, id, "%s:%zu: %s", r->name, line, what);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result add(reader *r, char kind, size_t start, size_t length) {
    json_text *j = r->out;
    if (j->count == JSON_MOST_VALUES)
        return refuse(r, BOLAN_LOG_MODEL_LIMIT, "more JSON values than expected; at most 1048576 are read");
    if ((size_t)j->count == j->capacity) {
        const size_t capacity = j->capacity ? 2 * j->capacity : 1024;
        json_value *larger = bolan_enlarge(j->values, j->capacity * sizeof *larger, capacity * sizeof *larger);
        if (!larger) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %zu JSON values", r->name, capacity);
            return BOLAN_ERROR_MEMORY;
        }
        j->values = larger, j->capacity = capacity;
    }
    j->values[j->count] = (json_value){kind, (uint32_t)start, (uint32_t)length, j->count + 1};
    j->count++;
    return BOLAN_OK;
}

// An escape of a plain letter would hide a key from a comparison of bytes.
static bool hides_a_letter(const char *text, size_t length) {
    for (size_t i = 0; i + 4 < length; i++)
        if (memcmp(text + i, "\\u00", 4) == 0 && text[i + 4] < '8') return true;
    return false;
}

static bolan_result read_string(reader *r) {
    const size_t start = ++r->at;
    while (r->at < r->size && r->text[r->at] != '"') r->at += r->text[r->at] == '\\' ? 2 : 1;
    if (r->at >= r->size) return refuse(r, BOLAN_LOG_MODEL_FORMAT, "a string does not end");
    const size_t length = r->at++ - start;
    if (length < 256 && hides_a_letter(r->text + start, length))
        return refuse(r, BOLAN_LOG_MODEL_FORMAT, "a string writes a plain letter as an escape; expected the letter");
    return add(r, '"', start, length);
}

static bolan_result read_word(reader *r) {
    const size_t start = r->at;
    while (r->at < r->size && !strchr(",:]}[{\" \t\r\n", r->text[r->at])) r->at++;
    if (r->at - start > JSON_LONGEST_WORD)
        return refuse(r, BOLAN_LOG_MODEL_LIMIT, "a number is longer than 64 characters");
    if (r->at == start) return refuse(r, BOLAN_LOG_MODEL_FORMAT, "a byte is 0");
    return add(r, r->text[start], start, r->at - start);
}

static bolan_result read_bracket(reader *r, char c) {
    if (c == '{' || c == '[') {
        if (r->depth == JSON_DEEPEST) return refuse(r, BOLAN_LOG_MODEL_LIMIT, "brackets are nested more than 64 deep");
        r->open[r->depth++] = r->out->count;
        r->at++;
        return add(r, c, r->at - 1, 1);
    }
    json_value *opened = r->depth ? &r->out->values[r->open[r->depth - 1]] : NULL;
    if (!opened || opened->kind != (c == '}' ? '{' : '['))
        return refuse(r, BOLAN_LOG_MODEL_FORMAT, "a bracket closes what was not opened");
    opened->next = r->out->count;
    r->depth--;
    r->at++;
    return BOLAN_OK;
}

bolan_result bolan_json_read(const char *name, const char *text, size_t size, json_text *out) {
    *out = (json_text){text, NULL, 0, 0};
    reader r = {name, text, size, 0, {0}, 0, out};
    if (size > UINT32_MAX) return refuse(&r, BOLAN_LOG_MODEL_LIMIT, "larger than 4 GiB");
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) r.at = 3;
    bolan_result result = BOLAN_OK;
    while (r.at < size && !result) {
        const char c = text[r.at];
        if (c != '\0' && strchr(" \t\r\n,:", c))
            r.at++;
        else if (c != '\0' && strchr("{[]}", c))
            result = read_bracket(&r, c);
        else
            result = c == '"' ? read_string(&r) : read_word(&r);
    }
    if (!result && r.depth > 0) result = refuse(&r, BOLAN_LOG_MODEL_FORMAT, "the text ends within brackets");
    if (!result && (out->count == 0 || out->values[0].kind != '{'))
        result = refuse(&r, BOLAN_LOG_MODEL_FORMAT, "not JSON; expected an object");
    return result;
}

void bolan_json_release(json_text *json) {
    bolan_release(json->values, json->capacity * sizeof *json->values);
    *json = (json_text){NULL, NULL, 0, 0};
}

int bolan_json_member(const json_text *j, int object, const char *key) {
    if (object < 0 || j->values[object].kind != '{') return JSON_NONE;
    const size_t length = strlen(key);
    const int end = j->values[object].next;
    for (int k = object + 1; k + 1 < end; k = j->values[j->values[k].next].next) {
        const json_value *name = &j->values[k];
        if (name->next >= end) break; // a key without a value
        if (name->kind == '"' && name->length == length && memcmp(j->text + name->start, key, length) == 0)
            return name->next;
    }
    return JSON_NONE;
}

int bolan_json_after(const json_text *j, int array, int element) {
    const int next = j->values[element].next;
    return next < j->values[array].next ? next : JSON_NONE;
}

int bolan_json_first(const json_text *j, int array) {
    if (array < 0 || j->values[array].kind != '[') return JSON_NONE;
    return array + 1 < j->values[array].next ? array + 1 : JSON_NONE;
}

uint64_t bolan_json_whole(const json_text *j, int value, uint64_t otherwise) {
    if (value < 0) return otherwise;
    const json_value *v = &j->values[value];
    uint64_t n = 0;
    if (v->length == 0 || v->length > 18 || v->kind == '"') return otherwise;
    for (uint32_t i = 0; i < v->length; i++) {
        const char c = j->text[v->start + i];
        if (c < '0' || c > '9') return otherwise;
        n = 10 * n + (uint64_t)(c - '0');
    }
    return n;
}
