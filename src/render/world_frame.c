// SPDX-License-Identifier: MIT
// The frame of a world.
#include "bolan/render.h"

bolan_frame_desc bolan_frame_desc_of_world(const bolan_world *world) {
    BOLAN_ASSERT(world);
    const bolan_water *water = bolan_world_water(world);
    bolan_frame_desc frame = bolan_frame_desc_default();
    frame.scene = bolan_world_scene(world);
    frame.sea = water->sea;
    frame.terrain = water->ground;
    frame.layers = water->layers;
    frame.layer_count = water->layer_count;
    frame.tiles = bolan_world_tiles(world);
    frame.models = bolan_world_object_models(world);
    return frame;
}
