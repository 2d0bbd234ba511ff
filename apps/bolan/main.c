// SPDX-License-Identifier: MIT
// The command line of Bolan: `bolan COMMAND [SCENE] [OPTIONS]`.
#include "commands.h"
#include "interrupt.h"
#include "options.h"

#include <string.h>

const command command_table[] = {
#ifdef BOLAN_HAVE_VIEWER
    {"view", ON_VIEW, command_view, "[SCENE]", "a window to fly through the scene", NULL},
#endif
    {"render", ON_RENDER, command_render, "[SCENE] -o FILE",
     "one .png or .exr, a numbered sequence (%04d), or .mp4/.webm", NULL},
    {"measure", ON_MEASURE, command_measure, "[SCENE]", "statistics of the synthesised sea", NULL},
    {"query", ON_QUERY, command_query, "[SCENE] --points FILE.csv", "heights and normals at points, as CSV", NULL},
    {"bake", ON_BAKE, command_bake, "[SCENE] -o DIR", "looping tiles: heights, normal maps, light on the bottom", NULL},
    {"farm", ON_FARM, command_farm, "[SCENE|TABLE.csv] -o FILE",
     "frames or rows of a table by many processes, MPI ranks or Slurm", NULL},
    {"export", ON_EXPORT, command_export, "mesh|fields|sky|spectrum [SCENE] -o FILE", "the water for other programs",
     NULL},
    {"bench", 0, command_bench, "[waves|query|frame|techniques|farm]", "benchmarks", bench_is_there},
    {"info", ON_INFO, command_info, "[FILE]", "build, processor, scenes; or what a file of spectra holds", NULL},
    {.name = NULL},
};

static int print_help(FILE *file) {
    fputs("Bolan makes, measures and draws seas.\n\nusage: bolan COMMAND [SCENE] [OPTIONS]\n\n", file);
    for (const command *c = command_table; c->name; c++)
        if (!c->exists || c->exists()) fprintf(file, "  bolan %-8s %-41s %s\n", c->name, c->arguments, c->help);
    fputs("\nbolan COMMAND --help lists the options of a command; bolan --version prints the version.\n", file);
    return EXIT_OK;
}

// Prints every message of the library and of the program. bolan_log() has made it one line without control characters.
static void print_message(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user;
    // What was chosen among records and locations is worth a line; other information is not.
    if (level == BOLAN_LOG_INFO && id != BOLAN_LOG_SPECTRUM_LOCATION && id != BOLAN_LOG_SPECTRUM_NEAREST_TIME) return;
    fprintf(stderr, "bolan: %s%s\n", level == BOLAN_LOG_WARNING ? "warning: " : "", sentence);
}

// Standard output may be a full disk or a closed pipe: then the result is lost, and the exit code must be an error.
static int flush_output(int code) {
    const bool failed = fflush(stdout) != 0 || ferror(stdout);
    bolan_set_hooks(&(bolan_hooks){.log = print_message}); // a command may have set another hook
    return failed && code == EXIT_OK ? failure("standard output cannot be written") : code;
}

int main(int count, char **arguments) {
    bolan_set_hooks(&(bolan_hooks){.log = print_message});
    interrupt_install();
    if (count < 2) return print_help(stderr), EXIT_USAGE;
    const char *name = arguments[1];
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0)
        return flush_output(print_help(stdout));
    if (strcmp(name, "--version") == 0) return printf("bolan %s\n", bolan_version()), flush_output(EXIT_OK);
    if (strcmp(name, "worker") == 0) return flush_output(command_farm_worker(count - 2, arguments + 2));
    for (const command *c = command_table; c->name; c++)
        if (strcmp(name, c->name) == 0) return flush_output(c->run(count - 2, arguments + 2));
    char word[SHORT_WORD];
    return usage_error("unknown command %s; see bolan --help", shorten(name, word));
}
