// SPDX-License-Identifier: MIT
// Removes what a farm that was killed had begun to write.
#ifndef BOLAN_CLI_FARM_CLEAN_H
#define BOLAN_CLI_FARM_CLEAN_H

#include "farm_job.h"

// Removes the unfinished files of these frames, unless the process that writes them lives on this machine.
void farm_clean(const farm_job *job, const uint32_t *frames, uint32_t count);

#endif
