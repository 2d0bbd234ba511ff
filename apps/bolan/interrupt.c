// SPDX-License-Identifier: MIT
// See interrupt.h.
//
// The handler itself removes unfinished files and ends the program: bolan_files_abandon() is async-signal-safe. A flag
// that loops poll would not be enough, because a frame of many samples, a compiling driver, a raster that is read or a
// hanging ffmpeg would delay the end.
#include "interrupt.h"

#include "options.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t bar_shown;

static void end_program(int signal_number) {
    static const char wipe[] = "\r\033[K";
    (void)signal_number;
    if (bar_shown && write(STDERR_FILENO, wipe, sizeof wipe - 1) < 0) bar_shown = 0;
    bolan_files_abandon();
    _exit(EXIT_INTERRUPTED);
}

void interrupt_install(void) {
    static const int ends[] = {SIGINT, SIGTERM, SIGQUIT, SIGHUP};
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = end_program;
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) sigaddset(&action.sa_mask, ends[i]);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        // nohup(1) has set SIGHUP to be ignored: it stays ignored.
        const bool nohup = ends[i] == SIGHUP && sigaction(SIGHUP, NULL, &before) == 0 && before.sa_handler == SIG_IGN;
        if (!nohup) sigaction(ends[i], &action, NULL);
    }
    action.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &action, NULL);
}

void interrupt_bar_is_shown(bool shown) { bar_shown = shown; }
