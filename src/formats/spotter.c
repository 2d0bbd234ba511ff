// SPDX-License-Identifier: MIT
// Spectra of Sofar Spotter buoys as JSON (Sofar API, "wave-data"): data.frequencyData is an array of records, each with
//
//     timestamp, latitude, longitude, and arrays frequency [Hz], varianceDensity [m2/Hz], a1, b1, a2, b2
//
// The coefficients are those of the angle that waves go TO, counter-clockwise from the east: the direction FROM is
// 270 - atan2(b1, a1). Where they are missing, direction (compass degrees FROM) and directionalSpread stand in.
#include "formats/bands.h"
#include "formats/format.h"
#include "formats/json_cursor.h"

#include "bolan/math.h"
#include "spectrum/portable.h"

#include <math.h>
#include <string.h>

// The array of records, in data or at the top.
static bool find_records(const bolan_spectrum_text *text, text_cursor *array) {
    text_cursor top = bolan_text_open(text), data;
    if (bolan_json_cursor_member(top, "data", &data)) top = data;
    return bolan_json_cursor_member(top, "frequencyData", array);
}

static bool is_spotter(const bolan_spectrum_text *text) {
    text_cursor array;
    return find_records(text, &array);
}

// ---- records --------------------------------------------------------------------------------------------------------

static bolan_result missing(const text_cursor *at, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s:%u: the record has no %s; expected one", at->name,
              (unsigned)at->line, what);
    return BOLAN_ERROR_FORMAT;
}

// "2018-02-14T00:27:19.000Z".
static bolan_result read_date(const text_cursor *record, record_date *date) {
    text_cursor value;
    text_word word;
    char text[20];
    if (!bolan_json_cursor_member(*record, "timestamp", &value) || !bolan_json_cursor_scalar(value, &word))
        return missing(record, "timestamp");
    const size_t length = word.length < 19 ? word.length : 19;
    memcpy(text, word.begin, length);
    text[length] = '\0';
    return bolan_record_date_from_text(text, date)
               ? BOLAN_OK
               : bolan_text_unexpected(&value, &word, "a timestamp such as 2018-02-14T00:27:19Z");
}

static bolan_result list_records(const bolan_spectrum_texts *texts, record_list *list) {
    text_cursor array = bolan_text_open(&texts->density), record;
    *list = (record_list){.timed = true, .style = RECORD_UTC_MINUTES};
    if (!find_records(&texts->density, &array) || !bolan_json_cursor_first(array, &record))
        return missing(&array, "spectrum in frequencyData");
    do {
        record_date date;
        if (read_date(&record, &date)) return BOLAN_ERROR_FORMAT;
        const bolan_result result = bolan_record_list_add(list, &date, record);
        if (result) return result;
    } while (bolan_json_cursor_after(&record));
    return BOLAN_OK;
}

static bool read_coordinate(const text_cursor *record, const char *key, double limit, double *value) {
    text_cursor at;
    text_word word;
    return bolan_json_cursor_member(*record, key, &at) && bolan_json_cursor_scalar(at, &word) &&
           bolan_text_number(word, value) && fabs(*value) <= limit;
}

// The buoy drifts: each record has its own place.
static bolan_result list_locations(const bolan_spectrum_texts *texts, const record_entry *record, location_list *list) {
    (void)texts;
    double x, y;
    list->spherical = true;
    if (!read_coordinate(&record->at, "longitude", 360.0, &x) || !read_coordinate(&record->at, "latitude", 90.0, &y))
        return BOLAN_OK;
    return bolan_location_list_add(list, x, y, NULL, 0);
}

// ---- one record -----------------------------------------------------------------------------------------------------

// An array of numbers; @p count is how many there must be, or 0 for the first array, which receives it. Absent: NAN,
// and @p found is false.
static bolan_result read_array(const text_cursor *record, const char *key, double low, double high, uint32_t *count,
                               double *values, bool *found) {
    text_cursor element;
    uint32_t n = 0;
    *found = bolan_json_cursor_member(*record, key, &element) && bolan_json_cursor_first(element, &element);
    if (!*found) return BOLAN_OK;
    do {
        text_word word = {"", 0, 1};
        if (n == SPECTRUM_MAX_FREQUENCIES || (*count > 0 && n == *count))
            return bolan_text_unexpected(&element, &(text_word){key, strlen(key), element.line},
                                         "as many values as frequencies, 1000 at most");
        if (!bolan_json_cursor_scalar(element, &word) || !bolan_text_number(word, &values[n]) ||
            !(values[n] >= low && values[n] <= high))
            return bolan_text_unexpected(&element, &word, "a number that the quantity can be");
        n++;
    } while (bolan_json_cursor_after(&element));
    if (*count > 0 && n < *count) return missing(record, "value for each frequency in one of its arrays");
    *count = n;
    return BOLAN_OK;
}

// Moments from coefficients of the mathematical angle TO, or from direction and spread.
static bolan_result read_directions(const text_cursor *record, spectrum_bands *bands) {
    double a[SPECTRUM_MAX_FREQUENCIES], b[SPECTRUM_MAX_FREQUENCIES];
    bool has_a, has_b;
    for (int order = 1; order <= 2; order++) {
        double *alpha = order == 1 ? bands->alpha1 : bands->alpha2, *r = order == 1 ? bands->r1 : bands->r2;
        if (read_array(record, order == 1 ? "a1" : "a2", -1.0, 1.0, &bands->count, a, &has_a) ||
            read_array(record, order == 1 ? "b1" : "b2", -1.0, 1.0, &bands->count, b, &has_b))
            return BOLAN_ERROR_FORMAT;
        for (uint32_t i = 0; has_a && has_b && i < bands->count; i++) {
            alpha[i] = bolan_math_to_compass_from(portable_angle(b[i], a[i]) / order);
            r[i] = fmin(sqrt(a[i] * a[i] + b[i] * b[i]), 1.0);
        }
    }
    if (!isnan(bands->r1[0])) return BOLAN_OK;
    if (read_array(record, "direction", -360.0, 360.0, &bands->count, a, &has_a) ||
        read_array(record, "directionalSpread", 0.0, 360.0, &bands->count, b, &has_b))
        return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i < bands->count; i++) {
        if (has_a) bands->alpha1[i] = a[i];
        if (has_b) bands->r1[i] = fmax(1.0 - 0.5 * bolan_radians(b[i]) * bolan_radians(b[i]), 0.0);
    }
    return BOLAN_OK;
}

static bolan_result read_bands(const text_cursor *record, spectrum_bands *bands) {
    bool found = false;
    bolan_spectrum_bands_clear(bands);
    bands->count = 0;
    if (read_array(record, "frequency", SPECTRUM_MIN_HERTZ, SPECTRUM_MAX_HERTZ, &bands->count, bands->hertz, &found))
        return BOLAN_ERROR_FORMAT;
    if (bands->count < SPECTRUM_MIN_FREQUENCIES) return missing(record, "array frequency of two values or more");
    for (uint32_t i = 1; i < bands->count; i++)
        if (!(bands->hertz[i] > bands->hertz[i - 1])) return missing(record, "array frequency that ascends");
    if (read_array(record, "varianceDensity", 0.0, SPECTRUM_MAX_DENSITY, &bands->count, bands->density, &found))
        return BOLAN_ERROR_FORMAT;
    return found ? read_directions(record, bands) : missing(record, "array varianceDensity");
}

static bolan_result read_spectrum(const bolan_spectrum_texts *texts, const format_choice *choice,
                                  const bolan_spectrum_options *options, spectrum_grid *grid) {
    (void)texts;
    spectrum_bands *bands;
    const text_cursor *record = &choice->record->at;
    bolan_result result = bolan_spectrum_bands_create(&bands);
    if (!result) result = read_bands(record, bands);
    if (!result) result = bolan_spectrum_bands_to_grid(bands, record->name, "has no directions", options, grid);
    bolan_spectrum_bands_destroy(&bands);
    return result;
}

const spectrum_format bolan_format_spotter = {
    "spotter", "Sofar Spotter buoy (JSON)", is_spotter, list_records, list_locations, read_spectrum};
