// SPDX-License-Identifier: MIT
// bolan-bench: costs of the library, as a table or as JSON. It is a separate program because FFTW, the yardstick of the
// synthesis, is under the GPL and must not be linked to the program bolan.
#include "bench.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

typedef struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *help;
} command;

static const command commands[] = {
    {"waves", bench_waves, "a step of the sea, as a ratio to FFTW's bare transforms"},
    {"query", bench_query, "heights, normals and motion a second, as a ratio to memory"},
    {"frame", bench_frame, "a picture, pass by pass, as a ratio to a full-screen pass"},
    {"techniques", bench_techniques, "every technique, and the tables of the papers beside ours"},
    {"farm", bench_farm, "frames by one and two processes, the hand-out, a simulation of 1000 ranks"},
    {"farm", bench_farm, "frames by one and two processes, the hand-out, a simulation of 1000 ranks"},
};

static double clock_ms(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

double bench_now_ms(void) { return clock_ms(CLOCK_MONOTONIC); }

double bench_cpu_ms(void) { return clock_ms(CLOCK_PROCESS_CPUTIME_ID); }
double bench_thread_ms(void) { return clock_ms(CLOCK_THREAD_CPUTIME_ID); }

bool bench_program(char *path, size_t size) {
    const ssize_t length = readlink("/proc/self/exe", path, size - 1);
    if (length <= 0) return false;
    path[length] = '\0';
    char *slash = strrchr(path, '/');
    if (!slash || (size_t)(slash - path) + sizeof "/bolan" > size) return false;
    memcpy(slash, "/bolan", sizeof "/bolan");
    return access(path, X_OK) == 0;
}

static void read_processor(char *name, size_t size) {
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    snprintf(name, size, "unknown processor");
    while (file && fgets(line, sizeof line, file)) {
        const char *value = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !value) continue;
        snprintf(name, size, "%.*s", (int)strcspn(value + 2, "\n\"\\"), value + 2);
        break;
    }
    if (file) fclose(file);
}

const char *bench_machine(void) {
    static char text[192];
    char processor[128];
    read_processor(processor, sizeof processor);
    snprintf(text, sizeof text, "%s, %s, %ld processors", processor, bolan_cpu_name(bolan_cpu_best()),
             sysconf(_SC_NPROCESSORS_ONLN));
    return text;
}

// Ends like the program; a benchmark writes no file, so nothing must be removed.
static void end_program(int signal_number) {
    (void)signal_number;
    _exit(130);
}

static void end_on_signals(void) {
    static const int ends[] = {SIGINT, SIGTERM, SIGQUIT, SIGHUP};
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = end_program;
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) sigaction(ends[i], &action, NULL);
}

static int usage(void) {
    fprintf(stderr, "usage: bolan-bench COMMAND [--json] [...]\n");
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++)
        fprintf(stderr, "  %-10s %s\n", commands[i].name, commands[i].help);
    return 2;
}

int main(int argc, char **argv) {
    end_on_signals();
    if (argc < 2) return usage();
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++)
        if (strcmp(argv[1], commands[i].name) == 0) return commands[i].run(argc - 1, argv + 1);
    fprintf(stderr, "bolan-bench: unknown command '%s'\n", argv[1]);
    return usage();
}
