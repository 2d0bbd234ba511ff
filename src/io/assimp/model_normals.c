// SPDX-License-Identifier: MIT
// Normals for meshes that have none. Triangles that meet at a point, whichever vertices of the file they use there, are
// averaged, weighted by their angles at the point (Thürmer & Wüthrich, J. Graphics Tools 3, 1998), but only with those
// that turn away from each other by less than the crease: a house keeps its edges, a hull its curves.
#include "io/assimp/model_file.h"

#include <string.h>

#define MOST_AROUND 128 // triangles at a point that are averaged; the cost is quadratic, and beyond normals are flat

typedef struct scratch {
    uint32_t vertices, corners; // of the part of the mesh, before it is split
    uint32_t table_size;        // a power of two
    bolan_vec3 *positions;      // of the old vertices
    bolan_vec4 *colors;
    bolan_vec3 *facing;       // unit normal of each triangle; 0 where it has no area
    uint32_t *corner;         // old vertex of each corner
    uint32_t *point;          // of each old vertex: the first vertex at its place
    uint32_t *start, *around; // corners of point p: around[start[p]] to around[start[p + 1] - 1]
    uint32_t *table;          // hash table of vertices, plus one; 0: free
    char *block;              // that holds them all, zero-filled
    size_t bytes;
} scratch;

static bool same3(bolan_vec3 a, bolan_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static uint32_t hash3(uint32_t h, bolan_vec3 v) {
    uint32_t words[3];
    const bolan_vec3 clean = {v.x + 0.0f, v.y + 0.0f, v.z + 0.0f}; // -0 is 0
    memcpy(words, &clean, sizeof words);
    for (int i = 0; i < 3; i++) {
        h = (h ^ words[i]) * 0x9e3779b1u;
        h ^= h >> 15;
    }
    return h;
}

// ---- points and their corners ---------------------------------------------------------------------------------------

static void weld_points(scratch *s) {
    const uint32_t mask = s->table_size - 1;
    for (uint32_t v = 0; v < s->vertices; v++) {
        uint32_t at = hash3(1u, s->positions[v]) & mask;
        while (s->table[at] && !same3(s->positions[s->table[at] - 1], s->positions[v])) at = (at + 1) & mask;
        if (!s->table[at]) s->table[at] = v + 1;
        s->point[v] = s->table[at] - 1;
    }
    memset(s->table, 0, s->table_size * sizeof *s->table);
}

static void list_corners(scratch *s) {
    for (uint32_t c = 0; c < s->corners; c++) s->start[s->point[s->corner[c]]]++;
    uint32_t end = 0;
    for (uint32_t p = 0; p < s->vertices; p++) s->start[p] = end += s->start[p]; // where the point's corners end
    s->start[s->vertices] = end;
    for (uint32_t c = s->corners; c-- > 0;) s->around[--s->start[s->point[s->corner[c]]]] = c;
}

static bolan_vec3 place(const scratch *s, uint32_t corner) { return s->positions[s->corner[corner]]; }

static void face_triangles(scratch *s) {
    for (uint32_t t = 0; t < s->corners / 3; t++) {
        const bolan_vec3 a = place(s, 3 * t);
        const bolan_vec3 n = bolan_v3_cross(bolan_v3_sub(place(s, 3 * t + 1), a), bolan_v3_sub(place(s, 3 * t + 2), a));
        const float length = bolan_v3_length(n);
        if (length > 0.0f && isfinite(length)) s->facing[t] = bolan_v3_scale(n, 1.0f / length);
    }
}

// ---- normals --------------------------------------------------------------------------------------------------------

static float angle_at(const scratch *s, uint32_t corner) {
    const uint32_t t = corner / 3 * 3;
    const bolan_vec3 at = place(s, corner), u = bolan_v3_sub(place(s, t + (corner - t + 1) % 3), at),
                     v = bolan_v3_sub(place(s, t + (corner - t + 2) % 3), at);
    return atan2f(bolan_v3_length(bolan_v3_cross(u, v)), bolan_v3_dot(u, v));
}

static bolan_vec3 corner_normal(const scratch *s, uint32_t corner, float crease) {
    const bolan_vec3 own = s->facing[corner / 3];
    const uint32_t p = s->point[s->corner[corner]], from = s->start[p], to = s->start[p + 1];
    if (same3(own, bolan_v3(0.0f, 0.0f, 0.0f))) return bolan_v3(0.0f, 0.0f, 1.0f); // no area: not visible
    bolan_vec3 sum = {0.0f, 0.0f, 0.0f};
    for (uint32_t k = from; k < to && crease <= 1.0f && to - from <= MOST_AROUND; k++) {
        const bolan_vec3 other = s->facing[s->around[k] / 3];
        if (bolan_v3_dot(own, other) > crease)
            sum = bolan_v3_add(sum, bolan_v3_scale(other, angle_at(s, s->around[k])));
    }
    const float length = bolan_v3_length(sum);
    return length > 1e-6f ? bolan_v3_scale(sum, 1.0f / length) : own;
}

// The vertex with these values; adds it where it does not exist yet.
static uint32_t vertex_of(scratch *s, model_mesh *m, uint32_t old, bolan_vec3 normal) {
    const bolan_vec3 position = s->positions[old];
    const bolan_vec4 color = s->colors[old];
    const uint32_t mask = s->table_size - 1;
    uint32_t at = hash3(hash3(hash3(2u, position), normal), bolan_v3(color.x, color.y, color.z)) & mask;
    for (; s->table[at]; at = (at + 1) & mask) {
        const uint32_t v = s->table[at] - 1;
        if (same3(m->positions[v], position) && same3(m->normals[v], normal) &&
            memcmp(&m->colors[v], &color, sizeof color) == 0)
            return v;
    }
    const uint32_t v = m->vertex_count++;
    m->positions[v] = position;
    m->normals[v] = normal;
    m->colors[v] = color;
    s->table[at] = v + 1;
    return v;
}

// ---- scratch memory -------------------------------------------------------------------------------------------------

static void *carve(scratch *s, size_t count, size_t size) {
    void *part = s->block ? s->block + s->bytes : NULL;
    s->bytes += (count * size + 15) / 16 * 16;
    return part;
}

// Places the arrays in the block; without a block it only counts the bytes.
static void lay_out(scratch *s) {
    s->bytes = 0;
    s->positions = carve(s, s->vertices, sizeof *s->positions);
    s->colors = carve(s, s->vertices, sizeof *s->colors);
    s->facing = carve(s, s->corners / 3, sizeof *s->facing);
    s->corner = carve(s, s->corners, sizeof *s->corner);
    s->point = carve(s, s->vertices, sizeof *s->point);
    s->start = carve(s, (size_t)s->vertices + 1, sizeof *s->start);
    s->around = carve(s, s->corners, sizeof *s->around);
    s->table = carve(s, s->table_size, sizeof *s->table);
}

static void start_scratch(scratch *s, const model_mesh *m, uint32_t first, uint32_t first_index) {
    memcpy(s->positions, m->positions + first, s->vertices * sizeof *s->positions);
    memcpy(s->colors, m->colors + first, s->vertices * sizeof *s->colors);
    for (uint32_t c = 0; c < s->corners; c++) s->corner[c] = m->indices[first_index + c] - first;
    weld_points(s);
    list_corners(s);
    face_triangles(s);
}

bolan_result bolan_model_make_normals(model_mesh *m, uint32_t first, uint32_t first_index, float crease) {
    scratch s = {.vertices = m->vertex_count - first, .corners = m->index_count - first_index, .table_size = 16};
    if (s.corners == 0) return BOLAN_OK;
    while (s.table_size < 2 * s.corners || s.table_size < 2 * s.vertices) s.table_size *= 2;
    lay_out(&s);
    const size_t bytes = s.bytes;
    s.block = bolan_allocate(bytes);
    if (!s.block) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for the normals of %u triangles",
                  (unsigned)(s.corners / 3));
        return BOLAN_ERROR_MEMORY;
    }
    lay_out(&s);
    start_scratch(&s, m, first, first_index);
    m->vertex_count = first;
    for (uint32_t c = 0; c < s.corners; c++)
        m->indices[first_index + c] = vertex_of(&s, m, s.corner[c], corner_normal(&s, c, crease));
    bolan_release(s.block, bytes);
    return BOLAN_OK;
}
