// SPDX-License-Identifier: MIT
/// @file text.h
/// Reading words and numbers from text in memory that need not end in NUL. Independent of the locale; knows the line
/// for messages. Private to the library.
#ifndef BOLAN_FORMATS_TEXT_H
#define BOLAN_FORMATS_TEXT_H

#include "bolan/formats.h"

#include <stdbool.h>
#include <string.h>

typedef struct text_cursor {
    const char *name; ///< of the text, for messages
    const char *next, *end;
    uint32_t line; ///< of @ref next, from 1
    bool one_line; ///< the text is one line of a longer one: for messages
} text_cursor;

typedef struct text_word {
    const char *begin;
    size_t length;
    uint32_t line;
} text_word;

text_cursor bolan_text_open(const bolan_spectrum_text *text);
/// The next run of characters that are not white space, on this line or a later one; false at the end of the text.
bool bolan_text_next_word(text_cursor *cursor, text_word *word);
/// The same where commas part the words, too.
bool bolan_text_next_field(text_cursor *cursor, text_word *word);
/// Moves past the end of the current line.
void bolan_text_skip_line(text_cursor *cursor);
/// The next line that is not blank, as a text of its own, without its end and the white space before that.
bool bolan_text_next_line(text_cursor *cursor, text_cursor *line);

/// ASCII letters in lower case, whatever the locale.
static inline char text_lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c + ('a' - 'A')) : c; }

/// Equal, but for the case of ASCII letters. In line, since src/io uses it and shared libraries export no private name.
static inline bool bolan_text_equals(text_word word, const char *expected) {
    if (strlen(expected) != word.length) return false;
    for (size_t i = 0; i < word.length; i++)
        if (text_lower(word.begin[i]) != text_lower(expected[i])) return false;
    return true;
}
/// A decimal number that fills the word: no "nan", "inf" or hexadecimal, and no overflow.
bool bolan_text_number(text_word word, double *value);
/// Like bolan_text_number(); accepts also Fortran's form of an exponent of three digits, which has no letter:
/// "0.67027118-104".
bool bolan_text_fortran_number(text_word word, double *value);

/// Logs "NAME:LINE: expected WHAT, found WORD" (SPECTRUM_SYNTAX), or, when @p word is NULL, that the text or line ends
/// where WHAT was expected (SPECTRUM_TRUNCATED). Returns BOLAN_ERROR_FORMAT.
bolan_result bolan_text_unexpected(const text_cursor *cursor, const text_word *word, const char *what);

/// The next word as a number, whole number, or non-negative density; an error is logged as above, and negative
/// densities as SPECTRUM_NEGATIVE.
bolan_result bolan_text_read_number(text_cursor *cursor, const char *what, double *value);
bolan_result bolan_text_read_count(text_cursor *cursor, const char *what, uint32_t low, uint32_t high, uint32_t *count);
/// The next field as a number of @p low to @p high; @p what names it with its range.
bolan_result bolan_text_read_field(text_cursor *cursor, const char *what, double low, double high, double *value);
bolan_result bolan_text_negative(const text_cursor *cursor, double value);

#endif
