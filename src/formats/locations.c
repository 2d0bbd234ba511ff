// SPDX-License-Identifier: MIT
// See locations.h.
#include "formats/locations.h"

#include "bolan/earth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PLACE_NEAR_KM 50.0 // a place farther than this from every location is worth a warning
#define PLACE_SAME_KM 0.05 // and one as near as this is the location itself

// ---- the list -------------------------------------------------------------------------------------------------------

static bolan_result grow(location_list *list) {
    const uint32_t capacity = list->capacity ? 2 * list->capacity : 16;
    bolan_spectrum_place *entries =
        bolan_enlarge(list->entries, list->capacity * sizeof *entries, capacity * sizeof *entries);
    if (!entries) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "the list of %u locations of a spectrum needs %zu bytes, which could not be allocated",
                  (unsigned)list->count + 1, capacity * sizeof *entries);
        return BOLAN_ERROR_MEMORY;
    }
    list->entries = entries;
    list->capacity = capacity;
    return BOLAN_OK;
}

bolan_result bolan_location_list_add(location_list *list, double x, double y, const char *name, size_t length) {
    if (list->count == list->capacity && grow(list)) return BOLAN_ERROR_MEMORY;
    bolan_spectrum_place *entry = &list->entries[list->count++];
    *entry = (bolan_spectrum_place){.x = x, .y = y};
    while (length > 0 && name[length - 1] == ' ') length--;
    for (size_t i = 0; i < length && i < sizeof entry->name - 1; i++)
        entry->name[i] = name[i] >= ' ' && name[i] <= '~' ? name[i] : '?';
    return BOLAN_OK;
}

void bolan_location_list_release(location_list *list) {
    bolan_release(list->entries, list->capacity * sizeof *list->entries);
    *list = (location_list){.entries = NULL};
}

// ---- the choice -----------------------------------------------------------------------------------------------------

// Great-circle distance [km] of longitudes and latitudes, else the distance in the plane [km].
static double distance_km(const location_list *list, uint32_t i, const double place[2]) {
    const bolan_spectrum_place *at = &list->entries[i];
    return 1e-3 * (list->spherical ? bolan_earth_distance(at->x, at->y, place[0], place[1])
                                   : hypot(at->x - place[0], at->y - place[1]));
}

static void choose_nearest(const location_list *list, const char *name, const double place[2], spectrum_notes *notes,
                           uint32_t *chosen) {
    double best = HUGE_VAL;
    for (uint32_t i = 0; i < list->count; i++) {
        const double distance = distance_km(list, i, place);
        if (!(distance < best)) continue;
        best = distance;
        *chosen = i;
    }
    if (best <= PLACE_SAME_KM) return;
    const bolan_spectrum_place *at = &list->entries[*chosen];
    bolan_spectrum_note_level(notes, best > PLACE_NEAR_KM ? BOLAN_LOG_WARNING : BOLAN_LOG_INFO,
                              BOLAN_LOG_SPECTRUM_LOCATION,
                              "%s: the location nearest to %g, %g is number %u at %g, %g, %.*f km away", name, place[0],
                              place[1], (unsigned)*chosen + 1, at->x, at->y, best < 10.0, best);
}

bolan_result bolan_location_list_choose(const location_list *list, const char *name, const bolan_spectrum_options *o,
                                        spectrum_notes *notes, uint32_t *chosen) {
    const bool by_place = o->location == 0 && !isnan(o->place[0]);
    *chosen = o->location ? o->location - 1 : 0;
    if (list->count == 0 && (o->location > 0 || by_place)) {
        bolan_log(
            BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_LOCATION,
            "%s: a location was asked for, but the file is of one buoy, whose place it does not give; expected none",
            name);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (o->location > list->count) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_LOCATION, "%s: location %u was asked for; expected 1 to %u", name,
                  (unsigned)o->location, (unsigned)list->count);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (by_place && list->spherical && !(fabs(o->place[1]) <= 90.0)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_LOCATION,
                  "%s: the location %g, %g was asked for; expected longitude, latitude in degrees", name, o->place[0],
                  o->place[1]);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (by_place) choose_nearest(list, name, o->place, notes, chosen);
    if (!by_place && o->location == 0 && list->count > 1)
        bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_LOCATION,
                            "%s: the file has %u locations; the first, at %g, %g, is taken; give location to choose",
                            name, (unsigned)list->count, list->entries[0].x, list->entries[0].y);
    return BOLAN_OK;
}
