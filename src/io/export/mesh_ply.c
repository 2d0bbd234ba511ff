// SPDX-License-Identifier: MIT
// Meshes as PLY, binary and little-endian: the vertices of all parts, then their triangles.
#include "io/export/mesh_file.h"

static void write_header(const mesh_rows *r, export_writer *w) {
    static const char *const names[] = {"x", "y", "z", "nx", "ny", "nz", "foam", "vx", "vy", "vz"};
    const bolan_dvec3 o = r->desc->origin;
    const uint64_t parts = bolan_mesh_parts(r);
    bolan_export_text(w, "ply\nformat binary_little_endian 1.0\ncomment Bolan %s: x east, y north, z up [m]\n",
                      bolan_version());
    bolan_export_text(w, "comment origin ");
    bolan_export_number(w, o.x, 12), bolan_export_text(w, " ");
    bolan_export_number(w, o.y, 12), bolan_export_text(w, " ");
    bolan_export_number(w, o.z, 12);
    bolan_export_text(w, "\ncomment time ");
    bolan_export_number(w, bolan_sea_time(r->water.sea), 12);
    bolan_export_text(w, "\nelement vertex %llu\n", (unsigned long long)(parts * bolan_mesh_vertices(r)));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) bolan_export_text(w, "property float %s\n", names[i]);
    if (parts > 1) bolan_export_text(w, "property uchar part\n");
    bolan_export_text(w, "element face %llu\nproperty list uchar int vertex_indices\nend_header\n",
                      (unsigned long long)(parts * bolan_mesh_triangles(r)));
}

static void write_vertex(export_writer *w, const mesh_vertex *v) {
    for (int k = 0; k < 3; k++) bolan_export_f32(w, v->position[k]);
    for (int k = 0; k < 3; k++) bolan_export_f32(w, v->normal[k]);
    bolan_export_f32(w, v->foam);
    for (int k = 0; k < 3; k++) bolan_export_f32(w, v->velocity[k]);
}

static void write_triangles(const mesh_rows *r, uint32_t part, export_writer *w) {
    const uint32_t indices = 6 * (r->columns - 1);
    for (uint32_t row = 0; row + 1 < r->rows && !w->result; row++) {
        const uint32_t first = (uint32_t)(part * bolan_mesh_vertices(r)) + row * r->columns;
        for (uint32_t i = 0; i < indices; i++) {
            if (i % 3 == 0) bolan_export_u8(w, 3);
            bolan_export_u32(w, first + r->strip[i]);
        }
    }
}

void bolan_mesh_write_ply(mesh_rows *r, export_writer *w) {
    const uint32_t parts = bolan_mesh_parts(r);
    write_header(r, w);
    for (uint32_t part = 0; part < parts; part++)
        for (uint32_t row = 0; row < r->rows && !w->result; row += r->batch) {
            const uint32_t count = bolan_mesh_rows_make(r, (mesh_part)part, row);
            for (uint32_t i = 0; i < count; i++) {
                write_vertex(w, &r->vertices[i]);
                if (parts > 1) bolan_export_u8(w, (uint8_t)part);
            }
            bolan_mesh_progress(r, (uint64_t)part * r->rows + row, (uint64_t)parts * r->rows);
        }
    for (uint32_t part = 0; part < parts; part++) write_triangles(r, part, w);
}
