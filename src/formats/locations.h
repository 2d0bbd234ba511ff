// SPDX-License-Identifier: MIT
/// @file locations.h
/// The locations of a record, and the choice of one by number, by place, or the first. Private to src/formats.
#ifndef BOLAN_FORMATS_LOCATIONS_H
#define BOLAN_FORMATS_LOCATIONS_H

#include "bolan/formats.h"
#include "spectrum/notes.h"

typedef struct location_list {
    bolan_spectrum_place *entries;
    uint32_t count, capacity;
    bool spherical; ///< longitudes and latitudes [deg], else x and y [m]
} location_list;

/// Appends a location with a name of @p length bytes, or none; MEMORY (logged).
bolan_result bolan_location_list_add(location_list *list, double x, double y, const char *name, size_t length);
void bolan_location_list_release(location_list *list);
/// The index of the location that the options ask for; 0 of an empty list. ARGUMENT (one sentence) if there is none.
/// What a person should know of the choice is a note: that there was one, and how far the place is.
bolan_result bolan_location_list_choose(const location_list *list, const char *name,
                                        const bolan_spectrum_options *options, spectrum_notes *notes, uint32_t *chosen);

#endif
