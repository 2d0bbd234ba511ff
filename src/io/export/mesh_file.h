// SPDX-License-Identifier: MIT
/// @file mesh_file.h
/// The formats of meshes. Each writes all of an open file; errors are kept in the writer. Private to src/io/export.
#ifndef BOLAN_IO_EXPORT_MESH_FILE_H
#define BOLAN_IO_EXPORT_MESH_FILE_H

#include "io/export/rows.h"
#include "io/export/writer.h"

void bolan_mesh_write_ply(mesh_rows *r, export_writer *w);
void bolan_mesh_write_obj(mesh_rows *r, export_writer *w);
/// Steps the world where there are several frames. FORMAT or MEMORY, logged, before anything is written.
bolan_result bolan_mesh_write_glb(mesh_rows *r, export_writer *w);

/// From x east, y north, z up to x east, y up, z south, the axes of glTF.
static inline void bolan_mesh_y_up(const float v[3], float out[3]) { out[0] = v[0], out[1] = v[2], out[2] = -v[1]; }

/// Tells the caller's function how many rows of the whole work are done.
static inline void bolan_mesh_progress(const mesh_rows *r, uint64_t done, uint64_t total) {
    const bolan_export_frames *f = &r->desc->frames;
    if (f->progress) f->progress(f->user, (uint32_t)(done * 1000 / total), 1000);
}

#endif
