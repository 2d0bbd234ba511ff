// SPDX-License-Identifier: MIT
// Spindrift over a storm: veils of spray around the eye, drawn over the picture of water and sky
// (shaders/shared/spray.glsl). Of waves that have breaking crests, cascades, for an eye in the air.
#ifndef BOLAN_RENDER_SPRAY_H
#define BOLAN_RENDER_SPRAY_H

#include "water_optics.h"

// The veils of one block of cells, which every block is drawn with.
typedef struct spray {
    gl_buffer vertices, indices;
    gl_mesh mesh;
    float (*blocks)[4]; // those that are drawn, see shaders/spray.glsl
} spray;

bolan_result bolan_spray_create(spray *s);
// Notes the program that bolan_spray_draw() uses, where there can be spray.
void bolan_spray_list(const water_setup *s, water_programs *all);
// With the fields of the waves, the noise of foam and the block Optics bound. Nothing below SPINDRIFT_BEGINS.
void bolan_spray_draw(const spray *s, const water_draw *d);
// Time in lives of a veil, modulo SPRAY_LIVES.
float bolan_spray_time(double seconds);
void bolan_spray_free(spray *s);

#endif
