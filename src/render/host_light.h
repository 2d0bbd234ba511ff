// SPDX-License-Identifier: MIT
// Light from the host: its cube map becomes the environment map that the water reflects. Shader: host_environment.glsl.
#ifndef BOLAN_RENDER_HOST_LIGHT_H
#define BOLAN_RENDER_HOST_LIGHT_H

#include "bolan/render.h"
#include "gl/gl.h"

typedef struct host_light {
    gl_program program;
    bool borrowed; // the program is that of another
    gl_sampler sampler;
    bolan_environment drawn; // what the environment map was made of; cube 0: Bolan's own sky
} host_light;

// Shares the program of `from`, which must live longer; NULL: makes its own.
bolan_result bolan_host_light_create(host_light *p, const host_light *from);
// Whether `drawn` is another light, or other contents of the same cube.
bool bolan_host_light_is_new(const host_light *p, const bolan_environment *e);
// Draws the cube into the bound target, a square of the environment map.
void bolan_host_light_draw(host_light *p, const bolan_environment *e, uint32_t unit);
void bolan_host_light_free(host_light *p);
// What is wrong with the numbers of an environment or a haze, as the end of a sentence; NULL: nothing.
const char *bolan_environment_problem(const bolan_environment *e);
const char *bolan_haze_problem(const bolan_haze *h);

#endif
