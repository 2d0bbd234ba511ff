// SPDX-License-Identifier: MIT
// The kind of output of a file name, and names of numbered images.
#ifndef BOLAN_CLI_OUTPUT_H
#define BOLAN_CLI_OUTPUT_H

#include "bolan/scene.h"

typedef enum output_kind { OUTPUT_UNKNOWN, OUTPUT_PNG, OUTPUT_EXR, OUTPUT_VIDEO } output_kind;

typedef struct output_name {
    output_kind kind;
    bool numbered;        // the name holds one %d or %0Nd
    bool wrong_pattern;   // the name holds several patterns, an unsupported one, or one in the name of a video
    size_t before, after; // where the pattern begins and ends in the name
    int digits;
} output_name;

// UNKNOWN for a suffix that is none of .png .exr .mp4 .webm. A pattern is read in the last part of the path only,
// because one folder holds the whole sequence. There %% is one percent sign; a single one without a pattern is kept.
output_name output_parse(const char *path);
// The name of frame @p number; false when it is too long.
bool output_frame_path(const output_name *name, const char *path, uint32_t number, char out[BOLAN_PATH_MAX]);
// Prints a text of the user on stdout, with its control characters escaped.
void output_print(const char *text);

#endif
