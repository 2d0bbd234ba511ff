// SPDX-License-Identifier: MIT
// What tests against a path tracer need: a copy of the shaders without gusts and with a plain sea bed, the share of
// light that the air lets through, and a studio that draws a view of the reference as radiance at the sea.
#ifndef BOLAN_TESTS_TRACED_LIGHT_H
#define BOLAN_TESTS_TRACED_LIGHT_H

#include "picture.h"

#include "../reference/views.h"

#include <dirent.h>

// ---- shaders without gusts, whose bed is plain ---------------------------------------------------------------------

static inline void link_folder(const char *from, const char *to, const char *but) {
    DIR *folder = opendir(from);
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        const size_t length = strlen(entry->d_name);
        if (length < 5 || strcmp(entry->d_name + length - 5, ".glsl") != 0 || strcmp(entry->d_name, but) == 0) continue;
        char target[1024], path[1024];
        snprintf(target, sizeof target, "%s/%s", from, entry->d_name);
        snprintf(path, sizeof path, "%s/%s", to, entry->d_name);
        assert_int_equal(symlink(target, path), 0);
    }
    closedir(folder);
}

static inline void empty_folder(const char *path) {
    DIR *folder = opendir(path);
    for (struct dirent *entry; folder != NULL && (entry = readdir(folder)) != NULL;) {
        char file[1024];
        snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
        unlink(file);
    }
    if (folder != NULL) closedir(folder);
    rmdir(path);
}

// Writes ground.glsl with a bed of one albedo, which is as bright from all sides.
static inline void make_bed(const char *folder) {
    static const char before[] = "    // The gradients of the billows as bumps";
    static char text[1 << 16];
    char path[512];
    FILE *from = fopen(BOLAN_SOURCE_DIR "/shaders/ground.glsl", "r");
    assert_non_null(from);
    text[fread(text, 1, sizeof text - 1, from)] = '\0';
    fclose(from);
    char *rest = strstr(text, before);
    assert_non_null(rest);
    snprintf(path, sizeof path, "%s/ground.glsl", folder);
    FILE *to = fopen(path, "w");
    assert_non_null(to);
    fprintf(to, "%.*s    m = material(vec3(%g), 0.0, 0.0);\n%s", (int)(rest - text), text, REFERENCE_ALBEDO, rest);
    fclose(to);
}

static inline void make_shaders(char *folder) {
    char common[512];
    assert_non_null(mkdtemp(folder));
    make_bed(folder);
    snprintf(common, sizeof common, "%s/common", folder);
    assert_int_equal(mkdir(common, 0777), 0);
    link_folder(BOLAN_SOURCE_DIR "/shaders", folder, "ground.glsl");
    static const char *const whole[] = {"shared", "papers", "include"};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; ++i) {
        char target[512], path[512];
        snprintf(target, sizeof target, "%s/shaders/%s", BOLAN_SOURCE_DIR, whole[i]);
        snprintf(path, sizeof path, "%s/%s", folder, whole[i]);
        assert_int_equal(symlink(target, path), 0);
    }
    link_folder(BOLAN_SOURCE_DIR "/shaders/common", common, "gusts.glsl");
    snprintf(common, sizeof common, "%s/common/gusts.glsl", folder);
    FILE *file = fopen(common, "w");
    assert_non_null(file);
    fputs("float gustiness(vec2 p, float width) { return 1.0; }\n", file);
    fclose(file);
}

static inline void remove_shaders(const char *folder) {
    char common[512];
    snprintf(common, sizeof common, "%s/common", folder);
    empty_folder(common);
    empty_folder(folder);
}

// ---- air -----------------------------------------------------------------------------------------------------------

// Share of the light that the air lets through, at 650, 550 and 450 nm: Rayleigh's optical depths over the scale
// height, and what haze is left at a visibility of 300 km. The eye is so low that the density is the sea's.
static inline double through_air(int channel, double distance) {
    const double rayleigh[3] = {0.049184 / 8000, 0.097070 / 8000, 0.221110 / 8000}, haze[3] = {1.78e-6, 2e-6, 2.3e-6};
    return exp(-(rayleigh[channel] + haze[channel]) * distance);
}

// ---- studio --------------------------------------------------------------------------------------------------------

typedef struct studio {
    stage s;
    bolan_target *target;
    uint32_t width, height;
    float *rgb, *distance;
} studio;

static inline void open_studio(studio *t, const reference_view *v, uint32_t width, uint32_t height,
                               const char *shaders) {
    const size_t pixels = (size_t)width * height;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_HIGH;
    desc.shader_directory = shaders;
    *t = (studio){.width = width, .height = height};
    t->rgb = malloc(sizeof(float) * 3 * pixels), t->distance = malloc(sizeof(float) * pixels);
    t->s.scene = reference_scene(v);
    assert_true(reference_world(v, &t->s.world));
    assert_int_equal(bolan_renderer_create(&desc, &t->s.renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(width, height, &t->target), BOLAN_OK);
}

static inline void close_studio(studio *t) {
    free(t->rgb), free(t->distance);
    bolan_target_destroy(&t->target);
    stage_close(&t->s);
}

static inline void add_picture(studio *t, uint32_t effects, double weight, double *sum) {
    const double half = tan(bolan_radians(0.5 * REFERENCE_FOV)), width = t->width, height = t->height;
    t->s.scene.look.effects = effects;
    const bolan_view v = stage_view(&t->s, t->target, t->width, t->height);
    bolan_renderer_draw_world(t->s.renderer, t->s.world, &v);
    bolan_renderer_read_linear(t->s.renderer, t->rgb, t->distance);
    for (uint32_t i = 0; i < t->width * t->height; ++i) {
        if (!isfinite(t->distance[i])) continue;
        const double x = (2.0 * (i % t->width + 0.5) - width) / height * half;
        const double y = (1.0 - 2.0 * (i / t->width + 0.5) / height) * half;
        const double d = (double)t->distance[i] * sqrt(1.0 + x * x + y * y);
        for (int c = 0; c < 3; ++c)
            sum[3 * i + (uint32_t)c] += weight * (double)t->rgb[3 * i + (uint32_t)c] / through_air(c, d);
    }
}

// Radiance of these effects as an eye in the water has it. light: width * height * 3.
static inline void draw_under_water(studio *t, uint32_t effects, double *light) {
    t->s.scene.look.effects = effects;
    const bolan_view v = stage_view(&t->s, t->target, t->width, t->height);
    bolan_renderer_draw_world(t->s.renderer, t->s.world, &v);
    bolan_renderer_read_linear(t->s.renderer, t->rgb, t->distance);
    for (uint32_t i = 0; i < 3 * t->width * t->height; ++i) light[i] = (double)t->rgb[i];
}

// Radiance of these effects at the sea: the picture less the one without any light of the sea, which is the air's.
// light: width * height * 3.
static inline void draw_light(studio *t, uint32_t effects, double *light) {
    memset(light, 0, sizeof(double) * 3 * t->width * t->height);
    add_picture(t, effects, 1.0, light);
    add_picture(t, 0, -1.0, light);
}

#endif
