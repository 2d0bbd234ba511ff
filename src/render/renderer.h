// SPDX-License-Identifier: MIT
// The renderer's insides, shared by renderer.c (life and read-back) and frame.c (one picture).
#ifndef BOLAN_RENDERER_H
#define BOLAN_RENDERER_H

#include "frame.h"

// The timed parts of a frame, in order.
typedef enum frame_part {
    PART_SKY_TABLES,
    PART_SEA,
    PART_TERRAIN,
    PART_MODELS,
    PART_COPY,
    PART_MIRROR,
    PART_WATER,
    PART_SKY,
    PART_TONEMAP,
    PART_COUNT
} frame_part;
extern const char *const frame_part_names[PART_COUNT];

struct bolan_renderer {
    bolan_renderer_desc desc;
    gl_caps caps;
    gl_saved *saved;
    pass_sky *sky;
    pass_terrain *terrain;
    pass_models *models;
    pass_water *water;
    pass_mirror *mirror;
    pass_tonemap *tonemap;
    gl_buffer uniforms;
    gl_program yardstick;
    // targets of the present size
    gl_texture hdr_color, hdr_depth, behind_color, behind_depth;
    gl_target hdr, behind;
    uint32_t width, height;
    // timing
    gl_timer timers[PART_COUNT];
    bool measure;
    double near_plane;   // of the last picture [m]
    float radiance_unit; // of the last picture: stored / unit is radiance
    bolan_frame_statistics statistics;
};

// Makes the targets fit; logs and returns GL when they cannot be had.
bolan_result renderer_resize(bolan_renderer *r, uint32_t width, uint32_t height);

#endif
