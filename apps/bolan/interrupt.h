// SPDX-License-Identifier: MIT
// Signals that end the program: INT (Ctrl-C), TERM, QUIT, HUP (the terminal is closed).
#ifndef BOLAN_CLI_INTERRUPT_H
#define BOLAN_CLI_INTERRUPT_H

#include <stdbool.h>

// After the call such a signal removes every unfinished file, ends ffmpeg and exits with EXIT_INTERRUPTED at once,
// whatever the program is doing. A file beyond the size limit is a write error and no signal.
void interrupt_install(void);
// Tells the handler that a progress bar is on standard error; the handler then erases it.
void interrupt_bar_is_shown(bool shown);

#endif
