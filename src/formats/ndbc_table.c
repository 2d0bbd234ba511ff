// SPDX-License-Identifier: MIT
// See ndbc_table.h.
#include "formats/ndbc_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const bolan_ndbc_quantity_names[] = {"an unnamed quantity",
                                                 "spectral density",
                                                 "alpha1, the mean direction",
                                                 "alpha2, the principal direction",
                                                 "r1, the first directional ratio",
                                                 "r2, the second directional ratio"};

// ---- the header -----------------------------------------------------------------------------------------------------

bool bolan_ndbc_is_header(text_word first) {
    return bolan_text_equals(first, "YY") || bolan_text_equals(first, "YYYY") || bolan_text_equals(first, "#YY") ||
           bolan_text_equals(first, "#YYYY");
}

// Real-time tables have a second line of the units, which also begins with #.
static bool is_header_line(text_cursor line) {
    text_word word;
    return bolan_text_next_word(&line, &word) && (word.begin[0] == '#' || word.begin[0] == 'Y' || word.begin[0] == 'y');
}

static bool begins_with(text_word word, const char *start) {
    const size_t length = strlen(start);
    return word.length > length && bolan_text_equals((text_word){word.begin, length, word.line}, start);
}

// "spec_1" and the like; UNNAMED for another word.
static ndbc_quantity quantity_of(text_word word) {
    static const char *const starts[] = {NULL, "spec_", "alpha1_", "alpha2_", "r1_", "r2_"};
    for (int i = NDBC_SPEC; i <= NDBC_R2; i++)
        if (begins_with(word, starts[i])) return (ndbc_quantity)i;
    return NDBC_UNNAMED;
}

static bolan_result refuse_table(const text_cursor *header, text_word word) {
    text_cursor line = *header;
    for (text_word other; bolan_text_next_word(&line, &other);) {
        if (!bolan_text_equals(other, "WVHT")) continue;
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_WRONG_TABLE,
                  "%s:%u: this is NDBC's table of wave heights (WVHT), not of spectral densities; give the station's "
                  ".data_spec, or its history file such as 41004w2018.txt",
                  header->name, (unsigned)word.line);
        return BOLAN_ERROR_FORMAT;
    }
    return bolan_text_unexpected(header, &word, "frequencies in hertz (history) or spec_1 (freq_1) (real time)");
}

// The words of a real-time header: Sep_Freq < spec_1 (freq_1) ... >
static bolan_result read_names(ndbc_table *table) {
    text_cursor line = table->header;
    for (text_word word; bolan_text_next_word(&line, &word);) {
        const ndbc_quantity quantity = quantity_of(word);
        if (quantity != NDBC_UNNAMED) {
            if (table->quantity == NDBC_UNNAMED) table->quantity = quantity;
        } else if (bolan_text_equals(word, "Sep_Freq")) {
            table->separation = true;
        } else if (!begins_with(word, "(freq_") && !memchr("<>.", word.begin[0], 3)) {
            return refuse_table(&table->header, word);
        }
    }
    return BOLAN_OK;
}

bolan_result bolan_ndbc_open(const bolan_spectrum_text *text, ndbc_table *table) {
    static const char expected[] = "the header YYYY MM DD hh or #YY MM DD hh mm";
    *table = (ndbc_table){.rows = bolan_text_open(text)};
    text_word word;
    double number;
    if (!bolan_text_next_line(&table->rows, &table->header)) return bolan_text_unexpected(&table->rows, NULL, expected);
    text_cursor line = table->header;
    while (bolan_text_next_word(&line, &word) && !bolan_text_equals(word, "hh")) table->date_words++;
    table->date_words++;
    table->header = line; // the frequencies of the history layout begin here, or after mm
    if (bolan_text_next_word(&line, &word) && bolan_text_equals(word, "mm")) {
        table->date_words++;
        table->header = line;
        if (!bolan_text_next_word(&line, &word)) return bolan_text_unexpected(&line, NULL, "a frequency in the header");
    }
    if (table->date_words != 4 && table->date_words != 5)
        return bolan_text_unexpected(&line, word.length ? &word : NULL, expected);
    table->pairs = !bolan_text_number(word, &number);
    return table->pairs ? read_names(table) : BOLAN_OK;
}

// ---- dates ----------------------------------------------------------------------------------------------------------

static bolan_result read_date_word(text_cursor *line, const char *expected, int low, int high, int *value) {
    text_word word;
    double number;
    if (!bolan_text_next_word(line, &word)) return bolan_text_unexpected(line, NULL, expected);
    if (!bolan_text_number(word, &number) || !(number >= low && number <= high) || number != floor(number))
        return bolan_text_unexpected(line, &word, expected);
    *value = (int)number;
    return BOLAN_OK;
}

bolan_result bolan_ndbc_read_date(const ndbc_table *table, text_cursor *line, record_date *date) {
    static const int high[5] = {2999, 12, 31, 23, 59};
    static const char *const expected[5] = {"a whole year", "a month 1 to 12", "", "an hour 0 to 23",
                                            "a minute 0 to 59"};
    int *f = date->field;
    *date = (record_date){{0}};
    for (int i = 0; i < table->date_words; i++) {
        char day[64];
        const int days = bolan_record_days_in_month(f[0], f[1]);
        snprintf(day, sizeof day, "a day 1 to %d of that month", days);
        if (read_date_word(line, i == 2 ? day : expected[i], i == 1 || i == 2, i == 2 ? days : high[i], &f[i]))
            return BOLAN_ERROR_FORMAT;
        if (i == 0 && f[0] < 100) f[0] += f[0] < 70 ? 2000 : 1900; // tables before 1999 have two digits
        if (i == 0 && f[0] < 1900) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_DATE,
                      "%s:%u: the year %d; expected 1900 to 2999, or 2 digits", line->name, (unsigned)line->line, f[0]);
            return BOLAN_ERROR_FORMAT;
        }
    }
    return BOLAN_OK;
}

bool bolan_ndbc_next_row(ndbc_table *table, text_cursor *line) {
    while (bolan_text_next_line(&table->rows, line))
        if (!is_header_line(*line)) return true;
    return false;
}

// ---- rows -----------------------------------------------------------------------------------------------------------

static bolan_result add_frequency(ndbc_row *row, const text_cursor *line, text_word word, const char *expected,
                                  double hertz) {
    if (row->count == SPECTRUM_MAX_FREQUENCIES)
        return bolan_text_unexpected(line, &word, "the end of the line after 1000 frequencies");
    const bool ascending = !row->count || hertz > row->hertz[row->count - 1];
    if (!ascending || !(hertz >= SPECTRUM_MIN_HERTZ && hertz <= SPECTRUM_MAX_HERTZ))
        return bolan_text_unexpected(line, &word, expected);
    row->hertz[row->count++] = hertz;
    return BOLAN_OK;
}

// "value (frequency)" up to the end of the line.
static bolan_result read_pairs(text_cursor *line, ndbc_row *row) {
    static const char expected[] = "an ascending frequency in hertz, 0.001 to 10, such as (0.033)";
    text_word word;
    while (bolan_text_next_word(line, &word)) {
        double value, hertz;
        if (!bolan_text_number(word, &value)) return bolan_text_unexpected(line, &word, "a number");
        if (!bolan_text_next_word(line, &word)) return bolan_text_unexpected(line, NULL, expected);
        const text_word inside = {word.begin + 1, word.length > 2 ? word.length - 2 : 0, word.line};
        if (word.begin[0] != '(' || word.begin[word.length - 1] != ')' || !bolan_text_number(inside, &hertz))
            return bolan_text_unexpected(line, &word, expected);
        if (add_frequency(row, line, word, expected, hertz)) return BOLAN_ERROR_FORMAT;
        row->value[row->count - 1] = value;
    }
    return BOLAN_OK;
}

// As many values as the header has frequencies.
static bolan_result read_columns(text_cursor header, text_cursor *line, ndbc_row *row) {
    text_word word;
    while (bolan_text_next_word(&header, &word)) {
        double hertz;
        if (!bolan_text_number(word, &hertz)) return bolan_text_unexpected(&header, &word, "a frequency in hertz");
        if (add_frequency(row, &header, word, "an ascending frequency in hertz, 0.001 to 10", hertz) ||
            bolan_text_read_number(line, "a value for every frequency of the header", &row->value[row->count - 1]))
            return BOLAN_ERROR_FORMAT;
    }
    return bolan_text_next_word(line, &word) ? bolan_text_unexpected(line, &word, "the end of the line") : BOLAN_OK;
}

bolan_result bolan_ndbc_read_row(const ndbc_table *table, text_cursor line, ndbc_row *row) {
    record_date date;
    double separation;
    row->count = 0;
    if (bolan_ndbc_read_date(table, &line, &date) ||
        (table->separation && bolan_text_read_number(&line, "the separation frequency", &separation)))
        return BOLAN_ERROR_FORMAT;
    return table->pairs ? read_pairs(&line, row) : read_columns(table->header, &line, row);
}
