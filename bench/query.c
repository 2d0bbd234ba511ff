// SPDX-License-Identifier: MIT
// bolan-bench query: queries a second, and the ratio of their time to that of streaming the samples they read from
// memory; and points a second of the program `bolan query`, from CSV to CSV. Times are the least of several; of one
// thread they are the processor's, which other programs disturb less.
#include "bench.h"

#include "bolan/flow.h"
#include "bolan/query.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { MOST_POINTS = 1000000, REPEATS = 11, TAPS = 16, COPY_BYTES = 64 << 20 };

// Bytes that a query reads of each of the TAPS samples in each cascade, from memory if the points are scattered: a
// texel of the displacement, or of the flow, whose texels are 16 floats.
enum { TEXEL = sizeof(bolan_sea_texel), FLOW_TEXEL = 16 * sizeof(float) };

typedef enum query_kind { HEIGHTS, SURFACE, BELOW, MOTION } query_kind;

// One row of the table.
typedef struct query_case {
    const char *name;
    query_kind kind;
    double extent; // side of the square the points lie in [m]
    double depth;  // below the level [m]
} query_case;

static const query_case cases[] = {
    {"heights, scattered over 10 km", HEIGHTS, 10000.0, 0.0},
    {"heights, under a hull of 100 m", HEIGHTS, 100.0, 0.0},
    {"heights, along 10 m", HEIGHTS, 10.0, 0.0},
    {"heights and normals, scattered", SURFACE, 10000.0, 0.0},
    {"heights and normals, 100 m", SURFACE, 100.0, 0.0},
    {"the surface's motion, 100 m", MOTION, 100.0, 0.0},
    {"the flow at 0 m, 100 m", BELOW, 100.0, 0.0},
    {"the flow 5 m below, 100 m", BELOW, 100.0, 5.0},
    {"the flow 20 m below, 100 m", BELOW, 100.0, 20.0},
};
static const uint32_t sizes[] = {1000, 10000, 100000, MOST_POINTS};
enum { SIZES_OF_FLOW = 2 }; // of sizes: more take no longer each
static const uint32_t thread_counts[] = {1, 2};

enum { CASES = sizeof cases / sizeof cases[0], SIZES = sizeof sizes / sizeof sizes[0], THREADS = 2 };

typedef struct query_row {
    const query_case *what;
    uint32_t points, threads;
    double ms, ratio;
    double bytes; // a point
} query_row;

typedef struct buffers {
    bolan_dvec2 *xy;
    float *height;
    bolan_query_point *surface;
    bolan_dvec3 *xyz;
    bolan_kinematics *below;
    bolan_surface_motion *motion;
} buffers;

static double seconds(void) { return 1e-3 * bench_now_ms(); }

static double seconds_of(uint32_t threads) { return threads == 1 ? 1e-3 * bench_cpu_ms() : seconds(); }

typedef struct copy_task {
    char *to;
    const char *from;
} copy_task;

static void copy_slice(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const copy_task *c = context;
    memcpy(c->to + ((size_t)begin << 20), c->from + ((size_t)begin << 20), (size_t)(end - begin) << 20);
}

// Bytes read a second while memory is copied.
static double bandwidth(uint32_t threads) {
    copy_task c = {malloc(COPY_BYTES), calloc(COPY_BYTES, 1)};
    double best = 1e30;
    for (int i = 0; i < REPEATS && c.to && c.from; i++) {
        const double start = seconds_of(threads);
        bolan_parallel(COPY_BYTES >> 20, 1, copy_slice, &c);
        best = fmin(best, seconds_of(threads) - start);
    }
    free((void *)c.from);
    free(c.to);
    return COPY_BYTES / best;
}

static void scatter(double extent, bolan_dvec2 *xy) {
    uint64_t state = 88172645463325252u;
    for (uint32_t i = 0; i < 2 * MOST_POINTS; i++) {
        state ^= state << 13, state ^= state >> 7, state ^= state << 17; // Marsaglia 2003
        (&xy[i / 2].x)[i % 2] = extent * (double)(state >> 11) / 9007199254740992.0;
    }
}

static void sink(double depth, const buffers *b) {
    for (uint32_t i = 0; i < MOST_POINTS; i++) b->xyz[i] = (bolan_dvec3){b->xy[i].x, b->xy[i].y, -depth};
}

static void ask(const bolan_water *water, query_kind kind, const buffers *b, uint32_t points) {
    switch (kind) {
    case HEIGHTS: bolan_query_heights(water, b->xy, points, b->height); break;
    case SURFACE: bolan_query_surface(water, b->xy, points, b->surface); break;
    case BELOW: bolan_query_below(water, NULL, b->xyz, points, b->below); break;
    case MOTION: bolan_query_motion(water, NULL, b->xy, points, b->motion); break;
    }
}

static query_row measure(const bolan_water *water, const query_case *what, const buffers *b, uint32_t points,
                         uint32_t threads, double bytes_per_second) {
    double time = 1e30;
    ask(water, what->kind, b, points);
    for (int i = 0; i < REPEATS; i++) {
        const double start = seconds_of(threads);
        ask(water, what->kind, b, points);
        time = fmin(time, seconds_of(threads) - start);
    }
    const double at_a_sample = what->kind == BELOW || what->kind == MOTION ? FLOW_TEXEL : TEXEL;
    const double bytes = bolan_sea_cascade_count(water->sea) * TAPS * at_a_sample;
    return (query_row){what, points, threads, 1e3 * time, time / (points * bytes / bytes_per_second), bytes};
}

static void print_table(const query_row *rows, uint32_t count, const double *bytes_per_second) {
    printf(
        "%s\nqueries of 4 cascades of 256 x 256; bytes: of the samples that a point reads; ratio: to the time in which "
        "memory streams them\n",
        bench_machine());
    for (int t = 0; t < THREADS; t++)
        printf("memory, %u thread%s: %.1f GB/s\n", thread_counts[t], thread_counts[t] > 1 ? "s" : "",
               bytes_per_second[t] * 1e-9);
    printf("%-32s %9s %8s %10s %14s %8s %7s\n", "", "points", "threads", "ms", "points/s", "bytes", "ratio");
    for (uint32_t i = 0; i < count; i++)
        printf("%-32s %9u %8u %10.3f %14.3g %8.0f %7.2f\n", rows[i].what->name, rows[i].points, rows[i].threads,
               rows[i].ms, 1e3 * rows[i].points / rows[i].ms, rows[i].bytes, rows[i].ratio);
}

static void print_json(const query_row *rows, uint32_t count, const double *bytes_per_second) {
    printf("{\"machine\": \"%s\", \"yardstick_bytes_per_second\": [%.4g, %.4g], \"query\": [", bench_machine(),
           bytes_per_second[0], bytes_per_second[1]);
    for (uint32_t i = 0; i < count; i++)
        printf("%s\n  {\"what\": \"%s\", \"points\": %u, \"threads\": %u, \"ms\": %.4f, \"points_per_second\": %.4g, "
               "\"bytes\": %.0f, \"ratio\": %.3f}",
               i ? "," : "", rows[i].what->name, rows[i].points, rows[i].threads, rows[i].ms,
               1e3 * rows[i].points / rows[i].ms, rows[i].bytes, rows[i].ratio);
    printf("\n]}\n");
}

static void run(const bolan_water *water, const buffers *b, bool json) {
    query_row rows[CASES * SIZES * THREADS];
    double bytes_per_second[THREADS];
    uint32_t count = 0;
    for (int t = 0; t < THREADS; t++) {
        bolan_set_threads(thread_counts[t]);
        bytes_per_second[t] = bandwidth(thread_counts[t]);
    }
    for (int c = 0; c < CASES; c++) {
        const bool flow = cases[c].kind == BELOW || cases[c].kind == MOTION;
        scatter(cases[c].extent, b->xy);
        sink(cases[c].depth, b);
        for (int s = 0; s < (flow ? SIZES_OF_FLOW : SIZES); s++) {
            for (int t = 0; t < THREADS; t++) {
                bolan_set_threads(thread_counts[t]);
                bytes_per_second[t] = fmax(bytes_per_second[t], bandwidth(thread_counts[t]));
                rows[count++] = measure(water, &cases[c], b, sizes[s], thread_counts[t], bytes_per_second[t]);
            }
        }
    }
    bolan_set_threads(1);
    (json ? print_json : print_table)(rows, count, bytes_per_second);
}

// ---- the program ----------------------------------------------------------------------------------------------------

enum { LONGEST_LINE = 32 };

// Of the programs that this one has started, and that have ended.
static double seconds_of_programs(void) {
    struct rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

// Seconds of `bolan query` for the points of a text, by pipes.
static double program_seconds(const char *program, const char *text, size_t size) {
    char command[BOLAN_PATH_MAX + 128];
    double best = 1e30;
    snprintf(command, sizeof command, "'%s' query open-sea --points - --quiet --threads 1 > /dev/null", program);
    for (int i = 0; i < REPEATS; i++) {
        const double start = seconds_of_programs();
        FILE *pipe = popen(command, "w");
        if (!pipe) return 0.0;
        const bool written = fwrite(text, 1, size, pipe) == size;
        if (pclose(pipe) != 0 || !written) return 0.0;
        best = fmin(best, seconds_of_programs() - start);
    }
    return best;
}

// From CSV to CSV, all columns that are printed by default; without what it takes to start.
static void run_program(const buffers *b) {
    char program[BOLAN_PATH_MAX];
    char *text = malloc((size_t)MOST_POINTS * LONGEST_LINE);
    size_t size = 0, first = 0;
    scatter(10000.0, b->xy);
    for (uint32_t i = 0; text && i < MOST_POINTS; i++) {
        size += (size_t)snprintf(text + size, LONGEST_LINE, "%.3f,%.3f\n", b->xy[i].x, b->xy[i].y);
        first = i ? first : size;
    }
    if (text && bench_program(program, sizeof program)) {
        const double start = program_seconds(program, text, first), all = program_seconds(program, text, size);
        if (all > start) printf("bolan query, CSV to CSV, 1 thread: %.3g points/s\n", MOST_POINTS / (all - start));
    }
    free(text);
}

static bool reserve(buffers *b) {
    *b = (buffers){malloc(sizeof *b->xy * MOST_POINTS),      malloc(sizeof *b->height * MOST_POINTS),
                   malloc(sizeof *b->surface * MOST_POINTS), malloc(sizeof *b->xyz * MOST_POINTS),
                   malloc(sizeof *b->below * MOST_POINTS),   malloc(sizeof *b->motion * MOST_POINTS)};
    return b->xy && b->height && b->surface && b->xyz && b->below && b->motion;
}

static void release(buffers *b) {
    free(b->xy), free(b->height), free(b->surface);
    free(b->xyz), free(b->below), free(b->motion);
}

int bench_query(int argc, char **argv) {
    bool json = false;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--json") != 0) {
            fprintf(stderr, "bolan-bench query: unknown option '%s'; usage: query [--json]\n", argv[i]);
            return 2;
        }
        json = true;
    }
    const bolan_sea_desc desc = bolan_sea_desc_default();
    bolan_sea *sea = NULL;
    bolan_flow *flow = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return 1;
    bolan_sea_step(sea, 10.0);
    bolan_sea_fields(sea);
    buffers b = {NULL};
    const bool ready = bolan_flow_create(sea, &flow) == BOLAN_OK && reserve(&b);
    if (ready) run(&(bolan_water){.sea = sea, .flow = flow}, &b, json);
    if (ready && !json) run_program(&b);
    release(&b);
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
    return ready ? 0 : 1;
}
