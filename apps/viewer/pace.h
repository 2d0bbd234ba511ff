// SPDX-License-Identifier: MIT
// The internal resolution, by the time that frames take.
#ifndef VIEWER_PACE_H
#define VIEWER_PACE_H

#include <stdbool.h>

typedef struct pace {
    double frame_ms;  // smoothed
    double scale;     // of the internal resolution, 0.25..1
    unsigned settled; // frames since the scale changed
} pace;

// A processor that draws starts below the window's resolution.
void pace_start(pace *p, bool software);
// Takes the time of one frame; with @p automatic it may change the scale.
void pace_frame(pace *p, double ms, bool automatic);

#endif
