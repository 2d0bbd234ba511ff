// SPDX-License-Identifier: MIT
// bolan-bench query: queries a second, and the ratio of their time to that of streaming the samples they read from
// memory.
#include "bench.h"

#include "bolan/query.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 1000000, REPEATS = 7, TAPS = 16, PLANES = 3, COPY_BYTES = 64 << 20 };

// One row of the table. A query reads 4 x 4 samples of three planes of each cascade, from memory if the points are
// scattered.
typedef struct query_case {
    const char *name;
    double extent; // side of the square the points lie in [m]
    bool surface;
} query_case;

static const query_case cases[] = {
    {"heights, scattered over 10 km", 10000.0, false},
    {"heights, under a hull of 100 m", 100.0, false},
    {"heights and normals, scattered", 10000.0, true},
};
static const uint32_t sizes[] = {1000, 10000, 100000, MOST_POINTS};
static const uint32_t thread_counts[] = {1, 2};

enum { CASES = sizeof cases / sizeof cases[0], SIZES = sizeof sizes / sizeof sizes[0], THREADS = 2 };

typedef struct query_row {
    const query_case *what;
    uint32_t points, threads;
    double ms, ratio;
} query_row;

typedef struct buffers {
    bolan_dvec2 *xy;
    float *height;
    bolan_query_point *surface;
} buffers;

static double seconds(void) { return 1e-3 * bench_now_ms(); }

static int by_value(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values) {
    qsort(values, REPEATS, sizeof values[0], by_value);
    return values[REPEATS / 2];
}

typedef struct copy_task {
    char *to;
    const char *from;
} copy_task;

static void copy_slice(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const copy_task *c = context;
    memcpy(c->to + ((size_t)begin << 20), c->from + ((size_t)begin << 20), (size_t)(end - begin) << 20);
}

// Bytes read a second while memory is copied, on the threads that are set.
static double bandwidth(void) {
    copy_task c = {malloc(COPY_BYTES), calloc(COPY_BYTES, 1)};
    double best = 1e30;
    for (int i = 0; i < REPEATS && c.to && c.from; i++) {
        const double start = seconds();
        bolan_parallel(COPY_BYTES >> 20, 1, copy_slice, &c);
        best = fmin(best, seconds() - start);
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

static void ask(const bolan_sea *sea, const query_case *what, const buffers *b, uint32_t points) {
    if (what->surface) {
        bolan_query_surface(&(bolan_water){.sea = sea}, b->xy, points, b->surface);
    } else {
        bolan_query_heights(&(bolan_water){.sea = sea}, b->xy, points, b->height);
    }
}

static query_row measure(const bolan_sea *sea, const query_case *what, const buffers *b, uint32_t points,
                         uint32_t threads, double bytes_per_second) {
    double times[REPEATS];
    ask(sea, what, b, points);
    for (int i = 0; i < REPEATS; i++) {
        const double start = seconds();
        ask(sea, what, b, points);
        times[i] = seconds() - start;
    }
    const double time = median(times);
    const double bytes = (double)points * bolan_sea_cascade_count(sea) * PLANES * TAPS * sizeof(float);
    return (query_row){what, points, threads, 1e3 * time, time / (bytes / bytes_per_second)};
}

static void print_table(const query_row *rows, uint32_t count, const double *bytes_per_second) {
    printf("%s\nqueries of 4 cascades of 256 x 256; ratio: to the time in which memory streams the samples read\n",
           bench_machine());
    for (int t = 0; t < THREADS; t++)
        printf("memory, %u thread%s: %.1f GB/s\n", thread_counts[t], thread_counts[t] > 1 ? "s" : "",
               bytes_per_second[t] * 1e-9);
    printf("%-32s %9s %8s %10s %14s %7s\n", "", "points", "threads", "ms", "points/s", "ratio");
    for (uint32_t i = 0; i < count; i++)
        printf("%-32s %9u %8u %10.3f %14.3g %7.2f\n", rows[i].what->name, rows[i].points, rows[i].threads, rows[i].ms,
               1e3 * rows[i].points / rows[i].ms, rows[i].ratio);
}

static void print_json(const query_row *rows, uint32_t count, const double *bytes_per_second) {
    printf("{\"machine\": \"%s\", \"yardstick_bytes_per_second\": [%.4g, %.4g], \"query\": [", bench_machine(),
           bytes_per_second[0], bytes_per_second[1]);
    for (uint32_t i = 0; i < count; i++)
        printf("%s\n  {\"what\": \"%s\", \"points\": %u, \"threads\": %u, \"ms\": %.4f, \"points_per_second\": %.4g, "
               "\"ratio\": %.3f}",
               i ? "," : "", rows[i].what->name, rows[i].points, rows[i].threads, rows[i].ms,
               1e3 * rows[i].points / rows[i].ms, rows[i].ratio);
    printf("\n]}\n");
}

static void run(const bolan_sea *sea, const buffers *b, bool json) {
    query_row rows[CASES * SIZES * THREADS];
    double bytes_per_second[THREADS];
    uint32_t count = 0;
    for (int t = 0; t < THREADS; t++) {
        bolan_set_threads(thread_counts[t]);
        bytes_per_second[t] = bandwidth();
    }
    for (int c = 0; c < CASES; c++) {
        scatter(cases[c].extent, b->xy);
        for (int s = 0; s < SIZES; s++) {
            for (int t = 0; t < THREADS; t++) {
                bolan_set_threads(thread_counts[t]);
                rows[count++] = measure(sea, &cases[c], b, sizes[s], thread_counts[t], bytes_per_second[t]);
            }
        }
    }
    bolan_set_threads(1);
    (json ? print_json : print_table)(rows, count, bytes_per_second);
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
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return 1;
    bolan_sea_step(sea, 10.0);
    const buffers b = {malloc(sizeof(bolan_dvec2) * MOST_POINTS), malloc(sizeof(float) * MOST_POINTS),
                       malloc(sizeof(bolan_query_point) * MOST_POINTS)};
    const bool have_memory = b.xy && b.height && b.surface;
    if (have_memory) run(sea, &b, json);
    free(b.xy);
    free(b.height);
    free(b.surface);
    bolan_sea_destroy(&sea);
    return have_memory ? 0 : 1;
}
