// SPDX-License-Identifier: MIT
// The commands. Each gets the arguments after its name and returns the program's exit code.
#ifndef BOLAN_CLI_COMMANDS_H
#define BOLAN_CLI_COMMANDS_H

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
