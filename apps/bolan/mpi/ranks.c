// SPDX-License-Identifier: MIT
// See ranks.h. Messages are small and few, one each way a frame. MPI's own waiting spins on a processor, which the
// process that draws needs: here a rank asks whether there is a message, and naps.
#include "ranks.h"

#include <mpi.h>
#include <stdlib.h>
#include <time.h>

enum { TAG_FRAME = 1, TAG_ANSWER, TAG_BEAT };

static double *heard; // of rank 0: when each rank was heard the last time [s]

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool is_started_by_mpi(void) {
    return getenv("OMPI_COMM_WORLD_SIZE") != NULL || getenv("PMIX_RANK") != NULL || getenv("PMI_RANK") != NULL;
}

int ranks_begin(ranks *r) {
    *r = (ranks){.rank = 0, .count = 1};
    if (!is_started_by_mpi()) return EXIT_OK;
    if (MPI_Init(NULL, NULL) != MPI_SUCCESS) return failure("MPI cannot be initialised");
    r->begun = true;
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN); // a rank that has died is no reason to die
    MPI_Comm_rank(MPI_COMM_WORLD, &r->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &r->count);
    heard = calloc((size_t)r->count, sizeof *heard);
    if (!heard) return failure("no memory for %d ranks", r->count);
    for (int i = 0; i < r->count; i++) heard[i] = now();
    return EXIT_OK;
}

void ranks_end(ranks *r, bool lost) {
    free(heard);
    heard = NULL;
    if (r->begun && lost) fflush(NULL), MPI_Abort(MPI_COMM_WORLD, EXIT_FAILED);
    if (r->begun) MPI_Finalize(); // which waits for every rank
    r->begun = false;
}

void ranks_give(int rank, uint32_t frame) {
    MPI_Request request; // small messages are buffered: to a dead rank a plain send would wait for ever
    static uint32_t numbers[4096];
    uint32_t *number = &numbers[(uint32_t)rank % 4096];
    *number = frame;
    if (MPI_Isend(number, sizeof *number, MPI_BYTE, rank, TAG_FRAME, MPI_COMM_WORLD, &request) == MPI_SUCCESS)
        MPI_Request_free(&request);
}

bool ranks_hear(int *rank, farm_result *result) {
    int there = 0, beat;
    MPI_Status status;
    for (;;) {
        if (MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status) != MPI_SUCCESS || !there)
            return false;
        *rank = status.MPI_SOURCE;
        heard[*rank] = now();
        if (status.MPI_TAG != TAG_BEAT) break;
        MPI_Recv(&beat, sizeof beat, MPI_BYTE, *rank, TAG_BEAT, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    return MPI_Recv(result, sizeof *result, MPI_BYTE, *rank, TAG_ANSWER, MPI_COMM_WORLD, MPI_STATUS_IGNORE) ==
           MPI_SUCCESS;
}

bool ranks_take(uint32_t *frame) {
    int there = 0;
    if (MPI_Iprobe(0, TAG_FRAME, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE) != MPI_SUCCESS || !there) return false;
    return MPI_Recv(frame, sizeof *frame, MPI_BYTE, 0, TAG_FRAME, MPI_COMM_WORLD, MPI_STATUS_IGNORE) == MPI_SUCCESS;
}

void ranks_answer(const farm_result *result) {
    MPI_Send(result, sizeof *result, MPI_BYTE, 0, TAG_ANSWER, MPI_COMM_WORLD);
}

void ranks_beat(void) {
    static double last;
    static const int beat = 1;
    if (now() - last < 1.0) return;
    last = now();
    MPI_Send(&beat, sizeof beat, MPI_BYTE, 0, TAG_BEAT, MPI_COMM_WORLD);
}

double ranks_silence(int rank) { return heard ? now() - heard[rank] : 0.0; }

void ranks_nap(void) { nanosleep(&(struct timespec){.tv_nsec = 200000}, NULL); }
