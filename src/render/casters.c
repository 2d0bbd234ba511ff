// SPDX-License-Identifier: MIT
// What throws shadows on water, ground and objects, as uniforms of shaders/common/object_shadow.glsl.
#include "pass_objects.h"

#include <string.h>

#define CASTER_EDGE 1.12f // of its soft edge, in radii: the root of CASTER_NONE there

void bolan_casters_use(const render_view *v, const gl_program *program) {
    bolan_gl_program_int(program, "caster_count", (int)v->caster_count);
    if (v->caster_count > 0) bolan_gl_program_vec4_array(program, "caster", v->casters, 3 * v->caster_count);
}

// The ball round a caster's ellipsoid, whose axes are across each other.
static float ball_of(const float row[CASTER_FLOATS], bolan_vec3 *middle) {
    float widest = 0.0f;
    *middle = (bolan_vec3){0};
    for (int i = 0; i < 3; i++, row += 4) {
        const bolan_vec3 axis = {row[0], row[1], row[2]};
        const float square = bolan_v3_dot(axis, axis);
        *middle = bolan_v3_add(*middle, bolan_v3_scale(axis, -row[3] / square));
        widest = fmaxf(widest, 1.0f / sqrtf(square));
    }
    return CASTER_EDGE * widest;
}

void bolan_casters_use_near(const render_view *v, const gl_program *program, bolan_vec3 middle, float radius,
                            float least, int but) {
    float near[MAX_CASTERS * CASTER_FLOATS];
    uint32_t count = 0;
    for (uint32_t i = 0; i < v->caster_count; i++) {
        const float *row = v->casters + CASTER_FLOATS * i;
        bolan_vec3 from;
        const float ball = ball_of(row, &from), reach = ball + radius;
        const bolan_vec3 way = bolan_v3_sub(middle, from), sun = v->frame->sun_direction;
        const float along = bolan_v3_dot(way, sun);
        if ((int)i == but || ball < least || along > reach) continue;
        if (bolan_v3_length(bolan_v3_sub(way, bolan_v3_scale(sun, along))) > reach) continue;
        memcpy(near + CASTER_FLOATS * count++, row, sizeof(float[CASTER_FLOATS]));
    }
    bolan_gl_program_int(program, "caster_count", (int)count);
    if (count > 0) bolan_gl_program_vec4_array(program, "caster", near, 3 * count);
}
