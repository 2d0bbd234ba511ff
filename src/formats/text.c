// SPDX-License-Identifier: MIT
// See text.h.
#include "formats/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

// Removes the white space at the end, so that a text that ends too early is reported at its last word.
static void trim(text_cursor *cursor) {
    while (cursor->end > cursor->next && is_space(cursor->end[-1])) cursor->end--;
}

text_cursor bolan_text_open(const bolan_spectrum_text *text) {
    text_cursor cursor = {text->name ? text->name : "spectrum", text->data, text->data, 1, false};
    if (!text->data) return cursor;
    cursor.end += text->size;
    if (text->size >= 3 && memcmp(text->data, "\xEF\xBB\xBF", 3) == 0) // a byte-order mark
        cursor.next += 3;
    trim(&cursor);
    return cursor;
}

bool bolan_text_next_word(text_cursor *cursor, text_word *word) {
    while (cursor->next < cursor->end && is_space(*cursor->next)) cursor->line += *cursor->next++ == '\n';
    word->begin = cursor->next;
    word->line = cursor->line;
    while (cursor->next < cursor->end && !is_space(*cursor->next)) cursor->next++;
    word->length = (size_t)(cursor->next - word->begin);
    return word->length > 0;
}

bool bolan_text_next_field(text_cursor *cursor, text_word *word) {
    while (cursor->next < cursor->end && (is_space(*cursor->next) || *cursor->next == ','))
        cursor->line += *cursor->next++ == '\n';
    word->begin = cursor->next;
    word->line = cursor->line;
    while (cursor->next < cursor->end && !is_space(*cursor->next) && *cursor->next != ',') cursor->next++;
    word->length = (size_t)(cursor->next - word->begin);
    return word->length > 0;
}

void bolan_text_skip_line(text_cursor *cursor) {
    if (cursor->next == cursor->end) return;
    const char *newline = memchr(cursor->next, '\n', (size_t)(cursor->end - cursor->next));
    cursor->line += newline != NULL;
    cursor->next = newline ? newline + 1 : cursor->end;
}

bool bolan_text_next_line(text_cursor *cursor, text_cursor *line) {
    while (cursor->next < cursor->end) {
        *line = *cursor;
        bolan_text_skip_line(cursor);
        line->end = cursor->next;
        line->one_line = true;
        trim(line);
        text_cursor probe = *line;
        text_word word;
        if (bolan_text_next_word(&probe, &word)) return true;
    }
    return false;
}

// ---- numbers --------------------------------------------------------------------------------------------------------

// mantissa * 10^exponent. Powers to 1e22 are exact doubles.
static double scale_decimal(double value, int exponent) {
    static const double powers[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    for (; exponent > 22 && value < 1e300; exponent -= 22) value *= 1e22;
    for (; exponent < -22 && value > 0.0; exponent += 22) value /= 1e22;
    if (exponent > 22) return HUGE_VAL;
    return exponent >= 0 ? value * powers[exponent] : exponent >= -22 ? value / powers[-exponent] : 0.0;
}

// Fortran leaves the letter out where an exponent has three digits: -104.
static bool is_bare_exponent(const char *p, const char *end) { return end - p == 4 && (*p == '-' || *p == '+'); }

// An exponent such as E-05 (Fortran also writes D) at *p; false if the letter or sign is not followed by digits.
static bool parse_exponent(const char **p, const char *end, bool fortran, int *exponent) {
    const bool bare = fortran && is_bare_exponent(*p, end);
    if (*p == end || (!bare && !memchr("eEdD", **p, 4))) return true;
    *p += !bare;
    const bool negative = *p < end && **p == '-';
    if (*p < end && (**p == '-' || **p == '+')) (*p)++;
    const char *digits = *p;
    int value = 0;
    for (; *p < end && **p >= '0' && **p <= '9'; (*p)++) value = value < 10000 ? value * 10 + (**p - '0') : value;
    *exponent += negative ? -value : value;
    return *p > digits;
}

static bool parse_number(text_word word, bool fortran, double *value) {
    const char *p = word.begin, *end = word.begin + word.length;
    if (word.length == 0 || word.length > 400) return false;
    const bool negative = *p == '-';
    if (*p == '-' || *p == '+') p++;
    uint64_t mantissa = 0;
    int exponent = 0, digits = 0;
    for (bool fraction = false; p < end; p++) {
        if (*p == '.' && !fraction) {
            fraction = true;
            continue;
        }
        if (*p < '0' || *p > '9') break;
        digits++;
        if (mantissa < 100000000000000000ULL) { // 18 digits are more than a double holds
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
            exponent -= fraction;
        } else {
            exponent += !fraction;
        }
    }
    if (digits == 0 || !parse_exponent(&p, end, fortran, &exponent) || p != end) return false;
    const double magnitude = scale_decimal((double)mantissa, exponent);
    *value = negative ? -magnitude : magnitude;
    return isfinite(magnitude);
}

bool bolan_text_number(text_word word, double *value) { return parse_number(word, false, value); }

bool bolan_text_fortran_number(text_word word, double *value) { return parse_number(word, true, value); }

// ---- messages -------------------------------------------------------------------------------------------------------

bolan_result bolan_text_unexpected(const text_cursor *cursor, const text_word *word, const char *what) {
    if (!word) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TRUNCATED, "%s:%u: the %s ends where %s was expected",
                  cursor->name, (unsigned)cursor->line, cursor->one_line ? "line" : "text", what);
        return BOLAN_ERROR_FORMAT;
    }
    char shown[24];
    size_t n = 0;
    for (; n < word->length && n < sizeof shown - 1; n++)
        shown[n] = word->begin[n] >= ' ' && word->begin[n] <= '~' ? word->begin[n] : '?';
    shown[n] = '\0';
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: expected %s, found \"%s\"", cursor->name,
              (unsigned)word->line, what, shown);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_text_negative(const text_cursor *cursor, double value) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NEGATIVE, "%s:%u: the density %g is negative; expected 0 or more",
              cursor->name, (unsigned)cursor->line, value);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_text_read_number(text_cursor *cursor, const char *what, double *value) {
    text_word word;
    if (!bolan_text_next_word(cursor, &word)) return bolan_text_unexpected(cursor, NULL, what);
    return bolan_text_number(word, value) ? BOLAN_OK : bolan_text_unexpected(cursor, &word, what);
}

bolan_result bolan_text_read_count(text_cursor *cursor, const char *what, uint32_t low, uint32_t high,
                                   uint32_t *count) {
    char expected[96];
    snprintf(expected, sizeof expected, "%s from %u to %u", what, (unsigned)low, (unsigned)high);
    text_word word;
    if (!bolan_text_next_word(cursor, &word)) return bolan_text_unexpected(cursor, NULL, expected);
    double value;
    if (!bolan_text_number(word, &value) || !(value >= low && value <= high) || value != floor(value))
        return bolan_text_unexpected(cursor, &word, expected);
    *count = (uint32_t)value;
    return BOLAN_OK;
}

bolan_result bolan_text_read_field(text_cursor *cursor, const char *what, double low, double high, double *value) {
    text_word word;
    if (!bolan_text_next_field(cursor, &word)) return bolan_text_unexpected(cursor, NULL, what);
    return bolan_text_number(word, value) && *value >= low && *value <= high
               ? BOLAN_OK
               : bolan_text_unexpected(cursor, &word, what);
}
