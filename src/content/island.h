// SPDX-License-Identifier: MIT
// The shape of the generated island before water has cut gullies into it.
#ifndef BOLAN_CONTENT_ISLAND_H
#define BOLAN_CONTENT_ISLAND_H

#include "bolan/ground.h"

#define ISLAND_HEADLANDS 4
#define ISLAND_MOTUS 4
#define ISLAND_PASSES 2

// Lengths in radii, in the frame where u points to the middle of the lagoon and v to the left of it.
typedef struct island_plan {
    float radius, peak, sea_floor; // [m]
    float axis_x, axis_y;          // u in world axes
    uint32_t seed;
    struct {
        float u, v, tu, tv, root, tip, height;
    } headland[ISLAND_HEADLANDS]; // capsule from (u, v) to (tu, tv)
    struct {
        float u, v, along_u, along_v, length, width;
    } motu[ISLAND_MOTUS]; // sand islets on the reef
    struct {
        float u, v;
    } pass[ISLAND_PASSES];  // gaps in the reef: unit directions
    float peak2_u, peak2_v; // direction of the second summit on the crater's rim
} island_plan;

island_plan bolan_island_plan_make(const bolan_ground_generator *generator);
// The ground "island" of content.h.
bolan_result bolan_island_create(const bolan_ground_generator *generator, bolan_ground **out);
// Elevation [m] at world metres; @drained receives how much running water may cut there, 0..1.
float bolan_island_shape(const island_plan *p, double x, double y, float *drained);

#endif
