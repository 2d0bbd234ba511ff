// SPDX-License-Identifier: MIT
// A pass over pixels by a fragment shader or by a compute shader, from one source: shaders/common/pixels.glsl.
#ifndef BOLAN_RENDER_PIXELS_H
#define BOLAN_RENDER_PIXELS_H

#include "gl/gl.h"

enum { PIXEL_GROUP = 8 }; // width and height of a group of the compute shader [px]

// Runs the program, which is in use, over rows from..to - 1 of the target, counted from the bottom, without blending or
// depth test. The first color of the target must have storage where the program is a compute shader.
void bolan_pixels_draw(const gl_program *program, const gl_target *target, uint32_t from, uint32_t to);

#endif
