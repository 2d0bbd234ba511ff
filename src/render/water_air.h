// SPDX-License-Identifier: MIT
// What varies slowly over the picture of the water, as a small picture: air, gusts, the shadow of clouds, the depth of
// the bed (shaders/water_air.glsl). common/water_air.glsl reads it.
#ifndef BOLAN_RENDER_WATER_AIR_H
#define BOLAN_RENDER_WATER_AIR_H

#include "water_optics.h"

typedef struct water_air {
    gl_texture map; // a layer for each output
    gl_target target;
} water_air;

// For a view of this size. On an error nothing is left to free.
bolan_result bolan_water_air_create(water_air *a, const render_view *v);
// Notes the program that bolan_water_air_draw() uses.
void bolan_water_air_list(const water_setup *s, water_programs *all);
// Fills the picture; the optics binds `map` where its shader reads it. False: the program does not compile.
bool bolan_water_air_draw(const water_air *a, const water_draw *d);
void bolan_water_air_free(water_air *a);

#endif
