// SPDX-License-Identifier: MIT
// A table of frames: CSV whose columns are `scene` and options of scenes without their dashes, and whose rows are
// frames. An empty cell is an option that is not given.
#ifndef BOLAN_CLI_FARM_TABLE_H
#define BOLAN_CLI_FARM_TABLE_H

#include "options.h"

typedef struct farm_row {
    uint32_t line;  // in the file, from 1
    uint32_t first; // of its arguments
    int count;
} farm_row;

typedef struct farm_table {
    const char *path;
    char *text;       // of the file, in which cells end with a NUL
    char *words;      // the arguments, "--wind=12"
    char **arguments; // of all rows
    farm_row *rows;
    uint32_t count;
} farm_table;

// Returns an exit code; failures were reported with file and line. farm_table_free() in any case.
int farm_table_read(const char *path, farm_table *table);
void farm_table_free(farm_table *table);

#endif
