// SPDX-License-Identifier: MIT
// The manual page bolan(1), of the tables that --help prints.
#ifndef BOLAN_CLI_MAN_H
#define BOLAN_CLI_MAN_H

#include <stdio.h>

// Prints the page in the macros of man(7).
void man_print(FILE *file);

#endif
