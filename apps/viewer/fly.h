// SPDX-License-Identifier: MIT
// The free camera: pure functions of the camera and what the hands do.
#ifndef VIEWER_FLY_H
#define VIEWER_FLY_H

#include "bolan/scene.h"

typedef struct fly_input {
    double forward, right, up; // -1..1
    double turn, tilt;         // to the right and up [deg], already what this frame shall do
    double faster;             // factor of this frame, 1 at rest
} fly_input;

// Speed [m/s] at @p height above the surface: a walk near it, a jet far above.
double fly_speed(double height);
// Moves the camera for @p seconds. Forward follows the view, up is the vertical. The camera stays above @p floor [m].
void fly_step(bolan_camera *camera, const fly_input *input, double speed, double floor, double seconds);
// The eye is never lower than @p floor: @p camera is lifted onto it, and no higher than the sky reaches.
void fly_keep_above(bolan_camera *camera, double floor);

#endif
