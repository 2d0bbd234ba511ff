// SPDX-License-Identifier: MIT
/// @file rows.h
/// Macros for the rows of parameter tables:
///
///     #define STRUCT bolan_sky
///     static const bolan_param rows[] = {
///         NUMBER(visibility, .low = 500, .high = 300e3, .fallback = 40e3, .unit = "m", .help = "..."),
///     };
///     #undef STRUCT
///     const bolan_param_table bolan_sky_params = TABLE("bolan_sky", rows);
///
/// Offset, size and name of a field come from its member.
#ifndef BOLAN_PARAMS_ROWS_H
#define BOLAN_PARAMS_ROWS_H

#include "bolan/params.h"

#include <math.h>

#define PARAM(member, type, ...)                                                          \
    {                                                                                     \
        .field = #member, .kind = BOLAN_PARAM_##type, .offset = offsetof(STRUCT, member), \
        .size = sizeof(((STRUCT *)NULL)->member), __VA_ARGS__                             \
    }
#define NUMBER(member, ...) PARAM(member, NUMBER, __VA_ARGS__)
#define WHOLE(member, ...) PARAM(member, WHOLE, __VA_ARGS__)
#define FLAG(member, ...) PARAM(member, FLAG, .high = 1, __VA_ARGS__)
#define NAME(member, ...) PARAM(member, NAME, __VA_ARGS__)
#define SET(member, ...) PARAM(member, SET, __VA_ARGS__)
#define TEXT(member, ...) PARAM(member, TEXT, __VA_ARGS__)
#define TABLE(type, rows) \
    { (type), (rows), sizeof(rows) / sizeof *(rows) }

#define SEED_MAX 0x1p64 // every number of 64 bits
#define HEADING(member, ...) NUMBER(member, .low = -360, .high = 360, .unit = "degrees", __VA_ARGS__)

#endif
