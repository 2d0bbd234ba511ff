// SPDX-License-Identifier: MIT
// The rows of the panel that show a parameter: label, range and unit come from the parameter's table.
#ifndef VIEWER_PANEL_ROWS_H
#define VIEWER_PANEL_ROWS_H

#include "bolan/io.h"

#ifdef __cplusplus
extern "C" {
#endif

// X(name, key of scene files).
#define PANEL_ROWS(X)                     \
    X(WIND_SPEED, "sea.wind.speed")       \
    X(WIND_FROM, "sea.wind.from")         \
    X(FETCH, "sea.fetch_km")              \
    X(SWELL_HEIGHT, "sea.swell.hs")       \
    X(SWELL_PERIOD, "sea.swell.tp")       \
    X(SWELL_FROM, "sea.swell.from")       \
    X(SWELL_SPREAD, "sea.swell.spread")   \
    X(CHOPPINESS, "sea.choppiness")       \
    X(FOAM_DECAY, "sea.foam_decay")       \
    X(CASCADES, "sea.cascades")           \
    X(RESOLUTION, "sea.resolution")       \
    X(SUN_AZIMUTH, "sky.sun.azimuth")     \
    X(SUN_ELEVATION, "sky.sun.elevation") \
    X(VISIBILITY, "sky.visibility_km")    \
    X(CLOUD_COVER, "sky.clouds.cover")    \
    X(CLOUD_BASE, "sky.clouds.base")      \
    X(WATER_TYPE, "water.type")           \
    X(FOAM, "water.foam")                 \
    X(FIELD_OF_VIEW, "camera.fov")        \
    X(EXPOSURE, "exposure")
#define PANEL_ROW_ID(name, key) ROW_##name,
typedef enum panel_row_id { PANEL_ROWS(PANEL_ROW_ID) PANEL_ROW_COUNT } panel_row_id;

typedef struct panel_row {
    char label[64];   // "height##sea.swell.hs": what follows ## is not shown, and tells rows of one label apart
    char format[32];  // "%.1f m/s"
    double low, high; // of the slider, in the unit of the format
    double factor;    // that unit in units of the field
    bool logarithmic;
} panel_row;

// Fills all rows.
void panel_rows_make(panel_row rows[PANEL_ROW_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
