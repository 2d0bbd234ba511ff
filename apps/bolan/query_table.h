// SPDX-License-Identifier: MIT
// The columns of `bolan query`: their names, what has to be asked for them, and their rows as text.
#ifndef BOLAN_CLI_QUERY_TABLE_H
#define BOLAN_CLI_QUERY_TABLE_H

#include "bolan/query.h"

enum { QUERY_MAX_COLUMNS = 32, QUERY_CELL = 32, QUERY_NAMES = 256 };

// What is asked for a column.
enum { ASK_SURFACE = 1, ASK_FOAM = 2, ASK_MOTION = 4, ASK_BELOW = 8 };

typedef struct query_columns {
    int index[QUERY_MAX_COLUMNS]; // in the table of columns
    int count;
    unsigned asks; // ASK_...
} query_columns;

// The columns where none are asked for: of points without and with a z.
#define QUERY_COLUMNS_SURFACE "x,y,height,normal,jacobian,residual"
#define QUERY_COLUMNS_BELOW "x,y,z,height,velocity,acceleration,pressure,wet"
// Reads a list such as "x,y,z,velocity". "velocity" is velocity_x, _y and _z. Says
// one sentence and returns false for a name that is none.
bool query_columns_parse(const char *list, query_columns *out);
// "x,y,height\n"; returns the length.
size_t query_columns_header(const query_columns *columns, char out[QUERY_MAX_COLUMNS * QUERY_CELL]);

// A batch of points and answers.
typedef struct query_batch {
    uint32_t count;
    bolan_dvec3 *xyz; // z NAN: at the surface
    bolan_dvec2 *xy;
    bolan_query_point *surface;
    float *foam;
    bolan_surface_motion *motion;
    bolan_kinematics *below;
} query_batch;

// Memory for `capacity` points, with what `asks` needs. False when there is none; free it in any case.
bool query_batch_create(query_batch *batch, uint32_t capacity, unsigned asks);
void query_batch_free(query_batch *batch);
// Answers the batch. A least wavelength makes height and normal those of bolan_query_motion().
void query_batch_answer(query_batch *batch, const bolan_water *water, const bolan_question *question, unsigned asks);
// Rows [first, end) as text; returns the length, at most QUERY_MAX_COLUMNS * QUERY_CELL a row.
size_t query_batch_print(const query_batch *batch, const query_columns *columns, const bolan_question *question,
                         uint32_t first, uint32_t end, char *out);

#endif
