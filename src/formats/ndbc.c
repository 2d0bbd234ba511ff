// SPDX-License-Identifier: MIT
// NDBC's spectra: a table of densities, and up to four of directions. Directions are compass degrees FROM. Rows of the
// tables are matched by their time, columns by their frequency. ndbc_table.h has the
// layouts, bands.h the replacement of missing values.
#include "formats/bands.h"
#include "formats/format.h"
#include "formats/ndbc_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ENERGY_MAX 1e6        // [m2/Hz]
#define FREQUENCY_NEAR 6e-4   // [Hz]: real-time tables print three decimals
#define WHOLE_NUMBERS_HS 10.0 // [m]: densities of so high a sea have decimals, directions have none

// ---- the table of densities -----------------------------------------------------------------------------------------

// The letter in the name of a history file of NDBC, which states its quantity: w density, d alpha1, i alpha2, j r1,
// k r2 ("41004w2018.txt"). NULL for other names.
static const char *letter_of(const char *path) {
    const char *slash = path ? strrchr(path, '/') : NULL, *name = slash ? slash + 1 : path, *found = NULL;
    for (const char *p = name; p && *p; p++) {
        const bool year = strspn(p + 1, "0123456789") == 4;
        if (p > name && year && strchr("wdijkWDIJK", *p)) found = p;
    }
    return found;
}

bool bolan_spectrum_companion(const char *path, uint32_t index, char *out, size_t capacity) {
    BOLAN_ASSERT(path && out && capacity > 0 && index < BOLAN_SPECTRUM_COMPANIONS);
    static const char density[] = ".data_spec";
    static const char *const suffixes[BOLAN_SPECTRUM_COMPANIONS] = {".swdir", ".swdir2", ".swr1", ".swr2"};
    static const char small[] = "dijk", capital[] = "DIJK";
    const size_t length = strlen(path), tail = sizeof density - 1;
    const char *letter = letter_of(path);
    int used = -1;
    if (length > tail && strcmp(path + length - tail, density) == 0)
        used = snprintf(out, capacity, "%.*s%s", (int)(length - tail), path, suffixes[index]);
    else if (letter && (*letter == 'w' || *letter == 'W'))
        used = snprintf(out, capacity, "%.*s%c%s", (int)(letter - path), path,
                        *letter == 'w' ? small[index] : capital[index], letter + 1);
    if (used >= 0 && (size_t)used < capacity) return true;
    out[0] = '\0';
    return false;
}

static ndbc_quantity quantity_by_name(const char *path) {
    const char *letter = letter_of(path);
    static const char letters[] = "wdijk"; // in the order of ndbc_quantity, from SPEC
    const char *at = letter ? strchr(letters, *letter | 0x20) : NULL;
    return at ? (ndbc_quantity)(NDBC_SPEC + (at - letters)) : NDBC_UNNAMED;
}

static bolan_result refuse_quantity(const char *name, uint32_t line, ndbc_quantity quantity) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_WRONG_TABLE,
              "%s:%u: this is NDBC's table of %s, not of spectral densities; give the density (.data_spec, or w in the "
              "name as in 41004w2018.txt), beside which it is found",
              name, (unsigned)line, bolan_ndbc_quantity_names[quantity]);
    return BOLAN_ERROR_FORMAT;
}

// Hs as if the row were densities, and whether all values are whole numbers.
static double height_of(const ndbc_row *row, bool *whole) {
    double m0 = 0.0;
    *whole = true;
    for (uint32_t i = 0; i < row->count; i++) {
        if (row->value[i] == NDBC_MISSING) continue;
        m0 += row->value[i] * bolan_spectrum_trapezoid_weight(row->hertz, row->count, i);
        *whole &= row->value[i] == floor(row->value[i]);
    }
    return 4.0 * sqrt(fmax(m0, 0.0));
}

// The history layout does not state its quantity. It follows from the name of the file, or from the values: directions
// and ratios in hundredths are whole numbers.
static bolan_result check_is_density(const ndbc_table *table, const text_cursor *line, const ndbc_row *row) {
    if (table->quantity > NDBC_SPEC) return refuse_quantity(line->name, table->header.line, table->quantity);
    if (table->quantity == NDBC_SPEC) return BOLAN_OK;
    bool whole;
    const ndbc_quantity named = quantity_by_name(line->name);
    const bool high = height_of(row, &whole) > WHOLE_NUMBERS_HS;
    if (named > NDBC_SPEC && (whole || high)) return refuse_quantity(line->name, line->line, named);
    if (!whole || !high) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_WRONG_TABLE,
              "%s:%u: whole numbers alone, which would be a sea of more than %g m: a table of directions or ratios; "
              "expected spectral densities",
              line->name, (unsigned)line->line, WHOLE_NUMBERS_HS);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result take_densities(const text_cursor *line, const ndbc_row *row, spectrum_bands *bands) {
    bands->count = row->count;
    memcpy(bands->hertz, row->hertz, row->count * sizeof(double));
    for (uint32_t i = 0; i < row->count; i++) {
        const double value = row->value[i];
        if (value == NDBC_MISSING) continue;
        if (value < 0.0) return bolan_text_negative(line, value);
        if (value > ENERGY_MAX) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: the density %g m2/Hz; expected 0 to %g",
                      line->name, (unsigned)line->line, value, ENERGY_MAX);
            return BOLAN_ERROR_FORMAT;
        }
        bands->density[i] = value;
    }
    text_cursor at = *line;
    at.next = at.end;
    return row->count >= SPECTRUM_MIN_FREQUENCIES ? BOLAN_OK : bolan_text_unexpected(&at, NULL, "a second frequency");
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    ndbc_table table;
    text_cursor line;
    if (bolan_ndbc_open(&texts->density, &table)) return BOLAN_ERROR_FORMAT;
    *list = (record_list){.timed = true, .style = RECORD_UTC_MINUTES};
    while (bolan_ndbc_next_row(&table, &line)) {
        const text_cursor start = line;
        record_date date;
        if (bolan_ndbc_read_date(&table, &line, &date)) return BOLAN_ERROR_FORMAT;
        const bolan_result result = bolan_record_list_add(list, &date, start);
        if (result) return result;
    }
    return list->count ? BOLAN_OK : bolan_text_unexpected(&table.rows, NULL, "a row of densities");
}

// ---- the tables of directions ---------------------------------------------------------------------------------------

typedef struct companion {
    const bolan_spectrum_text *text;
    double *values; // of the bands
    bool ratio;
    ndbc_table table;
} companion;

// A direction is refused as a ratio by its range; a ratio as a direction only by the header.
static bolan_result open_companion(companion *c) {
    if (bolan_ndbc_open(c->text, &c->table)) return BOLAN_ERROR_FORMAT;
    const ndbc_quantity q = c->table.quantity;
    const bool wrong = q == NDBC_SPEC || (!c->ratio && (q == NDBC_R1 || q == NDBC_R2));
    if (!wrong) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_WRONG_TABLE, "%s:%u: this is NDBC's table of %s; expected %s",
              c->table.header.name, (unsigned)c->table.header.line, bolan_ndbc_quantity_names[q],
              c->ratio ? "r1 or r2" : "alpha1 or alpha2");
    return BOLAN_ERROR_FORMAT;
}

// The row whose time is nearest to @p seconds; @p off is how far away [s], INT64_MAX where the table has no row.
static bolan_result nearest_row(ndbc_table table, int64_t seconds, text_cursor *found, record_date *date,
                                int64_t *off) {
    text_cursor line;
    *off = INT64_MAX;
    while (bolan_ndbc_next_row(&table, &line)) {
        text_cursor start = line;
        record_date at;
        if (bolan_ndbc_read_date(&table, &start, &at)) return BOLAN_ERROR_FORMAT;
        const int64_t distance = llabs(bolan_record_date_seconds(&at) - seconds);
        if (distance >= *off) continue;
        *off = distance;
        *found = line;
        *date = at;
    }
    return BOLAN_OK;
}

// The values of one row at the density's frequencies.
static bolan_result take_companion(const companion *c, text_cursor line, ndbc_row *row, const spectrum_bands *bands) {
    if (bolan_ndbc_read_row(&c->table, line, row)) return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0, j = 0; i < bands->count; i++) {
        while (j < row->count && row->hertz[j] < bands->hertz[i] - FREQUENCY_NEAR) j++;
        if (j == row->count || row->hertz[j] > bands->hertz[i] + FREQUENCY_NEAR || row->value[j] == NDBC_MISSING)
            continue;
        const double v = row->value[j] * (c->ratio && !c->table.pairs ? 0.01 : 1.0);
        if (!(v >= 0.0 && v <= (c->ratio ? 1.0 : 360.0))) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: %g at %g Hz; expected %s, or 999 for missing",
                      line.name, (unsigned)line.line, row->value[j], row->hertz[j],
                      c->ratio ? (c->table.pairs ? "0 to 1" : "0 to 100") : "0 to 360 degrees");
            return BOLAN_ERROR_FORMAT;
        }
        c->values[i] = v;
    }
    return BOLAN_OK;
}

// Why a record has no directions, for the warning about their replacement.
typedef struct reason {
    char text[320];
} reason;

static bolan_result read_companions(const bolan_spectrum_texts *texts, const record_date *date, spectrum_bands *bands,
                                    ndbc_row *row, reason *why, spectrum_notes *notes) {
    companion all[4] = {{.text = &texts->swdir, .values = bands->alpha1},
                        {.text = &texts->swdir2, .values = bands->alpha2},
                        {.text = &texts->swr1, .values = bands->r1, .ratio = true},
                        {.text = &texts->swr2, .values = bands->r2, .ratio = true}};
    char wanted[RECORD_TIME_SIZE], taken[RECORD_TIME_SIZE];
    int64_t seconds = bolan_record_date_seconds(date);
    bolan_record_date_print(date, RECORD_UTC_MINUTES, wanted);
    snprintf(why->text, sizeof why->text, "has no table of directions beside it");
    for (companion *c = all; c < all + 4; c++) {
        text_cursor line;
        record_date found;
        int64_t off;
        if (!c->text->data) continue;
        if (open_companion(c) || nearest_row(c->table, seconds, &line, &found, &off)) return BOLAN_ERROR_FORMAT;
        const bool first = c == all;
        if (first)
            snprintf(why->text, sizeof why->text, off ? "has no row within an hour in %s" : "has only 999 in %s",
                     c->table.rows.name);
        // The time of alpha1 is the time of the directions; the other three tables must have it too.
        if (off > (first ? RECORD_NEAR_SECONDS : 0)) continue;
        if (off) {
            bolan_record_date_print(&found, RECORD_UTC_MINUTES, taken);
            bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_NEAREST_TIME,
                                "%s: there is no row of %s; the nearest, of %s, is taken", line.name, wanted, taken);
            seconds = bolan_record_date_seconds(&found);
        }
        if (take_companion(c, line, row, bands)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

typedef struct ndbc_scratch {
    ndbc_row row;
    spectrum_bands bands;
    reason why;
} ndbc_scratch;

static bolan_result read_record(const bolan_spectrum_texts *texts, const record_entry *record,
                                const bolan_spectrum_options *options, ndbc_scratch *s, spectrum_grid *grid) {
    ndbc_table table;
    if (bolan_ndbc_open(&texts->density, &table)) return BOLAN_ERROR_FORMAT;
    bolan_spectrum_bands_clear(&s->bands);
    if (bolan_ndbc_read_row(&table, record->at, &s->row) || check_is_density(&table, &record->at, &s->row) ||
        take_densities(&record->at, &s->row, &s->bands) ||
        read_companions(texts, &record->date, &s->bands, &s->row, &s->why, &grid->notes))
        return BOLAN_ERROR_FORMAT;
    return bolan_spectrum_bands_to_grid(&s->bands, table.rows.name, s->why.text, options, grid);
}

static bolan_result no_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)texts, (void)record, (void)list;
    return BOLAN_OK;
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    ndbc_scratch *scratch = bolan_allocate(sizeof *scratch);
    if (!scratch) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "an NDBC spectrum needs %zu bytes, which could not be allocated", sizeof *scratch);
        return BOLAN_ERROR_MEMORY;
    }
    const bolan_result result = read_record(texts, choice->record, options, scratch, grid);
    bolan_release(scratch, sizeof *scratch);
    return result;
}

static bool is_ndbc(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text);
    text_word first;
    return bolan_text_next_word(&cursor, &first) && bolan_ndbc_is_header(first);
}

const spectrum_format bolan_format_ndbc = {
    "ndbc", "NDBC spectral wave density", is_ndbc, list_records, no_locations, read_spectrum};
