// SPDX-License-Identifier: MIT
/// @file model_file.h
/// Model files: the checks before assimp reads them, and the mesh that is built from them. Private to src/io.
#ifndef BOLAN_IO_MODEL_FILE_H
#define BOLAN_IO_MODEL_FILE_H

#include "bolan/io.h"

#define MODEL_FILE_LIMIT ((size_t)64 << 20) // [bytes]
#define MODEL_VERTEX_LIMIT (1u << 23)       // and three times as many indices
#define MODEL_DEPTH_LIMIT 64                // of nodes in nodes
#define MODEL_REACH 1e7f                    // of a vertex from the origin [m]

typedef enum model_format { MODEL_GLTF, MODEL_OBJ, MODEL_OTHER } model_format;

/// Refuses files that would cost the importing library too much time, memory or stack: numbers of hundreds of
/// digits, deep brackets and nodes, counts that the file does not hold; a glTF that requires an extension or is not of
/// version 2. FORMAT, IO, MEMORY.
bolan_result bolan_model_file_check(const char *path, model_format *format);
/// The checks of glTF, on the JSON of the file @p path.
bolan_result bolan_model_gltf_check(const char *path, const char *text, size_t size);
/// Logs a sentence with MODEL_LIMIT and returns FORMAT.
bolan_result bolan_model_refuse(const char *path, const char *what);

/// A mesh that grows up to its capacity.
typedef struct model_mesh {
    uint32_t vertex_count, index_count, vertex_room, index_room;
    bolan_vec3 *positions, *normals;
    bolan_vec4 *colors;
    uint32_t *indices;
} model_mesh;

/// Gives the vertices [first, vertex_count) of a mesh normals by their triangles, the indices from @p first_index on:
/// flat ones where @p crease is above 1, else the mean over the triangles around the vertex whose normals lie within
/// the angle of cosine @p crease. A vertex is split where its triangles differ, and those that are equal become one:
/// the mesh must have room for a vertex of each index. MEMORY.
bolan_result bolan_model_make_normals(model_mesh *mesh, uint32_t first, uint32_t first_index, float crease);

#endif
