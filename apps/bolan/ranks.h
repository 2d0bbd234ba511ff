// SPDX-License-Identifier: MIT
// The ranks of an MPI job. Rank 0 hands out, and every rank has one process that draws. Built with BOLAN_WITH_MPI
// (mpi/ranks.c) or without (without/ranks.c), where there is one rank.
#ifndef BOLAN_CLI_RANKS_H
#define BOLAN_CLI_RANKS_H

#include "farm_record.h"

#define FARM_STOP UINT32_MAX // the number of no frame

typedef struct ranks {
    int rank, count;
    bool begun; // MPI was initialised
} ranks;

// Joins the job that mpirun or srun has started, if any. Returns an exit code; failures were reported.
int ranks_begin(ranks *r);
// Leaves it. @p lost: a rank has died; the others are ended, for they would wait for it, and the program with them.
void ranks_end(ranks *r, bool lost);
// Of rank 0: hands a frame to another rank. FARM_STOP: no more.
void ranks_give(int rank, uint32_t frame);
// Of rank 0: whether an answer has come, and from whom.
bool ranks_hear(int *rank, farm_result *result);
// Of the others: whether a frame has come.
bool ranks_take(uint32_t *frame);
// Of the others: answers.
void ranks_answer(const farm_result *result);
// Of the others: says that this rank lives.
void ranks_beat(void);
// Of rank 0: seconds since the rank was heard.
double ranks_silence(int rank);
// Waits a moment, shorter than a frame by far.
void ranks_nap(void);

#endif
