// SPDX-License-Identifier: MIT
// See host_light.h.
#include "host_light.h"

#include <math.h>
#include <string.h>

bolan_environment bolan_environment_default(void) {
    return (bolan_environment){
        .turn = bolan_m4_identity(), .sun_direction = {0.0f, 0.0f, 1.0f}, .sky_irradiance = {-1.0f, 0.0f, 0.0f}};
}

bolan_result bolan_host_light_create(host_light *p, const host_light *from) {
    bolan_gl_sampler_create(&p->sampler, true);
    p->borrowed = from != NULL;
    if (from != NULL) p->program = from->program;
    return from != NULL ? BOLAN_OK : bolan_gl_program_create("host_environment", NULL, &p->program);
}

static bool is_same(bolan_vec3 a, bolan_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool bolan_host_light_is_new(const host_light *p, const bolan_environment *e) {
    const bolan_environment *d = &p->drawn;
    if (d->cube != e->cube || e->cube == 0) return d->cube != e->cube;
    return d->serial != e->serial || memcmp(d->turn.m, e->turn.m, sizeof e->turn.m) != 0 ||
           !is_same(d->sun_direction, e->sun_direction) || !is_same(d->sun_irradiance, e->sun_irradiance) ||
           !is_same(d->sky_irradiance, e->sky_irradiance);
}

void bolan_host_light_draw(host_light *p, const bolan_environment *e, uint32_t unit) {
    float columns[3][4] = {{0}};
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) columns[c][r] = e->turn.m[4 * c + r];
    bolan_gl_program_use(&p->program);
    bolan_gl_program_vec4_array(&p->program, "cube_turn", columns[0], 3);
    const uint32_t before = bolan_gl_cube_bind(e->cube, &p->sampler, unit);
    bolan_gl_draw_fullscreen();
    bolan_gl_cube_unbind(before, unit);
}

void bolan_host_light_free(host_light *p) {
    if (!p->borrowed) bolan_gl_program_free(&p->program);
    bolan_gl_sampler_free(&p->sampler);
}

static bool is_light(bolan_vec3 v) {
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z) && v.x >= 0.0f && v.y >= 0.0f && v.z >= 0.0f;
}

#define UNIT_ERROR 1e-3f // of a direction's length and of a rotation that was multiplied up in floats

static bool is_rotation(const float *m) {
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            float dot = 0.0f;
            for (int k = 0; k < 3; ++k) dot += m[4 * i + k] * m[4 * j + k];
            if (!(fabsf(dot - (i == j ? 1.0f : 0.0f)) <= UNIT_ERROR)) return false;
        }
    return true;
}

const char *bolan_environment_problem(const bolan_environment *e) {
    if (e->cube == 0) return NULL;
    if (!is_rotation(e->turn.m)) return "environment.turn is not a rotation";
    if (!(fabsf(bolan_v3_length(e->sun_direction) - 1.0f) <= UNIT_ERROR))
        return "environment.sun_direction does not have length 1";
    if (!is_light(e->sun_irradiance)) return "environment.sun_irradiance is negative or not finite";
    if (e->sky_irradiance.x < 0.0f) return NULL;
    return is_light(e->sky_irradiance) ? NULL : "environment.sky_irradiance is negative or not finite";
}

const char *bolan_haze_problem(const bolan_haze *h) {
    if ((int)h->kind < BOLAN_HAZE_AIR || h->kind > BOLAN_HAZE_NONE) return "haze.kind is not one of air, given, none";
    if (h->kind != BOLAN_HAZE_GIVEN) return NULL;
    if (!is_light(h->radiance)) return "haze.radiance is negative or not finite";
    return is_light(h->extinction) ? NULL : "haze.extinction is negative or not finite";
}
