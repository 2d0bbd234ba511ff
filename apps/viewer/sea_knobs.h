// SPDX-License-Identifier: MIT
// Sea parameters as the panel edits them: wind and fetch, one swell, and the layout of the sea; read from a sea and
// written back.
#ifndef VIEWER_SEA_KNOBS_H
#define VIEWER_SEA_KNOBS_H

#include "bolan/waves.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sea_knob_group {
    SEA_KNOBS_WIND = 1 << 0,   // wind_speed, wind_from, fetch_km: they make a new wind sea
    SEA_KNOBS_SWELL = 1 << 1,  // the swell
    SEA_KNOBS_LAYOUT = 1 << 2, // everything else
} sea_knob_group;

#define SEA_KNOBS_FETCH_MIN 1.0f    // [km]
#define SEA_KNOBS_FETCH_MAX 5000.0f // fully developed in any wind below 30 m/s

typedef struct sea_knobs {
    bool measured;               // the sea comes from a file: the wind only roughens it
    float wind_speed, wind_from; // [m/s], [deg]
    float fetch_km;
    bool swell;
    float swell_height, swell_period, swell_from, swell_spread; // [m], [s], [deg], cos-2s exponent
    float choppiness, foam_decay;
    bool second_order;
    int seed, resolution, cascades;
} sea_knobs;

// @p measured: the scene names a spectrum file.
sea_knobs sea_knobs_read(const bolan_sea_desc *desc, bool measured);
// Writes the groups in @p changed (bits) to @p desc, and leaves the rest of it alone.
void sea_knobs_write(const sea_knobs *knobs, unsigned changed, bolan_sea_desc *desc);

#ifdef __cplusplus
}
#endif
#endif
