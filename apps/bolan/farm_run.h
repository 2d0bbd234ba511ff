// SPDX-License-Identifier: MIT
// Hands out frames, one at a time, to whoever is free: processes of this machine, or one process on every rank.
#ifndef BOLAN_CLI_FARM_RUN_H
#define BOLAN_CLI_FARM_RUN_H

#include "farm_record.h"
#include "ranks.h"

typedef struct farm_run {
    const farm_job *job;
    int count; // of the arguments of bolan farm
    char **arguments;
    farm_result *results; // by frame
    uint32_t *todo;       // frames in order
    uint32_t todo_count;
    uint32_t processes; // of this machine; 1 under MPI
    uint32_t threads;   // of each
    bool lost;          // a rank has died
    double processor;   // what handing out has cost this process [s]
} farm_run;

// Of rank 0: draws what is to do. A frame that fails is not tried again; farm_run.results says why.
// False: nothing could be started.
bool farm_run_all(farm_run *run, const ranks *r);
// Of the other ranks: draws what is handed out.
bool farm_run_rank(farm_run *run);

#endif
