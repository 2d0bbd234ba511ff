// SPDX-License-Identifier: MIT
// The process that draws: this program, started anew, at the other end of a socket. It gets the numbers of frames and
// answers each with a farm_result. The process that hands out has no OpenGL, so that a driver that crashes takes one
// frame with it.
#ifndef BOLAN_CLI_FARM_PROCESS_H
#define BOLAN_CLI_FARM_PROCESS_H

#include "farm_record.h"

#include <sys/types.h>

typedef struct farm_process {
    pid_t pid;  // 0: none
    int socket; // -1: none
} farm_process;

// Monotonic time [s].
double farm_now(void);
// Starts a process for the arguments of bolan farm, which draws with that many threads. False with errno.
bool farm_process_start(farm_process *p, int count, char **arguments, uint32_t threads);
// Hands a frame out. False: the process has ended.
bool farm_process_give(const farm_process *p, uint32_t frame);
// Waits for an answer. False: the process has ended; call farm_process_bury().
bool farm_process_take(const farm_process *p, farm_result *result);
// Ends the process if it lives, and says how it ended: "ended by signal 9 (Killed)". Removes what it had begun to
// write of the frame.
void farm_process_bury(farm_process *p, const farm_job *job, uint32_t frame, char reason[FARM_SENTENCE]);
// Lets the process end by itself, with nothing left to do.
void farm_process_dismiss(farm_process *p);

#endif
