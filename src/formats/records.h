// SPDX-License-Identifier: MIT
/// @file records.h
/// The records of a text: their dates, their order in time, and the choice of one. Private to src/formats.
#ifndef BOLAN_FORMATS_RECORDS_H
#define BOLAN_FORMATS_RECORDS_H

#include "formats/text.h"
#include "spectrum/notes.h"

/// Year, month, day, hour, minute, second of the Gregorian calendar, UTC.
typedef struct record_date {
    int field[6];
} record_date;

/// Days of a month, 28 to 31; 31 for a month that is none.
int bolan_record_days_in_month(int year, int month);
/// Whether the date exists. Years 1900 to 2999, hours 0 to 23.
bool bolan_record_date_is_valid(const record_date *date);
/// Seconds since 1970 of a valid date.
int64_t bolan_record_date_seconds(const record_date *date);
/// The date of that many seconds since 1970, to the nearest second; false outside the valid years.
bool bolan_record_date_from_seconds(double seconds, record_date *date);
/// "2018-01-01", "2018-01-01T06:00" or "2018-01-01T06:00:00", with or without Z; false if it is none, or impossible.
bool bolan_record_date_from_text(const char *text, record_date *date);

/// How a format's times are printed: as exact as the format, and UTC only where the format says so.
typedef enum record_style {
    RECORD_UTC_MINUTES,   ///< "2018-01-01T06:00Z"
    RECORD_LOCAL_SECONDS, ///< "2018-01-01T06:00:00"
} record_style;
enum { RECORD_TIME_SIZE = 32 };
void bolan_record_date_print(const record_date *date, record_style style, char out[RECORD_TIME_SIZE]);

typedef struct record_entry {
    int64_t seconds; ///< since 1970; where the text has no readable times, the place in the text
    uint32_t order;  ///< in the text
    record_date date;
    text_cursor at; ///< where the record's content begins
} record_entry;

typedef struct record_list {
    record_entry *entries; ///< in the order of the text until one is chosen
    uint32_t count, capacity;
    bool timed; ///< the entries have dates
    record_style style;
} record_list;

/// Appends an entry; MEMORY (logged). Sets seconds by the date, or by the order where the list is not timed.
bolan_result bolan_record_list_add(record_list *list, const record_date *date, text_cursor at);
void bolan_record_list_release(record_list *list);
/// One record, or two for a time between them.
typedef struct record_choice {
    const record_entry *first, *second; ///< second NULL: the first alone
    double share;                       ///< of the second, 0..1
    char time[RECORD_TIME_SIZE];        ///< that is asked for between the two
} record_choice;

/// Sorts by time, equal times as in the text.
void bolan_record_list_sort(record_list *list);
/// The record of a sorted list that the options ask for. ARGUMENT (one sentence) if there is none. A date that is not
/// exact, but within an hour, or between two records that are interpolated, is a note.
bolan_result bolan_record_list_choose(const record_list *list, const char *name, const bolan_spectrum_options *options,
                                      spectrum_notes *notes, record_choice *chosen);

/// Largest difference between a requested time and the record that is used for it [s].
#define RECORD_NEAR_SECONDS 3600

#endif
