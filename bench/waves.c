// SPDX-License-Identifier: MIT
// bolan-bench waves: a step of the sea (time evolution, eight fields, packing to half, foam memory) as a ratio to
// FFTW doing only the four bare complex transforms that the eight fields of a cascade need. FFTW gets its best plan:
// the fastest of in place, out of place, and in place with padded rows; on two threads whole fields are shared out.
// Both sides are timed in turns, and the shortest time of each counts, so that other work on the machine disturbs
// them alike. Then the sums of waves: their fields at the 6534 points of a mesh (Liu, Xu & Chen 2009, n = 32, 6
// levels).
#include "bench.h"

#include "bolan/waves.h"

#include <fftw3.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { FIELDS = 4, PADDING = 8, LAYOUTS = 3 };

typedef struct yardstick {
    uint32_t n, transforms;
    size_t stride;           // complex numbers from field to field
    fftwf_complex *in, *out; // transforms fields each
    fftwf_plan plan;
} yardstick;

typedef struct row {
    uint32_t n, cascades, threads;
    double ms, fftw_ms;
} row;

static void fill(yardstick *y) {
    for (size_t i = 0; i < y->stride * y->transforms; i++) {
        y->in[i][0] = sinf((float)i);
        y->in[i][1] = cosf((float)i);
    }
}

static bool yardstick_open(yardstick *y, uint32_t n, uint32_t transforms, int layout) {
    const int size[2] = {(int)n, (int)n}, embed[2] = {(int)n, (int)n + (layout == 2 ? PADDING : 0)};
    y->n = n;
    y->transforms = transforms;
    y->stride = (size_t)n * (size_t)embed[1] + (layout == 2 ? 16 : 0);
    y->in = fftwf_alloc_complex(y->stride * transforms);
    y->out = layout == 1 ? fftwf_alloc_complex(y->stride * transforms) : y->in;
    if (!y->in || !y->out) return false;
    y->plan = fftwf_plan_many_dft(2, size, 1, y->in, embed, 1, 0, y->out, embed, 1, 0, FFTW_BACKWARD,
                                  n <= 256 ? FFTW_PATIENT : FFTW_MEASURE);
    fill(y);
    return y->plan != NULL;
}

static void yardstick_close(yardstick *y) {
    if (y->plan) fftwf_destroy_plan(y->plan);
    if (y->out != y->in) fftwf_free(y->out);
    fftwf_free(y->in);
    memset(y, 0, sizeof *y);
}

// Task: fields [begin, end).
static void transform_fields(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const yardstick *y = context;
    for (uint32_t f = begin; f < end; f++) fftwf_execute_dft(y->plan, y->in + f * y->stride, y->out + f * y->stride);
}

static double time_fftw(yardstick *y) {
    const double start = bench_now_ms();
    bolan_parallel(y->transforms, 1, transform_fields, y);
    const double ms = bench_now_ms() - start;
    if (y->out == y->in) fill(y); // in place it would grow without end
    return ms;
}

static double time_step(bolan_sea *sea, double time) {
    const double start = bench_now_ms();
    bolan_sea_step(sea, time);
    bolan_sea_fields(sea);
    return bench_now_ms() - start;
}

static bolan_cpu cpu; // --cpu: the kernels of both the cascades and the sums

static bool measure(row *r) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.cpu = cpu;
    desc.resolution = r->n;
    desc.fft.cascade_count = r->cascades;
    bolan_sea *sea = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return false;
    r->ms = r->fftw_ms = INFINITY;
    const uint32_t repeats = 4 + (1024 / r->n) * (1024 / r->n) * 4 / r->cascades;
    bool done = true;
    for (int layout = 0; layout < LAYOUTS && done; layout++) {
        yardstick y = {0};
        done = yardstick_open(&y, r->n, FIELDS * r->cascades, layout);
        for (uint32_t i = 0; i < repeats && done; i++) {
            r->ms = fmin(r->ms, time_step(sea, 0.03 * (i + 1)));
            r->fftw_ms = fmin(r->fftw_ms, time_fftw(&y));
        }
        yardstick_close(&y);
    }
    bolan_sea_destroy(&sea);
    return done;
}

// ---- sums of waves --------------------------------------------------------------------------------------------------

enum { MESH_POINTS = 6534, MODELS = 3, SUM_ROWS = 2 * MODELS };

typedef struct sum_row {
    const char *model;
    uint32_t waves, threads;
    double ms, ns; // ns of one wave at one point
} sum_row;

static bolan_sea_desc sum_desc(uint32_t index) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.cpu = cpu;
    desc.waves = index == 2 ? BOLAN_WAVES_EXP_COSINE : BOLAN_WAVES_COSINES;
    if (index == 1) desc.cosines.frequencies = BOLAN_MAX_FREQUENCIES;
    if (index == 1) desc.cosines.directions = BOLAN_MAX_DIRECTIONS;
    return desc;
}

static bool measure_sum(uint32_t index, sum_row *r) {
    static bolan_dvec2 points[MESH_POINTS];
    static bolan_sea_sample samples[MESH_POINTS];
    const bolan_sea_desc desc = sum_desc(index);
    bolan_sea *sea = NULL;
    if (bolan_sea_create(&desc, &sea) != BOLAN_OK) return false;
    for (uint32_t i = 0; i < MESH_POINTS; i++) points[i] = (bolan_dvec2){4.0 * (i % 81), 4.0 * (i / 81)};
    r->model = bolan_wave_model_names[desc.waves];
    r->waves = bolan_sea_component_count(sea);
    r->ms = INFINITY;
    for (uint32_t i = 0; i < 30; i++) {
        const double start = bench_now_ms();
        bolan_sea_step(sea, 0.03 * (i + 1));
        bolan_sea_fields(sea);
        bolan_sea_sample_grid(sea, points, NULL, MESH_POINTS, samples);
        r->ms = fmin(r->ms, bench_now_ms() - start);
    }
    r->ns = r->ms * 1e6 / ((double)r->waves * MESH_POINTS);
    bolan_sea_destroy(&sea);
    return true;
}

static bool measure_sums(sum_row rows[SUM_ROWS]) {
    for (uint32_t i = 0; i < SUM_ROWS; i++) {
        rows[i].threads = 1 + i / MODELS;
        bolan_set_threads(rows[i].threads);
        if (!measure_sum(i % MODELS, &rows[i])) return false;
    }
    bolan_set_threads(1);
    return true;
}

static void print_sums(const sum_row rows[SUM_ROWS], bool json) {
    if (!json) printf("\n%10s %6s %7s %8s %10s %15s\n", "model", "waves", "points", "threads", "ms", "ns/wave/point");
    for (uint32_t i = 0; i < SUM_ROWS; i++) {
        const sum_row *r = &rows[i];
        printf(json ? "%s\n    {\"model\": \"%s\", \"waves\": %u, \"points\": %d, \"threads\": %u, \"ms\": %.4f, "
                      "\"ns_per_wave_point\": %.4f}"
                    : "%s%10s %6u %7d %8u %10.3f %15.3f\n",
               json && i > 0 ? "," : "", r->model, (unsigned)r->waves, (int)MESH_POINTS, (unsigned)r->threads, r->ms,
               r->ns);
    }
}

static void print_json(const row *rows, uint32_t count, const sum_row sums[SUM_ROWS]) {
    printf("{\n  \"machine\": \"%s\",\n  \"waves\": [", bench_machine());
    for (uint32_t i = 0; i < count; i++)
        printf(
            "%s\n    {\"n\": %u, \"cascades\": %u, \"threads\": %u, \"ms\": %.4f, \"fftw_ms\": %.4f, \"ratio\": %.3f}",
            i > 0 ? "," : "", rows[i].n, rows[i].cascades, rows[i].threads, rows[i].ms, rows[i].fftw_ms,
            rows[i].ms / rows[i].fftw_ms);
    printf("\n  ],\n  \"sums\": [");
    print_sums(sums, true);
    printf("\n  ]\n}\n");
}

static void print_row(const row *r) {
    printf("%6u %9u %8u %10.3f %10.3f %7.2f\n", r->n, r->cascades, r->threads, r->ms, r->fftw_ms, r->ms / r->fftw_ms);
    fflush(stdout);
}

// The instruction set of that name; -1 where there is none, or this machine lacks it.
static int cpu_of(const char *name) {
    for (int i = BOLAN_CPU_AUTO; name && i <= (int)bolan_cpu_best(); i++)
        if (strcmp(name, bolan_cpu_name((bolan_cpu)i)) == 0) return i;
    return -1;
}

static int parse(int argc, char **argv, bool *json) {
    for (int i = 1; i < argc; i++) {
        int found = BOLAN_CPU_AUTO;
        if (strcmp(argv[i], "--json") == 0) {
            *json = true;
        } else if (strcmp(argv[i], "--cpu") == 0 && (found = cpu_of(argv[++i])) >= 0) {
            cpu = (bolan_cpu)found;
        } else {
            fprintf(
                stderr,
                "bolan-bench waves: unexpected %s; usage: waves [--json] [--cpu auto|scalar|generic4|avx2|avx512]\n",
                argv[i] ? argv[i] : "end after --cpu");
            return 2;
        }
    }
    return 0;
}

int bench_waves(int argc, char **argv) {
    static const uint32_t sizes[] = {128, 256, 512, 1024}, cascades[] = {1, 4};
    row rows[16];
    uint32_t count = 0;
    bool json = false;
    const int status = parse(argc, argv, &json);
    if (status != 0) return status;
    if (!json) {
        printf("%s; kernels: %s\n"
               "ratio: a step of the sea over FFTW's bare transforms, 4 a cascade\n\n",
               bench_machine(), bolan_cpu_name(cpu == BOLAN_CPU_AUTO ? bolan_cpu_best() : cpu));
        printf("%6s %9s %8s %10s %10s %7s\n", "n", "cascades", "threads", "ms", "FFTW ms", "ratio");
    }
    for (uint32_t threads = 1; threads <= 2; threads++) {
        bolan_set_threads(threads);
        for (uint32_t i = 0; i < 8; i++) {
            rows[count] = (row){.n = sizes[i % 4], .cascades = cascades[i / 4], .threads = threads};
            if (!measure(&rows[count])) return 1;
            if (!json) print_row(&rows[count]);
            count++;
        }
    }
    sum_row sums[SUM_ROWS];
    if (!measure_sums(sums)) return 1;
    if (json) {
        print_json(rows, count, sums);
    } else {
        print_sums(sums, false);
    }
    fftwf_cleanup();
    return 0;
}
