// SPDX-License-Identifier: MIT
/// @file unfinished.h
/// The register of what this process has begun to write and not finished: temporary files and folders, and the ffmpeg
/// processes that write some of them. bolan_files_abandon() clears it away from inside a signal handler. Private to
/// src/io.
///
///     bolan_unfinished_claim()  -> make the file, the folder or the process -> bolan_unfinished_own()     it is ours now
///                                                                     or bolan_unfinished_forget()  it was not made
///     ... write ...       -> rename or remove                         -> bolan_unfinished_forget()
///
/// Between claim and own this thread takes no signal, and a handler in another thread waits for the owner: so there is
/// no moment in which a file is there and not in the register, or the other way round.
#ifndef BOLAN_IO_UNFINISHED_H
#define BOLAN_IO_UNFINISHED_H

#include <signal.h>
#include <stdbool.h>
#include <sys/types.h>

typedef struct unfinished {
    int slot;  ///< of the register; -1: none, for the register was full
    bool held; ///< signals are held back from this thread
    sigset_t before;
} unfinished;

/// Removes what stands at @p path. Async-signal-safe.
typedef void unfinished_discard(const char *path);

/// Opens an entry for @p path. Never returns once bolan_files_abandon() has been called: the process is ending.
unfinished bolan_unfinished_claim(const char *path, unfinished_discard *discard);
/// Closes an entry again while something is made for it (a process).
void bolan_unfinished_reclaim(unfinished *u);
/// What was claimed exists. @p process: the leader of the process group that writes it, or 0.
void bolan_unfinished_own(unfinished *u, pid_t process);
/// The entry is no more: nothing was made, or it has its final name, or it is removed.
void bolan_unfinished_forget(unfinished *u);
/// Never returns once bolan_files_abandon() has been called.
void bolan_unfinished_wait_if_abandoned(void);

#endif
