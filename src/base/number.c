// SPDX-License-Identifier: MIT
// Numbers for machines: printed and read in the C locale, whatever locale the host program has set. A host with a
// decimal comma would otherwise write "29,97" into files and command lines, and read "1.294" as 1.
//
// The locale is switched for this thread and this call only (POSIX uselocale); the C library does the rest, so numbers
// are correctly rounded in both directions.
#include "bolan/base.h"

#include <float.h>
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

// Those that a double holds exactly.
static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// ---- short numbers, fast --------------------------------------------------------------------------------------------

enum { MOST_DIGITS = 12, DECIMAL = 12, LONGEST_FIXED = 32 };
#define LEAST_SHORT 1e-32 // 44 powers of ten from 12 digits before the point

// value * 10^power, rounded twice at most: within 4e-16 of itself. |power| <= 44.
static double scaled(double value, int power) {
    for (; power > 22; power -= 22) value *= 1e22;
    for (; power < -22; power += 22) value /= 1e22;
    return power < 0 ? value / powers[-power] : value * powers[power];
}

// floor(log2(value)) of a normal number > 0.
static int binary_exponent(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (int)(bits >> 52) - 1023;
}

// The decimal digits of `value` > 0, rounded to `digits` of them, and the exponent of the first. False where the double
// arithmetic cannot tell which way to round.
static bool short_decimal(double value, int digits, uint64_t *integer, int *exponent) {
    const double guess = binary_exponent(value) * 0.30102999566398120;
    *exponent = (int)guess - (guess < 0.0); // or one more
    double shifted = scaled(value, digits - 1 - *exponent);
    if (shifted >= powers[digits]) shifted = scaled(value, digits - 1 - ++*exponent);
    const uint64_t whole = (uint64_t)shifted;
    const double rest = shifted - (double)whole;
    if (fabs(rest - 0.5) < 1e-15 * shifted + 1e-9) return false;
    *integer = whole + (rest > 0.5);
    if ((double)*integer < powers[digits]) return true;
    *integer /= 10;
    ++*exponent;
    return true;
}

static void put_digits(char *out, int digits, uint64_t integer) {
    static const char pairs[] =
        "00010203040506070809101112131415161718192021222324252627282930313233343536373839404142434445"
        "46474849505152535455565758596061626364656667686970717273747576777879808182838485868788899091"
        "9293949596979899";
    for (; digits >= 2; digits -= 2, integer /= 100) memcpy(out + digits - 2, pairs + 2 * (integer % 100), 2);
    if (digits) out[0] = (char)('0' + integer);
}

// `decimal` has `digits` digits, zeros behind them that do not count, and room for copies of DECIMAL bytes, which are
// longer than what counts: `out` has room for them, too. The first digit is that of 10^exponent, -4 .. MOST_DIGITS - 1.
static int put_fixed(char *out, const char *decimal, int digits, int exponent) {
    if (exponent < 0) { // 0.00ddd
        memcpy(out, "0.000", 5);
        memcpy(out + 1 - exponent, decimal, DECIMAL);
        return 1 - exponent + digits;
    }
    memcpy(out, decimal, DECIMAL);
    if (digits <= exponent + 1) return exponent + 1;
    out[exponent + 1] = '.';
    memcpy(out + exponent + 2, decimal + exponent + 1, DECIMAL);
    return digits + 1;
}

// d.ddde-XX, the exponent -99 .. -5.
static int put_scientific(char *out, const char *decimal, int digits, int exponent) {
    int used = 0;
    out[used++] = decimal[0];
    if (digits > 1) out[used++] = '.';
    for (int i = 1; i < digits; i++) out[used++] = decimal[i];
    out[used++] = 'e';
    out[used++] = '-';
    put_digits(out + used, 2, (uint64_t)-exponent);
    return used + 2;
}

int bolan_format_number(char *out, size_t capacity, double value, int digits) {
    BOLAN_ASSERT(out && capacity >= LONGEST_FIXED && digits >= 1 && digits <= MOST_DIGITS);
    const double magnitude = fabs(value);
    uint64_t integer = 0;
    int exponent = 0;
    // Beyond these the form is another, and rare.
    const bool is_short = FLT_EVAL_METHOD == 0 && magnitude >= LEAST_SHORT && magnitude < 1e12;
    if (value != 0.0 && (!is_short || !short_decimal(magnitude, digits, &integer, &exponent) || exponent >= digits))
        return bolan_format(out, capacity, "%.*g", digits, value);
    char decimal[2 * DECIMAL] = {0};
    put_digits(decimal, digits, integer);
    while (digits > 1 && decimal[digits - 1] == '0') digits--;
    int used = signbit(value) != 0;
    out[0] = '-';
    used += (exponent < -4 ? put_scientific : put_fixed)(out + used, decimal, digits, exponent);
    out[used] = '\0';
    return used;
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

// The common case, exact: at most 15 digits are an integer that a double holds, and so is 10^e up to e = 22, so that
// one product or quotient rounds once (Clinger 1990). `text` is a number.
static bool parse_short(const char *text, size_t size, double *value) {
    const bool negative = text[0] == '-';
    double integer = 0.0;
    int digits = 0, decimals = 0, exponent = 0;
    bool point = false;
    size_t at = negative || text[0] == '+';
    for (; at < size && text[at] != 'e' && text[at] != 'E'; at++) {
        if (text[at] == '.') {
            point = true;
            continue;
        }
        integer = 10.0 * integer + (text[at] - '0');
        digits += integer > 0.0;
        decimals += point;
    }
    if (digits > 15) return false;
    if (at < size) {
        const bool minus = text[++at] == '-';
        at += minus || text[at] == '+';
        if (size - at > 3) return false;
        for (; at < size; at++) exponent = 10 * exponent + (text[at] - '0');
        if (minus) exponent = -exponent;
    }
    exponent -= decimals;
    if (exponent < -22 || exponent > 22) return false;
    const double magnitude = exponent < 0 ? integer / powers[-exponent] : integer * powers[exponent];
    *value = negative ? -magnitude : magnitude;
    return true;
}

bool bolan_parse_number(const char *text, size_t size, double *value) {
    BOLAN_ASSERT(value && (text || size == 0));
    if (size > LONGEST_NUMBER || !is_number(text, size)) return false;
    if (FLT_EVAL_METHOD == 0 && parse_short(text, size, value)) return true;
    char copy[LONGEST_NUMBER + 1];
    memcpy(copy, text, size);
    copy[size] = '\0';
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = uselocale(c);
    *value = strtod(copy, NULL);
    uselocale(before);
    if (c) freelocale(c);
    return isfinite(*value);
}
