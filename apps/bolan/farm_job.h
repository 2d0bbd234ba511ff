// SPDX-License-Identifier: MIT
// The frames of a farm: frame i of a scene, or row i of a table. Every process reads the same arguments and finds the
// same frames, so that a frame is handed out by its number alone.
#ifndef BOLAN_CLI_FARM_JOB_H
#define BOLAN_CLI_FARM_JOB_H

#include "farm_table.h"
#include "options.h"
#include "output.h"

// What is written of a frame, as bits, by the names of --outputs.
enum {
    FARM_PICTURE = 1,       // NAME.png
    FARM_LINEAR = 2,        // NAME.exr: R, G, B
    FARM_DISTANCE = 4,      // Z
    FARM_NORMAL = 8,        // normal.X, .Y, .Z
    FARM_SEGMENTATION = 16, // segmentation
    FARM_MOTION = 32,       // motion.X, .Y, .Z
    FARM_LAYERS = 62,       // all that stands in NAME.exr
    FARM_SURFACES = FARM_NORMAL | FARM_SEGMENTATION | FARM_MOTION,
};

typedef enum farm_file { FARM_FILE_PICTURE, FARM_FILE_LAYERS, FARM_FILE_RECORD, FARM_FILES } farm_file;

typedef struct farm_job {
    options given; // of the command line
    farm_table table;
    bool has_table;
    bolan_scene scene; // without a table: of all frames
    const char *path;
    output_name name; // of path
    uint32_t count, part, parts;
    uint32_t width, height, samples, tile;
    double fps;
    unsigned outputs; // FARM_PICTURE ...
    bolan_quality quality;
    bolan_backend backend;
    bolan_pixels pixels;
    bool quiet;
} farm_job;

// Reads the arguments of bolan farm. Returns an exit code; failures were reported. farm_job_free() in any case.
int farm_job_read(const options *o, farm_job *job);
void farm_job_free(farm_job *job);
// The scene of a frame, at its time. Returns an exit code; failures were reported.
int farm_job_scene(const farm_job *job, uint32_t frame, bolan_scene *scene);
// The name of a file of a frame; false where it is too long.
bool farm_job_file(const farm_job *job, uint32_t frame, farm_file file, char out[BOLAN_PATH_MAX]);
// Whether such a file is among the outputs. Every frame has a record.
bool farm_job_has_file(const farm_job *job, farm_file file);
// The name of the manifest.
bool farm_job_manifest(const farm_job *job, char out[BOLAN_PATH_MAX]);
// What stands behind the last slash.
const char *farm_last_part(const char *path);

#endif
