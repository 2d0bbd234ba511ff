// SPDX-License-Identifier: MIT
// The free camera: pure functions of the camera and the input.
#ifndef VIEWER_FLY_H
#define VIEWER_FLY_H

#include "bolan/scene.h"

typedef struct fly_input {
    double forward, right, up; // -1..1
    double turn, tilt;         // to the right and up, of this frame [deg]
    double faster;             // factor of this frame, 1 at rest
} fly_input;

// Speed [m/s] at @p height above the surface: a walk near it, a jet far above.
double fly_speed(double height);
// Moves the camera for @p seconds. Forward follows the view, up is the vertical. The camera stays above @p floor [m].
void fly_step(bolan_camera *camera, const fly_input *input, double speed, double floor, double seconds);
// Lifts @p camera to @p floor at least, and lowers it to the ceiling of the sky at most.
void fly_keep_above(bolan_camera *camera, double floor);

#endif
