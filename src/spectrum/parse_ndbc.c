// SPDX-License-Identifier: MIT Spectral wave density tables of the US National Data Buoy Center (NDBC, "Measurement
// descriptions and units"), in both of their layouts, and the four tables of directions that may come with them:
//
//   history     YYYY MM DD hh [mm]  .030  .040 ...            frequencies in the header; r1, r2 in hundredths
//               2000 01 01 00        .00   .12 ...            oldest first
//   real time   #YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >
//               2020 06 08 03 50 0.225 0.000 (0.033) ...      newest first; r1, r2 as fractions
//
// 999 is a missing value everywhere. Directions are compass degrees FROM. Rows of the tables are matched by their time,
// columns by their frequency.
#include "spectrum/measured.h"

#include "bolan/math.h"
#include "spectrum/directional.h"
#include "spectrum/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MISSING 999.0
#define ENERGY_MAX 1e6 // [m2/Hz]

typedef struct ndbc_date {
    int field[5]; // year, month, day, hour, minute
} ndbc_date;

// One table, opened at its header.
typedef struct ndbc_table {
    text_cursor rows; // after the header
    text_cursor header;
    int date_words;  // 4 or 5
    bool pairs;      // "value (frequency)"
    bool separation; // a Sep_Freq column
} ndbc_table;

// One row: the values at frequencies.
typedef struct ndbc_row {
    uint32_t count;
    double hertz[SPECTRUM_MAX_FREQUENCIES], value[SPECTRUM_MAX_FREQUENCIES];
} ndbc_row;

// ---- tables ---------------------------------------------------------------------------------------------------------

static bool is_header(text_cursor line) {
    text_word word;
    return text_next_word(&line, &word) && (word.begin[0] == '#' || word.begin[0] == 'Y' || word.begin[0] == 'y');
}

static bolan_result open_table(const bolan_spectrum_text *text, ndbc_table *table) {
    *table = (ndbc_table){.rows = text_open(text)};
    text_word word;
    double number;
    if (!text_next_line(&table->rows, &table->header))
        return text_unexpected(&table->rows, NULL, "the header YYYY MM DD hh");
    text_cursor line = table->header;
    static const char *const names[2] = {"hh", "mm"};
    while (text_next_word(&line, &word) && !text_equals(word, names[0])) table->date_words++;
    table->date_words++;
    table->header = line; // the frequencies of the history layout begin here, or after mm
    if (text_next_word(&line, &word) && text_equals(word, names[1])) {
        table->date_words++;
        table->header = line;
        if (!text_next_word(&line, &word)) return text_unexpected(&line, NULL, "a frequency in the header");
    }
    if (table->date_words != 4 && table->date_words != 5)
        return text_unexpected(&line, word.length ? &word : NULL, "the header YYYY MM DD hh");
    table->pairs = !text_number(word, &number);
    table->separation = table->pairs && text_equals(word, "Sep_Freq");
    return BOLAN_OK;
}

static bolan_result read_date(const ndbc_table *table, text_cursor *line, ndbc_date *date) {
    static const int low[5] = {0, 1, 1, 0, 0}, high[5] = {9999, 12, 31, 24, 59};
    static const char *const expected[5] = {"a year", "a month 1 to 12", "a day 1 to 31", "an hour 0 to 24",
                                            "a minute 0 to 59"};
    *date = (ndbc_date){{0}};
    for (int i = 0; i < table->date_words; i++) {
        text_word word;
        double value;
        if (!text_next_word(line, &word)) return text_unexpected(line, NULL, expected[i]);
        if (!text_number(word, &value) || !(value >= low[i] && value <= high[i]))
            return text_unexpected(line, &word, expected[i]);
        date->field[i] = (int)value;
    }
    if (date->field[0] < 100) // tables before 1999 have two digits
        date->field[0] += date->field[0] < 70 ? 2000 : 1900;
    return BOLAN_OK;
}

static int compare_dates(const ndbc_date *a, const ndbc_date *b) {
    for (int i = 0; i < 5; i++)
        if (a->field[i] != b->field[i]) return a->field[i] < b->field[i] ? -1 : 1;
    return 0;
}

static bool next_row(ndbc_table *table, text_cursor *line) {
    while (text_next_line(&table->rows, line))
        if (!is_header(*line)) return true;
    return false;
}

// ---- rows -----------------------------------------------------------------------------------------------------------

static bolan_result add_frequency(ndbc_row *row, text_cursor *line, text_word word, const char *expected,
                                  double hertz) {
    const double before = row->count ? row->hertz[row->count - 1] : SPECTRUM_MIN_HERTZ;
    if (row->count == SPECTRUM_MAX_FREQUENCIES)
        return text_unexpected(line, &word, "the end of the line after 1000 frequencies");
    if (!(hertz > before && hertz <= SPECTRUM_MAX_HERTZ)) return text_unexpected(line, &word, expected);
    row->hertz[row->count++] = hertz;
    return BOLAN_OK;
}

// "value (frequency)" up to the end of the line.
static bolan_result read_pairs(text_cursor *line, ndbc_row *row) {
    static const char expected[] = "an ascending frequency in hertz such as (0.033)";
    text_word word;
    while (text_next_word(line, &word)) {
        double value, hertz;
        if (!text_number(word, &value)) return text_unexpected(line, &word, "a number");
        if (!text_next_word(line, &word)) return text_unexpected(line, NULL, expected);
        const text_word inside = {word.begin + 1, word.length > 2 ? word.length - 2 : 0, word.line};
        if (word.begin[0] != '(' || word.begin[word.length - 1] != ')' || !text_number(inside, &hertz))
            return text_unexpected(line, &word, expected);
        if (add_frequency(row, line, word, expected, hertz)) return BOLAN_ERROR_FORMAT;
        row->value[row->count - 1] = value;
    }
    return BOLAN_OK;
}

// As many values as the header has frequencies.
static bolan_result read_columns(text_cursor header, text_cursor *line, ndbc_row *row) {
    text_word word;
    while (text_next_word(&header, &word)) {
        double hertz;
        if (!text_number(word, &hertz)) return text_unexpected(&header, &word, "a frequency in hertz");
        if (add_frequency(row, &header, word, "an ascending frequency in hertz", hertz) ||
            text_read_number(line, "a value for every frequency of the header", &row->value[row->count - 1]))
            return BOLAN_ERROR_FORMAT;
    }
    return text_next_word(line, &word) ? text_unexpected(line, &word, "the end of the line") : BOLAN_OK;
}

static bolan_result read_row(const ndbc_table *table, text_cursor line, ndbc_row *row) {
    ndbc_date date;
    double separation;
    row->count = 0;
    if (read_date(table, &line, &date) ||
        (table->separation && text_read_number(&line, "the separation frequency", &separation)))
        return BOLAN_ERROR_FORMAT;
    return table->pairs ? read_pairs(&line, row) : read_columns(table->header, &line, row);
}

// The line of record number @p record in time, its date, and the number of records.
static bolan_result find_record(ndbc_table *table, uint32_t record, text_cursor *found, ndbc_date *date,
                                uint32_t *count) {
    ndbc_table scan = *table;
    ndbc_date first = {{0}}, last = {{0}};
    text_cursor line;
    for (*count = 0; next_row(&scan, &line); ++*count)
        if (read_date(table, &line, *count ? &last : &first)) return BOLAN_ERROR_FORMAT;
    if (*count == 0) return text_unexpected(&scan.rows, NULL, "a row of densities");
    if (record >= *count) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TIME_INDEX, "%s: record %u was asked for; expected 0 to %u",
                  table->rows.name, (unsigned)record, (unsigned)(*count - 1));
        return BOLAN_ERROR_ARGUMENT;
    }
    const bool newest_first = *count > 1 && compare_dates(&last, &first) < 0;
    const uint32_t row = newest_first ? *count - 1 - record : record;
    scan = *table;
    for (uint32_t i = 0; i <= row; i++) next_row(&scan, found);
    line = *found;
    return read_date(table, &line, date);
}

// ---- directions -----------------------------------------------------------------------------------------------------

typedef enum companion { SWDIR, SWDIR2, SWR1, SWR2, COMPANIONS } companion;

// The values of one companion at the density's frequencies; MISSING where there are none.
static bolan_result read_companion(const bolan_spectrum_text *text, companion kind, const ndbc_date *date,
                                   const ndbc_row *density, ndbc_row *scratch, double *value) {
    for (uint32_t i = 0; i < density->count; i++) value[i] = MISSING;
    if (!text->data) return BOLAN_OK;
    ndbc_table table;
    text_cursor line;
    ndbc_date found;
    int order = 1;
    if (open_table(text, &table)) return BOLAN_ERROR_FORMAT;
    while (order != 0 && next_row(&table, &line)) {
        text_cursor start = line;
        if (read_date(&table, &start, &found)) return BOLAN_ERROR_FORMAT;
        order = compare_dates(&found, date);
    }
    if (order != 0) return BOLAN_OK; // the buoy sent no directions at that time
    if (read_row(&table, line, scratch)) return BOLAN_ERROR_FORMAT;
    const bool is_ratio = kind == SWR1 || kind == SWR2;
    for (uint32_t i = 0, j = 0; i < density->count; i++) {
        while (j < scratch->count && scratch->hertz[j] < density->hertz[i] - 6e-4) j++;
        if (j == scratch->count || scratch->hertz[j] > density->hertz[i] + 6e-4 || scratch->value[j] == MISSING)
            continue;
        const double v = scratch->value[j] * (is_ratio && !table.pairs ? 0.01 : 1.0);
        if (!(v >= 0.0 && v <= (is_ratio ? 1.0 : 360.0))) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: %g at %g Hz; expected %s, or 999 for missing",
                      line.name, (unsigned)line.line, scratch->value[j], scratch->hertz[j],
                      is_ratio ? (table.pairs ? "0 to 1" : "0 to 100") : "0 to 360 degrees");
            return BOLAN_ERROR_FORMAT;
        }
        value[i] = v;
    }
    return BOLAN_OK;
}

// Bands without a direction take the one of the nearest lower band, or of the lowest that has one.
static void fill_missing(double *swdir, uint32_t count, double from_deg) {
    uint32_t first = 0;
    while (first < count && swdir[first] == MISSING) first++;
    double previous = first < count ? swdir[first] : from_deg;
    for (uint32_t i = 0; i < count; i++) previous = swdir[i] = swdir[i] == MISSING ? previous : swdir[i];
}

typedef double companion_values[COMPANIONS][SPECTRUM_MAX_FREQUENCIES];

// D on the bins for band i: by four moments, by one, or by cos-2s with the caller's exponent, as far as they are known.
static void spread_band(companion_values values, uint32_t i, double spread_s, double spread[DIRECTIONAL_BINS]) {
    const double to = bolan_compass_from_to_math(values[SWDIR][i]);
    const double r1 = values[SWR1][i], r2 = values[SWR2][i], a2 = values[SWDIR2][i];
    if (r1 == MISSING)
        directional_cos2s(to, spread_s, spread);
    else if (r2 == MISSING || a2 == MISSING)
        directional_cos2s(to, r1 < 0.995 ? r1 / (1.0 - r1) : 200.0, spread); // r1 of cos-2s is s / (s + 1)
    else
        directional_from_moments((directional_moments){to, bolan_compass_from_to_math(a2), r1, r2}, spread);
}

// ---- the whole ------------------------------------------------------------------------------------------------------

static bolan_result check_densities(const text_cursor *line, ndbc_row *row) {
    for (uint32_t i = 0; i < row->count; i++) {
        if (row->value[i] == MISSING) row->value[i] = 0.0;
        if (row->value[i] < 0.0) return text_negative(line, row->value[i]);
        if (row->value[i] > ENERGY_MAX) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: the density %g m2/Hz; expected 0 to %g",
                      line->name, (unsigned)line->line, row->value[i], ENERGY_MAX);
            return BOLAN_ERROR_FORMAT;
        }
    }
    text_cursor at = *line;
    at.next = at.end;
    return row->count >= SPECTRUM_MIN_FREQUENCIES ? BOLAN_OK : text_unexpected(&at, NULL, "a second frequency");
}

static bolan_result fill_grid(const ndbc_row *row, companion_values values, double spread_s, spectrum_grid *grid) {
    grid->frequency_count = row->count;
    grid->direction_count = DIRECTIONAL_BINS;
    if (!spectrum_grid_allocate(grid)) return BOLAN_ERROR_MEMORY;
    for (uint32_t j = 0; j < DIRECTIONAL_BINS; j++) grid->to[j] = directional_angle(j);
    for (uint32_t i = 0; i < row->count; i++) {
        double *energy = grid->energy + (size_t)i * DIRECTIONAL_BINS;
        grid->hertz[i] = row->hertz[i];
        if (!(row->value[i] > 0.0)) continue;
        spread_band(values, i, spread_s, energy);
        for (uint32_t j = 0; j < DIRECTIONAL_BINS; j++) energy[j] *= row->value[i];
    }
    return BOLAN_OK;
}

typedef struct ndbc_scratch {
    ndbc_row density, companion;
    companion_values values;
} ndbc_scratch;

static bolan_result read_all(const bolan_spectrum_texts *texts, uint32_t record, ndbc_scratch *s, spectrum_grid *grid) {
    const bolan_spectrum_text *companions[COMPANIONS] = {&texts->swdir, &texts->swdir2, &texts->swr1, &texts->swr2};
    ndbc_table table;
    text_cursor line;
    ndbc_date date;
    bolan_result result = open_table(&texts->density, &table);
    if (!result) result = find_record(&table, record, &line, &date, &grid->record_count);
    if (!result) result = read_row(&table, line, &s->density);
    if (!result) result = check_densities(&line, &s->density);
    for (companion kind = SWDIR; !result && kind < COMPANIONS; kind++)
        result = read_companion(companions[kind], kind, &date, &s->density, &s->companion, s->values[kind]);
    if (result) return result;
    fill_missing(s->values[SWDIR], s->density.count, texts->from_deg);
    const int *d = date.field;
    snprintf(grid->time, sizeof grid->time, "%04d-%02d-%02dT%02d:%02dZ", d[0], d[1], d[2], d[3], d[4]);
    return fill_grid(&s->density, s->values, texts->spread_s, grid);
}

bolan_result spectrum_parse_ndbc(const bolan_spectrum_texts *texts, uint32_t record, spectrum_grid *grid) {
    ndbc_scratch *scratch = bolan_allocate(sizeof *scratch);
    if (!scratch) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "an NDBC spectrum needs %zu bytes, which could not be allocated", sizeof *scratch);
        return BOLAN_ERROR_MEMORY;
    }
    const bolan_result result = read_all(texts, record, scratch, grid);
    bolan_release(scratch, sizeof *scratch);
    return result;
}
