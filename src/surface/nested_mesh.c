// SPDX-License-Identifier: MIT
// Nested grids, their triangles and normals (Liu, Xu & Chen 2009, sections 1 to 3, figures 2 and 3).
//
//      +--------------N--------------+      ring S, N: n cells long; W, E: n - 2
//      | +------+----------+-------+ |      blocks SW S SE W E NW N NE between the ring and the hole;
//      | |  NW  |    N     |  NE   | |      a block is empty where the hole touches the ring
//      | +------+----------+-------+ |
//      W |  W   |   hole   |   E   | E      cell (i, j):   c--d      triangles a b c and c b d, so that
//      | +------+----------+-------+ |                     |\ |      a vertex has six triangles round it
//      | |  SW  |    S     |  SE   | |                     | \|
//      | +------+----------+-------+ |                     a--b
//      +--------------S--------------+
#include "bolan/surface.h"

typedef struct cell_range {
    uint32_t i0, i1, j0, j1; // cells [i0, i1) x [j0, j1)
} cell_range;

static cell_range ring_part(uint32_t n, uint32_t part) {
    switch (part) {
    case 8: return (cell_range){0, n, 0, 1};
    case 9: return (cell_range){0, n, n - 1, n};
    case 10: return (cell_range){0, 1, 1, n - 1};
    default: return (cell_range){n - 1, n, 1, n - 1};
    }
}

static cell_range part_cells(const bolan_nested *nested, uint32_t level, uint32_t part) {
    static const uint8_t column[8] = {0, 1, 2, 0, 2, 0, 1, 2}, row[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    uint32_t n = nested->cells;
    if (level + 1 == nested->levels) return part == 0 ? (cell_range){0, n, 0, n} : (cell_range){0};
    if (part >= 8) return ring_part(n, part);
    const bolan_nested_level *at = &nested->level[level];
    const uint32_t x[4] = {1, at->hole_i, at->hole_i + n / 2, n - 1}, y[4] = {1, at->hole_j, at->hole_j + n / 2, n - 1};
    return (cell_range){x[column[part]], x[column[part] + 1], y[row[part]], y[row[part] + 1]};
}

uint32_t bolan_surface_nested_indices(const bolan_nested *nested, uint32_t level, uint32_t part, uint32_t *out) {
    BOLAN_ASSERT(nested != NULL && level < nested->levels && part < BOLAN_NESTED_PARTS);
    cell_range cells = part_cells(nested, level, part);
    uint32_t stride = nested->cells + 1, first = level * stride * stride, count = 0;
    for (uint32_t j = cells.j0; j < cells.j1; ++j)
        for (uint32_t i = cells.i0; i < cells.i1; ++i, count += 6) {
            if (out == NULL) continue;
            uint32_t a = first + j * stride + i, c = a + stride;
            out[count] = a, out[count + 1] = a + 1, out[count + 2] = c;
            out[count + 3] = c, out[count + 4] = a + 1, out[count + 5] = c + 1;
        }
    return count;
}

// ---- normals --------------------------------------------------------------------------------------------------------

static bolan_vec3 unit_or_up(bolan_vec3 v) {
    float square = bolan_v3_dot(v, v);
    return square > 0.0f ? bolan_v3_scale(v, 1.0f / sqrtf(square)) : bolan_v3(0.0f, 0.0f, 1.0f);
}

static void add_triangle(const bolan_vec3 *at, bolan_vec3 *sums, uint32_t a, uint32_t b, uint32_t c) {
    bolan_vec3 normal = bolan_v3_cross(bolan_v3_sub(at[b], at[a]), bolan_v3_sub(at[c], at[a]));
    float length = bolan_v3_length(normal);
    if (!(length > 0.0f)) return; // degenerate: it has no normal
    normal = bolan_v3_scale(normal, 1.0f / length);
    sums[a] = bolan_v3_add(sums[a], normal);
    sums[b] = bolan_v3_add(sums[b], normal);
    sums[c] = bolan_v3_add(sums[c], normal);
}

static void add_level(const bolan_nested *nested, uint32_t level, const bolan_vec3 *at, bolan_vec3 *sums) {
    uint32_t stride = nested->cells + 1, first = level * stride * stride;
    for (uint32_t part = 0; part < BOLAN_NESTED_PARTS; ++part) {
        cell_range cells = part_cells(nested, level, part);
        for (uint32_t j = cells.j0; j < cells.j1; ++j)
            for (uint32_t i = cells.i0; i < cells.i1; ++i) {
                uint32_t a = first + j * stride + i, c = a + stride;
                add_triangle(at, sums, a, a + 1, c);
                add_triangle(at, sums, c, a + 1, c + 1);
            }
    }
}

// The k-th of the 4 n border vertices of a level, counter-clockwise from the south-west corner; even k lie on the
// parent.
static void border_vertex(uint32_t n, uint32_t k, uint32_t *i, uint32_t *j) {
    uint32_t side = k / n, along = k % n;
    *i = side == 0 ? along : side == 1 ? n : side == 2 ? n - along : 0;
    *j = side == 0 ? 0 : side == 1 ? along : side == 2 ? n : n - along;
}

// Where two levels meet, the triangles of both count at the vertices of both.
static void join_levels(const bolan_nested *nested, uint32_t child, bolan_vec3 *sums) {
    uint32_t n = nested->cells, stride = n + 1, i, j;
    const bolan_nested_level *parent = &nested->level[child - 1];
    bolan_vec3 *inner = sums + (size_t)child * stride * stride, *outer = inner - (size_t)stride * stride;
    for (uint32_t k = 0; k < 4 * n; k += 2) {
        border_vertex(n, k, &i, &j);
        bolan_vec3 *a = &inner[j * stride + i], *b = &outer[(parent->hole_j + j / 2) * stride + parent->hole_i + i / 2];
        *a = *b = bolan_v3_add(*a, *b);
    }
}

static void stitch_normals(uint32_t n, bolan_vec3 *normals) {
    for (uint32_t k = 1; k < 4 * n; k += 2) {
        uint32_t i, j, stride = n + 1;
        border_vertex(n, k, &i, &j);
        uint32_t at = j * stride + i, step = j == 0 || j == n ? 1 : stride;
        normals[at] = unit_or_up(bolan_v3_add(normals[at - step], normals[at + step]));
    }
}

void bolan_surface_nested_normals(const bolan_nested *nested, const bolan_vec3 *positions, bolan_vec3 *normals) {
    BOLAN_ASSERT(nested != NULL && positions != NULL && normals != NULL);
    uint32_t count = bolan_surface_nested_vertex_count(nested), square = (nested->cells + 1) * (nested->cells + 1);
    for (uint32_t k = 0; k < count; ++k) normals[k] = bolan_v3(0.0f, 0.0f, 0.0f);
    for (uint32_t l = 0; l < nested->levels; ++l) add_level(nested, l, positions, normals);
    for (uint32_t l = 1; l < nested->levels; ++l) join_levels(nested, l, normals);
    for (uint32_t k = 0; k < count; ++k) normals[k] = unit_or_up(normals[k]);
    for (uint32_t l = 1; l < nested->levels; ++l) stitch_normals(nested->cells, normals + (size_t)l * square);
}
