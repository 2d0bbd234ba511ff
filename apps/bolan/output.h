// SPDX-License-Identifier: MIT
// What kind of output a file name means, and names of numbered pictures.
#ifndef BOLAN_CLI_OUTPUT_H
#define BOLAN_CLI_OUTPUT_H

#include "bolan/scene.h"

typedef enum output_kind { OUTPUT_UNKNOWN, OUTPUT_PNG, OUTPUT_EXR, OUTPUT_VIDEO } output_kind;

typedef struct output_name {
    output_kind kind;
    bool numbered;        // the name holds one %d or %0Nd
    bool wrong_pattern;   // it holds several, or another form of them, or one in the name of a video
    size_t before, after; // where the pattern begins and ends in the name
    int digits;
} output_name;

// UNKNOWN for a suffix that is none of .png .exr .mp4 .webm. A percent sign counts in the last part of the path alone,
// for a folder holds the whole sequence. There %% is one percent sign, and one that begins no pattern is itself.
output_name output_parse(const char *path);
// The name of frame @p number; false when it is too long.
bool output_frame_path(const output_name *name, const char *path, uint32_t number, char out[BOLAN_PATH_MAX]);
// Prints a text of the user on stdout, with its control characters escaped.
void output_print(const char *text);

#endif
