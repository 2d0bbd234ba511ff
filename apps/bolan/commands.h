// SPDX-License-Identifier: MIT
// The commands, in one table: the program, its help, its manual page and the completions of shells read it.
#ifndef BOLAN_CLI_COMMANDS_H
#define BOLAN_CLI_COMMANDS_H

typedef struct command {
    const char *name;
    unsigned bit; // ON_... of options.h, 0: it reads its arguments itself
    // Gets the arguments after the name; returns the program's exit code.
    int (*run)(int count, char **arguments);
    // As in the help. [SCENE] and [FILE] stand for what they say; a word or words|with|bars in small letters are the
    // choices of the first argument.
    const char *arguments;
    const char *help;
    int (*exists)(void); // NULL: always
} command;

extern const command command_table[]; // a NULL name ends it

int command_view(int count, char **arguments);
int command_render(int count, char **arguments);
int command_measure(int count, char **arguments);
int command_query(int count, char **arguments);
int command_farm(int count, char **arguments);
// One process of a farm: begun by command_farm() alone.
int command_farm_worker(int count, char **arguments);
int command_bake(int count, char **arguments);
int command_export(int count, char **arguments);
int command_info(int count, char **arguments);
int command_bench(int count, char **arguments);

// Is the program of the benchmarks beside this one?
int bench_is_there(void);

#endif
