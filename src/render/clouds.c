// SPDX-License-Identifier: MIT
// Keeps the cloud panorama and the shadow map: noise once, both maps again for another place of the eye or the sun.
#include "clouds.h"

#include "sky_lattice.h"

#include <math.h>
#include <string.h>

enum { NOISE_SIZE = 64, WEATHER_SIZE = 128 };
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
    bolan_gl_target_free(&m->panorama);
    bolan_gl_target_free(&m->shadow);
    bolan_gl_texture_free(&m->map);
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
    bolan_result result = bolan_gl_texture_create(&d, &m->map);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, 0, 0, &m->panorama);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, 1, 0, &m->shadow);
    return result;
}

void bolan_clouds_share(clouds *c, const clouds *from) {
    c->borrowed = true;
    c->filled = c->noise_filled = false;
    c->noise_program = from->noise_program;
    c->weather_program = from->weather_program;
    c->panorama_program = from->panorama_program;
    c->shadow_program = from->shadow_program;
}

static bolan_result create_programs(clouds *c) {
    bolan_result result = bolan_gl_program_create("cloud_noise", NULL, &c->noise_program);
    if (result == BOLAN_OK) result = bolan_gl_program_create("cloud_weather", NULL, &c->weather_program);
    if (result == BOLAN_OK) result = bolan_gl_program_create("cloud_panorama", NULL, &c->panorama_program);
    return result == BOLAN_OK ? bolan_gl_program_create("cloud_shadow", NULL, &c->shadow_program) : result;
}

bolan_result bolan_clouds_create(clouds *c, const clouds *from) {
    memset(c, 0, sizeof *c);
    const gl_texture_desc noise = {.format = GL_FMT_RGBA8,
                                   .width = NOISE_SIZE,
                                   .height = NOISE_SIZE,
                                   .depth = NOISE_SIZE,
                                   .filter = GL_FILTER_MIPMAP_NEAREST,
                                   .wrap = GL_WRAP_REPEAT};
    // Half floats: a texture of bytes is interpolated in steps of 1/255, at which clouds would be cut into squares.
    const gl_texture_desc weather = {.format = GL_FMT_RG16F,
                                     .width = WEATHER_SIZE,
                                     .height = WEATHER_SIZE,
                                     .filter = GL_FILTER_LINEAR,
                                     .wrap = GL_WRAP_REPEAT};
    if (from != NULL) bolan_clouds_share(c, from);
    bolan_result result = from != NULL ? BOLAN_OK : create_programs(c);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&noise, &c->noise);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&weather, &c->weather);
    for (int i = 0; i < 2 && result == BOLAN_OK; i++) result = create_maps(&c->maps[i], BOLAN_QUALITY_LOW);
    if (result != BOLAN_OK) bolan_clouds_free(c);
    return result;
}

bolan_result bolan_clouds_reload(clouds *c) {
    c->filled = c->noise_filled = false;
    bolan_result result = bolan_gl_program_reload(&c->noise_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&c->weather_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&c->panorama_program);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&c->shadow_program);
    return result;
}

const gl_texture *bolan_clouds_map(const clouds *c) { return &c->maps[c->shown].map; }

double bolan_clouds_rise(const clouds *c, const render_view *v) { return v->eye.z - c->maps[c->shown].eye.z; }

// ---- when ---------------------------------------------------------------------------------------------------------

// A deck of stratocumulus is thinner than heaped cumulus.
static float layer_thickness(float cover) { return 1350.0f - 700.0f * cover * cover; }

// Value that the billows exceed over the share `cover` of the sky: their distribution, measured, is near normal.
static float billow_threshold(float cover) {
    const double p = fmin(fmax(1.0 - (double)cover, 0.001), 0.999);
    const double quantile = log(p / (1.0 - p)) / 1.702; // of the normal distribution, within 0.1
    return (float)(0.445 + (quantile > 0.0 ? 0.118 : 0.125) * quantile);
}

// How far from the eye a panorama may be made before it is wrong by more than one sees: a part of the distance to the
// clouds.
static double allowed_shift(double base, double height) { return fmax(150.0, 0.12 * fabs(base - height)); }

#define SUN_STEP 0.01 // between suns that clouds are lit by [rad]

static double shift(const cloud_maps *m, const render_view *v) {
    const double dx = v->eye.x - m->eye.x, dy = v->eye.y - m->eye.y, dz = v->eye.z - m->eye.z;
    return sqrt(dx * dx + dy * dy + dz * dz);
}

static double sun_turn(const cloud_maps *m, const render_view *v) {
    return (double)bolan_v3_length(bolan_v3_sub(v->frame->sun_direction, m->sun));
}

// Where on the lattice a map for this eye is made, on the same side of the clouds' base.
static bolan_dvec3 place_of(const render_view *v, double base, bool above) {
    const double margin = 1.0, sea_level = v->frame->level;
    const double octave = floor(log2(allowed_shift(base, v->eye.z - sea_level) / 150.0));
    bolan_dvec3 eye = bolan_sky_lattice_point(v->eye, 150.0 * exp2(octave));
    eye.z = above ? fmax(eye.z, sea_level + base + margin) : fmin(eye.z, sea_level + base - margin);
    return eye;
}

// Everything that a pair of maps depends on. An empty sky is the same from everywhere.
static void describe(cloud_maps *m, const render_view *v) {
    const frame_block *f = &v->frame->block;
    m->seed = v->frame->lighting.sky.cloud_seed;
    m->cover = f->cloud_cover;
    m->base = f->cloud_base;
    m->visibility = f->visibility;
    m->quality = v->frame->quality;
    m->above = v->block.eye_height > f->cloud_base;
    m->unit = m->cover > 0.0f ? f->radiance_unit : 0.0f;
    m->sun = m->cover > 0.0f ? bolan_sky_lattice_direction(v->frame->sun_direction, SUN_STEP) : (bolan_vec3){0};
    m->eye = m->cover > 0.0f ? place_of(v, (double)m->base, m->above) : (bolan_dvec3){0};
}

static bool is_another_sky(const cloud_maps *a, const cloud_maps *b) {
    return a->quality != b->quality || a->cover != b->cover || a->base != b->base || a->visibility != b->visibility ||
           a->seed != b->seed || a->unit != b->unit;
}

static bool is_same(const cloud_maps *a, const cloud_maps *b) {
    return !is_another_sky(a, b) && a->above == b->above && a->eye.x == b->eye.x && a->eye.y == b->eye.y &&
           a->eye.z == b->eye.z && a->sun.x == b->sun.x && a->sun.y == b->sun.y && a->sun.z == b->sun.z;
}

void bolan_clouds_place(const clouds *c, render_view *v) {
    const cloud_maps *m = &c->maps[c->shown];
    const bool any = m->cover > 0.0f;
    v->light.above_clouds = m->above;
    v->light.cloud_offset =
        (bolan_vec2){any ? (float)(v->eye.x - m->eye.x) : 0.0f, any ? (float)(v->eye.y - m->eye.y) : 0.0f};
}

// The frame as an eye at the maps' own place and under their own sun sees it.
static void set_uniforms(clouds *c, const cloud_maps *m, const render_view *v) {
    c->uniforms = (block_values){.frame = v->frame->block, .view = v->block};
    c->uniforms.view.eye_height = (float)fmax(m->eye.z - v->frame->level, 0.0);
    c->uniforms.frame.sun_direction = m->sun;
    c->uniforms.view.eye_above_clouds = m->above ? 1.0f : 0.0f;
    c->uniforms.view.cloud_offset.x = c->uniforms.view.cloud_offset.y = 0.0f;
}

cloud_work bolan_clouds_plan(clouds *c, const render_view *v) {
    cloud_maps *shown = &c->maps[c->shown], *made = &c->maps[c->shown ^ 1], wanted = *shown;
    describe(&wanted, v);
    const bool fits = c->filled && is_same(shown, &wanted), gradual = v->progressive;
    if (fits && !(gradual && c->strip > 0)) {
        c->strip = 0;
        return CLOUDS_KEEP;
    }
    const bool jump = !c->filled || is_another_sky(shown, &wanted) || sun_turn(shown, v) > 0.1 ||
                      shift(shown, v) > 8.0 * allowed_shift((double)shown->base, shown->eye.z - v->frame->level);
    if (jump || !gradual) {
        *shown = wanted;
        set_uniforms(c, shown, v);
        c->strip = 0;
        return CLOUDS_ALL;
    }
    if (c->strip == 0) {
        describe(made, v);
        set_uniforms(c, made, v);
        c->strip = 1;
    }
    return CLOUDS_STRIP;
}

// ---- how ----------------------------------------------------------------------------------------------------------

static void fill_weather(clouds *c) {
    const gl_texture *color = &c->weather;
    gl_target whole = {0};
    if (bolan_gl_target_create(&color, 1, NULL, -1, 0, &whole) != BOLAN_OK) return;
    bolan_gl_target_bind(&whole);
    bolan_gl_program_use(&c->weather_program);
    bolan_gl_draw_fullscreen();
    bolan_gl_target_free(&whole);
}

static void fill_noise(clouds *c) {
    const gl_texture *color = &c->noise;
    for (int i = 0; i < NOISE_SIZE; i++) {
        gl_target slice = {0};
        if (bolan_gl_target_create(&color, 1, NULL, i, 0, &slice) != BOLAN_OK) return;
        bolan_gl_target_bind(&slice);
        bolan_gl_program_float(&c->noise_program, "slice", ((float)i + 0.5f) / (float)NOISE_SIZE);
        bolan_gl_draw_fullscreen();
        bolan_gl_target_free(&slice);
    }
    bolan_gl_texture_generate_mipmaps(&c->noise);
    fill_weather(c);
    c->noise_filled = true;
}

static double wrap(double x) { return x - PATTERN * floor(x / PATTERN); }

static void set_origin(const cloud_maps *m, const gl_program *program) {
    // Another seed is another place in the pattern: steps by irrational shares never meet.
    const double s = (double)(m->seed % 65536u);
    const double x = wrap(m->eye.x + PATTERN * 0.7548776662466927 * s),
                 y = wrap(m->eye.y + PATTERN * 0.5698402909980532 * s);
    bolan_gl_program_vec4(program, "cloud_origin",
                          (bolan_vec4){(float)x, (float)y, layer_thickness(m->cover), billow_threshold(m->cover)});
}

static void clear(const cloud_maps *m) {
    bolan_gl_target_bind(&m->panorama);
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    bolan_gl_target_bind(&m->shadow);
    bolan_gl_target_clear_color(1.0f, 1.0f, 1.0f, 1.0f);
}

static void draw_strip(const gl_target *target, const gl_program *program, uint32_t index, uint32_t count) {
    const uint32_t from = target->width * index / count, to = target->width * (index + 1) / count;
    const float width = (float)target->width;
    bolan_gl_target_bind_part(target, from, 0, to - from, target->height);
    bolan_gl_program_vec2(program, "strip", (float)from / width, (float)(to - from) / width);
    bolan_gl_draw_fullscreen();
}

static void draw_maps(const clouds *c, const cloud_maps *m, uint32_t index, uint32_t count) {
    bolan_gl_texture_bind(&c->noise, UNIT_OWN + 1);
    bolan_gl_texture_bind(&c->weather, UNIT_OWN + 2);
    set_origin(m, &c->panorama_program);
    bolan_gl_program_float(&c->panorama_program, "texel_angle", (float)(2.0 * BOLAN_PI / (double)m->map.width));
    draw_strip(&m->panorama, &c->panorama_program, index, count);
    set_origin(m, &c->shadow_program);
    bolan_gl_program_float(&c->shadow_program, "shadow_size", SHADOW_SIZE);
    draw_strip(&m->shadow, &c->shadow_program, index, count);
}

bool bolan_clouds_march(clouds *c, const render_view *v, cloud_work work) {
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
        v->frame->caps->software ? (m->above ? 64 : 24) : 4; // a wider map, of clouds that are farther away
    draw_maps(c, m, c->strip - 1, strips);
    if (c->strip++ < strips) return false;
    c->strip = 0;
    c->shown ^= 1;
    return true;
}

void bolan_clouds_free(clouds *c) {
    free_maps(&c->maps[0]);
    free_maps(&c->maps[1]);
    bolan_gl_texture_free(&c->noise);
    bolan_gl_texture_free(&c->weather);
    if (c->borrowed) return;
    bolan_gl_program_free(&c->noise_program);
    bolan_gl_program_free(&c->weather_program);
    bolan_gl_program_free(&c->panorama_program);
    bolan_gl_program_free(&c->shadow_program);
}
