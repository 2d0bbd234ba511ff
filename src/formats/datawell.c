// SPDX-License-Identifier: MIT
// Datawell's spectrum files .spt ("Datawell file formats"): twelve lines of one number, of which the fourth is the
// largest density Smax [m2/Hz], then a row a band:
//
//     f [Hz], S / Smax, direction [compass degrees FROM], spread [deg], skewness, kurtosis
//
// The time stands in the name of the file: NAME}2024-09-09T01h15Z.spt. Spread, skewness and kurtosis are those of Kuik,
// van Vledder & Holthuijsen (1988) and give back the centred moments m1, m2, n2 of the directions (their eqs. 24, 37,
// 38).
#include "formats/bands.h"
#include "formats/format.h"

#include "bolan/math.h"
#include "spectrum/portable.h"

#include <math.h>
#include <stdio.h>

enum { HEADER_LINES = 12, SMAX_LINE = 4 };

#define SPREAD_MAX 81.1 // [deg]: sqrt(2) rad, the circular spread of waves from everywhere

// Steps over the header; false where it is none. @p smax may be NULL.
static bool read_header(text_cursor *text, double *smax) {
    text_cursor line;
    for (int i = 1; i <= HEADER_LINES; i++) {
        text_word word, more;
        double value;
        if (!bolan_text_next_line(text, &line) || !bolan_text_next_word(&line, &word) ||
            bolan_text_next_word(&line, &more) || !bolan_text_number(word, &value))
            return false;
        if (i == SMAX_LINE && smax) *smax = value;
    }
    return true;
}

// The header, and a first row of six numbers.
static bool is_datawell(const bolan_spectrum_text *text) {
    text_cursor cursor = bolan_text_open(text), line;
    text_word word;
    double value;
    int fields = 0;
    if (!read_header(&cursor, NULL) || !bolan_text_next_line(&cursor, &line)) return false;
    while (bolan_text_next_field(&line, &word) && bolan_text_number(word, &value)) fields++;
    return fields == 6;
}

// The date in a file name: "2024-09-09T01h15" or "20240909T0115", by its digits.
static bool date_in_name(const char *name, record_date *date) {
    static const char *const forms[] = {"####-##-##T##h##", "########T####"};
    for (const char *p = name; p && *p; p++)
        for (int form = 0; form < 2; form++) {
            char digits[13] = "", text[17];
            size_t i = 0, n = 0;
            for (; forms[form][i] && p[i]; i++) {
                const bool digit = p[i] >= '0' && p[i] <= '9';
                if (forms[form][i] == '#' ? !digit : p[i] != forms[form][i]) break;
                if (digit) digits[n++] = p[i];
            }
            if (forms[form][i]) continue;
            snprintf(text, sizeof text, "%.4s-%.2s-%.2sT%.2s:%.2s", digits, digits + 4, digits + 6, digits + 8,
                     digits + 10);
            if (bolan_record_date_from_text(text, date)) return true;
        }
    return false;
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    record_date date = {{0}};
    *list = (record_list){.timed = date_in_name(texts->density.name, &date), .style = RECORD_UTC_MINUTES};
    return bolan_record_list_add(list, &date, bolan_text_open(&texts->density));
}

static bolan_result no_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)texts, (void)record, (void)list;
    return BOLAN_OK;
}

// The moments of a band. Where skewness and kurtosis fit no distribution (noise), the first moment alone is kept.
static void set_moments(double from, double spread, double skewness, double kurtosis, spectrum_bands *bands) {
    const uint32_t i = bands->count;
    const double sigma = bolan_radians(spread), m1 = fmax(1.0 - 0.5 * sigma * sigma, 0.0);
    const double four = 2.0 * (1.0 - m1), m2 = 0.5 * (kurtosis * four * four - 6.0 + 8.0 * m1);
    const double half = 0.5 * (1.0 - m2);
    bands->alpha1[i] = from;
    bands->r1[i] = m1;
    if (!(half >= 0.0)) return;
    const double n2 = -skewness * half * sqrt(half), r2 = sqrt(m2 * m2 + n2 * n2);
    if (!(r2 <= 1.0)) return;
    bands->r2[i] = r2;
    bands->alpha2[i] = from + 0.5 * bolan_degrees(portable_angle(n2, m2));
}

static bolan_result read_row(text_cursor line, double smax, spectrum_bands *bands) {
    double hertz, share, from, spread, skewness, kurtosis;
    text_word word;
    if (bolan_text_read_field(&line, "a frequency of 0.001 to 10 Hz", SPECTRUM_MIN_HERTZ, SPECTRUM_MAX_HERTZ, &hertz) ||
        bolan_text_read_field(&line, "a density over Smax, 0 to 1", 0.0, 1.0001, &share) ||
        bolan_text_read_field(&line, "a direction in degrees", -360.0, 360.0, &from) ||
        bolan_text_read_field(&line, "a spread of 0 to 81 degrees", 0.0, SPREAD_MAX, &spread) ||
        bolan_text_read_field(&line, "a skewness", -1e6, 1e6, &skewness) ||
        bolan_text_read_field(&line, "a kurtosis", -1e6, 1e6, &kurtosis))
        return BOLAN_ERROR_FORMAT;
    if (bolan_text_next_field(&line, &word)) return bolan_text_unexpected(&line, &word, "the end of the row");
    const uint32_t i = bands->count;
    if (i == SPECTRUM_MAX_FREQUENCIES || (i > 0 && !(hertz > bands->hertz[i - 1])))
        return bolan_text_unexpected(&line, NULL, "an ascending frequency, the 1000th at most");
    bands->hertz[i] = hertz;
    bands->density[i] = share * smax;
    set_moments(from, spread, skewness, kurtosis, bands);
    bands->count++;
    return BOLAN_OK;
}

static bolan_result read_table(text_cursor text, spectrum_bands *bands) {
    double smax = 0.0;
    text_cursor line;
    bolan_spectrum_bands_clear(bands);
    if (!read_header(&text, &smax)) return bolan_text_unexpected(&text, NULL, "twelve lines of one number");
    if (!(smax >= 0.0 && smax <= SPECTRUM_MAX_DENSITY)) return bolan_text_negative(&text, smax);
    while (bolan_text_next_line(&text, &line))
        if (read_row(line, smax, bands)) return BOLAN_ERROR_FORMAT;
    return bands->count >= SPECTRUM_MIN_FREQUENCIES ? BOLAN_OK
                                                    : bolan_text_unexpected(&text, NULL, "a second frequency");
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)texts;
    spectrum_bands *bands;
    bolan_result result = bolan_spectrum_bands_create(&bands);
    if (!result) result = read_table(choice->record->at, bands);
    if (!result)
        result = bolan_spectrum_bands_to_grid(bands, choice->record->at.name, "has no directions", options, grid);
    bolan_spectrum_bands_destroy(&bands);
    return result;
}

const spectrum_format bolan_format_datawell = {
    "datawell", "Datawell Waverider spectrum", is_datawell, list_records, no_locations, read_spectrum};
