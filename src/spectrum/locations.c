// SPDX-License-Identifier: MIT
// See locations.h.
#include "spectrum/locations.h"

#include "bolan/earth.h"

#include <math.h>

#define PLACE_NEAR_KM 50.0 // a place farther than this from every location is worth a warning

// Great-circle distance [km] of longitudes and latitudes, else the distance in the plane [km].
static double distance_km(bool spherical, const double a[2], const double b[2]) {
    return 1e-3 * (spherical ? bolan_earth_distance(a[0], a[1], b[0], b[1]) : hypot(a[0] - b[0], a[1] - b[1]));
}

static bool by_place(const bolan_spectrum_options *options) {
    return options->location == 0 && !isnan(options->place[0]);
}

location_choice bolan_location_choice_begin(const bolan_spectrum_options *options, bool spherical) {
    const location_choice choice = {.options = options, .spherical = spherical, .distance = HUGE_VAL};
    return choice;
}

bool bolan_location_choice_offer(location_choice *choice, const double place[2]) {
    const bolan_spectrum_options *o = choice->options;
    const uint32_t index = choice->count++, wanted = o->location ? o->location - 1 : 0;
    const double distance = by_place(o)       ? distance_km(choice->spherical, place, o->place)
                            : index == wanted ? 0.0
                                              : HUGE_VAL;
    if (!(distance < choice->distance)) return false;
    choice->index = index;
    choice->place[0] = place[0];
    choice->place[1] = place[1];
    choice->distance = distance;
    return true;
}

bolan_result bolan_location_choice_end(const location_choice *choice, const char *name) {
    if (choice->options->location <= choice->count) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_LOCATION, "%s: location %u was asked for; expected 1 to %u", name,
              (unsigned)choice->options->location, (unsigned)choice->count);
    return BOLAN_ERROR_ARGUMENT;
}

void bolan_location_choice_say(const location_choice *choice, const char *name, spectrum_notes *notes) {
    const bolan_spectrum_options *o = choice->options;
    if (by_place(o) && choice->distance > PLACE_NEAR_KM)
        bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_LOCATION,
                            "%s: the location nearest to %g, %g is number %u at %g, %g, %.0f km away", name,
                            o->place[0], o->place[1], (unsigned)choice->index + 1, choice->place[0], choice->place[1],
                            choice->distance);
    if (!by_place(o) && o->location == 0 && choice->count > 1)
        bolan_spectrum_note(notes, BOLAN_LOG_SPECTRUM_LOCATION,
                            "%s: the file has %u locations; the first, at %g, %g, is taken; give location to choose",
                            name, (unsigned)choice->count, choice->place[0], choice->place[1]);
}
