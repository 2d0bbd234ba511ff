// SPDX-License-Identifier: MIT
// See ranks.h. A build without MPI.
#include "ranks.h"

#include <stdlib.h>

int ranks_begin(ranks *r) {
    *r = (ranks){.rank = 0, .count = 1};
    const char *count = getenv("OMPI_COMM_WORLD_SIZE");
    if (!count || atoi(count) <= 1) return EXIT_OK;
    return failure("mpirun has started %d of these programs, which are built without MPI; start one, or build with "
                   "-DBOLAN_WITH_MPI=ON",
                   atoi(count));
}

void ranks_end(ranks *r, bool lost) { (void)r, (void)lost; }
void ranks_give(int rank, uint32_t frame) { (void)rank, (void)frame; }
bool ranks_hear(int *rank, farm_result *result) { return (void)rank, (void)result, false; }
bool ranks_take(uint32_t *frame) { return (void)frame, false; }
void ranks_answer(const farm_result *result) { (void)result; }
void ranks_beat(void) {}
double ranks_silence(int rank) { return (void)rank, 0.0; }
void ranks_nap(void) {}
