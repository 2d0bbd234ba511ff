// SPDX-License-Identifier: MIT
// See stage.h.
#include "stage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WARM_UP 4 // frames for compilation, allocation and caches
#define FRAMES 15 // of which the median is taken, in a row without and one with the passes timed
#define TICK (1.0 / 30.0)
#define YARDSTICK_REPEATS 5
#define YARDSTICK_RUNS 5
#define RATE_REPEATS 8

stage_options stage_options_default(void) {
    return (stage_options){.width = 1024, .height = 768, .quality = BOLAN_QUALITY_MEDIUM};
}

// ---- options --------------------------------------------------------------------------------------------------------

static bool parse_size(const char *text, stage_options *o) {
    char rest = '\0';
    return sscanf(text, "%5ux%5u%c", &o->width, &o->height, &rest) == 2 && o->width >= 1 && o->width <= 16384 &&
           o->height >= 1 && o->height <= 16384;
}

static bool parse_threads(const char *text, stage_options *o) {
    char rest = '\0';
    return sscanf(text, "%3u%c", &o->threads, &rest) == 1 && o->threads <= 64;
}

// The place of a name in a list that ends with NULL; -1: it has none.
static int find_name(const char *text, const char *const *names) {
    for (int i = 0; names[i]; ++i)
        if (strcmp(text, names[i]) == 0) return i;
    return -1;
}

static bool parse_quality(const char *text, stage_options *o) {
    const int found = find_name(text, bolan_quality_names);
    if (found >= 0) o->quality = (bolan_quality)found;
    return found >= 0;
}

static bool parse_backend(const char *text, stage_options *o) {
    const int found = find_name(text, bolan_backend_names);
    if (found >= 0) o->backend = (bolan_backend)found;
    return found >= 0;
}

static bool parse_pixels(const char *text, stage_options *o) {
    const int found = find_name(text, bolan_pixels_names);
    if (found >= 0) o->pixels = (bolan_pixels)found;
    return found >= 0;
}

int stage_option(const char *name, int argc, char **argv, int *index, stage_options *o) {
    static const struct {
        const char *word, *expects;
        bool (*parse)(const char *text, stage_options *o);
    } table[] = {
        {"--size", "WIDTHxHEIGHT, each 1 to 16384", parse_size},
        {"--threads", "0 (one per processor) to 64", parse_threads},
        {"--quality", "low, medium, high or ultra", parse_quality},
        {"--backend", "auto, cpu or compute", parse_backend},
        {"--pixels", "auto, fragment or compute", parse_pixels},
    };
    const char *word = argv[*index], *value = *index + 1 < argc ? argv[*index + 1] : "";
    if (strcmp(word, "--json") == 0) return o->json = true, 1;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i) {
        if (strcmp(word, table[i].word) != 0) continue;
        ++*index;
        if (table[i].parse(value, o)) return 1;
        fprintf(stderr, "bolan-bench %s: %s is %s; expected %s\n", name, word, *value ? value : "empty",
                table[i].expects);
        return -1;
    }
    return 0;
}

// ---- the stage ------------------------------------------------------------------------------------------------------

void stage_close(stage *s) {
    bolan_target_destroy(&s->target);
    bolan_renderer_destroy(&s->renderer);
    bolan_world_destroy(&s->world);
}

bolan_result stage_open(stage *s, const char *name, const stage_options *o,
                        void (*change)(bolan_scene *scene, void *context), void *context) {
    *s = (stage){.width = o->width, .height = o->height};
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = o->quality;
    desc.max_vertices = o->max_vertices;
    desc.backend = o->backend;
    desc.pixels = o->pixels;
    desc.restore = BOLAN_RESTORE_NONE; // the context is this program's
    bolan_scene scene;
    bolan_result result = bolan_scene_load(name, &scene);
    if (result == BOLAN_OK && change) change(&scene, context);
    if (result == BOLAN_OK) result = bolan_world_load_scene(&scene, &s->world);
    if (result == BOLAN_OK) result = bolan_renderer_create(&desc, &s->renderer);
    if (result == BOLAN_OK) result = bolan_target_create(s->width, s->height, &s->target);
    if (result != BOLAN_OK) {
        stage_close(s);
        return result;
    }
    bolan_world_settle(s->world, scene.time);
    return BOLAN_OK;
}

static double step_sea(stage *s) {
    double start = bench_now_ms();
    if (!s->without_water) bolan_world_step(s->world, bolan_world_scene(s->world)->time + TICK);
    if (!s->without_water && bolan_renderer_backend(s->renderer) == BOLAN_BACKEND_CPU)
        bolan_sea_fields(bolan_world_water(s->world)->sea); // what the first reader would make
    return bench_now_ms() - start;
}

static void draw(stage *s) {
    bolan_view view = bolan_view_from_camera(&bolan_world_scene(s->world)->camera, s->width, s->height);
    view.eye = bolan_world_clear_eye(s->world, view.eye);
    view.without_water = s->without_water;
    view.framebuffer = bolan_target_framebuffer(s->target);
    view.progressive = true; // like a window
    const double start = bench_thread_ms();
    bolan_renderer_draw_world(s->renderer, s->world, &view);
    s->calling_ms = bench_thread_ms() - start;
    s->statistics = bolan_renderer_statistics(s->renderer);
    uint8_t pixel[3]; // reading one pixel waits for all of them
    bolan_renderer_read_rgb8(s->renderer, view.framebuffer, 1, 1, pixel);
}

void stage_frame(stage *s) {
    step_sea(s);
    draw(s);
}

// ---- measuring ------------------------------------------------------------------------------------------------------

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, size_t count) {
    qsort(values, count, sizeof values[0], ascending);
    return values[count / 2];
}

static void time_frames(stage *s, stage_figures *f) {
    double ms[FRAMES], cpu[FRAMES], calling[FRAMES];
    for (int i = 0; i < WARM_UP + FRAMES; ++i) {
        const double start = bench_now_ms(), cpu_start = bench_cpu_ms();
        stage_frame(s);
        if (i < WARM_UP) continue;
        ms[i - WARM_UP] = bench_now_ms() - start;
        cpu[i - WARM_UP] = bench_cpu_ms() - cpu_start;
        calling[i - WARM_UP] = s->calling_ms;
    }
    f->ms = median(ms, FRAMES);
    f->cpu_ms = median(cpu, FRAMES);
    f->calling_ms = median(calling, FRAMES);
}

// In a row of its own: timing a pass makes the GPU wait between passes.
static void time_passes(stage *s, stage_figures *f) {
    double ms[BOLAN_MAX_PASSES + 1][FRAMES];
    const bolan_frame_statistics *statistics = &s->statistics;
    bolan_renderer_measure_passes(s->renderer, true);
    for (int i = 0; i < WARM_UP + FRAMES; ++i) {
        double synthesis = step_sea(s);
        draw(s);
        if (i < WARM_UP) continue;
        ms[0][i - WARM_UP] = synthesis;
        for (uint32_t p = 0; p < statistics->pass_count; ++p) ms[p + 1][i - WARM_UP] = statistics->passes[p].ms;
    }
    bolan_renderer_measure_passes(s->renderer, false);
    f->pass_count = statistics->pass_count + 1;
    for (uint32_t p = 0; p < f->pass_count; ++p) {
        f->passes[p].name = p == 0 ? "synthesis" : statistics->passes[p - 1].name;
        f->passes[p].ms = median(ms[p], FRAMES);
        f->passes[p].gl_calls = p == 0 ? 0 : statistics->passes[p - 1].gl_calls;
    }
}

static stage_yard time_yardstick(stage *s) {
    double ms[YARDSTICK_RUNS], cpu[YARDSTICK_RUNS];
    for (int i = 0; i < YARDSTICK_RUNS; ++i) {
        const double start = bench_cpu_ms();
        ms[i] = bolan_renderer_yardstick(s->renderer, s->width, s->height, YARDSTICK_REPEATS);
        cpu[i] = (bench_cpu_ms() - start) / (YARDSTICK_REPEATS + 1); // it warms up with one more
    }
    return (stage_yard){median(ms, YARDSTICK_RUNS), median(cpu, YARDSTICK_RUNS)};
}

void stage_measure(stage *s, bool passes, stage_figures *f) {
    const bolan_scene *scene = bolan_world_scene(s->world);
    *f = (stage_figures){.technique = scene->technique.name};
    memcpy(f->scene, scene->name, sizeof f->scene);
    const stage_yard before = time_yardstick(s);
    time_frames(s, f);
    const stage_yard after = time_yardstick(s);
    f->yard = (stage_yard){0.5 * (before.ms + after.ms), 0.5 * (before.cpu_ms + after.cpu_ms)};
    const bolan_frame_statistics *statistics = &s->statistics;
    f->triangles = statistics->triangles;
    f->water_triangles = statistics->water_triangles;
    f->gl_calls = statistics->gl_calls;
    f->gl_questions = statistics->gl_questions;
    f->backend = bolan_renderer_backend(s->renderer);
    f->pixels = bolan_renderer_pixels(s->renderer);
    f->sea_bytes = statistics->sea_bytes;
    if (f->sea_bytes > 0) f->memory_rate = bolan_renderer_memory_rate(s->renderer, RATE_REPEATS);
    if (passes) time_passes(s, f);
}

// ---- printing -------------------------------------------------------------------------------------------------------

void stage_print_machine(const stage_options *o, stage_yard yard) {
    printf("%s, %s, %u threads, %u x %u\n", bench_machine(), bolan_gl_get_info().renderer, bolan_threads(), o->width,
           o->height);
    printf("yardstick (6 bilinear fetches a pixel): %.2f ms, %.2f ms of the processors\n\n", yard.ms, yard.cpu_ms);
}

// What the stages of a synthesis on the GPU took: each from its own row.
static double sea_ms(const stage_figures *f) {
    double ms = 0.0;
    for (uint32_t p = 0; p < f->pass_count; ++p)
        if (strncmp(f->passes[p].name, "sea ", 4) == 0) ms += f->passes[p].ms;
    return ms;
}

// The time in which the GPU could move the bytes of a synthesis [ms].
static double floor_ms(const stage_figures *f) {
    return f->memory_rate > 0.0 ? (double)f->sea_bytes / f->memory_rate * 1e3 : 0.0;
}

static void print_floor(const stage_figures *f) {
    if (f->sea_bytes == 0 || !(sea_ms(f) > 0.0)) return;
    printf("%s: synthesis %.3f ms, of which %.0f %% are the floor: %.1f MB at %.0f GB/s\n", f->scene, sea_ms(f),
           100.0 * floor_ms(f) / sea_ms(f), (double)f->sea_bytes * 1e-6, f->memory_rate * 1e-9);
}

void stage_print_table(const stage_figures *figures, uint32_t count) {
    printf("%-12s %-12s %10s %9s %8s %7s %6s %9s %8s %8s %9s\n", "scene", "technique", "triangles", "water", "ms",
           "fps", "ratio", "cpu ratio", "cpu ms", "gl calls", "questions");
    for (uint32_t i = 0; i < count; ++i) {
        const stage_figures *f = &figures[i];
        printf("%-12s %-12s %10u %9u %8.2f %7.1f %6.2f %9.2f %8.2f %8u %9u\n", f->scene, f->technique, f->triangles,
               f->water_triangles, f->ms, 1e3 / f->ms, f->ms / f->yard.ms, f->cpu_ms / f->yard.cpu_ms, f->calling_ms,
               f->gl_calls, f->gl_questions);
    }
    printf("\npasses [ms] ");
    for (uint32_t p = 0; p < figures[0].pass_count; ++p) printf(" %11s", figures[0].passes[p].name);
    for (uint32_t i = 0; i < count; ++i) {
        printf("\n%-12s", figures[i].technique);
        for (uint32_t p = 0; p < figures[i].pass_count; ++p) printf(" %11.2f", figures[i].passes[p].ms);
        printf("\n%12s", "gl calls");
        for (uint32_t p = 0; p < figures[i].pass_count; ++p) printf(" %11u", figures[i].passes[p].gl_calls);
    }
    printf("\n");
    for (uint32_t i = 0; i < count; ++i) print_floor(&figures[i]);
}

void stage_print_machine_json(const stage_options *o, stage_yard yard) {
    printf("  \"machine\": \"%s\",\n  \"renderer\": \"%s\",\n  \"threads\": %u,\n  \"width\": %u,\n  \"height\": %u,\n"
           "  \"yardstick_ms\": %.3f,\n  \"yardstick_cpu_ms\": %.3f,\n",
           bench_machine(), bolan_gl_get_info().renderer, bolan_threads(), o->width, o->height, yard.ms, yard.cpu_ms);
}

void stage_print_json(const stage_options *o, const stage_figures *figures, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const stage_figures *f = &figures[i];
        printf("    {\"scene\": \"%s\", \"technique\": \"%s\", \"backend\": \"%s\", \"pixels\": \"%s\", \"width\": %u, "
               "\"height\": %u, \"triangles\": %u, "
               "\"water_triangles\": %u, \"ms\": %.3f, \"fps\": %.2f, \"ratio\": %.3f, \"cpu_ratio\": %.3f,\n     "
               "\"cpu_ms\": %.3f, \"process_ms\": %.3f, \"gl_calls\": %u, \"gl_questions\": %u,\n     "
               "\"passes\": {",
               f->scene, f->technique, bolan_backend_names[f->backend], bolan_pixels_names[f->pixels], o->width,
               o->height, f->triangles, f->water_triangles, f->ms, 1e3 / f->ms, f->ms / f->yard.ms,
               f->cpu_ms / f->yard.cpu_ms, f->calling_ms, f->cpu_ms, f->gl_calls, f->gl_questions);
        for (uint32_t p = 0; p < f->pass_count; ++p)
            printf("%s\"%s\": %.3f", p > 0 ? ", " : "", f->passes[p].name, f->passes[p].ms);
        printf("}");
        if (f->sea_bytes > 0)
            printf(",\n     \"sea_bytes\": %llu, \"memory_rate\": %.4g, \"sea_ms\": %.4f, \"sea_floor_ms\": %.4f",
                   (unsigned long long)f->sea_bytes, f->memory_rate, sea_ms(f), floor_ms(f));
        printf("}%s\n", i + 1 < count ? "," : "");
    }
}
