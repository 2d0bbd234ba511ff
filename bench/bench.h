// SPDX-License-Identifier: MIT
// Shared by the subcommands of bolan-bench. Each subcommand is `int bench_<name>(int argc, char **argv)`: argv[0] is
// its own name; it prints a table, or with --json one object, and returns the exit status.
#ifndef BOLAN_BENCH_BENCH_H
#define BOLAN_BENCH_BENCH_H

#include "bolan/base.h"

int bench_waves(int argc, char **argv);
int bench_query(int argc, char **argv);
int bench_frame(int argc, char **argv);
int bench_techniques(int argc, char **argv);
int bench_farm(int argc, char **argv);
int bench_farm(int argc, char **argv);

// Processor, instruction set and processor count in words, without characters that JSON would have to escape.
const char *bench_machine(void);
// Path of the program bolan, where it lies beside this one.
bool bench_program(char *path, size_t size);
// Monotonic time, and processor time of all threads of this process [ms].
double bench_now_ms(void);
double bench_cpu_ms(void);
double bench_thread_ms(void); // processor time of the calling thread [ms]

#endif
