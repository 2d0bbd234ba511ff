// SPDX-License-Identifier: MIT
// A script for sbatch: an array of tasks, each of which draws its part of the frames.
#ifndef BOLAN_CLI_FARM_SLURM_H
#define BOLAN_CLI_FARM_SLURM_H

#include "farm_job.h"

// Writes the script for the arguments of bolan farm. Returns an exit code.
int farm_slurm_write(const farm_job *job, const char *path, int count, char **arguments);

#endif
