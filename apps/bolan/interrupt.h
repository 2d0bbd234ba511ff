// SPDX-License-Identifier: MIT
// What ends the program from outside: INT (Ctrl-C), TERM, QUIT, HUP (the terminal is gone).
#ifndef BOLAN_CLI_INTERRUPT_H
#define BOLAN_CLI_INTERRUPT_H

#include <stdbool.h>

// From now on such a signal removes every unfinished file, ends ffmpeg and exits with EXIT_INTERRUPTED, at once and
// whatever the program is doing. A file that grows too large is an error of writing and no signal.
void interrupt_install(void);
// A progress bar stands on standard error, which an interrupt should wipe away.
void interrupt_bar_is_shown(bool shown);

#endif
