// SPDX-License-Identifier: MIT
// The internal resolution, by the time that frames take.
#ifndef VIEWER_PACE_H
#define VIEWER_PACE_H

#include <stdbool.h>

typedef struct pace {
    double frame_ms;         // smoothed
    double scale;            // of the internal resolution, 0.25..1
    double slow_ms, fast_ms; // above the first a step down; a step up if it is expected to stay below the other
    unsigned settled;        // frames since the scale changed
} pace;

// A processor that draws starts below the window's resolution.
void pace_start(pace *p, bool software);
// Other limits than the viewer's.
void pace_limit(pace *p, double slow_ms, double fast_ms);
// Takes the time of one frame; with @p automatic it may change the scale.
void pace_frame(pace *p, double ms, bool automatic);

#endif
