// SPDX-License-Identifier: MIT
// Small pictures for tests: draw a scene, compare two pictures, and write a report with both and their difference.
#ifndef BOLAN_TESTS_PICTURE_H
#define BOLAN_TESTS_PICTURE_H

#include "../gl_watch.h"
#include "bolan/io.h"
#include "bolan/render.h"
#include "need_gl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct picture {
    uint32_t width, height;
    uint8_t *rgb;
    float *distance;
} picture;

static inline void picture_free(picture *p) {
    free(p->rgb);
    free(p->distance);
    *p = (picture){0};
}

static const char
    *stage_shaders; // the folder that the renderers of stages take their shaders from; NULL: the built-in ones

static bolan_backend stage_backend; // of the renderers of stages; default auto
static bolan_pixels stage_pixels;   // likewise

// A world and a renderer; the context must be current. The world takes over `scene`, which a test may change, before it
// is drawn.
typedef struct stage {
    bolan_scene scene;
    bolan_world *world;
    bolan_renderer *renderer;
    bool progressive; // as a window is drawn: see bolan_view
} stage;

static inline const bolan_sea *stage_sea(const stage *s) { return bolan_world_water(s->world)->sea; }
static inline const bolan_ground *stage_ground(const stage *s) { return bolan_world_water(s->world)->ground; }
static inline void stage_step(stage *s, double time) { bolan_world_step(s->world, time); }
static inline void stage_settle(stage *s, double time) { bolan_world_settle(s->world, time); }

// Puts another world in the place of the present one, stepped to the scene's time.
static inline bool stage_load(stage *s, const bolan_scene *scene) {
    bolan_world_destroy(&s->world);
    s->scene = *scene;
    return bolan_world_load_scene(scene, &s->world) == BOLAN_OK;
}

// The same with the waves and the foam of that time; the renderer stays, and with it what takes long to make.
static inline void stage_settle_scene(stage *s, const bolan_scene *scene) {
    assert_true(stage_load(s, scene));
    stage_settle(s, scene->time);
}

static inline bool stage_open(stage *s, const bolan_scene *scene, bolan_quality quality, bool no_clip_control) {
    watch_begin();
    *s = (stage){.world = NULL};
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = quality;
    desc.no_clip_control = no_clip_control;
    desc.shader_directory = stage_shaders;
    desc.backend = stage_backend;
    desc.pixels = stage_pixels;
    if (!stage_load(s, scene)) return false;
    stage_settle(s, scene->time);
    return bolan_renderer_create(&desc, &s->renderer) == BOLAN_OK;
}

static inline void stage_close(stage *s) {
    bolan_renderer_destroy(&s->renderer);
    bolan_world_destroy(&s->world);
    assert_true(watch_is_clean("at the end of a stage"));
}

// The scene over a level bed at that elevation [m], with its object, a file, if it has one.
static inline void stage_over_bed(stage *s, const bolan_scene *scene, float elevation) {
    static float heights[16];
    for (int i = 0; i < 16; ++i) heights[i] = elevation;
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){4, 4, -150.0, -150.0, 100.0, 100.0, heights};
    d.detail = 0.0;
    d.edge_elevation = (double)elevation;
    bolan_ground *ground = NULL;
    assert_int_equal(bolan_ground_create(&d, &ground), BOLAN_OK);
    bolan_world_assets assets = {.ground = ground, .model_count = scene->object_count};
    assert_true(scene->object_count <= 1);
    if (scene->object_count == 1) {
        const bolan_model_desc model = {.path = scene->objects[0].model};
        assert_int_equal(bolan_model_load(&model, &assets.models[0]), BOLAN_OK);
        assets.object_models[0] = assets.models[0];
    }
    bolan_world_destroy(&s->world);
    s->scene = *scene;
    assert_int_equal(bolan_world_create(&(bolan_world_desc){scene, &assets}, &s->world), BOLAN_OK);
    stage_settle(s, scene->time);
}

// Gives the world the scene as the test has changed it.
static inline void stage_update(stage *s) { assert_int_equal(bolan_world_set_scene(s->world, &s->scene), BOLAN_OK); }

// The view of the stage's camera; the eye keeps clear of the water.
static inline bolan_view stage_view(stage *s, const bolan_target *target, uint32_t width, uint32_t height) {
    stage_update(s);
    bolan_view view = bolan_view_from_camera(&s->scene.camera, width, height);
    view.eye = bolan_world_clear_eye(s->world, view.eye);
    view.framebuffer = bolan_target_framebuffer(target);
    view.progressive = s->progressive;
    return view;
}

static inline picture stage_draw(stage *s, uint32_t width, uint32_t height, uint32_t samples) {
    picture p = {width, height, malloc((size_t)width * height * 3), malloc(sizeof(float) * width * height)};
    bolan_target *target = NULL;
    if (bolan_target_create(width, height, &target) != BOLAN_OK) return p;
    bolan_view view = stage_view(s, target, width, height);
    view.samples = samples;
    bolan_renderer_draw_world(s->renderer, s->world, &view);
    bolan_renderer_read_rgb8(s->renderer, view.framebuffer, width, height, p.rgb);
    bolan_renderer_read_linear(s->renderer, NULL, p.distance);
    bolan_target_destroy(&target);
    assert_true(watch_is_clean("after a picture"));
    return p;
}

// Draws once more, closes the stage and returns the radiance, as stage_radiance() does.
static inline float *stage_last_radiance(stage *s, uint32_t width, uint32_t height) {
    picture p = stage_draw(s, width, height, 1);
    float *rgb = malloc(sizeof(float) * 3 * width * height);
    bolan_renderer_read_linear(s->renderer, rgb, NULL);
    picture_free(&p);
    stage_close(s);
    return rgb;
}

// Radiance of a scene at high quality, three floats a pixel, the top row first; the caller frees it.
static inline float *stage_radiance(const bolan_scene *scene, uint32_t width, uint32_t height) {
    stage s;
    assert_true(stage_open(&s, scene, BOLAN_QUALITY_HIGH, false));
    return stage_last_radiance(&s, width, height);
}

// Peak signal-to-noise ratio of two pictures after a 2 x 2 average [dB]: one pixel of antialiasing does not count,
// colour, shape and place do.
static inline double picture_psnr(const picture *a, const picture *b) {
    double sum = 0;
    size_t n = 0;
    for (uint32_t y = 0; y + 1 < a->height; y += 2)
        for (uint32_t x = 0; x + 1 < a->width; x += 2)
            for (uint32_t c = 0; c < 3; ++c, ++n) {
                double d = 0;
                for (uint32_t k = 0; k < 4; ++k) {
                    size_t i = 3 * ((size_t)(y + k / 2) * a->width + x + k % 2) + c;
                    d += (double)a->rgb[i] - b->rgb[i];
                }
                sum += d * d / 16.0;
            }
    return 10.0 * log10(255.0 * 255.0 * (double)n / (sum + 1e-9));
}

// Appends a failed comparison to report/index.html in the working folder.
static inline void picture_report(const char *name, const picture *expected, const picture *got, double psnr,
                                  double wanted) {
    mkdir("report", 0777);
    char path[256];
    size_t bytes = (size_t)got->width * got->height * 3;
    uint8_t *difference = malloc(bytes);
    for (size_t i = 0; i < bytes; ++i) {
        int d = 4 * abs((int)expected->rgb[i] - (int)got->rgb[i]);
        difference[i] = (uint8_t)(d > 255 ? 255 : d);
    }
    const struct {
        const char *suffix;
        const uint8_t *rgb;
    } parts[] = {{"expected", expected->rgb}, {"got", got->rgb}, {"difference", difference}};
    for (int i = 0; i < 3; ++i) {
        snprintf(path, sizeof path, "report/%s_%s.png", name, parts[i].suffix);
        bolan_png_write(path, got->width, got->height, parts[i].rgb);
    }
    free(difference);
    FILE *html = fopen("report/index.html", "a");
    if (html == NULL) return;
    fprintf(html, "<h2>%s: %.1f dB, wanted %.1f</h2><table><tr><th>expected<th>got<th>difference x4<tr>", name, psnr,
            wanted);
    for (int i = 0; i < 3; ++i) fprintf(html, "<td><img src=\"%s_%s.png\">", name, parts[i].suffix);
    fprintf(html, "</table>\n");
    fclose(html);
    char cwd[512];
    if (getcwd(cwd, sizeof cwd) != NULL) fprintf(stderr, "%s differs: see %s/report/index.html\n", name, cwd);
}

#endif
