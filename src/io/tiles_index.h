// SPDX-License-Identifier: MIT
/// @file tiles_index.h
/// index.json of a folder of tiles: one flat JSON object of numbers. Private to src/io.
#ifndef BOLAN_IO_TILES_INDEX_H
#define BOLAN_IO_TILES_INDEX_H

#include "bolan/tiles.h"

enum { TILES_INDEX_CAPACITY = 1024, TILES_INDEX_LIMIT = 4096 }; ///< [bytes] written at most; read at most

/// Prints the index of @p v; @p step: metres between two grey values of the heights. Returns the length.
size_t bolan_tiles_index_print(const bolan_tiles_view *v, double step, char out[TILES_INDEX_CAPACITY]);
/// Reads an index. FORMAT with file, key and what was expected: text that is not such an object, a key that is missing,
/// unknown or given twice, a number out of its range.
bolan_result bolan_tiles_index_parse(const char *path, const char *text, size_t size, bolan_tiles_view *v,
                                     double *step);

#endif
