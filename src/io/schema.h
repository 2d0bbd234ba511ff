// SPDX-License-Identifier: MIT
/// @file schema.h
/// Reads a YAML document into structs by tables of parameters: a dotted key such as "sky.clouds.cover" is the key
/// `cover` of the map `clouds` in the map `sky`. Unknown keys and values outside their ranges are refused with file,
/// line, key and what was expected. Private to src/io.
#ifndef BOLAN_IO_SCHEMA_H
#define BOLAN_IO_SCHEMA_H

#include "bolan/params.h"

/// The most keys, maps and list items of one document. More than the limits of lists allow.
enum { SCHEMA_MAX_GIVEN = 1024, SCHEMA_PATH = 44 };

/// The contents of a document: each key, map and list item by its path ("objects[3].scale", "" the document), with its
/// line.
typedef struct schema_given {
    uint32_t count;
    struct {
        char path[SCHEMA_PATH];
        uint32_t line;
    } entry[SCHEMA_MAX_GIVEN];
} schema_given;

/// The target of values: the groups of a struct (a NULL table ends them), and the struct.
typedef struct schema_target {
    const bolan_param_group *groups;
    void *base;
} schema_target;
enum { SCHEMA_TARGETS = 2 };

/// Parses @p text into the structs of @p targets. Fields without a key in the document keep their values; an element of
/// a list starts with its defaults. The root is a map; an empty document is an empty map. FORMAT on failure, also
/// beyond the limits of yaml_limits.h, and MEMORY (one sentence is logged; the structs are then partly filled).
bolan_result bolan_schema_read(const char *name, const char *text, size_t size,
                               const schema_target targets[SCHEMA_TARGETS], schema_given *given);
/// The line of the key, map or item @p path; 0 where the document does not have it.
uint32_t bolan_schema_line(const schema_given *given, const char *path);

#endif
