// SPDX-License-Identifier: MIT
// The fields of a water for the host's own programs: textures and uniform block of shaders/include/bolan_fields.glsl.
#ifndef BOLAN_RENDER_FIELDS_H
#define BOLAN_RENDER_FIELDS_H

#include "bolan/water.h"
#include "gl/gl.h"
#include "sea_compute.h"

// bolan_sea_block of bolan_fields.glsl: std140, keep in step.
typedef struct fields_block {
    bolan_vec4 tile[BOLAN_MAX_CASCADES], band[BOLAN_MAX_CASCADES], bound[BOLAN_MAX_CASCADES], lift[13];
    bolan_vec4 layer_wave[BOLAN_MAX_WAVE_LAYERS], layer_area[BOLAN_MAX_WAVE_LAYERS],
        layer_extent[BOLAN_MAX_WAVE_LAYERS];
    bolan_vec4 warp_wave[BOLAN_WARP_WAVES];
    int32_t cascade_count, wave_count;
    float sharpness, mean, wave_height, choppiness, foam_threshold, level;
    int32_t layer_count, warp_count;
    bolan_vec2 warp_at_origin;
} fields_block;

typedef struct host_fields {
    gl_texture displacement, slopes, foam, waves;
    gl_buffer block;
    sea_tables tables; // of the compute backend
    uint64_t serial; // of the sea whose fields are in the textures; 0: none
} host_fields;

void bolan_host_fields_free(host_fields *p);

#endif
