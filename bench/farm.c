// SPDX-License-Identifier: MIT
// bolan-bench farm: frames by one and by two processes of one thread, what handing out costs, and a simulation of many
// ranks with the times that were measured.
#include "bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FRAMES = 24, SKIPPED = 4, MOST = 4096, RANKS = 1000, FRAMES_A_RANK = 50 }; // SKIPPED: of each process's first

typedef struct times {
    uint32_t count;
    double draw[MOST], taken[MOST];
    uint32_t by[MOST];
    double processor; // of the process that hands out [s]
} times;

// ---- measured -------------------------------------------------------------------------------------------------------

static bool read_times(const char *path, times *t) {
    FILE *file = fopen(path, "r");
    char line[256];
    unsigned frame, by;
    t->count = 0;
    while (file && fgets(line, sizeof line, file) && t->count < MOST) {
        if (sscanf(line, "%u,%u,%lf,%lf", &frame, &by, &t->draw[t->count], &t->taken[t->count]) == 4)
            t->by[t->count++] = by;
        else
            sscanf(line, "# processor time of the process that hands out: %lf", &t->processor);
    }
    if (file) fclose(file);
    return t->count > 0;
}

static bool draw(const char *program, const char *folder, int processes, const char *scene, const char *size,
                 times *t) {
    char command[4096], path[1024];
    snprintf(path, sizeof path, "%s/%d.csv", folder, processes);
    snprintf(command, sizeof command,
             "LP_NUM_THREADS=1 '%s' farm '%s' -o '%s/%d' --processes %d --threads 1 --frames %d --size %s --quiet "
             "--times '%s'",
             program, scene, folder, processes, processes, processes * FRAMES, size, path);
    return system(command) == 0 && read_times(path, t);
}

// Frames a second of one process, without its first frames, which pay for the start.
static double mean_taken(const times *t) {
    uint32_t seen[8] = {0}, count = 0;
    double sum = 0.0;
    for (uint32_t i = 0; i < t->count; i++) {
        if (t->by[i] < 8 && seen[t->by[i]]++ < SKIPPED) continue;
        sum += t->taken[i];
        count++;
    }
    return count ? sum / count : NAN;
}

static int by_value(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The median of what an answer takes beyond the drawing [s].
static double hand_out(const times *t) {
    static double extra[MOST];
    uint32_t seen[8] = {0}, count = 0;
    for (uint32_t i = 0; i < t->count; i++)
        if (t->by[i] >= 8 || seen[t->by[i]]++ >= SKIPPED) extra[count++] = t->taken[i] - t->draw[i];
    qsort(extra, count, sizeof *extra, by_value);
    return count ? extra[count / 2] : NAN;
}

// ---- simulated ------------------------------------------------------------------------------------------------------

// The rank that is free first, as a heap of times.
static void sift(double *heap, uint32_t count, double value) {
    uint32_t at = 0;
    for (uint32_t child; (child = 2 * at + 1) < count; at = child) {
        if (child + 1 < count && heap[child + 1] < heap[child]) child++;
        if (heap[child] >= value) break;
        heap[at] = heap[child];
    }
    heap[at] = value;
}

// Share of the ranks' time in which they draw. Rank 0 serves one request after another, `service` seconds each.
static double simulate(const times *t, double service) {
    static double heap[RANKS];
    uint64_t random = 1;
    double served = 0.0, drawn = 0.0, end = 0.0;
    memset(heap, 0, sizeof heap);
    for (uint32_t i = 0; i < RANKS * FRAMES_A_RANK; i++) {
        random = random * 6364136223846793005u + 1442695040888963407u; // Knuth's
        const double took = t->draw[SKIPPED + (random >> 33) % (t->count - SKIPPED)];
        served = fmax(served, heap[0]) + service;
        drawn += took;
        sift(heap, RANKS, served + took);
        end = fmax(end, served + took);
    }
    return drawn / (RANKS * end);
}

int bench_farm(int argc, char **argv) {
    bool json = false;
    const char *scene = "open-sea", *size = "640x360";
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--json") == 0)
            json = true;
        else if (strcmp(argv[i], "--size") == 0 && i + 1 < argc)
            size = argv[++i];
        else if (argv[i][0] != '-')
            scene = argv[i];
        else
            return fprintf(stderr, "usage: bolan-bench farm [SCENE] [--size WxH] [--json]\n"), 2;
    }
    static times one, two;
    char program[1024], folder[] = P_tmpdir "/bolan-XXXXXX", command[64];
    if (!bench_program(program, sizeof program)) return fprintf(stderr, "bolan-bench: no program bolan here\n"), 1;
    if (!mkdtemp(folder)) return fprintf(stderr, "bolan-bench: no folder for the frames\n"), 1;
    const bool ok = draw(program, folder, 1, scene, size, &one) && draw(program, folder, 2, scene, size, &two);
    snprintf(command, sizeof command, "rm -r %s", folder);
    if (system(command) != 0 || !ok) return fprintf(stderr, "bolan-bench: the farm failed\n"), 1;
    const double efficiency = mean_taken(&one) / mean_taken(&two), extra = hand_out(&one);
    const double service = one.processor / one.count, many = simulate(&one, service), at_most = simulate(&one, extra);
    if (json)
        printf(
            "{\"machine\": \"%s\", \"frame_s\": %.6g, \"efficiency_2\": %.4g, \"hand_out_ms\": %.4g, "
            "\"service_ms\": %.4g, \"simulated_efficiency_1000\": %.4g, \"simulated_efficiency_1000_serial\": %.4g}\n",
            bench_machine(), mean_taken(&one), efficiency, 1e3 * extra, 1e3 * service, many, at_most);
    else
        printf("%s; %s, %s\n"
               "frame by one process of one thread        %9.1f ms\n"
               "efficiency of two such processes          %9.3f\n"
               "hand-out, beyond the drawing              %9.3f ms a frame\n"
               "processor time of who hands out           %9.3f ms a frame\n"
               "SIMULATION of %d ranks with these times  %9.3f of their time is drawing\n"
               "  if the whole hand-out were serial        %9.3f\n",
               bench_machine(), scene, size, 1e3 * mean_taken(&one), efficiency, 1e3 * extra, 1e3 * service, RANKS,
               many, at_most);
    return 0;
}
