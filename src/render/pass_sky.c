// SPDX-License-Identifier: MIT
// The sky: keeps the tables of the air, the clouds and the environment map, measures the light on the sea, and draws the
// background. Shader: shaders/sky.glsl; atmosphere.c and clouds.c fill the tables.
#include "atmosphere.h"
#include "clouds.h"

#include <math.h>

enum { ENVIRONMENT_SIZE = 512, LIGHT_PIXELS = 4 };

struct pass_sky {
    atmosphere air;
    clouds clouds;
    gl_program sky_program, environment_program, light_program;
    gl_texture environment, light;
    gl_target environment_target, light_target;
    gl_buffer uniforms;            // Frame, while tables are drawn
    float measured[4 * LIGHT_PIXELS]; // the last read-back of sky_light.glsl
};

static bolan_result create_targets(pass_sky *p) {
    const gl_texture_desc environment = {.format = GL_FMT_RGBA16F, .width = ENVIRONMENT_SIZE, .height = ENVIRONMENT_SIZE,
                                         .levels = 8, .filter = GL_FILTER_MIPMAP};
    const gl_texture_desc light = {.format = GL_FMT_RGBA32F, .width = LIGHT_PIXELS, .height = 1};
    const gl_texture *color = &p->environment;
    bolan_result result = gl_texture_create(&environment, &p->environment);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, -1, 0, &p->environment_target);
    if (result == BOLAN_OK) result = gl_texture_create(&light, &p->light);
    color = &p->light;
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, -1, 0, &p->light_target);
    if (result == BOLAN_OK) {
        result = gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof(frame_uniforms), NULL, &p->uniforms);
    }
    return result;
}

bolan_result pass_sky_create(const gl_caps *caps, pass_sky **out) {
    *out = NULL;
    if (!caps->color_float) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED, "this OpenGL ES lacks EXT_color_buffer_float, which the sky needs");
        return BOLAN_ERROR_UNSUPPORTED;
    }
    pass_sky *p = bolan_allocate(sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result result = atmosphere_create(&p->air);
    if (result == BOLAN_OK) result = clouds_create(&p->clouds);
    if (result == BOLAN_OK) result = gl_program_create("sky", NULL, &p->sky_program);
    if (result == BOLAN_OK) result = gl_program_create("sky_environment", NULL, &p->environment_program);
    if (result == BOLAN_OK) result = gl_program_create("sky_light", NULL, &p->light_program);
    if (result == BOLAN_OK) result = create_targets(p);
    if (result != BOLAN_OK) {
        pass_sky_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result pass_sky_reload(pass_sky *p) {
    bolan_result result = atmosphere_reload(&p->air);
    if (result == BOLAN_OK) result = clouds_reload(&p->clouds);
    if (result == BOLAN_OK) result = gl_program_reload(&p->sky_program);
    if (result == BOLAN_OK) result = gl_program_reload(&p->environment_program);
    if (result == BOLAN_OK) result = gl_program_reload(&p->light_program);
    return result;
}

// Radiance in twilight falls by six orders of magnitude, below what half floats hold: so the unit of radiance falls with it.
static float radiance_unit(float sun_height) {
    const double below = -bolan_degrees(asin(fmax(-1.0, fmin(1.0, sun_height))));
    return below <= 0.0 ? 1.0f : (float)pow(10.0, below / 3.0);
}

static void draw_environment(pass_sky *p) {
    gl_texture_bind(&p->air.sea_view, UNIT_PASS);
    gl_target_bind(&p->environment_target);
    gl_program_use(&p->environment_program);
    gl_draw_fullscreen();
    gl_texture_generate_mipmaps(&p->environment);
    gl_texture_bind(&p->environment, UNIT_ENVIRONMENT);
    gl_target_bind(&p->light_target);
    gl_program_use(&p->light_program);
    gl_draw_fullscreen();
    gl_target_read_float(&p->light_target, 0, p->measured);
}

static float luminance(const float *c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

// Automatic exposure: what makes the illuminance of the scene a middle grey, but not wholly: a dusk should look darker than a
// noon. E in units of the sun above the air; at noon, E about 0.9, the factor is EXPOSURE_NOON.
static float exposure(const pass_sky *p, const frame *f, float unit) {
    const float exposure_noon = 3.6f, adaptation = 0.86f;
    const float shadow = p->measured[12], sun_height = fmaxf(f->uniforms.sun.z, 0.0f);
    const float sky = luminance(p->measured), direct = luminance(p->measured + 4) * (0.25f + 0.75f * sun_height) * shadow;
    const float illuminance = fmaxf((sky + direct) / unit, 1e-10f);
    return exposure_noon * powf(illuminance / 0.9f, -adaptation) * exp2f((float)f->scene->exposure) / unit;
}

static void set_light(const pass_sky *p, frame *f) {
    frame_uniforms *u = &f->uniforms;
    const float *sky = p->measured, *sun = p->measured + 4;
    u->sky_light.x = sky[0], u->sky_light.y = sky[1], u->sky_light.z = sky[2];
    u->sun_light.x = sun[0], u->sun_light.y = sun[1], u->sun_light.z = sun[2];
    u->sun_light.w = exposure(p, f, u->haze.w);
}

void pass_sky_prepare(pass_sky *p, frame *f) {
    frame_uniforms *u = &f->uniforms;
    u->haze.w = radiance_unit(u->sun.z);
    const bool cloudy = clouds_place(&p->clouds, f, u);
    gl_buffer_update(&p->uniforms, 0, sizeof *u, u);
    gl_buffer_bind_uniform(&p->uniforms, 0);
    const bool changed = atmosphere_update(&p->air, u);
    atmosphere_bind(&p->air);
    if (cloudy || changed) {
        const gl_state drawing = {.color_write = true};
        gl_set_state(&drawing);
        gl_texture_bind(&p->air.sea_view, UNIT_PASS);
        if (cloudy) clouds_march(&p->clouds, f);
        gl_texture_bind(&p->clouds.map, UNIT_CLOUDS);
        draw_environment(p);
    }
    gl_texture_bind(&p->clouds.map, UNIT_CLOUDS);
    gl_texture_bind(&p->environment, UNIT_ENVIRONMENT);
    set_light(p, f);
}

void pass_sky_draw(pass_sky *p, const frame *f) {
    (void)f;
    const gl_state behind = {.depth_test = true, .color_write = true};
    gl_set_state(&behind);
    gl_program_use(&p->sky_program);
    gl_draw_fullscreen();
}

void pass_sky_destroy(pass_sky **pp) {
    if (!pp || !*pp) return;
    pass_sky *p = *pp;
    atmosphere_free(&p->air);
    clouds_free(&p->clouds);
    gl_target_free(&p->environment_target);
    gl_target_free(&p->light_target);
    gl_texture_free(&p->environment);
    gl_texture_free(&p->light);
    gl_program_free(&p->sky_program);
    gl_program_free(&p->environment_program);
    gl_program_free(&p->light_program);
    gl_buffer_free(&p->uniforms);
    bolan_release(p, sizeof *p);
    *pp = NULL;
}
