// SPDX-License-Identifier: MIT
// bolan_format() for a va_list. Private to src/base.
#ifndef BOLAN_BASE_NUMBER_H
#define BOLAN_BASE_NUMBER_H

#include <stdarg.h>
#include <stddef.h>

/// vsnprintf() in the C locale.
#if defined(__GNUC__)
__attribute__((format(printf, 3, 0)))
#endif
int bolan_number_format_list(char *out, size_t capacity, const char *format, va_list arguments);

#endif
