// SPDX-License-Identifier: MIT
// bolan-bench frame: what a picture costs, pass by pass, and as a ratio to a full-screen pass of 6 bilinear look-ups of
// the same size in the same run.
#include "bench.h"

#include "bolan/io.h"
#include "bolan/render.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP 4 // frames that pay for compilation, allocation and caches
#define FRAMES 15 // of which the median is taken, in a row without and one with the passes timed
#define TICK (1.0 / 30.0)
#define YARDSTICK_REPEATS 10
#define SCENES_MAX 16

typedef struct frame_options {
    bool json;
    uint32_t width, height, threads;
    bolan_quality quality;
    const char *scenes[SCENES_MAX];
    uint32_t scene_count;
} frame_options;

typedef struct frame_figures {
    char scene[BOLAN_NAME_MAX];
    const char *technique;
    uint32_t triangles, water_triangles;
    double ms;
    uint32_t pass_count;
    struct {
        const char *name;
        double ms;
    } passes[BOLAN_MAX_PASSES + 1];
} frame_figures;

typedef struct stage {
    bolan_scene scene;
    bolan_scene_assets assets;
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_target *target;
    uint32_t width, height;
    double time;
} stage;

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double *values, size_t count) {
    double sorted[FRAMES];
    memcpy(sorted, values, count * sizeof sorted[0]);
    qsort(sorted, count, sizeof sorted[0], ascending);
    return sorted[count / 2];
}

// ---- measuring ------------------------------------------------------------------------------------------------------

static double step_sea(stage *s) {
    double start = bench_now_ms();
    s->time += TICK;
    bolan_sea_step(s->sea, s->time);
    return bench_now_ms() - start;
}

static void draw(stage *s) {
    bolan_frame_desc frame = bolan_frame_desc_default();
    frame.scene = &s->scene;
    frame.sea = s->sea;
    frame.terrain = s->assets.terrain;
    frame.tiles = s->assets.tiles;
    frame.models = s->assets.object_models;
    frame.framebuffer = bolan_target_framebuffer(s->target);
    frame.width = s->width;
    frame.height = s->height;
    bolan_renderer_draw(s->renderer, &frame);
    uint8_t pixel[3]; // to read one pixel is to wait for all of them
    bolan_renderer_read_rgb8(s->renderer, frame.framebuffer, 1, 1, pixel);
}

static double time_frames(stage *s) {
    double ms[FRAMES];
    for (int i = 0; i < WARM_UP + FRAMES; ++i) {
        double start = bench_now_ms();
        step_sea(s);
        draw(s);
        if (i >= WARM_UP) ms[i - WARM_UP] = bench_now_ms() - start;
    }
    return median(ms, FRAMES);
}

// In a row of its own: timing a pass makes the GPU wait between passes.
static void time_passes(stage *s, frame_figures *f) {
    double ms[BOLAN_MAX_PASSES + 1][FRAMES];
    bolan_frame_statistics statistics = {0};
    bolan_renderer_measure_passes(s->renderer, true);
    for (int i = 0; i < WARM_UP + FRAMES; ++i) {
        double synthesis = step_sea(s);
        draw(s);
        statistics = bolan_renderer_statistics(s->renderer);
        if (i < WARM_UP) continue;
        ms[0][i - WARM_UP] = synthesis;
        for (uint32_t p = 0; p < statistics.pass_count; ++p) ms[p + 1][i - WARM_UP] = statistics.passes[p].ms;
    }
    bolan_renderer_measure_passes(s->renderer, false);
    f->triangles = statistics.triangles;
    f->water_triangles = statistics.water_triangles;
    f->pass_count = statistics.pass_count + 1;
    for (uint32_t p = 0; p < f->pass_count; ++p) {
        f->passes[p].name = p == 0 ? "synthesis" : statistics.passes[p - 1].name;
        f->passes[p].ms = median(ms[p], FRAMES);
    }
}

static void stage_close(stage *s) {
    bolan_target_destroy(&s->target);
    bolan_renderer_destroy(&s->renderer);
    bolan_sea_destroy(&s->sea);
    bolan_scene_assets_destroy(&s->assets);
}

static bolan_result stage_open(stage *s, const char *name, const frame_options *o) {
    *s = (stage){.width = o->width, .height = o->height};
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = o->quality;
    bolan_result result = bolan_scene_load(name, &s->scene);
    if (result == BOLAN_OK) result = bolan_scene_assets_load(&s->scene, &s->assets);
    if (result == BOLAN_OK) result = bolan_scene_create_sea(&s->scene, &s->assets, &s->sea);
    if (result == BOLAN_OK) result = bolan_renderer_create(&desc, &s->renderer);
    if (result == BOLAN_OK) result = bolan_target_create(s->width, s->height, &s->target);
    if (result != BOLAN_OK) {
        stage_close(s);
        return result;
    }
    s->time = s->scene.time;
    bolan_sea_settle(s->sea, s->time);
    return BOLAN_OK;
}

static bolan_result measure(const char *name, const frame_options *o, frame_figures *f, double *yardstick) {
    stage s;
    bolan_result result = stage_open(&s, name, o);
    if (result != BOLAN_OK) return result;
    *f = (frame_figures){.technique = s.scene.technique.name};
    memcpy(f->scene, s.scene.name, sizeof f->scene);
    if (*yardstick == 0.0) *yardstick = bolan_renderer_yardstick(s.renderer, o->width, o->height, YARDSTICK_REPEATS);
    f->ms = time_frames(&s);
    time_passes(&s, f);
    stage_close(&s);
    return BOLAN_OK;
}

// ---- printing -------------------------------------------------------------------------------------------------------

static void print_json(const frame_options *o, const frame_figures *figures, double yardstick) {
    printf("{\n  \"machine\": \"%s\",\n  \"renderer\": \"%s\",\n  \"threads\": %u,\n  \"yardstick_ms\": %.3f,\n  "
           "\"frame\": [",
           bench_machine(), bolan_gl_get_info().renderer, bolan_threads(), yardstick);
    for (uint32_t i = 0; i < o->scene_count; ++i) {
        const frame_figures *f = &figures[i];
        printf("%s\n    {\"scene\": \"%s\", \"technique\": \"%s\", \"width\": %u, \"height\": %u, \"triangles\": %u, "
               "\"water_triangles\": %u, \"ms\": %.3f, \"fps\": %.2f, \"ratio\": %.3f,\n     \"passes\": {",
               i > 0 ? "," : "", f->scene, f->technique, o->width, o->height, f->triangles, f->water_triangles, f->ms,
               1e3 / f->ms, f->ms / yardstick);
        for (uint32_t p = 0; p < f->pass_count; ++p)
            printf("%s\"%s\": %.3f", p > 0 ? ", " : "", f->passes[p].name, f->passes[p].ms);
        printf("}}");
    }
    printf("\n  ]\n}\n");
}

static void print_table(const frame_options *o, const frame_figures *figures, double yardstick) {
    printf("%s, %s, %u threads, %u x %u\n", bench_machine(), bolan_gl_get_info().renderer, bolan_threads(), o->width,
           o->height);
    printf("yardstick (6 bilinear look-ups a pixel): %.2f ms\n\n", yardstick);
    printf("%-12s %-10s %10s %9s %8s %7s %6s\n", "scene", "technique", "triangles", "water", "ms", "fps", "ratio");
    for (uint32_t i = 0; i < o->scene_count; ++i) {
        const frame_figures *f = &figures[i];
        printf("%-12s %-10s %10u %9u %8.2f %7.1f %6.2f\n", f->scene, f->technique, f->triangles, f->water_triangles,
               f->ms, 1e3 / f->ms, f->ms / yardstick);
    }
    printf("\npasses [ms]");
    for (uint32_t p = 0; p < figures[0].pass_count; ++p) printf(" %11s", figures[0].passes[p].name);
    for (uint32_t i = 0; i < o->scene_count; ++i) {
        printf("\n%-11s", figures[i].scene);
        for (uint32_t p = 0; p < figures[i].pass_count; ++p) printf(" %11.2f", figures[i].passes[p].ms);
    }
    printf("\n");
}

// ---- the command ----------------------------------------------------------------------------------------------------

static int usage(const char *why, const char *what) {
    fprintf(stderr,
            "bolan-bench frame: %s: %s\n"
            "usage: frame [--json] [--size WxH] [--quality low|medium|high|ultra] [--threads N] [SCENE...]\n",
            why, what);
    return 2;
}

static bool parse_size(const char *text, frame_options *o) {
    char rest = '\0';
    return sscanf(text, "%5ux%5u%c", &o->width, &o->height, &rest) == 2 && o->width >= 1 && o->width <= 16384 &&
           o->height >= 1 && o->height <= 16384;
}

static bool parse_threads(const char *text, frame_options *o) {
    char rest = '\0';
    return sscanf(text, "%3u%c", &o->threads, &rest) == 1 && o->threads <= 64;
}

static bool parse_quality(const char *text, frame_options *o) {
    static const char *const names[] = {"low", "medium", "high", "ultra"};
    for (int i = 0; i < 4; ++i)
        if (strcmp(text, names[i]) == 0) {
            o->quality = (bolan_quality)i;
            return true;
        }
    return false;
}

static int parse(int argc, char **argv, frame_options *o) {
    for (int i = 1; i < argc; ++i) {
        const char *word = argv[i], *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(word, "--json") == 0) {
            o->json = true;
        } else if (strcmp(word, "--size") == 0) {
            if (!parse_size(value, o)) return usage("--size expects WIDTHxHEIGHT", value);
            ++i;
        } else if (strcmp(word, "--quality") == 0) {
            if (!parse_quality(value, o)) return usage("--quality expects low, medium, high or ultra", value);
            ++i;
        } else if (strcmp(word, "--threads") == 0) {
            if (!parse_threads(value, o)) return usage("--threads expects 0 (one per processor) to 64", value);
            ++i;
        } else if (word[0] == '-') {
            return usage("unknown option", word);
        } else if (o->scene_count == SCENES_MAX) {
            return usage("too many scenes from here", word);
        } else {
            o->scenes[o->scene_count++] = word;
        }
    }
    return 0;
}

int bench_frame(int argc, char **argv) {
    frame_options o = {.width = 1024, .height = 768, .quality = BOLAN_QUALITY_MEDIUM};
    int status = parse(argc, argv, &o);
    if (status != 0) return status;
    if (o.scene_count == 0) {
        static const char *const usual[] = {"island", "open-sea", "storm"};
        for (size_t i = 0; i < sizeof usual / sizeof usual[0]; ++i) o.scenes[o.scene_count++] = usual[i];
    }
    bolan_set_threads(o.threads);
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 1;
    frame_figures figures[SCENES_MAX];
    double yardstick = 0.0;
    for (uint32_t i = 0; i < o.scene_count && status == 0; ++i)
        if (measure(o.scenes[i], &o, &figures[i], &yardstick) != BOLAN_OK) status = 1;
    if (status == 0) (o.json ? print_json : print_table)(&o, figures, yardstick);
    bolan_context_destroy(&context);
    return status;
}
