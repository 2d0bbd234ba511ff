// SPDX-License-Identifier: MIT
// Caustics of the drawn waves round the eye: see shaders/caustics.glsl and shaders/common/gathered.glsl.
#ifndef BOLAN_RENDER_CAUSTICS_H
#define BOLAN_RENDER_CAUSTICS_H

#include "water_optics.h"

enum { CAUSTIC_PATCHES = 2 }; // a wide one, and a finer one near the eye

typedef struct caustic_maps {
    uint32_t cells; // of each patch's side
    gl_texture rays, lights, map;
    gl_target source, targets[CAUSTIC_PATCHES]; // a layer of the map each
    gl_buffer nodes, indices;
    gl_mesh mesh;
    gl_program program;
} caustic_maps;

bolan_result bolan_caustics_create(caustic_maps *c, bolan_quality quality);
bolan_result bolan_caustics_reload(caustic_maps *c);
void bolan_caustics_free(caustic_maps *c);
void bolan_caustics_list(const water_setup *s, water_programs *all);
// Draws and binds the maps of a view that can show them, and sets what the shaders read; else clears that.
void bolan_caustics_draw(caustic_maps *c, const water_draw *d);

#endif
