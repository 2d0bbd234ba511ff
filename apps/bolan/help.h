// SPDX-License-Identifier: MIT
// The help of one command.
#ifndef BOLAN_CLI_HELP_H
#define BOLAN_CLI_HELP_H

// Prints how to use a command (its usage line, what it does, its options) on stdout; returns EXIT_OK.
int help_command(unsigned command, const char *usage, const char *what);

#endif
