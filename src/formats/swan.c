// SPDX-License-Identifier: MIT
// SWAN spectral files, 2-D and 1-D (SWAN user manual, appendix D). After the header (swan_header.h):
//
//     for each time:  date, and for each location:
//         2-D:  FACTOR f, then frequencies x directions whole numbers      or ZERO, or NODATA
//         1-D:  LOCATION n, then for each frequency a value a quantity     or ZERO, or NODATA
//
// The text is read twice. The first pass skips all blocks, without parsing their numbers, to list the records. The
// second pass reads the requested block strictly.
#include "formats/bands.h"
#include "formats/format.h"
#include "formats/swan_header.h"

#include "bolan/math.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SPREAD_MAX 81.1 // [deg]: sqrt(2) rad, the circular spread of waves from everywhere

// ---- words ----------------------------------------------------------------------------------------------------------

typedef enum block_kind { BLOCK_NONE, BLOCK_VALUES, BLOCK_ZERO, BLOCK_NODATA } block_kind;

static block_kind kind_of(const swan_header *h, text_word word) {
    if (bolan_text_equals(word, "ZERO")) return BLOCK_ZERO;
    if (bolan_text_equals(word, "NODATA")) return BLOCK_NODATA;
    return bolan_text_equals(word, h->directions ? "FACTOR" : "LOCATION") ? BLOCK_VALUES : BLOCK_NONE;
}

static const char *block_words(const swan_header *h) {
    return h->directions ? "FACTOR, ZERO or NODATA"
                         : "LOCATION, ZERO or NODATA (a 1-D spectrum, since there is no section NDIR or CDIR)";
}

// Is it ISO notation, "20161011.013000"? Digits that are left out at the end are 0.
static bool looks_like_date(const swan_header *h, text_word word) {
    if (!h->has_times || h->time_code != 1 || word.length < 8 || word.length > 15) return false;
    for (size_t i = 0; i < word.length; i++)
        if (i == 8 ? word.begin[i] != '.' : word.begin[i] < '0' || word.begin[i] > '9') return false;
    return true;
}

static record_date date_of(text_word word) {
    static const uint8_t part[15] = {0, 0, 0, 0, 1, 1, 2, 2, 9, 3, 3, 4, 4, 5, 5};
    record_date date = {{0}};
    for (size_t i = 0; i < 15; i++)
        if (i != 8) date.field[part[i]] = date.field[part[i]] * 10 + (i < word.length ? word.begin[i] - '0' : 0);
    return date;
}

// ---- the list of records --------------------------------------------------------------------------------------------

// Skips one block. A block that is cut short by the next one, by a date or by the end of the text is accepted, since
// only the requested block must be readable.
static bolan_result skip_block(const swan_header *h, text_cursor *text, block_kind *kind) {
    text_word word;
    text_cursor before = *text;
    *kind = BLOCK_NODATA;
    if (!bolan_swan_next_word(text, &word)) return BOLAN_OK;
    *kind = kind_of(h, word);
    if (*kind == BLOCK_NONE) return bolan_text_unexpected(text, &word, block_words(h));
    if (*kind != BLOCK_VALUES) return BOLAN_OK;
    const size_t columns = h->directions ? h->directions : h->quantities;
    size_t count = (size_t)h->frequencies * columns + 1; // and the factor, or the number of the location
    bool energy = false;
    for (size_t i = 0; i < count; i++) {
        double value = 0.0;
        before = *text;
        if (!bolan_swan_next_word(text, &word)) break;
        const block_kind next = kind_of(h, word);
        if (i == 1 && !h->directions && (next == BLOCK_ZERO || next == BLOCK_NODATA)) {
            *kind = next; // LOCATION 3 NODATA
            return BOLAN_OK;
        }
        if (next != BLOCK_NONE || looks_like_date(h, word)) {
            *text = before;
            break;
        }
        energy |= i > 0 && bolan_text_fortran_number(word, &value) && value > 0.0;
    }
    if (!energy) *kind = BLOCK_ZERO;
    return BOLAN_OK;
}

static bolan_result skip_record(const swan_header *h, text_cursor *text) {
    for (uint32_t i = 0; i < h->locations; i++) {
        block_kind kind;
        if (skip_block(h, text, &kind)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

static bolan_result read_date(const swan_header *h, text_cursor *text, text_word word, record_date *date) {
    *date = (record_date){{0}};
    if (h->time_code == 1) {
        if (!looks_like_date(h, word))
            return bolan_text_unexpected(text, &word, "the date of the next time, such as 20161011.013000");
        *date = date_of(word);
        if (!bolan_record_date_is_valid(date)) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_DATE,
                      "%s:%u: there is no date %.*s; expected one of the calendar, as yyyymmdd.hhmmss", text->name,
                      (unsigned)word.line, (int)word.length, word.begin);
            return BOLAN_ERROR_FORMAT;
        }
    } else if (word.begin[0] < '0' || word.begin[0] > '9') {
        return bolan_text_unexpected(text, &word, "the date of the next time");
    }
    bolan_text_skip_line(text);
    return BOLAN_OK;
}

static bolan_result list_records_of(const swan_header *h, record_list *list) {
    text_cursor text = h->text;
    text_word word;
    *list = (record_list){.timed = h->has_times && h->time_code == 1, .style = RECORD_LOCAL_SECONDS};
    while (h->has_times ? bolan_swan_next_word(&text, &word) : list->count == 0) {
        record_date date = {{0}};
        if (h->has_times && read_date(h, &text, word, &date)) return BOLAN_ERROR_FORMAT;
        const bolan_result result = bolan_record_list_add(list, &date, text);
        if (result) return result;
        if (skip_record(h, &text)) return BOLAN_ERROR_FORMAT;
    }
    if (list->count == 0) return bolan_text_unexpected(&text, NULL, "the date of the first time");
    return bolan_swan_next_word(&text, &word)
               ? bolan_text_unexpected(&text, &word, "the end of the text after the last location")
               : BOLAN_OK;
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    swan_header h;
    return bolan_swan_read_header(&texts->density, &h) ? BOLAN_ERROR_FORMAT : list_records_of(&h, list);
}

// ---- the locations --------------------------------------------------------------------------------------------------

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)record; // all records have the same
    swan_header h;
    if (bolan_swan_read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    list->spherical = h.spherical;
    for (uint32_t i = 0; i < h.locations; i++) {
        double place[2];
        if (bolan_swan_read_place(&h.places, place)) return BOLAN_ERROR_FORMAT;
        if (bolan_location_list_add(list, place[0], place[1], NULL, 0)) return BOLAN_ERROR_MEMORY;
    }
    return BOLAN_OK;
}

// The chosen location is dry: the sentence states the number of locations and which have energy at this time.
static bolan_result refuse_dry(const swan_header *h, const format_choice *choice, const char *time) {
    const bolan_spectrum_place *place = &choice->locations->entries[choice->location];
    text_cursor text = choice->record->at;
    enum { SHOWN = 8 };
    char list[96] = "";
    uint32_t wet = 0;
    for (uint32_t i = 0; i < h->locations; i++) {
        block_kind kind;
        if (skip_block(h, &text, &kind)) return BOLAN_ERROR_FORMAT;
        if (kind != BLOCK_VALUES || wet++ >= SHOWN) continue;
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%u", used ? ", " : "", (unsigned)i + 1);
    }
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NO_ENERGY,
              "%s: location %u of %u, at %g, %g, has no data (NODATA)%s%s; %u of the %u have energy%s%s%s",
              h->text.name, (unsigned)choice->location + 1, (unsigned)h->locations, place->x, place->y,
              time[0] ? " at " : "", time, (unsigned)wet, (unsigned)h->locations, wet ? ": " : "", list,
              wet > SHOWN ? ", ..."
              : wet       ? "; give location to choose"
                          : "");
    return BOLAN_ERROR_FORMAT;
}

// ---- the values -----------------------------------------------------------------------------------------------------

// After the last value comes a block, a date or the end.
static bolan_result expect_end_of_block(const swan_header *h, text_cursor *text) {
    text_word word;
    if (!bolan_swan_next_word(text, &word) || kind_of(h, word) != BLOCK_NONE || (h->has_times && h->time_code != 1) ||
        looks_like_date(h, word))
        return BOLAN_OK;
    return bolan_text_unexpected(text, &word, "the end of the densities");
}

static bolan_result read_value(const swan_header *h, text_cursor *text, const char *expected, text_word *word,
                               double *value) {
    if (!bolan_text_next_word(text, word)) return bolan_text_unexpected(text, NULL, expected);
    return !looks_like_date(h, *word) && bolan_text_fortran_number(*word, value)
               ? BOLAN_OK
               : bolan_text_unexpected(text, word, expected);
}

static bolan_result read_matrix(const swan_header *h, text_cursor *text, double factor, spectrum_grid *grid) {
    const size_t count = (size_t)h->frequencies * h->directions;
    size_t missing = 0;
    for (size_t i = 0; i < count; i++) {
        text_word word;
        double value;
        if (read_value(h, text, "a density", &word, &value)) return BOLAN_ERROR_FORMAT;
        const bool exception = value == h->quantity[0].exception;
        missing += exception;
        if (exception) value = 0.0;
        if (value < 0.0) return bolan_text_negative(text, value);
        grid->energy[i] = value * factor * h->scale;
        if (!(grid->energy[i] <= SPECTRUM_MAX_DENSITY))
            return bolan_text_unexpected(text, &word, "a density that a sea can have");
    }
    if (missing == count) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NO_ENERGY,
                  "%s:%u: every density of the record is the exception value; expected at least one that is not",
                  text->name, (unsigned)text->line);
        return BOLAN_ERROR_FORMAT;
    }
    if (missing > 0)
        bolan_spectrum_note(
            &grid->notes, BOLAN_LOG_SPECTRUM_MISSING,
            "%s: %.1f %% of the densities of the record are missing (the exception value): they count as 0", text->name,
            100.0 * (double)missing / (double)count);
    return BOLAN_OK;
}

// FACTOR and a matrix, into the grid.
static bolan_result read_2d(const swan_header *h, text_cursor *text, block_kind kind, spectrum_grid *grid) {
    if (bolan_spectrum_grid_begin(grid, h->hertz, h->frequencies, h->to, h->directions)) return BOLAN_ERROR_MEMORY;
    if (kind == BLOCK_ZERO) return BOLAN_OK; // a calm
    text_word word;
    double factor;
    if (read_value(h, text, "the factor", &word, &factor)) return BOLAN_ERROR_FORMAT;
    if (factor < 0.0) return bolan_text_negative(text, factor);
    return read_matrix(h, text, factor, grid) || expect_end_of_block(h, text) ? BOLAN_ERROR_FORMAT : BOLAN_OK;
}

// One value of a band by what it is. r1 follows from the circular spread sqrt(2 (1 - r1)).
static bolan_result take_value(const swan_header *h, const text_cursor *text, text_word word, swan_quantity quantity,
                               double value, spectrum_bands *bands, uint32_t i) {
    if (value == quantity.exception) return BOLAN_OK;
    switch (quantity.role) {
    case SWAN_DENSITY:
        if (value < 0.0) return bolan_text_negative(text, value);
        bands->density[i] = value * h->scale;
        return bands->density[i] <= SPECTRUM_MAX_DENSITY
                   ? BOLAN_OK
                   : bolan_text_unexpected(text, &word, "a density that a sea can have");
    case SWAN_SPREAD:
        if (!(value >= 0.0 && value <= SPREAD_MAX))
            return bolan_text_unexpected(text, &word, "a spread of 0 to 81 degrees");
        bands->r1[i] = fmax(1.0 - 0.5 * bolan_radians(value) * bolan_radians(value), 0.0);
        return BOLAN_OK;
    case SWAN_FROM:
    case SWAN_TO:
        if (!(fabs(value) <= 720.0)) return bolan_text_unexpected(text, &word, "a direction in degrees");
        bands->alpha1[i] = quantity.role == SWAN_FROM ? value : 270.0 - value;
        return BOLAN_OK;
    }
    return BOLAN_OK;
}

// LOCATION n and a table, into the bands.
static bolan_result read_table(const swan_header *h, text_cursor *text, block_kind kind, spectrum_bands *bands) {
    bolan_spectrum_bands_clear(bands);
    bands->count = h->frequencies;
    memcpy(bands->hertz, h->hertz, h->frequencies * sizeof(double));
    for (uint32_t i = 0; kind == BLOCK_ZERO && i < bands->count; i++) bands->density[i] = 0.0;
    if (kind == BLOCK_ZERO) return BOLAN_OK; // a calm
    uint32_t number;
    if (bolan_text_read_count(text, "the number of the location", 1, h->locations, &number)) return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i < h->frequencies; i++)
        for (uint32_t q = 0; q < h->quantities; q++) {
            text_word word;
            double value;
            if (read_value(h, text, "a value for every quantity", &word, &value) ||
                take_value(h, text, word, h->quantity[q], value, bands, i))
                return BOLAN_ERROR_FORMAT;
        }
    return expect_end_of_block(h, text);
}

static bolan_result read_1d(const swan_header *h, text_cursor *text, block_kind kind,
                            const bolan_spectrum_options *options, spectrum_grid *grid) {
    spectrum_bands *bands;
    bolan_result result = bolan_spectrum_bands_create(&bands);
    bolan_spectrum_options calm = *options;
    if (kind == BLOCK_ZERO) calm.from_deg = 270.0, calm.spread_s = 0.0; // a calm needs no direction and no warning
    if (!result) result = read_table(h, text, kind, bands);
    if (!result) result = bolan_spectrum_bands_to_grid(bands, h->text.name, "has no directions", &calm, grid);
    bolan_spectrum_bands_destroy(&bands);
    return result;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

// "LOCATION 3" may be followed by NODATA or ZERO in place of its values.
static block_kind block_after_number(const swan_header *h, text_cursor text) {
    text_word word;
    if (!bolan_text_next_word(&text, &word) || !bolan_swan_next_word(&text, &word)) return BLOCK_VALUES;
    const block_kind kind = kind_of(h, word);
    return kind == BLOCK_NONE ? BLOCK_VALUES : kind;
}

static bolan_result read_block(const swan_header *h, const format_choice *choice, const bolan_spectrum_options *options,
                               spectrum_grid *grid) {
    text_cursor text = choice->record->at;
    text_word word;
    for (uint32_t i = 0; i < choice->location; i++) {
        block_kind skipped;
        if (skip_block(h, &text, &skipped)) return BOLAN_ERROR_FORMAT;
    }
    if (!bolan_swan_next_word(&text, &word)) return bolan_text_unexpected(&text, NULL, block_words(h));
    block_kind kind = kind_of(h, word);
    if (kind == BLOCK_VALUES && !h->directions) kind = block_after_number(h, text);
    if (kind == BLOCK_NONE) return bolan_text_unexpected(&text, &word, block_words(h));
    if (kind == BLOCK_NODATA) return refuse_dry(h, choice, grid->time);
    return h->directions ? read_2d(h, &text, kind, grid) : read_1d(h, &text, kind, options, grid);
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    swan_header h;
    if (bolan_swan_read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    const bolan_result result = read_block(&h, choice, options, grid);
    if (!result && h.has_times && h.time_code != 1)
        bolan_spectrum_note(&grid->notes, BOLAN_LOG_SPECTRUM_DATE,
                            "%s: times are coded by option %u, which is not read; records count as in the text",
                            h.text.name, (unsigned)h.time_code);
    return result;
}

static bool is_swan(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text);
    text_word first;
    return bolan_text_next_word(&cursor, &first) && bolan_text_equals(first, "SWAN");
}

const spectrum_format bolan_format_swan = {"swan",       "SWAN spectra", is_swan,
                                           list_records, list_locations, read_spectrum};
