// SPDX-License-Identifier: MIT
// See json_cursor.h. No recursion: depth is a count.
#include "formats/json_cursor.h"

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == ':'; }

static bool skip_blank(text_cursor *c) {
    while (c->next < c->end && is_blank(*c->next)) c->line += *c->next++ == '\n';
    return c->next < c->end;
}

// A string without its quotes, a bracket, or a run of other characters; false at the end.
static bool next_token(text_cursor *c, text_word *word, bool *quoted) {
    if (!skip_blank(c)) return false;
    *quoted = *c->next == '"';
    *word = (text_word){c->next + *quoted, 0, c->line};
    if (*quoted) {
        for (c->next++; c->next < c->end && *c->next != '"'; c->next++)
            c->next += *c->next == '\\' && c->next + 1 < c->end;
        word->length = (size_t)(c->next - word->begin);
        if (c->next == c->end) return false; // the string does not end
        c->next++;
        return true;
    }
    if (memchr("{}[]", *c->next, 4)) {
        c->next++;
        word->length = 1;
        return true;
    }
    while (c->next < c->end && !is_blank(*c->next) && !memchr("{}[]\"", *c->next, 5)) c->next++;
    word->length = (size_t)(c->next - word->begin);
    return true;
}

static bool is_bracket(text_word word, bool quoted, const char *brackets) {
    return !quoted && word.length == 1 && memchr(brackets, word.begin[0], 2);
}

// Moves past one value.
static bool skip_value(text_cursor *c) {
    text_word word;
    bool quoted;
    uint32_t depth = 0;
    do {
        if (!next_token(c, &word, &quoted)) return false;
        if (is_bracket(word, quoted, "{[")) depth++;
        if (is_bracket(word, quoted, "}]")) {
            if (depth == 0) return false;
            depth--;
        }
    } while (depth > 0);
    return true;
}

bool bolan_json_cursor_member(text_cursor object, const char *key, text_cursor *value) {
    text_word word;
    bool quoted;
    if (!next_token(&object, &word, &quoted) || !is_bracket(word, quoted, "{{")) return false;
    while (next_token(&object, &word, &quoted) && quoted) {
        if (!skip_blank(&object)) return false;
        const bool found = word.length == strlen(key) && memcmp(word.begin, key, word.length) == 0;
        *value = object;
        if (found) return true;
        if (!skip_value(&object)) return false;
    }
    return false;
}

bool bolan_json_cursor_first(text_cursor array, text_cursor *element) {
    text_word word;
    bool quoted;
    if (!next_token(&array, &word, &quoted) || !is_bracket(word, quoted, "[[")) return false;
    *element = array;
    return skip_blank(element) && *element->next != ']' && *element->next != '}';
}

bool bolan_json_cursor_after(text_cursor *element) {
    return skip_value(element) && skip_blank(element) && *element->next != ']' && *element->next != '}';
}

bool bolan_json_cursor_scalar(text_cursor value, text_word *word) {
    bool quoted;
    return next_token(&value, word, &quoted) && !is_bracket(*word, quoted, "{[") && !is_bracket(*word, quoted, "}]");
}
