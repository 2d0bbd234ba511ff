// SPDX-License-Identifier: MIT
/// @file schema.h
/// Reads a YAML document into a C struct by a table of keys. What is not in the table, or outside its range, is refused
/// with file, line, key and what was expected. Private to src/io.
#ifndef BOLAN_IO_SCHEMA_H
#define BOLAN_IO_SCHEMA_H

#include "bolan/base.h"

typedef enum schema_kind {
    SCHEMA_NUMBER, ///< double in [low, high]
    SCHEMA_COUNT,  ///< uint64_t in [low, high]
    SCHEMA_NAME,   ///< int: index into names, in any case
    SCHEMA_FLAG,   ///< bool: true or false, yes or no
    SCHEMA_SET,    ///< uint32_t: a bit for each of the names given as a YAML list or a text with commas; all or none
    SCHEMA_TEXT,   ///< char[capacity], not empty
    SCHEMA_VECTOR, ///< double[capacity], each in [low, high]: a YAML list of that length
    SCHEMA_MAP,    ///< a struct that begins with uint32_t line: 0 where the map is absent
    SCHEMA_LIST, ///< at most `capacity` such structs, `stride` apart; the uint32_t at `count_offset` receives how many
} schema_kind;

typedef struct schema_key {
    const char *name; ///< NULL ends a table
    schema_kind kind;
    size_t offset; ///< in the struct that the table describes
    double low, high;
    const char *unit;         ///< for messages; NULL for none
    const char *const *names; ///< of NAME and SET, NULL at the end
    uint32_t capacity;
    size_t stride, count_offset;
    const struct schema_key *keys; ///< of MAP and LIST
} schema_key;

/// Parses @p text and fills the struct @p out, whose members keep their values where the document has no key. The root
/// is a map; an empty document is an empty map. FORMAT on failure, also beyond the limits of yaml_limits.h, and MEMORY
/// (one sentence is logged; @p out is then partly filled).
bolan_result bolan_schema_read(const char *name, const char *text, size_t size, const schema_key *keys, void *out);

#endif
