// SPDX-License-Identifier: MIT
// Forecast spectra in the format OCTOPUS of MetOcean Solutions: a header, then for each time
//
//     CCYYMM,DDHHmm,...            names of the parameters
//     201803,'110000,...           their values, the first two of which are the time
//     freq,f1,f2,...,anspec        frequencies [Hz]
//     direction,e1,e2,...,sum      a row a direction, compass degrees FROM: variances of the cells [m2]
//     fSpec,...  and  den,...      sums over direction, and these over the band widths
//
// A band reaches half-way to its neighbours, so that the trapezoid rule gives back the variance of the file.
#include "formats/format.h"

#include "bolan/math.h"

#include <math.h>

enum { MOST_RECORDS = 1000000 };

typedef struct octopus_header {
    text_cursor text; // after the header
    uint32_t frequencies, directions, records;
    double place[2];
} octopus_header;

// "nfreqs,24": a line that begins with a key.
static bool take_key(text_cursor *text, const char *key, text_cursor *line) {
    text_word word;
    return bolan_text_next_line(text, line) && bolan_text_next_field(line, &word) && bolan_text_equals(word, key);
}

static bool is_octopus(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text), line;
    return bolan_text_next_line(&cursor, &line) && take_key(&cursor, "nfreqs", &line);
}

static bolan_result take_number(text_cursor *text, const char *key, const char *what, double low, double high,
                                double *value) {
    text_cursor line;
    if (!take_key(text, key, &line)) return bolan_text_unexpected(text, NULL, what);
    return bolan_text_read_field(&line, what, low, high, value);
}

static bolan_result read_header(const bolan_spectrum_text *text, octopus_header *h) {
    text_cursor line;
    double frequencies, directions, records;
    *h = (octopus_header){.text = bolan_text_open(text)};
    bolan_text_next_line(&h->text, &line); // a description
    if (take_number(&h->text, "nfreqs", "nfreqs of 2 to 1000", SPECTRUM_MIN_FREQUENCIES, SPECTRUM_MAX_FREQUENCIES,
                    &frequencies) ||
        take_number(&h->text, "ndir", "ndir of 3 to 720", SPECTRUM_MIN_DIRECTIONS, SPECTRUM_MAX_DIRECTIONS,
                    &directions) ||
        take_number(&h->text, "nrecs", "nrecs of 1 or more", 1, MOST_RECORDS, &records) ||
        take_number(&h->text, "Latitude", "Latitude of -90 to 90", -90.0, 90.0, &h->place[1]) ||
        take_number(&h->text, "Longitude", "Longitude of -360 to 360", -360.0, 360.0, &h->place[0]))
        return BOLAN_ERROR_FORMAT;
    h->frequencies = (uint32_t)frequencies;
    h->directions = (uint32_t)directions;
    h->records = (uint32_t)records;
    return BOLAN_OK;
}

// Six digits, of which an apostrophe may stand before; -1 where they are none.
static long digits_of(text_word word) {
    if (word.length == 7 && word.begin[0] == '\'') word = (text_word){word.begin + 1, 6, word.line};
    long value = 0;
    for (size_t i = 0; i < word.length; i++) {
        if (word.length != 6 || word.begin[i] < '0' || word.begin[i] > '9') return -1;
        value = value * 10 + (word.begin[i] - '0');
    }
    return word.length == 6 ? value : -1;
}

static bolan_result read_date(text_cursor line, record_date *date) {
    static const char expected[] = "the time as CCYYMM,DDHHmm, such as 201803,'110000";
    text_word month, day;
    if (!bolan_text_next_field(&line, &month) || !bolan_text_next_field(&line, &day))
        return bolan_text_unexpected(&line, NULL, expected);
    const long m = digits_of(month), d = digits_of(day);
    if (m < 0 || d < 0) return bolan_text_unexpected(&line, m < 0 ? &month : &day, expected);
    *date = (record_date){{(int)(m / 100), (int)(m % 100), (int)(d / 10000), (int)(d / 100 % 100), (int)(d % 100), 0}};
    return bolan_record_date_is_valid(date) ? BOLAN_OK : bolan_text_unexpected(&line, &month, expected);
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    octopus_header h;
    text_cursor line;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    *list = (record_list){.timed = true, .style = RECORD_UTC_MINUTES};
    for (text_cursor text = h.text; bolan_text_next_line(&text, &line) && list->count < h.records;) {
        text_word word;
        record_date date;
        if (!bolan_text_next_field(&line, &word) || !bolan_text_equals(word, "CCYYMM")) continue;
        if (!bolan_text_next_line(&text, &line)) return bolan_text_unexpected(&text, NULL, "the time of a record");
        if (read_date(line, &date)) return BOLAN_ERROR_FORMAT;
        const bolan_result result = bolan_record_list_add(list, &date, text);
        if (result) return result;
    }
    return list->count ? BOLAN_OK : bolan_text_unexpected(&h.text, NULL, "a line CCYYMM,DDHHmm and the time after it");
}

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)record;
    octopus_header h;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    list->spherical = true;
    return bolan_location_list_add(list, h.place[0], h.place[1], NULL, 0);
}

// ---- one record -----------------------------------------------------------------------------------------------------

static bolan_result read_frequencies(text_cursor *text, uint32_t count, double *hertz) {
    text_cursor line;
    if (!take_key(text, "freq", &line)) return bolan_text_unexpected(text, NULL, "the line freq of the record");
    for (uint32_t i = 0; i < count; i++)
        if (bolan_text_read_field(&line, "an ascending frequency, 0.001 to 10 Hz",
                                  i ? hertz[i - 1] + 1e-9 : SPECTRUM_MIN_HERTZ, SPECTRUM_MAX_HERTZ, &hertz[i]))
            return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

static bolan_result read_rows(const octopus_header *h, text_cursor *text, spectrum_grid *grid) {
    const double step = 2.0 * BOLAN_PI / h->directions;
    for (uint32_t j = 0; j < h->directions; j++) {
        text_cursor line;
        double from, variance;
        if (!bolan_text_next_line(text, &line)) return bolan_text_unexpected(text, NULL, "a row of variances");
        if (bolan_text_read_field(&line, "a direction in degrees", -360.0, 360.0, &from)) return BOLAN_ERROR_FORMAT;
        grid->to[j] = bolan_compass_from_to_math(from);
        for (uint32_t i = 0; i < h->frequencies; i++) {
            if (bolan_text_read_field(&line, "a variance of 0 to 1000 m2", 0.0, 1000.0, &variance))
                return BOLAN_ERROR_FORMAT;
            const double width = bolan_spectrum_trapezoid_weight(grid->hertz, h->frequencies, i);
            grid->energy[(size_t)i * h->directions + j] = variance / (width * step);
        }
    }
    return BOLAN_OK;
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)options;
    octopus_header h;
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS] = {0.0};
    text_cursor text = choice->record->at;
    if (read_header(&texts->density, &h) || read_frequencies(&text, h.frequencies, hertz)) return BOLAN_ERROR_FORMAT;
    if (bolan_spectrum_grid_begin(grid, hertz, h.frequencies, to, h.directions)) return BOLAN_ERROR_MEMORY;
    return read_rows(&h, &text, grid);
}

const spectrum_format bolan_format_octopus = {
    "octopus", "OCTOPUS forecast spectra", is_octopus, list_records, list_locations, read_spectrum};
