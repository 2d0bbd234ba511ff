// SPDX-License-Identifier: MIT
// The free camera.
#include "fly.h"

#include <math.h>

#define CEILING 20000.0 // [m] the sky is valid up to here

double fly_speed(double height) {
    // Proportional to height, so that the picture flows equally fast at any altitude.
    return fmin(fmax(1.2 * height, 4.0), 4000.0);
}

void fly_keep_above(bolan_camera *camera, double floor) {
    camera->position.z = fmin(fmax(camera->position.z, floor), CEILING);
}

static double clamp_pitch(double pitch) { return fmin(fmax(pitch, -89.5), 89.5); }

void fly_step(bolan_camera *camera, const fly_input *input, double speed, double floor, double seconds) {
    camera->heading_deg = bolan_wrap_degrees(camera->heading_deg + input->turn);
    camera->pitch_deg = clamp_pitch(camera->pitch_deg + input->tilt);
    double heading = bolan_radians(camera->heading_deg), pitch = bolan_radians(camera->pitch_deg);
    double way = speed * input->faster * seconds;
    double ahead = input->forward * cos(pitch) * way, aside = input->right * way;
    camera->position.x += sin(heading) * ahead + cos(heading) * aside;
    camera->position.y += cos(heading) * ahead - sin(heading) * aside;
    camera->position.z += (input->forward * sin(pitch) + input->up) * way;
    fly_keep_above(camera, floor);
}
