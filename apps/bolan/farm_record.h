// SPDX-License-Identifier: MIT
// What stands beside each frame, and the manifest of all. A record is a function of the frame's parameters and of the
// bytes of its files: a frame is finished when the record on disk equals the one that its files on disk give.
#ifndef BOLAN_CLI_FARM_RECORD_H
#define BOLAN_CLI_FARM_RECORD_H

#include "farm_job.h"
#include "sha256.h"

// What became of a frame. Sent between processes as bytes of the same program.
typedef enum farm_state { FARM_OPEN, FARM_DONE, FARM_FAILED } farm_state;
enum { FARM_SENTENCE = 256 };
typedef struct farm_result {
    uint32_t frame;
    farm_state state;
    double time;                        // of the frame's scene [s]
    // What it took: drawing and writing; from hand-out to answer [s]. By which process or rank. Not in the manifest.
    double draw, taken;
    uint32_t by;
    char hash[FARM_FILES][SHA256_TEXT]; // "" for a file that is not among the outputs
    char reason[FARM_SENTENCE];         // of a failure
    char warning[FARM_SENTENCE];        // the first that was said, or ""
} farm_result;

// Hashes the frame's files and its record, which is written first with @p write. Returns false where one is missing or,
// without @p write, where the record on disk is another.
bool farm_record(const farm_job *job, uint32_t frame, const bolan_scene *scene, bool write, farm_result *result);
// Writes the manifest of the frames that are done or have failed. Returns an exit code.
int farm_manifest_write(const farm_job *job, const farm_result *results);

#endif
