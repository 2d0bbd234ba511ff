// SPDX-License-Identifier: MIT
// Meshes of the surface: which format, and the life of the file.
#include "io/export/mesh_file.h"

static bolan_export_grid default_grid(void) { return (bolan_export_grid){{-128.0, -128.0}, {128.0, 128.0}, 0.5}; }
static bolan_export_frames default_frames(void) { return (bolan_export_frames){.count = 1, .fps = 30.0}; }

bolan_export_mesh_desc bolan_export_mesh_desc_default(void) {
    return (bolan_export_mesh_desc){.vertices = BOLAN_EXPORT_VIEW,
                                    .grid = default_grid(),
                                    .width = 1280,
                                    .height = 720,
                                    .most_vertices = 200000,
                                    .frames = default_frames()};
}

bolan_export_fields_desc bolan_export_fields_desc_default(void) {
    return (bolan_export_fields_desc){.grid = default_grid(), .frames = default_frames()};
}

static bolan_result refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %s", path, what);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result write_mesh(mesh_rows *r, const char *path) {
    export_writer w;
    bolan_result result = bolan_export_open(path, &w);
    if (result) return result;
    if (bolan_export_has_suffix(path, ".glb")) {
        result = bolan_mesh_write_glb(r, &w);
    } else {
        bolan_mesh_rows_step(r, bolan_sea_time(r->water.sea), 0);
        if (bolan_export_has_suffix(path, ".ply")) {
            bolan_mesh_write_ply(r, &w);
        } else {
            bolan_mesh_write_obj(r, &w);
        }
    }
    const bolan_result closed = bolan_export_close(&w, result == BOLAN_OK);
    return result ? result : closed;
}

bolan_result bolan_export_mesh(bolan_world *world, const bolan_export_mesh_desc *desc, const char *path) {
    BOLAN_ASSERT(world && desc && path);
    const bool glb = bolan_export_has_suffix(path, ".glb"), obj = bolan_export_has_suffix(path, ".obj");
    if (!glb && !obj && !bolan_export_has_suffix(path, ".ply"))
        return refuse(path, "expected a name that ends in .ply, .obj or .glb");
    if (desc->frames.count > 1 && !glb)
        return refuse(path, "several frames in one mesh; expected a .glb, or a file each");
    mesh_rows r;
    bolan_result result = bolan_mesh_rows_open(world, desc, path, &r);
    if (!result && obj)
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_EXPORT_LEFT_OUT,
                  "%s: OBJ has no place for the velocity; .ply and .glb have one", path);
    if (!result) result = write_mesh(&r, path);
    bolan_mesh_rows_close(&r);
    return result;
}
