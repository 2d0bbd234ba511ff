// SPDX-License-Identifier: MIT
// Spectra of TRIAXYS buoys (AXYS), one record a file: a header of "KEY = VALUE", then
//
//     DIRECTIONAL SPECTRUM      a row a frequency, a column a direction from 0 to 360 [m2/Hz/deg]; both ends are one
//     NON-DIRECTIONAL SPECTRUM  rows of frequency and density [m2/Hz]
//
// Directions are compass degrees waves come FROM. The first line ends in the place, 4857.6668S16631.6837W: degrees and
// minutes.
#include "formats/bands.h"
#include "formats/format.h"

#include "bolan/math.h"

#include <math.h>
#include <string.h>

typedef struct triaxys_header {
    text_cursor rows; // after the header
    bool directional, timed, placed;
    record_date date;
    double place[2];
    uint32_t frequencies, directions;
    double first_hertz, step_hertz;
} triaxys_header;

static bool is_triaxys(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text);
    text_word first, second;
    return bolan_text_next_word(&cursor, &first) && bolan_text_equals(first, "TRIAXYS") &&
           bolan_text_next_word(&cursor, &second) && bolan_text_equals(second, "BUOY");
}

// ---- the header -----------------------------------------------------------------------------------------------------

// "4857.6668S" at *p: degrees, signed; false where it is none.
static bool read_angle(const char **p, const char *end, const char *letters, double *degrees) {
    const char *begin = *p;
    while (*p < end && !memchr(letters, **p, 2)) ++*p;
    double value;
    if (*p == end || !bolan_text_number((text_word){begin, (size_t)(*p - begin), 1}, &value) || !(value >= 0.0))
        return false;
    const double whole = floor(value / 100.0);
    *degrees = (whole + (value - 100.0 * whole) / 60.0) * (**p == letters[1] ? -1.0 : 1.0);
    ++*p;
    return true;
}

// The last word of the first line, where it is a place.
static void read_place(text_cursor line, triaxys_header *h) {
    text_word word, last = {"", 0, 1};
    while (bolan_text_next_word(&line, &word)) last = word;
    const char *p = last.begin, *end = last.begin + last.length;
    h->placed = read_angle(&p, end, "NS", &h->place[1]) && read_angle(&p, end, "EW", &h->place[0]) && p == end &&
                fabs(h->place[1]) <= 90.0 && fabs(h->place[0]) <= 360.0;
}

// "2018-01-31 21:00(UTC)".
static bolan_result read_date(text_cursor value, triaxys_header *h) {
    text_word day, time;
    char text[17];
    static const char expected[] = "a date such as 2018-01-31 21:00(UTC)";
    if (!bolan_text_next_word(&value, &day)) return bolan_text_unexpected(&value, NULL, expected);
    if (!bolan_text_next_word(&value, &time)) return bolan_text_unexpected(&value, NULL, expected);
    if (day.length != 10 || time.length < 5) return bolan_text_unexpected(&value, &day, expected);
    memcpy(text, day.begin, 10);
    text[10] = 'T';
    memcpy(text + 11, time.begin, 5);
    text[16] = '\0';
    h->timed = bolan_record_date_from_text(text, &h->date);
    return h->timed ? BOLAN_OK : bolan_text_unexpected(&value, &day, expected);
}

static bool begins_with(const text_cursor *line, const char *key) {
    const size_t length = strlen(key);
    text_cursor c = *line;
    text_word word;
    return bolan_text_next_word(&c, &word) && (size_t)(line->end - word.begin) >= length &&
           memcmp(word.begin, key, length) == 0;
}

// One line "KEY = VALUE" of the header. ROWS and COLUMN 2 end it.
static bolan_result read_line(text_cursor line, triaxys_header *h) {
    const char *equals = memchr(line.next, '=', (size_t)(line.end - line.next));
    text_cursor value = line;
    if (!equals) return BOLAN_OK;
    value.next = equals + 1;
    if (begins_with(&line, "TYPE")) {
        text_word word;
        h->directional = bolan_text_next_word(&value, &word) && bolan_text_equals(word, "DIRECTIONAL");
    }
    if (begins_with(&line, "DATE")) return read_date(value, h);
    if (begins_with(&line, "NUMBER OF FREQUENCIES"))
        return bolan_text_read_count(&value, "a number of frequencies", SPECTRUM_MIN_FREQUENCIES,
                                     SPECTRUM_MAX_FREQUENCIES, &h->frequencies);
    if (begins_with(&line, "NUMBER OF DIRECTIONS"))
        return bolan_text_read_count(&value, "a number of directions", SPECTRUM_MIN_DIRECTIONS + 1,
                                     SPECTRUM_MAX_DIRECTIONS + 1, &h->directions);
    if (begins_with(&line, "INITIAL FREQUENCY"))
        return bolan_text_read_number(&value, "the first frequency", &h->first_hertz);
    if (begins_with(&line, "FREQUENCY SPACING"))
        return bolan_text_read_number(&value, "the step of the frequencies", &h->step_hertz);
    return BOLAN_OK;
}

static bolan_result read_header(const bolan_spectrum_text *text, triaxys_header *h) {
    *h = (triaxys_header){.rows = bolan_text_open(text)};
    text_cursor line;
    bool first = true;
    while (bolan_text_next_line(&h->rows, &line)) {
        if (first) read_place(line, h);
        first = false;
        if (read_line(line, h)) return BOLAN_ERROR_FORMAT;
        if (!begins_with(&line, "ROWS") && !begins_with(&line, "COLUMN 2")) continue;
        if (h->frequencies == 0) return bolan_text_unexpected(&h->rows, NULL, "NUMBER OF FREQUENCIES before it");
        if (!h->directional) return BOLAN_OK;
        if (h->directions == 0) return bolan_text_unexpected(&h->rows, NULL, "NUMBER OF DIRECTIONS before it");
        const double last = h->first_hertz + h->step_hertz * (h->frequencies - 1);
        return h->first_hertz >= 0.0 && h->step_hertz > 0.0 && last <= SPECTRUM_MAX_HERTZ
                   ? BOLAN_OK
                   : bolan_text_unexpected(&h->rows, NULL, "frequencies of 0 to 10 Hz");
    }
    return bolan_text_unexpected(&h->rows, NULL, "the line ROWS or COLUMN 2 of the header");
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    triaxys_header h;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    *list = (record_list){.timed = h.timed, .style = RECORD_UTC_MINUTES};
    return bolan_record_list_add(list, &h.date, h.rows);
}

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)record;
    triaxys_header h;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    list->spherical = true;
    return h.placed ? bolan_location_list_add(list, h.place[0], h.place[1], NULL, 0) : BOLAN_OK;
}

// ---- the values -----------------------------------------------------------------------------------------------------

static bolan_result read_density(text_cursor *line, double *value) {
    text_word word;
    if (!bolan_text_next_word(line, &word)) return bolan_text_unexpected(line, NULL, "a density");
    if (!bolan_text_number(word, value)) return bolan_text_unexpected(line, &word, "a density");
    if (*value < 0.0) return bolan_text_negative(line, *value);
    return *value <= SPECTRUM_MAX_DENSITY ? BOLAN_OK
                                          : bolan_text_unexpected(line, &word, "a density that a sea can have");
}

// The first frequency is 0 as a rule: rows below the least that a sea has are left out.
static uint32_t first_row(const triaxys_header *h) {
    uint32_t row = 0;
    while (row < h->frequencies && h->first_hertz + row * h->step_hertz < SPECTRUM_MIN_HERTZ) row++;
    return row;
}

static bolan_result read_matrix(triaxys_header *h, spectrum_grid *grid) {
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS], last = 0.0;
    const uint32_t skipped = first_row(h), rows = h->frequencies - skipped, columns = h->directions - 1;
    if (rows < SPECTRUM_MIN_FREQUENCIES) return bolan_text_unexpected(&h->rows, NULL, "a second frequency");
    for (uint32_t i = 0; i < rows; i++) hertz[i] = h->first_hertz + (i + skipped) * h->step_hertz;
    for (uint32_t j = 0; j < columns; j++) to[j] = bolan_compass_from_to_math(360.0 * j / columns);
    if (bolan_spectrum_grid_begin(grid, hertz, rows, to, columns)) return BOLAN_ERROR_MEMORY;
    for (uint32_t i = 0; i < h->frequencies; i++) {
        text_cursor line;
        text_word word;
        if (!bolan_text_next_line(&h->rows, &line)) return bolan_text_unexpected(&h->rows, NULL, "a row of densities");
        for (uint32_t j = 0; j <= columns; j++) {
            double value;
            if (read_density(&line, j < columns ? &value : &last)) return BOLAN_ERROR_FORMAT;
            if (j < columns && i >= skipped)
                grid->energy[(size_t)(i - skipped) * columns + j] = value * 180.0 / BOLAN_PI;
        }
        if (bolan_text_next_word(&line, &word)) return bolan_text_unexpected(&line, &word, "the end of the row");
    }
    return BOLAN_OK;
}

static bolan_result read_table(triaxys_header *h, spectrum_bands *bands) {
    bolan_spectrum_bands_clear(bands);
    for (uint32_t i = 0; i < h->frequencies; i++) {
        double hertz, density;
        text_cursor line;
        if (!bolan_text_next_line(&h->rows, &line)) return bolan_text_unexpected(&h->rows, NULL, "a row of densities");
        if (bolan_text_read_number(&line, "a frequency", &hertz) || read_density(&line, &density))
            return BOLAN_ERROR_FORMAT;
        if (hertz >= 0.0 && hertz < SPECTRUM_MIN_HERTZ) continue;
        if (!(hertz > 0.0 && hertz <= SPECTRUM_MAX_HERTZ) ||
            (bands->count > 0 && !(hertz > bands->hertz[bands->count - 1])))
            return bolan_text_unexpected(&line, NULL, "an ascending frequency up to 10 Hz");
        bands->hertz[bands->count] = hertz;
        bands->density[bands->count++] = density;
    }
    return bands->count >= SPECTRUM_MIN_FREQUENCIES ? BOLAN_OK
                                                    : bolan_text_unexpected(&h->rows, NULL, "a second frequency");
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)choice;
    triaxys_header h;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    if (h.directional) return read_matrix(&h, grid);
    spectrum_bands *bands;
    bolan_result result = bolan_spectrum_bands_create(&bands);
    if (!result) result = read_table(&h, bands);
    if (!result) result = bolan_spectrum_bands_to_grid(bands, h.rows.name, "has no directions", options, grid);
    bolan_spectrum_bands_destroy(&bands);
    return result;
}

const spectrum_format bolan_format_triaxys = {"triaxys",    "TRIAXYS buoy", is_triaxys,
                                              list_records, list_locations, read_spectrum};
