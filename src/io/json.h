// SPDX-License-Identifier: MIT
/// @file json.h
/// A JSON text as a flat list of values, for checks before another library reads it. Private to src/io.
///
/// Values stand in the order of the text, each followed by its contents; the members of an object are alternately a key
/// and a value. The syntax is checked as far as the structure needs: brackets match and strings end.
#ifndef BOLAN_IO_JSON_H
#define BOLAN_IO_JSON_H

#include "bolan/base.h"

enum {
    JSON_MOST_VALUES = 1 << 20,
    JSON_DEEPEST = 64,
    JSON_LONGEST_WORD = 64, ///< of a number or literal [characters]
    JSON_NONE = -1
};

typedef struct json_value {
    char kind;      ///< the first character of its text: { [ " or that of a number or literal
    uint32_t start; ///< its text, of a string without the quotes
    uint32_t length;
    int next; ///< index of the value after it and all that is in it
} json_value;

typedef struct json_text {
    const char *text;
    json_value *values;
    int count;
    size_t capacity;
} json_text;

/// Lists the values of @p text. FORMAT, with a sentence that names the line, where the text is no JSON or beyond the
/// limits above; MEMORY. Call bolan_json_release() in any case.
bolan_result bolan_json_read(const char *name, const char *text, size_t size, json_text *out);
void bolan_json_release(json_text *json);

/// The value of a key of an object; JSON_NONE where there is none, or @p object is JSON_NONE or no object.
int bolan_json_member(const json_text *json, int object, const char *key);
/// The first element of an array, or the one after @p element of it; JSON_NONE at the end, or where it is no array.
int bolan_json_first(const json_text *json, int array);
int bolan_json_after(const json_text *json, int array, int element);
/// A whole number of the file, or @p otherwise where @p value is no whole number or JSON_NONE.
uint64_t bolan_json_whole(const json_text *json, int value, uint64_t otherwise);

#endif
