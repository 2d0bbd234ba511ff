// SPDX-License-Identifier: MIT
// The date of a scene's sun.
#include "io/scene_file.h"

// Days from 1970-01-01 to a date of the Gregorian calendar (Fliegel & Van Flandern, Comm. ACM 11, 1968).
static int days_since_1970(int year, int month, int day) {
    const int a = (month - 14) / 12;
    const int julian = day - 32075 + 1461 * (year + 4800 + a) / 4 + 367 * (month - 2 - a * 12) / 12 -
                       3 * ((year + 4900 + a) / 100) / 4;
    return julian - 2440588;
}

// Exactly @p count digits at *text, which is moved behind them; -1 for anything else: no sign, no blank.
static int digits(const char **text, int count) {
    int value = 0;
    for (int i = 0; i < count; i++, (*text)++) {
        if (**text < '0' || **text > '9') return -1;
        value = value * 10 + (**text - '0');
    }
    return value;
}

// That many digits behind the character @p before.
static int digits_behind(char before, const char **text, int count) {
    return **text == before ? ((*text)++, digits(text, count)) : -1;
}

static int days_of_month(int year, int month) {
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : days[month - 1];
}

// ISO 8601: YYYY-MM-DDTHH:MM, :SS if you like, and Z or +HH:MM or -HH:MM.
bool bolan_scene_file_date(const char *text, double *unix_time) {
    const int year = digits(&text, 4);
    if (year < 1900 || year > 2100) return false;
    const int month = digits_behind('-', &text, 2);
    if (month < 1 || month > 12) return false;
    const int day = digits_behind('-', &text, 2);
    if (day < 1 || day > days_of_month(year, month)) return false;
    const int hour = digits_behind('T', &text, 2);
    if (hour < 0 || hour > 23) return false;
    const int minute = digits_behind(':', &text, 2);
    if (minute < 0 || minute > 59) return false;
    const int second = *text == ':' ? digits_behind(':', &text, 2) : 0;
    if (second < 0 || second > 60) return false; // 60: a leap second
    const char sign = *text;
    int zone_hour = 0, zone_minute = 0;
    if (sign == '+' || sign == '-') {
        zone_hour = digits_behind(sign, &text, 2);
        if (zone_hour < 0 || zone_hour > 14) return false;
        zone_minute = digits_behind(':', &text, 2);
        if (zone_minute < 0 || zone_minute > 59) return false;
    } else if (*text++ != 'Z') {
        return false;
    }
    if (*text) return false;
    const double zone = (zone_hour * 60.0 + zone_minute) * 60.0 * (sign == '-' ? -1.0 : 1.0);
    *unix_time = days_since_1970(year, month, day) * 86400.0 + (hour * 60.0 + minute) * 60.0 + second - zone;
    return true;
}
