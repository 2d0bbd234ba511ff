// SPDX-License-Identifier: MIT
/// @file locations.h
/// The choice of one location among those of a text, by number, by place, or the first. Private to src/spectrum.
#ifndef BOLAN_SPECTRUM_LOCATIONS_H
#define BOLAN_SPECTRUM_LOCATIONS_H

#include "bolan/spectrum.h"
#include "spectrum/notes.h"

typedef struct location_choice {
    const bolan_spectrum_options *options;
    bool spherical;  ///< places are longitude and latitude [deg], else x and y [m]
    uint32_t count;  ///< locations that were offered
    uint32_t index;  ///< of the best so far, from 0
    double place[2]; ///< of the best so far
    double distance; ///< to the place that was asked for [km]
} location_choice;

location_choice bolan_location_choice_begin(const bolan_spectrum_options *options, bool spherical);
/// The next location of the text; true if it is the best so far.
bool bolan_location_choice_offer(location_choice *choice, const double place[2]);
/// After the last: ARGUMENT (one sentence) if there is none of the number that was asked for.
bolan_result bolan_location_choice_end(const location_choice *choice, const char *name);
/// What a person should know of a choice that succeeded, as a note: that there was a choice, or that the place is far.
void bolan_location_choice_say(const location_choice *choice, const char *name, spectrum_notes *notes);

#endif
