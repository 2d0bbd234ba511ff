// SPDX-License-Identifier: MIT
// The options of a measured spectrum: record, location, and defaults for missing directions.
#include "bolan/formats.h"
#include "formats/records.h"
#include "params/rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define STRUCT bolan_spectrum_options
static const bolan_param options_rows[] = {
    HEADING(from_deg, .key = "from", .option = "from", .rules = BOLAN_PARAM_OR_NAN, .fallback = (double)NAN,
            .otherwise = "270, with a warning",
            .help = "where the waves come from, compass degrees, for a spectrum file without directions"),
    NUMBER(spread_s, .key = "spread", .option = "spread", .low = 0, .high = 200, .rules = BOLAN_PARAM_OR_NAN,
           .fallback = (double)NAN, .otherwise = "10, with a warning",
           .help = "exponent of the waves' cos-2s spreading, for a spectrum file without spreads"),
    FLAG(interpolate, .key = "interpolate", .option = "interpolate",
         .help = "a date between two records of the spectrum file is interpolated; otherwise the nearest record"),
    NUMBER(place[0], .low = -1e9, .high = 1e9, .rules = BOLAN_PARAM_OR_NAN, .fallback = (double)NAN,
           .help = "longitude, or x, of the location that is read"),
    NUMBER(place[1], .low = -1e9, .high = 1e9, .rules = BOLAN_PARAM_OR_NAN, .fallback = (double)NAN,
           .help = "latitude, or y, of the location that is read"),
};
#undef STRUCT
const bolan_param_table bolan_spectrum_options_params = TABLE("bolan_spectrum_options", options_rows);

bolan_spectrum_options bolan_spectrum_options_default(void) {
    bolan_spectrum_options options;
    memset(&options, 0, sizeof options);
    bolan_params_default(&bolan_spectrum_options_params, &options);
    return options;
}

// A number from @p low that fills the text up to @p end.
static bool read_number(const char *text, const char *end, double low, double high, double *value) {
    return bolan_text_number((text_word){text, (size_t)(end - text), 1}, value) && *value >= low && *value <= high;
}

static bool read_whole(const char *text, double low, uint32_t *out) {
    double value;
    if (!read_number(text, text + strlen(text), low, 1e9, &value) || value != floor(value)) return false;
    *out = (uint32_t)value;
    return true;
}

bool bolan_spectrum_options_set_record(bolan_spectrum_options *options, const char *text) {
    BOLAN_ASSERT(options && text);
    record_date date;
    uint32_t record = 0;
    const bool is_date = bolan_record_date_from_text(text, &date);
    if (!is_date && !read_whole(text, 0.0, &record)) return false;
    options->record = record;
    snprintf(options->time, sizeof options->time, "%s", is_date ? text : "");
    return true;
}

bool bolan_spectrum_options_set_location(bolan_spectrum_options *options, const char *text) {
    BOLAN_ASSERT(options && text);
    const char *comma = strchr(text, ',');
    uint32_t location = 0;
    double x = (double)NAN, y = (double)NAN;
    if (comma) {
        const char *second = comma + 1 + strspn(comma + 1, " ");
        if (!read_number(text, comma, -1e9, 1e9, &x) || !read_number(second, text + strlen(text), -1e9, 1e9, &y))
            return false;
    } else if (!read_whole(text, 1.0, &location)) {
        return false;
    }
    options->location = location;
    options->place[0] = x;
    options->place[1] = y;
    return true;
}

bolan_result bolan_spectrum_options_validate(const bolan_spectrum_options *o) {
    BOLAN_ASSERT(o);
    record_date date;
    if (!memchr(o->time, '\0', sizeof o->time) || (o->time[0] && !bolan_record_date_from_text(o->time, &date))) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
                  "bolan_spectrum_options: time is %.31s; expected a date such as 2018-01-01T06:00", o->time);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (isnan(o->place[0]) != isnan(o->place[1])) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_NOT_FINITE, "bolan_spectrum_options: one coordinate of place is missing");
        return BOLAN_ERROR_ARGUMENT;
    }
    return bolan_params_validate(&bolan_spectrum_options_params, o, "bolan_spectrum_options: ");
}
