// SPDX-License-Identifier: MIT
// See farm_slurm.h. Slurm copies the script away before it runs it, so that the program has its whole path, and the
// script goes to the folder that sbatch was called from. A task draws with one process of as many threads as Slurm
// gives it processors.
#include "farm_slurm.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_TASKS = 1000 }; // Slurm's own default limit of an array is 1001

// Quotes a word for the shell.
static void print_word(FILE *file, const char *word) {
    fputc('\'', file);
    for (; *word; word++) {
        if (*word == '\'')
            fputs("'\\''", file);
        else
            fputc(*word, file);
    }
    fputc('\'', file);
}

static void print_script(FILE *file, const farm_job *job, const char *program, int count, char **arguments) {
    const uint32_t tasks = job->count < MOST_TASKS ? job->count : MOST_TASKS;
    fprintf(file,
            "#!/bin/sh\n"
            "# %u frames by %u tasks. Submit it with: sbatch [-p PARTITION] [--array=...%%LIMIT] FILE\n"
            "# What is finished is not drawn again, so that it can be submitted once more after a failure.\n"
            "#SBATCH --job-name=bolan-farm\n"
            "#SBATCH --array=0-%u\n"
            "#SBATCH --ntasks=1\n"
            "#SBATCH --cpus-per-task=1\n"
            "set -eu\n"
            "cd \"${SLURM_SUBMIT_DIR:-.}\"\n"
            "exec ",
            (unsigned)job->count, (unsigned)tasks, (unsigned)tasks - 1);
    print_word(file, program);
    fprintf(file, " farm");
    for (int i = 0; i < count; i++) {
        if (strcmp(arguments[i], "--slurm") == 0) {
            i++;
        } else if (strncmp(arguments[i], "--slurm=", 8) != 0) {
            fputc(' ', file);
            print_word(file, arguments[i]);
        }
    }
    fprintf(file, " --processes 1 --threads \"${SLURM_CPUS_PER_TASK:-1}\" --quiet --part \"$SLURM_ARRAY_TASK_ID/%u\"\n",
            (unsigned)tasks);
}

int farm_slurm_write(const farm_job *job, const char *path, int count, char **arguments) {
    char program[BOLAN_PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (length <= 0) return failure("the path of this program is not known: %s", strerror(errno));
    program[length] = '\0';
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    if (file) print_script(file, job, program, count, arguments);
    const bool ok = file && fclose(file) == 0 && bolan_file_write(path, text, size) == BOLAN_OK;
    free(text);
    return ok ? EXIT_OK : EXIT_FAILED;
}
