// SPDX-License-Identifier: MIT
// See unfinished.h. Everything that bolan_files_abandon() reaches is async-signal-safe: lock-free atomics, and the
// system calls that POSIX lists (signal-safety(7)).
#include "io/unfinished.h"

#include "io/file.h"

#include <errno.h>
#include <poll.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SLOTS = 32, PATIENCE_MS = 300 };
enum { FREE, CLAIMED, OWNED };

typedef struct slot {
    atomic_int state;
    atomic_int process;
    unfinished_discard *discard;
    char path[FILE_NAME_CAPACITY];
} slot;

static slot slots[SLOTS];
static atomic_bool abandoned;

void bolan_unfinished_wait_if_abandoned(void) {
    while (atomic_load(&abandoned)) pause();
}

static void hold_signals(unfinished *u) {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &u->before);
    u->held = true;
}

static void release_signals(unfinished *u) {
    if (u->held) pthread_sigmask(SIG_SETMASK, &u->before, NULL);
    u->held = false;
}

// This thread claims a slot, then reads `abandoned`; the handler sets `abandoned`, then reads the slots. So at least
// one of the two sees the other.
static void stay_away_if_abandoned(unfinished *u) {
    if (!atomic_load(&abandoned)) return;
    if (u->slot >= 0) atomic_store(&slots[u->slot].state, FREE);
    release_signals(u);
    bolan_unfinished_wait_if_abandoned();
}

unfinished bolan_unfinished_claim(const char *path, unfinished_discard *discard) {
    unfinished u = {.slot = -1};
    hold_signals(&u);
    for (int i = 0; i < SLOTS && u.slot < 0; i++) {
        int expected = FREE;
        if (atomic_compare_exchange_strong(&slots[i].state, &expected, CLAIMED)) u.slot = i;
    }
    if (u.slot >= 0) {
        snprintf(slots[u.slot].path, sizeof slots[u.slot].path, "%s", path);
        slots[u.slot].discard = discard;
        atomic_store(&slots[u.slot].process, 0);
    }
    stay_away_if_abandoned(&u);
    return u;
}

void bolan_unfinished_reclaim(unfinished *u) {
    hold_signals(u);
    int expected = OWNED;
    // Where the handler came first, it has removed the file.
    if (u->slot >= 0) atomic_compare_exchange_strong(&slots[u->slot].state, &expected, CLAIMED);
    stay_away_if_abandoned(u);
}

void bolan_unfinished_own(unfinished *u, pid_t process) {
    if (u->slot >= 0) {
        atomic_store(&slots[u->slot].process, (int)process);
        atomic_store(&slots[u->slot].state, OWNED);
    }
    release_signals(u);
}

void bolan_unfinished_forget(unfinished *u) {
    if (u->slot >= 0) atomic_store(&slots[u->slot].state, FREE);
    u->slot = -1;
    release_signals(u);
}

// Ends the process group, so that the children of the process end too.
static void end_process(int process) {
    if (process <= 0) return;
    kill(-process, SIGKILL);
    while (waitpid(process, NULL, 0) < 0 && errno == EINTR) continue;
}

void bolan_files_abandon(void) {
    const int reason = errno;
    atomic_store(&abandoned, true);
    for (int i = 0; i < SLOTS; i++) {
        for (int ms = 0; ms < PATIENCE_MS && atomic_load(&slots[i].state) == CLAIMED; ms++) poll(NULL, 0, 1);
        if (atomic_load(&slots[i].state) == OWNED) end_process(atomic_load(&slots[i].process));
    }
    // In reverse order, because a folder is claimed before the files in it.
    for (int i = SLOTS - 1; i >= 0; i--)
        if (atomic_load(&slots[i].state) == OWNED) slots[i].discard(slots[i].path);
    errno = reason;
}
