// SPDX-License-Identifier: MIT
// See records.h.
#include "formats/records.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- dates ----------------------------------------------------------------------------------------------------------

int bolan_record_days_in_month(int year, int month) {
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (month < 1 || month > 12) return 31;
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return days[month - 1] + (month == 2 && leap);
}

bool bolan_record_date_is_valid(const record_date *date) {
    const int *f = date->field;
    return f[0] >= 1900 && f[0] <= 2999 && f[1] >= 1 && f[1] <= 12 && f[2] >= 1 &&
           f[2] <= bolan_record_days_in_month(f[0], f[1]) && f[3] >= 0 && f[3] <= 23 && f[4] >= 0 && f[4] <= 59 &&
           f[5] >= 0 && f[5] <= 59;
}

int64_t bolan_record_date_seconds(const record_date *date) {
    const int *f = date->field;
    int64_t days = 0;
    for (int year = 1970; year < f[0]; year++) days += bolan_record_days_in_month(year, 2) + 337;
    for (int year = f[0]; year < 1970; year++) days -= bolan_record_days_in_month(year, 2) + 337;
    for (int month = 1; month < f[1]; month++) days += bolan_record_days_in_month(f[0], month);
    days += f[2] - 1;
    return ((days * 24 + f[3]) * 60 + f[4]) * 60 + f[5];
}

bool bolan_record_date_from_seconds(double seconds, record_date *date) {
    static const record_date first = {{1900, 1, 1, 0, 0, 0}}, last = {{2999, 12, 31, 23, 59, 59}};
    if (!(seconds >= (double)bolan_record_date_seconds(&first) && seconds < (double)bolan_record_date_seconds(&last)))
        return false;
    const int64_t whole = (int64_t)floor(seconds + 0.5);
    int64_t days = whole / 86400 - (whole % 86400 < 0);
    const int rest = (int)(whole - 86400 * days);
    *date = (record_date){{1970, 1, 1, rest / 3600, rest / 60 % 60, rest % 60}};
    int *f = date->field;
    while (days < 0) days += bolan_record_days_in_month(--f[0], 2) + 337;
    while (days >= bolan_record_days_in_month(f[0], 2) + 337) days -= bolan_record_days_in_month(f[0]++, 2) + 337;
    while (days >= bolan_record_days_in_month(f[0], f[1])) days -= bolan_record_days_in_month(f[0], f[1]++);
    f[2] += (int)days;
    return true;
}

// @p count digits at *p, after the character @p before (0 for none).
static bool read_digits(const char **p, char before, int count, int *value) {
    if (before && *(*p)++ != before) return false;
    *value = 0;
    for (int i = 0; i < count; i++, (*p)++) {
        if (**p < '0' || **p > '9') return false;
        *value = *value * 10 + (**p - '0');
    }
    return true;
}

bool bolan_record_date_from_text(const char *text, record_date *date) {
    const char *p = text;
    int *f = date->field;
    *date = (record_date){{0}};
    if (!read_digits(&p, 0, 4, &f[0]) || !read_digits(&p, '-', 2, &f[1]) || !read_digits(&p, '-', 2, &f[2]))
        return false;
    if (*p == 'T' && (!read_digits(&p, 'T', 2, &f[3]) || !read_digits(&p, ':', 2, &f[4]))) return false;
    if (*p == ':' && !read_digits(&p, ':', 2, &f[5])) return false;
    if (*p == 'Z') p++;
    return *p == '\0' && bolan_record_date_is_valid(date);
}

void bolan_record_date_print(const record_date *date, record_style style, char out[RECORD_TIME_SIZE]) {
    const int *f = date->field;
    const int used = snprintf(out, RECORD_TIME_SIZE, "%04d-%02d-%02dT%02d:%02d", f[0], f[1], f[2], f[3], f[4]);
    snprintf(out + used, RECORD_TIME_SIZE - (size_t)used, style == RECORD_LOCAL_SECONDS ? ":%02d" : "Z", f[5]);
}

// ---- the list -------------------------------------------------------------------------------------------------------

static bolan_result grow(record_list *list) {
    const uint32_t capacity = list->capacity ? 2 * list->capacity : 64;
    record_entry *entries = bolan_enlarge(list->entries, list->capacity * sizeof *entries, capacity * sizeof *entries);
    if (!entries) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "the list of %u records of a spectrum needs %zu bytes, which could not be allocated",
                  (unsigned)list->count + 1, capacity * sizeof *entries);
        return BOLAN_ERROR_MEMORY;
    }
    list->entries = entries;
    list->capacity = capacity;
    return BOLAN_OK;
}

bolan_result bolan_record_list_add(record_list *list, const record_date *date, text_cursor at) {
    if (list->count == list->capacity && grow(list)) return BOLAN_ERROR_MEMORY;
    record_entry *entry = &list->entries[list->count];
    *entry = (record_entry){.seconds = list->timed ? bolan_record_date_seconds(date) : list->count, .at = at};
    entry->order = list->count++;
    if (list->timed) entry->date = *date;
    return BOLAN_OK;
}

void bolan_record_list_release(record_list *list) {
    bolan_release(list->entries, list->capacity * sizeof *list->entries);
    *list = (record_list){.entries = NULL};
}

static int by_time(const void *a, const void *b) {
    const record_entry *x = a, *y = b;
    if (x->seconds != y->seconds) return x->seconds < y->seconds ? -1 : 1;
    return (x->order > y->order) - (x->order < y->order);
}

void bolan_record_list_sort(record_list *list) { qsort(list->entries, list->count, sizeof *list->entries, by_time); }

static bolan_result choose_number(const record_list *list, const char *name, uint32_t record, record_choice *chosen) {
    if (record >= list->count) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TIME_INDEX, "%s: record %u was asked for; expected 0 to %u", name,
                  (unsigned)record, (unsigned)(list->count - 1));
        return BOLAN_ERROR_ARGUMENT;
    }
    chosen->first = &list->entries[record];
    return BOLAN_OK;
}

// The last record before a time and the next, where the time lies between them.
static bool choose_pair(const record_list *list, const char *name, const record_date *date, spectrum_notes *notes,
                        record_choice *chosen) {
    const int64_t wanted = bolan_record_date_seconds(date);
    uint32_t next = 0;
    while (next < list->count && list->entries[next].seconds < wanted) next++;
    if (next == 0 || next == list->count || list->entries[next].seconds == wanted) return false;
    const record_entry *a = &list->entries[next - 1], *b = &list->entries[next];
    char before[RECORD_TIME_SIZE], after[RECORD_TIME_SIZE];
    bolan_record_date_print(&a->date, list->style, before);
    bolan_record_date_print(&b->date, list->style, after);
    bolan_record_date_print(date, list->style, chosen->time);
    bolan_spectrum_note_level(notes, BOLAN_LOG_INFO, BOLAN_LOG_SPECTRUM_NEAREST_TIME,
                              "%s: the spectrum of %s is interpolated between the records of %s and %s", name,
                              chosen->time, before, after);
    chosen->first = a;
    chosen->second = b;
    chosen->share = (double)(wanted - a->seconds) / (double)(b->seconds - a->seconds);
    return true;
}

static const record_entry *nearest_to(const record_list *list, int64_t wanted) {
    const record_entry *best = &list->entries[0];
    for (uint32_t i = 1; i < list->count; i++)
        if (llabs(list->entries[i].seconds - wanted) < llabs(best->seconds - wanted)) best = &list->entries[i];
    return best;
}

static bolan_result choose_time(const record_list *list, const char *name, const bolan_spectrum_options *options,
                                spectrum_notes *notes, record_choice *chosen) {
    record_date date;
    if (!list->timed || !bolan_record_date_from_text(options->time, &date)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TIME_INDEX,
                  "%s: the record of %s was asked for, but the text has no times that can be read; expected a number",
                  name, options->time);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (options->interpolate && choose_pair(list, name, &date, notes, chosen)) return BOLAN_OK;
    const int64_t wanted = bolan_record_date_seconds(&date);
    const record_entry *best = nearest_to(list, wanted);
    char nearest[RECORD_TIME_SIZE], first[RECORD_TIME_SIZE], last[RECORD_TIME_SIZE];
    bolan_record_date_print(&best->date, list->style, nearest);
    if (llabs(best->seconds - wanted) > RECORD_NEAR_SECONDS) {
        bolan_record_date_print(&list->entries[0].date, list->style, first);
        bolan_record_date_print(&list->entries[list->count - 1].date, list->style, last);
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TIME_INDEX,
                  "%s: the record of %s was asked for; expected a time within an hour of one of its %u records, from "
                  "%s to %s (the nearest is of %s), or interpolation between two",
                  name, options->time, (unsigned)list->count, first, last, nearest);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (best->seconds != wanted)
        bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_NEAREST_TIME,
                            "%s: there is no record of %s; the nearest, of %s, is taken", name, options->time, nearest);
    chosen->first = best;
    return BOLAN_OK;
}

bolan_result bolan_record_list_choose(const record_list *list, const char *name, const bolan_spectrum_options *options,
                                      spectrum_notes *notes, record_choice *chosen) {
    *chosen = (record_choice){.first = NULL};
    return options->time[0] ? choose_time(list, name, options, notes, chosen)
                            : choose_number(list, name, options->record, chosen);
}
