// SPDX-License-Identifier: MIT
// A scene that is opened, drawn and timed, for the benchmarks of frames.
#ifndef BOLAN_BENCH_STAGE_H
#define BOLAN_BENCH_STAGE_H

#include "bench.h"

#include "bolan/io.h"
#include "bolan/render.h"

// The command line of these benchmarks.
typedef struct stage_options {
    bool json;
    uint32_t width, height, threads;
    bolan_quality quality;
    bolan_backend backend;
    bolan_pixels pixels;
    uint32_t max_vertices; // of the water; 0: by quality. No option of the command line: a row of a table sets it
} stage_options;
// The defaults: 1024 x 768, medium.
stage_options stage_options_default(void);
// Takes the option at *index; 1: taken, 0: it is none of these, -1: its value is wrong (said on stderr after
// "bolan-bench NAME: ").
int stage_option(const char *name, int argc, char **argv, int *index, stage_options *o);

typedef struct stage {
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
    uint32_t width, height;
    bool without_water;
    double calling_ms; // of the last frame
    bolan_frame_statistics statistics;
} stage;

// The yardstick: a full-screen pass of 6 bilinear texture fetches at the stage's size.
typedef struct stage_yard {
    double ms, cpu_ms;
} stage_yard;

typedef struct stage_figures {
    char scene[BOLAN_NAME_MAX];
    const char *technique;
    uint32_t triangles, water_triangles;
    double ms; // median of a frame, synthesis included
    bolan_backend backend;
    bolan_pixels pixels;
    uint64_t sea_bytes;              // bolan_frame_statistics.sea_bytes
    double memory_rate;              // [bytes/s], where there are such bytes
    double calling_ms;               // processor time of the calling thread in the call that draws
    uint32_t gl_calls, gl_questions; // bolan_frame_statistics, of the last frame
    double cpu_ms;                   // processor time of all threads for the same frames; hardly depends on other load
    stage_yard yard; // timed right before and after these frames, since a machine's speed changes from minute to minute
    uint32_t pass_count;
    struct {
        const char *name;
        double ms;
        uint32_t gl_calls;
    } passes[BOLAN_MAX_PASSES + 1];
} stage_figures;

// Loads a scene; `change` may alter it before anything is made of it (NULL: it stays).
bolan_result stage_open(stage *s, const char *name, const stage_options *o,
                        void (*change)(bolan_scene *scene, void *context), void *context);
void stage_close(stage *s);
// A frame 1/30 s after the last, waited for.
void stage_frame(stage *s);
// Median time of a frame; passes: each of them too, in a run of its own.
void stage_measure(stage *s, bool passes, stage_figures *f);

// Printing: what was measured on, and a list of figures with their passes.
void stage_print_machine(const stage_options *o, stage_yard yard);
void stage_print_table(const stage_figures *figures, uint32_t count);
void stage_print_machine_json(const stage_options *o, stage_yard yard); // keys of an open object
void stage_print_json(const stage_options *o, const stage_figures *figures, uint32_t count);

#endif
