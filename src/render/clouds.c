// SPDX-License-Identifier: MIT
// Keeps the cloud panorama and the shadow map: noise once, both maps again when the eye or the sun has moved.
#include "clouds.h"

#include <math.h>
#include <string.h>

enum { NOISE_SIZE = 64 };
static const double PATTERN = 57600.0 * 16.0; // every tile of common/clouds.glsl divides it [m] but for cirrus, which is far
static const float SHADOW_SIZE = 100000.0f;   // CLOUD_SHADOW_SIZE of common/atmosphere.glsl [m]

static const struct { uint32_t width, height; } panorama_size[] = {
    [BOLAN_QUALITY_LOW] = {1024, 256}, [BOLAN_QUALITY_MEDIUM] = {1536, 384},
    [BOLAN_QUALITY_HIGH] = {2048, 512}, [BOLAN_QUALITY_ULTRA] = {4096, 768},
};

static bolan_result create_map(clouds *c, bolan_quality quality) {
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F, .width = panorama_size[quality].width,
                               .height = panorama_size[quality].height, .depth = 2, .array = true,
                               .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_REPEAT_CLAMP};
    gl_target_free(&c->panorama_target);
    gl_target_free(&c->shadow_target);
    gl_texture_free(&c->map);
    const gl_texture *color = &c->map;
    bolan_result result = gl_texture_create(&d, &c->map);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 0, 0, &c->panorama_target);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 1, 0, &c->shadow_target);
    return result;
}

bolan_result clouds_create(clouds *c) {
    memset(c, 0, sizeof *c);
    const gl_texture_desc noise = {.format = GL_FMT_RGBA8, .width = NOISE_SIZE, .height = NOISE_SIZE, .depth = NOISE_SIZE,
                                   .filter = GL_FILTER_MIPMAP_NEAREST, .wrap = GL_WRAP_REPEAT};
    bolan_result result = gl_program_create("cloud_noise", NULL, &c->noise_program);
    if (result == BOLAN_OK) result = gl_program_create("cloud_panorama", NULL, &c->panorama_program);
    if (result == BOLAN_OK) result = gl_program_create("cloud_shadow", NULL, &c->shadow_program);
    if (result == BOLAN_OK) result = gl_texture_create(&noise, &c->noise);
    if (result == BOLAN_OK) result = create_map(c, BOLAN_QUALITY_LOW);
    if (result != BOLAN_OK) clouds_free(c);
    return result;
}

bolan_result clouds_reload(clouds *c) {
    c->filled = c->noise_filled = false;
    bolan_result result = gl_program_reload(&c->noise_program);
    if (result == BOLAN_OK) result = gl_program_reload(&c->panorama_program);
    if (result == BOLAN_OK) result = gl_program_reload(&c->shadow_program);
    return result;
}

// A deck of stratocumulus is thinner than heaped cumulus.
static float layer_thickness(float cover) { return 850.0f - 200.0f * cover * cover; }

// Value that the billows exceed over the share `cover` of the sky: their distribution, measured, is near normal.
static float billow_threshold(float cover) {
    const double p = fmin(fmax(1.0 - (double)cover, 0.001), 0.999);
    const double quantile = log(p / (1.0 - p)) / 1.702; // of the normal distribution, within 0.1
    return (float)(0.488 + (quantile > 0.0 ? 0.100 : 0.112) * quantile);
}

// How far the eye may move before the panorama is wrong by more than one sees: a part of the distance to the clouds.
static double allowed_shift(const clouds *c, const frame *f) { return fmax(150.0, 0.12 * fabs((double)c->base - f->eye.z)); }

static bool is_stale(const clouds *c, const frame *f, const frame_uniforms *u) {
    if (!c->filled || c->quality != f->quality) return true;
    if (u->wind.w != c->cover || u->haze.y != c->base || u->haze.x != c->visibility || f->scene->sky.cloud_seed != c->seed) return true;
    const double dx = f->eye.x - c->eye.x, dy = f->eye.y - c->eye.y, dz = f->eye.z - c->eye.z;
    const bolan_vec3 turned = bolan_v3_sub(f->sun_direction, c->sun);
    const bool moved = dx * dx + dy * dy + dz * dz > pow(allowed_shift(c, f), 2.0);
    if (c->cover <= 0.0f) return false;
    return moved || bolan_v3_dot(turned, turned) > 0.01f * 0.01f || fabsf(u->air.x / c->unit - 1.0f) > 0.05f;
}

bool clouds_place(clouds *c, const frame *f, frame_uniforms *u) {
    const bool stale = is_stale(c, f, u);
    if (stale) {
        c->eye = f->eye;
        c->sun = f->sun_direction;
        c->seed = f->scene->sky.cloud_seed;
        c->cover = u->wind.w;
        c->base = u->haze.y;
        c->visibility = u->haze.x;
        c->unit = u->air.x;
        c->above = u->eye.z > u->haze.y;
    }
    u->air.x = c->cover > 0.0f ? c->unit : u->air.x;
    u->air.y = c->above ? 1.0f : 0.0f;
    u->air.z = (float)(f->eye.x - c->eye.x);
    u->air.w = (float)(f->eye.y - c->eye.y);
    return stale;
}

static void fill_noise(clouds *c) {
    const gl_texture *color = &c->noise;
    for (int i = 0; i < NOISE_SIZE; i++) {
        gl_target slice = {0};
        if (gl_target_create(&color, 1, NULL, i, 0, &slice) != BOLAN_OK) return;
        gl_target_bind(&slice);
        gl_program_float(&c->noise_program, "slice", ((float)i + 0.5f) / (float)NOISE_SIZE);
        gl_draw_fullscreen();
        gl_target_free(&slice);
    }
    gl_texture_generate_mipmaps(&c->noise);
    c->noise_filled = true;
}

static double wrap(double x) { return x - PATTERN * floor(x / PATTERN); }

static void set_origin(const clouds *c, const gl_program *program) {
    // Another seed is another place in the pattern: steps by irrational shares never meet.
    const double s = (double)(c->seed % 65536u);
    const double x = wrap(c->eye.x + PATTERN * 0.7548776662466927 * s), y = wrap(c->eye.y + PATTERN * 0.5698402909980532 * s);
    gl_program_vec4(program, "cloud_origin", (bolan_vec4){(float)x, (float)y, layer_thickness(c->cover), billow_threshold(c->cover)});
}

static void clear(const clouds *c) {
    gl_target_bind(&c->panorama_target);
    gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    gl_target_bind(&c->shadow_target);
    gl_target_clear_color(1.0f, 1.0f, 1.0f, 1.0f);
}

void clouds_march(clouds *c, const frame *f) {
    if (c->map.width != panorama_size[f->quality].width && create_map(c, f->quality) != BOLAN_OK) return;
    c->quality = f->quality;
    c->filled = true;
    if (c->cover <= 0.0f) {
        clear(c);
        return;
    }
    if (!c->noise_filled) fill_noise(c);
    gl_texture_bind(&c->noise, UNIT_SCENE_COLOR);
    gl_target_bind(&c->panorama_target);
    set_origin(c, &c->panorama_program);
    gl_program_float(&c->panorama_program, "texel_angle", (float)(2.0 * BOLAN_PI / (double)c->map.width));
    gl_draw_fullscreen();
    gl_target_bind(&c->shadow_target);
    set_origin(c, &c->shadow_program);
    gl_program_float(&c->shadow_program, "shadow_size", SHADOW_SIZE);
    gl_draw_fullscreen();
}

void clouds_free(clouds *c) {
    gl_target_free(&c->panorama_target);
    gl_target_free(&c->shadow_target);
    gl_texture_free(&c->map);
    gl_texture_free(&c->noise);
    gl_program_free(&c->noise_program);
    gl_program_free(&c->panorama_program);
    gl_program_free(&c->shadow_program);
}
