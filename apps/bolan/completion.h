// SPDX-License-Identifier: MIT
// Completions of the command line for shells, of the tables that --help prints.
#ifndef BOLAN_CLI_COMPLETION_H
#define BOLAN_CLI_COMPLETION_H

#include <stdio.h>

extern const char *const completion_shells[]; // bash, zsh, fish; NULL at the end

// Prints the completion file for the shell of this index.
void completion_print(FILE *file, int shell);

#endif
