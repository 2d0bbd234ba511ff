// SPDX-License-Identifier: MIT
// Point spectra of WAVEWATCH III as text (user manual, program ww3_outp, ITYPE 1, transfer file):
//
//     'WAVEWATCH III SPECTRA' frequencies directions points 'name of the grid'
//     the frequencies [Hz] / the directions [rad], compass, where waves go TO
//     then for each time:  yyyymmdd hhmmss, and for each point:
//         'name' latitude longitude depth wind its-direction current its-direction
//         densities [m2/Hz/rad], for each direction those of all frequencies
//
// The text is walked twice, as in swan.c.
#include "formats/format.h"

#include "bolan/math.h"

#include <math.h>
#include <string.h>

enum { MAX_POINTS = 1000000 };

typedef struct ww3_header {
    text_cursor text; // after the header
    uint32_t frequencies, directions, points;
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS];
} ww3_header;

// ---- the header -----------------------------------------------------------------------------------------------------

// The directions are even but printed with three digits: replaces them by the nearest even directions.
static void even_out(double *to, uint32_t count) {
    const double step = 2.0 * BOLAN_PI / count;
    double mean = 0.0;
    for (uint32_t j = 0; j < count; j++) {
        const double off = remainder(to[j] - to[0], step);
        if (fabs(off) > 0.1 * step) return;
        mean += off / count;
    }
    const double origin = to[0] + mean;
    for (uint32_t j = 0; j < count; j++) to[j] = origin + step * round((to[j] - origin) / step);
}

static bolan_result read_header(const bolan_spectrum_text *text, ww3_header *h) {
    text_word word;
    *h = (ww3_header){.text = bolan_text_open(text)};
    for (int i = 0; i < 3; i++) bolan_text_next_word(&h->text, &word); // 'WAVEWATCH III SPECTRA'
    if (bolan_text_read_count(&h->text, "a number of frequencies", SPECTRUM_MIN_FREQUENCIES, SPECTRUM_MAX_FREQUENCIES,
                              &h->frequencies) ||
        bolan_text_read_count(&h->text, "a number of directions", SPECTRUM_MIN_DIRECTIONS, SPECTRUM_MAX_DIRECTIONS,
                              &h->directions) ||
        bolan_text_read_count(&h->text, "a number of points", 1, MAX_POINTS, &h->points))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    if (bolan_format_read_frequencies(&h->text, h->hertz, h->frequencies)) return BOLAN_ERROR_FORMAT;
    for (uint32_t j = 0; j < h->directions; j++) {
        double radians;
        if (!bolan_text_next_word(&h->text, &word)) return bolan_text_unexpected(&h->text, NULL, "a direction");
        if (!bolan_text_number(word, &radians) || fabs(radians) > 4.0 * BOLAN_PI)
            return bolan_text_unexpected(&h->text, &word, "a direction in radians");
        h->to[j] = 0.5 * BOLAN_PI - radians; // from the north clockwise to from the east counter-clockwise
    }
    even_out(h->to, h->directions);
    return BOLAN_OK;
}

// ---- records and points ---------------------------------------------------------------------------------------------

static bolan_result read_digits(text_cursor *text, uint32_t length, const char *expected, int *value) {
    text_word word;
    if (!bolan_text_next_word(text, &word)) return bolan_text_unexpected(text, NULL, expected);
    *value = 0;
    for (size_t i = 0; i < word.length && i < 9; i++) {
        if (word.length != length || word.begin[i] < '0' || word.begin[i] > '9')
            return bolan_text_unexpected(text, &word, expected);
        *value = *value * 10 + (word.begin[i] - '0');
    }
    return BOLAN_OK;
}

static bolan_result read_date(text_cursor *text, record_date *date) {
    int day, time;
    if (read_digits(text, 8, "a date such as 20220912", &day) || read_digits(text, 6, "a time such as 060000", &time))
        return BOLAN_ERROR_FORMAT;
    *date = (record_date){{day / 10000, day / 100 % 100, day % 100, time / 10000, time / 100 % 100, time % 100}};
    if (bolan_record_date_is_valid(date)) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_DATE,
              "%s:%u: there is no date %08d %06d; expected one of the calendar, as yyyymmdd hhmmss", text->name,
              (unsigned)text->line, day, time);
    return BOLAN_ERROR_FORMAT;
}

// 'name' and seven numbers, of which the first two are latitude and longitude.
static bolan_result read_point(text_cursor *text, double place[2], text_word *name) {
    text_word word;
    if (!bolan_text_next_word(text, &word)) return bolan_text_unexpected(text, NULL, "the name of a point in quotes");
    const char *quote =
        word.begin[0] == '\'' ? memchr(word.begin + 1, '\'', (size_t)(text->end - word.begin - 1)) : NULL;
    if (!quote) return bolan_text_unexpected(text, &word, "the name of a point in quotes");
    if (name) *name = (text_word){word.begin + 1, (size_t)(quote - word.begin - 1), word.line};
    text->next = quote + 1;
    if (bolan_text_read_number(text, "the latitude of a point", &place[1]) ||
        bolan_text_read_number(text, "the longitude of a point", &place[0]))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(text);
    return BOLAN_OK;
}

// Skips the densities of a point, also where they are cut short by the next name or the end of the text.
static void skip_densities(const ww3_header *h, text_cursor *text) {
    text_word word;
    for (size_t i = 0, count = (size_t)h->frequencies * h->directions; i < count; i++) {
        const text_cursor before = *text;
        if (!bolan_text_next_word(text, &word)) return;
        if (word.begin[0] != '\'') continue;
        *text = before;
        return;
    }
}

static bolan_result list_records_of(const ww3_header *h, record_list *list) {
    text_cursor text = h->text;
    text_word word;
    *list = (record_list){.timed = true, .style = RECORD_LOCAL_SECONDS};
    for (text_cursor probe = text; bolan_text_next_word(&probe, &word); probe = text) {
        record_date date;
        double place[2];
        if (read_date(&text, &date)) return BOLAN_ERROR_FORMAT;
        const bolan_result result = bolan_record_list_add(list, &date, text);
        if (result) return result;
        for (uint32_t i = 0; i < h->points && text.next < text.end; i++) {
            if (read_point(&text, place, NULL)) return BOLAN_ERROR_FORMAT;
            skip_densities(h, &text);
        }
    }
    return list->count ? BOLAN_OK : bolan_text_unexpected(&text, NULL, "the date of the first time");
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    ww3_header h;
    return read_header(&texts->density, &h) ? BOLAN_ERROR_FORMAT : list_records_of(&h, list);
}

static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    ww3_header h;
    text_cursor text = record->at;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    list->spherical = true;
    if (text.next == text.end) return bolan_text_unexpected(&text, NULL, "the name of a point in quotes");
    for (uint32_t i = 0; i < h.points && text.next < text.end; i++) {
        double place[2];
        text_word name;
        if (read_point(&text, place, &name)) return BOLAN_ERROR_FORMAT;
        if (bolan_location_list_add(list, place[0], place[1], name.begin, name.length)) return BOLAN_ERROR_MEMORY;
        skip_densities(&h, &text);
    }
    return BOLAN_OK;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

static bolan_result read_densities(const ww3_header *h, text_cursor *text, spectrum_grid *grid) {
    if (bolan_spectrum_grid_begin(grid, h->hertz, h->frequencies, h->to, h->directions)) return BOLAN_ERROR_MEMORY;
    for (uint32_t j = 0; j < h->directions; j++)
        for (uint32_t i = 0; i < h->frequencies; i++) {
            text_word word;
            double value;
            if (!bolan_text_next_word(text, &word)) return bolan_text_unexpected(text, NULL, "a density");
            if (!bolan_text_fortran_number(word, &value)) return bolan_text_unexpected(text, &word, "a density");
            if (value < 0.0) return bolan_text_negative(text, value);
            if (value > SPECTRUM_MAX_DENSITY)
                return bolan_text_unexpected(text, &word, "a density that a sea can have");
            grid->energy[(size_t)i * h->directions + j] = value;
        }
    return BOLAN_OK;
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)options;
    ww3_header h;
    text_cursor text = choice->record->at;
    if (read_header(&texts->density, &h)) return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i <= choice->location; i++) {
        double place[2];
        if (read_point(&text, place, NULL)) return BOLAN_ERROR_FORMAT;
        if (i < choice->location) skip_densities(&h, &text);
    }
    return read_densities(&h, &text, grid);
}

static bool is_ww3(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text);
    text_word first;
    return bolan_text_next_word(&cursor, &first) && bolan_text_equals(first, "'WAVEWATCH");
}

const spectrum_format bolan_format_ww3 = {
    "ww3", "WAVEWATCH III point spectra (text)", is_ww3, list_records, list_locations, read_spectrum};
