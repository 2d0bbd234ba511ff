// SPDX-License-Identifier: MIT
// See swan_header.h.
#include "formats/swan_header.h"

#include "formats/format.h"

#include "bolan/math.h"

#include <math.h>

#define SEA_WATER_DENSITY 1025.0 // SWAN's default rho, by which EnDens [J/m2/Hz/degr] is rho g times VaDens

enum { MAX_LOCATIONS = 1000000 };

bool bolan_swan_next_word(text_cursor *text, text_word *word) {
    while (bolan_text_next_word(text, word)) {
        if (word->begin[0] != '$') return true;
        bolan_text_skip_line(text);
    }
    return false;
}

bolan_result bolan_swan_read_place(text_cursor *places, double place[2]) {
    if (bolan_text_read_number(places, "the x of a location", &place[0]) ||
        bolan_text_read_number(places, "the y of a location", &place[1]))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(places); // a name may follow
    return BOLAN_OK;
}

static bolan_result read_locations(swan_header *h, bool spherical) {
    h->spherical = spherical;
    bolan_text_skip_line(&h->text);
    if (bolan_text_read_count(&h->text, "a number of locations", 1, MAX_LOCATIONS, &h->locations))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    h->places = h->text;
    for (uint32_t i = 0; i < h->locations; i++) {
        double place[2];
        if (bolan_swan_read_place(&h->text, place)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

static bolan_result read_frequencies(swan_header *h) {
    bolan_text_skip_line(&h->text);
    if (bolan_text_read_count(&h->text, "a number of frequencies", SPECTRUM_MIN_FREQUENCIES, SPECTRUM_MAX_FREQUENCIES,
                              &h->frequencies))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    if (bolan_format_read_frequencies(&h->text, h->hertz, h->frequencies)) return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    return BOLAN_OK;
}

static bolan_result read_directions(swan_header *h, bool nautical) {
    bolan_text_skip_line(&h->text);
    if (bolan_text_read_count(&h->text, "a number of directions", SPECTRUM_MIN_DIRECTIONS, SPECTRUM_MAX_DIRECTIONS,
                              &h->directions))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    for (uint32_t j = 0; j < h->directions; j++) {
        text_word word;
        double degrees;
        if (!bolan_text_next_word(&h->text, &word)) return bolan_text_unexpected(&h->text, NULL, "a direction");
        if (!bolan_text_number(word, &degrees) || fabs(degrees) > 720.0)
            return bolan_text_unexpected(&h->text, &word, "a direction in degrees");
        // NDIR: compass, where waves come FROM. CDIR: counter-clockwise from the x axis, where they go TO.
        h->to[j] = nautical ? bolan_compass_from_to_math(degrees) : bolan_radians(degrees);
    }
    bolan_text_skip_line(&h->text);
    return BOLAN_OK;
}

// ---- quantities -----------------------------------------------------------------------------------------------------

static bolan_result read_quantity(swan_header *h, swan_quantity *quantity) {
    static const struct {
        const char *name;
        swan_role role;
    } known[] = {{"VaDens", SWAN_DENSITY},
                 {"EnDens", SWAN_DENSITY},
                 {"NDIR", SWAN_FROM},
                 {"CDIR", SWAN_TO},
                 {"DSPRDEGR", SWAN_SPREAD}};
    const bool one_dimension = h->directions == 0;
    const char *expected = one_dimension ? "VaDens, EnDens, NDIR, CDIR or DSPRDEGR" : "VaDens or EnDens";
    text_word word;
    if (!bolan_text_next_word(&h->text, &word)) return bolan_text_unexpected(&h->text, NULL, expected);
    size_t i = 0;
    while (i < sizeof known / sizeof *known && !bolan_text_equals(word, known[i].name)) i++;
    if (i == sizeof known / sizeof *known || (!one_dimension && known[i].role != SWAN_DENSITY))
        return bolan_text_unexpected(&h->text, &word, expected);
    quantity->role = known[i].role;
    if (quantity->role == SWAN_DENSITY) {
        h->scale = one_dimension ? 1.0 : 180.0 / BOLAN_PI; // per degree to per radian
        if (bolan_text_equals(word, "EnDens")) h->scale /= SEA_WATER_DENSITY * BOLAN_GRAVITY;
    }
    bolan_text_skip_line(&h->text); // the unit is implied
    bolan_text_skip_line(&h->text);
    if (bolan_text_read_number(&h->text, "the exception value", &quantity->exception)) return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    return BOLAN_OK;
}

static bolan_result read_quantities(swan_header *h) {
    bolan_text_skip_line(&h->text);
    if (bolan_text_read_count(&h->text,
                              h->directions
                                  ? "one quantity (a 2-D spectrum): a number"
                                  : "a number of quantities (a 1-D spectrum, since there is no section NDIR or CDIR)",
                              1, h->directions ? 1 : SWAN_MAX_QUANTITIES, &h->quantities))
        return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    for (uint32_t i = 0; i < h->quantities; i++)
        if (read_quantity(h, &h->quantity[i])) return BOLAN_ERROR_FORMAT;
    h->ready = true;
    return BOLAN_OK;
}

// ---- the whole ------------------------------------------------------------------------------------------------------

static bolan_result read_time_code(swan_header *h) {
    h->has_times = true;
    bolan_text_skip_line(&h->text);
    const bolan_result result = bolan_text_read_count(&h->text, "the time coding option", 1, 6, &h->time_code);
    bolan_text_skip_line(&h->text);
    return result;
}

static bolan_result read_section(swan_header *h, text_word keyword) {
    if (bolan_text_equals(keyword, "TIME")) return read_time_code(h);
    if (bolan_text_equals(keyword, "LOCATIONS") || bolan_text_equals(keyword, "LONLAT"))
        return read_locations(h, bolan_text_equals(keyword, "LONLAT"));
    if (bolan_text_equals(keyword, "AFREQ") || bolan_text_equals(keyword, "RFREQ")) return read_frequencies(h);
    if (bolan_text_equals(keyword, "NDIR") || bolan_text_equals(keyword, "CDIR"))
        return read_directions(h, bolan_text_equals(keyword, "NDIR"));
    if (bolan_text_equals(keyword, "QUANT")) return read_quantities(h);
    return bolan_text_unexpected(&h->text, &keyword, "TIME, LOCATIONS, LONLAT, AFREQ, RFREQ, NDIR, CDIR or QUANT");
}

static bool has_density(const swan_header *h) {
    for (uint32_t i = 0; i < h->quantities; i++)
        if (h->quantity[i].role == SWAN_DENSITY) return true;
    return false;
}

bolan_result bolan_swan_read_header(const bolan_spectrum_text *text, swan_header *h) {
    uint32_t version;
    text_word word;
    *h = (swan_header){.text = bolan_text_open(text)};
    bolan_text_next_word(&h->text, &word); // SWAN
    if (bolan_text_read_count(&h->text, "the version of the format", 1, 1, &version)) return BOLAN_ERROR_FORMAT;
    bolan_text_skip_line(&h->text);
    while (!h->ready) {
        if (!bolan_swan_next_word(&h->text, &word))
            return bolan_text_unexpected(&h->text, NULL, "a section, and QUANT at the end of the header");
        if (read_section(h, word)) return BOLAN_ERROR_FORMAT;
    }
    if (!h->locations) return bolan_text_unexpected(&h->text, &word, "LOCATIONS or LONLAT before it");
    if (!h->frequencies) return bolan_text_unexpected(&h->text, &word, "AFREQ or RFREQ before it");
    return has_density(h) ? BOLAN_OK : bolan_text_unexpected(&h->text, &word, "a quantity VaDens or EnDens in it");
}
