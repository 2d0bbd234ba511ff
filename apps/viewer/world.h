// SPDX-License-Identifier: MIT
// Heights of the world for the camera of the viewer.
#ifndef VIEWER_WORLD_H
#define VIEWER_WORLD_H

#include "bolan/world.h"

// Height of the surface at (x, y), water or ground, whichever is higher [m]; *land tells which.
double world_surface(const bolan_world *w, double x, double y, bool *land);
// The lowest height for an eye there [m].
double world_floor(const bolan_world *w, double x, double y);
double seconds_now(void);

#endif
