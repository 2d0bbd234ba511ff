// SPDX-License-Identifier: MIT
/// @file unfinished.h
/// The register of unfinished output of this process: temporary files and folders, and the ffmpeg processes that write
/// some of them. bolan_files_abandon() removes all of it from inside a signal handler. Private to src/io.
///
///     bolan_unfinished_claim()   then make the file, the folder or the process
///     bolan_unfinished_own()     it exists;  or bolan_unfinished_forget(): it was not made
///     ... write, then rename or remove ...
///     bolan_unfinished_forget()
///
/// Between claim and own this thread blocks signals, and a handler in another thread waits for the owner: a file exists
/// if and only if it is in the register.
#ifndef BOLAN_IO_UNFINISHED_H
#define BOLAN_IO_UNFINISHED_H

#include <signal.h>
#include <stdbool.h>
#include <sys/types.h>

typedef struct unfinished {
    int slot;  ///< of the register; -1: the register was full
    bool held; ///< signals are blocked in this thread
    sigset_t before;
} unfinished;

/// Removes the file or folder @p path. Async-signal-safe.
typedef void unfinished_discard(const char *path);

/// Opens an entry for @p path. Never returns once bolan_files_abandon() has been called: the process is ending.
unfinished bolan_unfinished_claim(const char *path, unfinished_discard *discard);
/// Closes an entry again while something is made for it (a process).
void bolan_unfinished_reclaim(unfinished *u);
/// Call it once the claimed file or process exists. @p process: the leader of the process group that writes it, or 0.
void bolan_unfinished_own(unfinished *u, pid_t process);
/// Frees the entry: nothing was made, or the file has its final name or is removed.
void bolan_unfinished_forget(unfinished *u);
/// Never returns once bolan_files_abandon() has been called.
void bolan_unfinished_wait_if_abandoned(void);

#endif
