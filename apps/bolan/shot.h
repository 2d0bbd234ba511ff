// SPDX-License-Identifier: MIT
// One image of a world at a time: its view, and the file of its linear layers.
#ifndef BOLAN_CLI_SHOT_H
#define BOLAN_CLI_SHOT_H

#include "bolan/io.h"
#include "bolan/render.h"

// Sets the camera of the world's path at @p time, the time of its step, and returns the view of it.
bolan_view shot_view(bolan_world *world, double time, uint32_t width, uint32_t height, uint32_t samples);
// Splits width * height pixels of three floats into three planes.
void shot_planes(const float *pixels, size_t count, float *planes);

#endif
