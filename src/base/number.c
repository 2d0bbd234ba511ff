// SPDX-License-Identifier: MIT
// Numbers for machines: printed and read in the C locale, whatever locale the host program has set. A host with a
// decimal comma would otherwise write "29,97" into files and command lines, and read "1.294" as 1.
//
// The locale is switched for this thread and this call only (POSIX uselocale); the C library does the rest, so numbers
// are correctly rounded in both directions.
#include "bolan/base.h"

#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"

enum { LONGEST_NUMBER = 400 }; // a double with all its decimals needs fewer than 350

int bolan_number_format_list(char *out, size_t capacity, const char *format, va_list arguments) {
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(c);
    const int length = vsnprintf(out, capacity, format, arguments);
    uselocale(before);
    if (c) freelocale(c);
    return length;
}

int bolan_format(char *out, size_t capacity, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int length = bolan_number_format_list(out, capacity, format, arguments);
    va_end(arguments);
    return length;
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

static size_t skip_digits(const char *text, size_t size, size_t at) {
    while (at < size && is_digit(text[at])) at++;
    return at;
}

// [+-]digits[.digits][e[+-]digits], with a digit on one side of the point at least.
static bool is_number(const char *text, size_t size) {
    size_t at = size > 0 && (text[0] == '-' || text[0] == '+');
    const size_t first = at;
    at = skip_digits(text, size, at);
    size_t digits = at - first;
    if (at < size && text[at] == '.') {
        const size_t point = at + 1;
        at = skip_digits(text, size, point);
        digits += at - point;
    }
    if (digits == 0) return false;
    if (at < size && (text[at] == 'e' || text[at] == 'E')) {
        at += 1 + (at + 1 < size && (text[at + 1] == '-' || text[at + 1] == '+'));
        if (at >= size || !is_digit(text[at])) return false;
        at = skip_digits(text, size, at);
    }
    return at == size;
}

bool bolan_parse_number(const char *text, size_t size, double *value) {
    BOLAN_ASSERT(value && (text || size == 0));
    if (size > LONGEST_NUMBER || !is_number(text, size)) return false;
    char copy[LONGEST_NUMBER + 1];
    memcpy(copy, text, size);
    copy[size] = '\0';
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(c);
    *value = strtod(copy, NULL);
    uselocale(before);
    if (c) freelocale(c);
    return isfinite(*value);
}
