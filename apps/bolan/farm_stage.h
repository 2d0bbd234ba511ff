// SPDX-License-Identifier: MIT
// Draws and writes one frame of a farm. A frame is a function of its parameters: its foam is that of a sea that has run
// (bolan_world_settle()), and what the renderer keeps is made anew where the scene has changed.
#ifndef BOLAN_CLI_FARM_STAGE_H
#define BOLAN_CLI_FARM_STAGE_H

#include "farm_record.h"

typedef struct farm_stage farm_stage;

// NULL after an error, which was logged: no OpenGL, no memory.
farm_stage *farm_stage_open(const farm_job *job);
// Writes the files of a frame and, last, its record. False after an error, which was logged.
bool farm_stage_draw(farm_stage *stage, uint32_t frame, farm_result *result);
void farm_stage_close(farm_stage **stage);

#endif
