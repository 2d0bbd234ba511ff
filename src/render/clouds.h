// SPDX-License-Identifier: MIT
// Clouds: marched once into a panorama round the eye and a map of their shadow on the sea, and again when the eye or the sun
// has moved. Shaders: cloud_noise, cloud_panorama, cloud_shadow.
#ifndef BOLAN_RENDER_CLOUDS_H
#define BOLAN_RENDER_CLOUDS_H

#include "frame.h"

typedef struct clouds {
    gl_program noise_program, panorama_program, shadow_program;
    gl_texture noise, map; // map: layer 0 panorama, layer 1 shadow (see common/atmosphere.glsl)
    gl_target panorama_target, shadow_target;
    bool filled, noise_filled;
    bolan_dvec3 eye;       // where the panorama was made
    uint64_t seed;
    bolan_vec3 sun;
    float cover, base, visibility, unit;
    bool above;            // the eye stood above the base
    bolan_quality quality; // of the panorama
} clouds;

bolan_result clouds_create(clouds *c);
bolan_result clouds_reload(clouds *c);
// Sets the uniforms that say where the panorama was made; true when it must be made again.
bool clouds_place(clouds *c, const frame *f, frame_uniforms *u);
// Marches them. The uniforms and the air's tables must be bound, the sea's view at UNIT_PASS.
void clouds_march(clouds *c, const frame *f);
void clouds_free(clouds *c);

#endif
