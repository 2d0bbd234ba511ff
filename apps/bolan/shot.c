// SPDX-License-Identifier: MIT
// See shot.h.
#include "shot.h"

bolan_view shot_view(bolan_world *world, double time, uint32_t width, uint32_t height, uint32_t samples) {
    const bolan_camera camera = bolan_world_camera_at(world, time);
    bolan_world_set_camera(world, &camera);
    bolan_view view = bolan_view_from_camera(&camera, width, height);
    view.eye = bolan_world_clear_eye(world, view.eye);
    view.samples = samples;
    return view;
}

void shot_planes(const float *pixels, size_t count, float *planes) {
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++) planes[c * count + i] = pixels[3 * i + c];
}
