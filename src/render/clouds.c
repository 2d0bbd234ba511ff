// SPDX-License-Identifier: MIT
// Keeps the cloud panorama and the shadow map: noise once, both maps again when the eye or the sun has moved.
#include "clouds.h"

#include <math.h>
#include <string.h>

enum { NOISE_SIZE = 64 };
static const double PATTERN =
    57600.0 * 16.0; // every tile of common/clouds.glsl divides it [m] but for cirrus, which is far
static const float SHADOW_SIZE = 100000.0f; // CLOUD_SHADOW_SIZE of common/atmosphere.glsl [m]

static const struct {
    uint32_t width, height;
} panorama_size[] = {
    [BOLAN_QUALITY_LOW] = {1024, 256},
    [BOLAN_QUALITY_MEDIUM] = {1536, 384},
    [BOLAN_QUALITY_HIGH] = {2048, 512},
    [BOLAN_QUALITY_ULTRA] = {4096, 768},
};

static void free_maps(cloud_maps *m) {
    gl_target_free(&m->panorama);
    gl_target_free(&m->shadow);
    gl_texture_free(&m->map);
}

// From above, clouds are seen against the sea from near to far: their map is one quality finer.
static bolan_result create_maps(cloud_maps *m, bolan_quality quality) {
    const int size = m->above && quality < BOLAN_QUALITY_ULTRA ? quality + 1 : quality;
    const uint32_t width = panorama_size[size].width, height = panorama_size[size].height;
    if (m->map.id && m->map.width == width) return BOLAN_OK;
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F,
                               .width = width,
                               .height = height,
                               .depth = 2,
                               .array = true,
                               .filter = GL_FILTER_LINEAR,
                               .wrap = GL_WRAP_REPEAT_CLAMP};
    free_maps(m);
    const gl_texture *color = &m->map;
    bolan_result result = gl_texture_create(&d, &m->map);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 0, 0, &m->panorama);
    if (result == BOLAN_OK) result = gl_target_create(&color, 1, NULL, 1, 0, &m->shadow);
    return result;
}

bolan_result clouds_create(clouds *c) {
    memset(c, 0, sizeof *c);
    const gl_texture_desc noise = {.format = GL_FMT_RGBA8,
                                   .width = NOISE_SIZE,
                                   .height = NOISE_SIZE,
                                   .depth = NOISE_SIZE,
                                   .filter = GL_FILTER_MIPMAP_NEAREST,
                                   .wrap = GL_WRAP_REPEAT};
    bolan_result result = gl_program_create("cloud_noise", NULL, &c->noise_program);
    if (result == BOLAN_OK) result = gl_program_create("cloud_panorama", NULL, &c->panorama_program);
    if (result == BOLAN_OK) result = gl_program_create("cloud_shadow", NULL, &c->shadow_program);
    if (result == BOLAN_OK) result = gl_texture_create(&noise, &c->noise);
    for (int i = 0; i < 2 && result == BOLAN_OK; i++) result = create_maps(&c->maps[i], BOLAN_QUALITY_LOW);
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

const gl_texture *clouds_map(const clouds *c) { return &c->maps[c->shown].map; }

double clouds_rise(const clouds *c, const frame *f) { return f->eye.z - c->maps[c->shown].eye.z; }

// ---- when ---------------------------------------------------------------------------------------------------------

// A deck of stratocumulus is thinner than heaped cumulus.
static float layer_thickness(float cover) { return 850.0f - 200.0f * cover * cover; }

// Value that the billows exceed over the share `cover` of the sky: their distribution, measured, is near normal.
static float billow_threshold(float cover) {
    const double p = fmin(fmax(1.0 - (double)cover, 0.001), 0.999);
    const double quantile = log(p / (1.0 - p)) / 1.702; // of the normal distribution, within 0.1
    return (float)(0.462 + (quantile > 0.0 ? 0.118 : 0.125) * quantile);
}

// How far the eye may move before the panorama is wrong by more than one sees: a part of the distance to the clouds.
static double allowed_shift(const cloud_maps *m, const frame *f) {
    return fmax(150.0, 0.12 * fabs((double)m->base - f->eye.z));
}

static double shift(const cloud_maps *m, const frame *f) {
    const double dx = f->eye.x - m->eye.x, dy = f->eye.y - m->eye.y, dz = f->eye.z - m->eye.z;
    return sqrt(dx * dx + dy * dy + dz * dz);
}

static double sun_turn(const cloud_maps *m, const frame *f) {
    return (double)bolan_v3_length(bolan_v3_sub(f->sun_direction, m->sun));
}

static bool is_another_sky(const clouds *c, const cloud_maps *m, const frame *f, const frame_uniforms *u) {
    return !c->filled || m->quality != f->quality || m->cover != u->wind.w || m->base != u->haze.y ||
           m->visibility != u->haze.x || m->seed != f->scene->sky.cloud_seed;
}

static bool is_above(const frame_uniforms *u) { return u->eye.z > u->haze.y; }

static void describe(cloud_maps *m, const frame *f, const frame_uniforms *u) {
    m->eye = f->eye;
    m->sun = f->sun_direction;
    m->seed = f->scene->sky.cloud_seed;
    m->cover = u->wind.w;
    m->base = u->haze.y;
    m->visibility = u->haze.x;
    m->unit = u->air.x;
    m->quality = f->quality;
    m->above = is_above(u);
}

void clouds_place(const clouds *c, const frame *f, frame_uniforms *u) {
    const cloud_maps *m = &c->maps[c->shown];
    u->air.y = m->above ? 1.0f : 0.0f;
    u->air.z = (float)(f->eye.x - m->eye.x);
    u->air.w = (float)(f->eye.y - m->eye.y);
}

static void begin_strips(clouds *c, const frame *f, const frame_uniforms *u) {
    describe(&c->maps[c->shown ^ 1], f, u);
    c->uniforms = *u;
    c->uniforms.air.y = is_above(u) ? 1.0f : 0.0f;
    c->uniforms.air.z = c->uniforms.air.w = 0.0f;
    c->strip = 1;
}

cloud_work clouds_plan(clouds *c, const frame *f, frame_uniforms *u) {
    cloud_maps *m = &c->maps[c->shown];
    const double moved = shift(m, f), allowed = allowed_shift(m, f), turned = sun_turn(m, f);
    cloud_work work = CLOUDS_KEEP;
    if (is_another_sky(c, m, f, u) ||
        (m->cover > 0.0f && (m->unit != u->air.x || moved > 8.0 * allowed || turned > 0.1))) {
        describe(m, f, u);
        c->strip = 0;
        work = CLOUDS_ALL;
    } else if (m->cover > 0.0f) {
        if (c->strip == 0 && (moved > allowed || turned > 0.01 || m->above != is_above(u))) begin_strips(c, f, u);
        if (c->strip > 0) work = CLOUDS_STRIP;
    }
    clouds_place(c, f, u);
    return work;
}

// ---- how ----------------------------------------------------------------------------------------------------------

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

static void set_origin(const cloud_maps *m, const gl_program *program) {
    // Another seed is another place in the pattern: steps by irrational shares never meet.
    const double s = (double)(m->seed % 65536u);
    const double x = wrap(m->eye.x + PATTERN * 0.7548776662466927 * s),
                 y = wrap(m->eye.y + PATTERN * 0.5698402909980532 * s);
    gl_program_vec4(program, "cloud_origin",
                    (bolan_vec4){(float)x, (float)y, layer_thickness(m->cover), billow_threshold(m->cover)});
}

static void clear(const cloud_maps *m) {
    gl_target_bind(&m->panorama);
    gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    gl_target_bind(&m->shadow);
    gl_target_clear_color(1.0f, 1.0f, 1.0f, 1.0f);
}

static void draw_strip(const gl_target *target, const gl_program *program, uint32_t index, uint32_t count) {
    const uint32_t from = target->width * index / count, to = target->width * (index + 1) / count;
    const float width = (float)target->width;
    gl_target_bind_part(target, from, 0, to - from, target->height);
    gl_program_vec2(program, "strip", (float)from / width, (float)(to - from) / width);
    gl_draw_fullscreen();
}

static void draw_maps(const clouds *c, const cloud_maps *m, uint32_t index, uint32_t count) {
    gl_texture_bind(&c->noise, UNIT_SCENE_COLOR);
    set_origin(m, &c->panorama_program);
    gl_program_float(&c->panorama_program, "texel_angle", (float)(2.0 * BOLAN_PI / (double)m->map.width));
    draw_strip(&m->panorama, &c->panorama_program, index, count);
    set_origin(m, &c->shadow_program);
    gl_program_float(&c->shadow_program, "shadow_size", SHADOW_SIZE);
    draw_strip(&m->shadow, &c->shadow_program, index, count);
}

bool clouds_march(clouds *c, const frame *f, cloud_work work) {
    if (work == CLOUDS_KEEP) return false;
    cloud_maps *m = &c->maps[work == CLOUDS_ALL ? c->shown : c->shown ^ 1];
    c->filled = true;
    if (create_maps(m, m->quality) != BOLAN_OK) return false;
    if (m->cover <= 0.0f) {
        clear(m);
        return true;
    }
    if (!c->noise_filled) fill_noise(c);
    if (work == CLOUDS_ALL) {
        draw_maps(c, m, 0, 1);
        return true;
    }
    const uint32_t strips =
        f->caps->software ? (m->above ? 64 : 24) : 4; // a wider map, of clouds that are farther away
    draw_maps(c, m, c->strip - 1, strips);
    if (c->strip++ < strips) return false;
    c->strip = 0;
    c->shown ^= 1;
    return true;
}

void clouds_free(clouds *c) {
    free_maps(&c->maps[0]);
    free_maps(&c->maps[1]);
    gl_texture_free(&c->noise);
    gl_program_free(&c->noise_program);
    gl_program_free(&c->panorama_program);
    gl_program_free(&c->shadow_program);
}
