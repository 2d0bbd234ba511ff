// SPDX-License-Identifier: MIT
// Meshes as OBJ, text: an object for each part. Foam is the colour of the vertex, which many programs read behind its
// position.
#include "io/export/mesh_file.h"

enum { DIGITS = 9 }; // which read back as the same float

static void write_vector(export_writer *w, const char *word, const float v[3]) {
    float turned[3];
    bolan_mesh_y_up(v, turned);
    bolan_export_text(w, "%s", word);
    for (int k = 0; k < 3; k++) {
        bolan_export_text(w, " ");
        bolan_export_number(w, (double)turned[k], DIGITS);
    }
}

static void write_vertices(mesh_rows *r, uint32_t part, export_writer *w) {
    for (uint32_t row = 0; row < r->rows && !w->result; row += r->batch) {
        const uint32_t count = bolan_mesh_rows_make(r, (mesh_part)part, row);
        for (uint32_t i = 0; i < count; i++) {
            const mesh_vertex *v = &r->vertices[i];
            write_vector(w, "v", v->position);
            for (int k = 0; k < 3; k++) {
                bolan_export_text(w, " ");
                bolan_export_number(w, (double)v->foam, DIGITS);
            }
            write_vector(w, "\nvn", v->normal);
            bolan_export_text(w, "\n");
        }
        bolan_mesh_progress(r, (uint64_t)part * r->rows + row, (uint64_t)bolan_mesh_parts(r) * r->rows);
    }
}

static void write_triangles(const mesh_rows *r, uint32_t part, export_writer *w) {
    for (uint32_t row = 0; row + 1 < r->rows && !w->result; row++) {
        const uint32_t first = (uint32_t)(part * bolan_mesh_vertices(r)) + row * r->columns + 1; // counted from 1
        for (uint32_t i = 0; i < 6 * (r->columns - 1); i += 3) {
            const uint32_t a = first + r->strip[i], b = first + r->strip[i + 1], c = first + r->strip[i + 2];
            bolan_export_text(w, "f %u//%u %u//%u %u//%u\n", (unsigned)a, (unsigned)a, (unsigned)b, (unsigned)b,
                              (unsigned)c, (unsigned)c);
        }
    }
}

void bolan_mesh_write_obj(mesh_rows *r, export_writer *w) {
    const bolan_dvec3 o = r->desc->origin;
    bolan_export_text(w, "# Bolan %s: x east, y up, z south [m]; colour: foam\n# origin (east north up) ",
                      bolan_version());
    bolan_export_number(w, o.x, 12), bolan_export_text(w, " ");
    bolan_export_number(w, o.y, 12), bolan_export_text(w, " ");
    bolan_export_number(w, o.z, 12);
    bolan_export_text(w, "\n# time ");
    bolan_export_number(w, bolan_sea_time(r->water.sea), 12);
    for (uint32_t part = 0; part < bolan_mesh_parts(r); part++) {
        bolan_export_text(w, "\no %s\n", part == MESH_GROUND ? "ground" : "water");
        write_vertices(r, part, w);
        write_triangles(r, part, w);
    }
}
