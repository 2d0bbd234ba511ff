// SPDX-License-Identifier: MIT
// The views of the shading reference: what the path tracer (trace.c) and the test of the picture both look at.
#ifndef BOLAN_REFERENCE_VIEWS_H
#define BOLAN_REFERENCE_VIEWS_H

#include "bolan/scene.h"
#include "bolan/world.h"

enum { REFERENCE_WIDTH = 144, REFERENCE_HEIGHT = 81, REFERENCE_PIXELS = REFERENCE_WIDTH * REFERENCE_HEIGHT };
// Red, green, blue; green without the sun's reflection, of which a pixel has too few rays for its contrast; and before
// it, its standard error.
enum { REFERENCE_SIGMA = 3, REFERENCE_SUNLESS, REFERENCE_CHANNELS };

#define REFERENCE_FOV 40.0   // vertical [deg]
#define REFERENCE_ALBEDO 0.4 // of the sea bed

typedef struct reference_view {
    const char *name;
    double height, heading, pitch, sun_azimuth, sun_elevation; // [m], [deg]
    uint32_t samples; // rays a pixel of the path tracer: more where glitter is, of which few rays have much
    double wind, bed; // [m/s]; depth of a level sea bed [m], 0: deep water
} reference_view;

static const reference_view reference_views[] = {
    {"near", 1.5, 0.0, -22.0, 180.0, 35.0, 256, 8.0, 0.0},
    {"glitter", 10.0, 180.0, -18.0, 180.0, 20.0, 384, 8.0, 0.0},
    {"low_sun", 10.0, 180.0, -18.0, 180.0, 5.0, 1024, 8.0, 0.0},
    {"far", 100.0, 30.0, -24.0, 90.0, 35.0, 192, 8.0, 0.0},
    {"high", 300.0, 30.0, -28.0, 90.0, 35.0, 192, 8.0, 0.0},
    {"bed", 3.0, 0.0, -45.0, 90.0, 50.0, 128, 5.0, 5.0},
    {"window", -3.0, 180.0, 42.0, 180.0, 40.0, 192, 5.0, 0.0},
    {"lagoon", -3.0, 60.0, 0.0, 180.0, 50.0, 128, 5.0, 5.0},
};
enum { REFERENCE_VIEWS = sizeof reference_views / sizeof reference_views[0] };

static inline bolan_scene reference_scene(const reference_view *v) {
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, v->wind, 270.0);
    scene.sea.seed = 5;
    scene.time = 20.0;
    scene.water = (bolan_seawater){.type = BOLAN_JERLOV_IB, .foam = 0.0};
    scene.sky.visibility = 300000.0;
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg = v->sun_azimuth;
    scene.sky.sun_elevation_deg = v->sun_elevation;
    scene.camera = (bolan_camera){
        .position = {0, 0, v->height}, .heading_deg = v->heading, .pitch_deg = v->pitch, .fov_deg = REFERENCE_FOV};
    return scene;
}

// The world of that scene; false: not made.
static inline bool reference_world(const reference_view *v, bolan_world **world) {
    const bolan_scene scene = reference_scene(v);
    const float level = (float)-v->bed, bed[4] = {level, level, level, level};
    bolan_ground_desc ground = bolan_ground_desc_default();
    ground.field = (bolan_heightfield){2, 2, -2000.0, -2000.0, 4000.0, 4000.0, bed};
    ground.detail = 0.0, ground.edge_elevation = -v->bed;
    bolan_world_assets assets = {.spectrum = NULL};
    if (v->bed > 0.0 && bolan_ground_create(&ground, &assets.ground) != BOLAN_OK) return false;
    if (bolan_world_create(&(bolan_world_desc){&scene, &assets}, world) != BOLAN_OK) return false;
    bolan_world_settle(*world, scene.time);
    return true;
}

#endif
