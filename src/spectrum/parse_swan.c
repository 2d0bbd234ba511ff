// SPDX-License-Identifier: MIT
// SWAN spectral files, 2-D ("SWAN 1"; SWAN user manual, appendix D).
//
//     SWAN 1 / TIME code / LONLAT n, n points / AFREQ n, n values / NDIR n, n values / QUANT 1, name, unit, exception
//     then for each time:  date, and for each location:  FACTOR f, then frequencies x directions whole numbers
//                                                        or ZERO, or NODATA
// Words matter, lines only where a remark may follow a value. The first location is read.
#include "spectrum/measured.h"

#include "bolan/math.h"
#include "spectrum/text.h"

#include <math.h>
#include <string.h>

#define SEA_WATER_DENSITY 1025.0 // SWAN's default rho, by which EnDens [J/m2/Hz/degr] is rho g times VaDens
#define ENERGY_MAX 1e9           // [m2/Hz/rad]: far above any sea, far below overflow

enum { MAX_LOCATIONS = 1000000 };

typedef struct swan_reader {
    text_cursor text;
    bool has_times, ready;
    uint32_t locations, frequencies, directions;
    double hertz[SPECTRUM_MAX_FREQUENCIES], to[SPECTRUM_MAX_DIRECTIONS];
    double exception; // marks a missing value
    double scale;     // from the file's unit to m2/Hz/rad
} swan_reader;

// The next word that is not in a $ comment.
static bool next_word(text_cursor *text, text_word *word) {
    while (text_next_word(text, word)) {
        if (word->begin[0] != '$') return true;
        text_skip_line(text);
    }
    return false;
}

static bolan_result read_locations(swan_reader *r) {
    text_skip_line(&r->text);
    if (text_read_count(&r->text, "a number of locations", 1, MAX_LOCATIONS, &r->locations)) return BOLAN_ERROR_FORMAT;
    for (uint32_t i = 0; i < r->locations; i++) {
        double x, y;
        text_skip_line(&r->text);
        if (text_read_number(&r->text, "the x of a location", &x) ||
            text_read_number(&r->text, "the y of a location", &y))
            return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

static bolan_result read_frequencies(swan_reader *r) {
    text_skip_line(&r->text);
    if (text_read_count(&r->text, "a number of frequencies", SPECTRUM_MIN_FREQUENCIES, SPECTRUM_MAX_FREQUENCIES,
                        &r->frequencies))
        return BOLAN_ERROR_FORMAT;
    text_skip_line(&r->text);
    for (uint32_t i = 0; i < r->frequencies; i++) {
        text_word word;
        if (!text_next_word(&r->text, &word)) return text_unexpected(&r->text, NULL, "a frequency");
        if (!text_number(word, &r->hertz[i]) || !(r->hertz[i] > (i ? r->hertz[i - 1] : SPECTRUM_MIN_HERTZ)) ||
            r->hertz[i] > SPECTRUM_MAX_HERTZ)
            return text_unexpected(&r->text, &word, "an ascending frequency, 1e-5 to 100 Hz");
    }
    return BOLAN_OK;
}

static bolan_result read_directions(swan_reader *r, bool nautical) {
    text_skip_line(&r->text);
    if (text_read_count(&r->text, "a number of directions", SPECTRUM_MIN_DIRECTIONS, SPECTRUM_MAX_DIRECTIONS,
                        &r->directions))
        return BOLAN_ERROR_FORMAT;
    text_skip_line(&r->text);
    for (uint32_t j = 0; j < r->directions; j++) {
        text_word word;
        double degrees;
        if (!text_next_word(&r->text, &word)) return text_unexpected(&r->text, NULL, "a direction");
        if (!text_number(word, &degrees) || fabs(degrees) > 720.0)
            return text_unexpected(&r->text, &word, "a direction in degrees");
        // NDIR: compass, where waves come FROM. CDIR: counter-clockwise from the x axis, where they go TO.
        r->to[j] = nautical ? bolan_compass_from_to_math(degrees) : bolan_radians(degrees);
    }
    return BOLAN_OK;
}

static bolan_result read_quantity(swan_reader *r) {
    uint32_t quantities;
    text_word word;
    text_skip_line(&r->text);
    if (text_read_count(&r->text, "one quantity (a 2-D spectrum): a number", 1, 1, &quantities))
        return BOLAN_ERROR_FORMAT;
    text_skip_line(&r->text);
    if (!text_next_word(&r->text, &word)) return text_unexpected(&r->text, NULL, "VaDens or EnDens");
    r->scale = 180.0 / BOLAN_PI; // per degree to per radian
    if (text_equals(word, "EnDens"))
        r->scale /= SEA_WATER_DENSITY * BOLAN_GRAVITY;
    else if (!text_equals(word, "VaDens"))
        return text_unexpected(&r->text, &word, "VaDens or EnDens");
    text_skip_line(&r->text); // the unit is implied
    text_skip_line(&r->text);
    if (text_read_number(&r->text, "the exception value", &r->exception)) return BOLAN_ERROR_FORMAT;
    text_skip_line(&r->text);
    r->ready = true;
    return BOLAN_OK;
}

static bolan_result read_section(swan_reader *r, text_word keyword) {
    if (text_equals(keyword, "TIME")) {
        double code;
        r->has_times = true;
        text_skip_line(&r->text);
        const bolan_result result = text_read_number(&r->text, "the time coding option", &code);
        text_skip_line(&r->text);
        return result;
    }
    bolan_result result;
    if (text_equals(keyword, "LOCATIONS") || text_equals(keyword, "LONLAT"))
        result = read_locations(r);
    else if (text_equals(keyword, "AFREQ") || text_equals(keyword, "RFREQ"))
        result = read_frequencies(r);
    else if (text_equals(keyword, "NDIR") || text_equals(keyword, "CDIR"))
        result = read_directions(r, text_equals(keyword, "NDIR"));
    else if (text_equals(keyword, "QUANT"))
        return read_quantity(r);
    else
        return text_unexpected(&r->text, &keyword, "TIME, LOCATIONS, LONLAT, AFREQ, RFREQ, NDIR, CDIR or QUANT");
    text_skip_line(&r->text);
    return result;
}

static bolan_result read_header(swan_reader *r) {
    text_word word;
    text_next_word(&r->text, &word); // SWAN
    text_skip_line(&r->text);
    while (!r->ready) {
        if (!next_word(&r->text, &word))
            return text_unexpected(&r->text, NULL, "a section, and QUANT at the end of the header");
        if (read_section(r, word)) return BOLAN_ERROR_FORMAT;
    }
    const char *missing = !r->locations ? "LOCATIONS or LONLAT" : !r->frequencies ? "AFREQ or RFREQ" : "NDIR or CDIR";
    return r->locations && r->frequencies && r->directions ? BOLAN_OK : text_unexpected(&r->text, &word, missing);
}

// ---- the blocks -----------------------------------------------------------------------------------------------------

static bolan_result read_values(swan_reader *r, double factor, double *energy) {
    const size_t count = (size_t)r->frequencies * r->directions;
    for (size_t i = 0; i < count; i++) {
        text_word word;
        double value;
        if (!text_next_word(&r->text, &word)) return text_unexpected(&r->text, NULL, "a density");
        if (!text_number(word, &value)) return text_unexpected(&r->text, &word, "a density");
        if (value == r->exception) value = 0.0; // missing
        if (value < 0.0) return text_negative(&r->text, value);
        const double density = value * factor * r->scale;
        if (!(density <= ENERGY_MAX)) return text_unexpected(&r->text, &word, "a density that a sea can have");
        if (energy) energy[i] = density;
    }
    return BOLAN_OK;
}

// One location at one time, into @p energy, or skipped where that is NULL.
static bolan_result read_block(swan_reader *r, double *energy) {
    text_word word;
    double factor;
    if (!next_word(&r->text, &word)) return text_unexpected(&r->text, NULL, "FACTOR, ZERO or NODATA");
    if (text_equals(word, "ZERO") || text_equals(word, "NODATA")) return BOLAN_OK;
    if (!text_equals(word, "FACTOR")) return text_unexpected(&r->text, &word, "FACTOR, ZERO or NODATA");
    if (text_read_number(&r->text, "the factor", &factor)) return BOLAN_ERROR_FORMAT;
    return factor < 0.0 ? text_negative(&r->text, factor) : read_values(r, factor, energy);
}

// "20161011.013000" -> "2016-10-11T01:30:00"; other codings of time are left out.
static void format_time(text_word word, char time[32]) {
    if (word.length != 15 || word.begin[8] != '.') return;
    for (size_t i = 0; i < 15; i++)
        if (i != 8 && (word.begin[i] < '0' || word.begin[i] > '9')) return;
    static const char pattern[] = "YYYY-YY-YYTYY:YY:YY";
    const char *digit = word.begin;
    for (size_t i = 0; i < sizeof pattern; i++) {
        time[i] = pattern[i];
        if (pattern[i] != 'Y') continue;
        if (*digit == '.') digit++;
        time[i] = *digit++;
    }
}

static bolan_result read_records(swan_reader *r, uint32_t record, spectrum_grid *grid) {
    text_word word;
    while (r->has_times ? next_word(&r->text, &word) : grid->record_count == 0) {
        const bool wanted = grid->record_count++ == record;
        if (r->has_times) {
            if (word.begin[0] < '0' || word.begin[0] > '9')
                return text_unexpected(&r->text, &word, "the date of the next time");
            text_skip_line(&r->text);
            if (wanted) format_time(word, grid->time);
        }
        for (uint32_t location = 0; location < r->locations; location++)
            if (read_block(r, wanted && location == 0 ? grid->energy : NULL)) return BOLAN_ERROR_FORMAT;
    }
    if (grid->record_count == 0) return text_unexpected(&r->text, NULL, "the date of the first time");
    if (record < grid->record_count) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_TIME_INDEX, "%s: record %u was asked for; expected 0 to %u",
              r->text.name, (unsigned)record, (unsigned)(grid->record_count - 1));
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result spectrum_parse_swan(const bolan_spectrum_texts *texts, uint32_t record, spectrum_grid *grid) {
    swan_reader r = {.text = text_open(&texts->density)};
    if (read_header(&r)) return BOLAN_ERROR_FORMAT;
    grid->frequency_count = r.frequencies;
    grid->direction_count = r.directions;
    if (!spectrum_grid_allocate(grid)) return BOLAN_ERROR_MEMORY;
    memcpy(grid->hertz, r.hertz, r.frequencies * sizeof(double));
    memcpy(grid->to, r.to, r.directions * sizeof(double));
    return read_records(&r, record, grid);
}
