// SPDX-License-Identifier: MIT
// See nested_grid.h.
#include "nested_grid.h"
#include "memory.h"
#include "water_block.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"
#include "shared/grid.glsl"

#include <math.h>

enum { SIDE = NESTED_BLOCK + 1, MOST_CELLS = 256, MOST_LEVELS = BOLAN_NESTED_MAX_LEVELS };

static const uint8_t corner[] = {2}, instance[] = {4, 1};

static bolan_result create_block(nested_grid *g) {
    float corners[SIDE * SIDE][2];
    uint32_t indices[6 * NESTED_BLOCK * NESTED_BLOCK];
    for (uint32_t i = 0; i < SIDE * SIDE; ++i) corners[i][0] = (float)(i % SIDE), corners[i][1] = (float)(i / SIDE);
    bolan_surface_grid_indices((bolan_surface_size){SIDE, SIDE}, indices);
    bolan_result r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, sizeof corners, corners, &g->corners);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, sizeof indices, indices, &g->indices);
    if (r == BOLAN_OK) r = bolan_gl_mesh_create(&g->corners, &g->indices, corner, 1, sizeof corners[0], &g->block);
    return r;
}

// The vertices along the border of a level, counter-clockwise, and a triangle of no area for each edge of its parent:
// see fill_seams() in water_mesh.c.
static bolan_result create_edge(nested_grid *g) {
    const uint32_t n = g->cells, count = 4 * n;
    float corners[4 * MOST_CELLS][2];
    uint32_t indices[3 * 2 * MOST_CELLS], at = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t side = k / n, along = k % n;
        corners[k][0] = (float)(side == 0 ? along : side == 1 ? n : side == 2 ? n - along : 0);
        corners[k][1] = (float)(side == 0 ? 0 : side == 1 ? along : side == 2 ? n : n - along);
    }
    for (uint32_t k = 0; k < count; k += 2)
        for (uint32_t i = 0; i < 3; ++i) indices[at++] = (k + i) % count;
    nested_block levels[MOST_LEVELS - 1];
    for (uint32_t l = 1; l < MOST_LEVELS; ++l) levels[l - 1] = (nested_block){0.0f, 0.0f, (float)n, (float)n, (float)l};
    bolan_result r =
        bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, count * sizeof corners[0], corners, &g->edge_corners);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, at * sizeof indices[0], indices, &g->edge_indices);
    if (r == BOLAN_OK) r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, sizeof levels, levels, &g->edges);
    if (r == BOLAN_OK)
        r = bolan_gl_mesh_create(&g->edge_corners, &g->edge_indices, corner, 1, sizeof corners[0], &g->edge);
    if (r == BOLAN_OK) bolan_gl_mesh_attach_instances(&g->edge, &g->edges, 1, instance, 2, sizeof(nested_block));
    return r;
}

bolan_result bolan_nested_grid_create(nested_grid *g, uint32_t cells) {
    BOLAN_ASSERT(cells >= 12 && cells <= MOST_CELLS && cells % 4 == 0);
    *g = (nested_grid){.cells = cells};
    const uint32_t along = cells / NESTED_BLOCK + 2; // of a ring's bands, cut at its hole
    g->capacity = MOST_LEVELS * along * along;
    g->list = allocate_for("the nested levels of the water", g->capacity * sizeof *g->list);
    if (g->list == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result r = create_block(g);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STREAM, g->capacity * sizeof *g->list, NULL, &g->blocks);
    if (r == BOLAN_OK) bolan_gl_mesh_attach_instances(&g->block, &g->blocks, 1, instance, 2, sizeof(nested_block));
    return r == BOLAN_OK ? create_edge(g) : r;
}

// ---- blocks ---------------------------------------------------------------------------------------------------------

typedef struct block_list {
    nested_block *list;
    uint32_t count, capacity;
} block_list;

static uint32_t lesser(uint32_t a, uint32_t b) { return a < b ? a : b; }

// Cells [i0, i1) x [j0, j1) of a level.
static void cut(block_list *to, uint32_t level, uint32_t i0, uint32_t i1, uint32_t j0, uint32_t j1) {
    for (uint32_t j = j0; j < j1; j += NESTED_BLOCK)
        for (uint32_t i = i0; i < i1; i += NESTED_BLOCK) {
            BOLAN_ASSERT(to->count < to->capacity);
            if (to->count == to->capacity) return;
            to->list[to->count++] = (nested_block){(float)i, (float)j, (float)lesser(NESTED_BLOCK, i1 - i),
                                                   (float)lesser(NESTED_BLOCK, j1 - j), (float)level};
        }
}

uint32_t bolan_nested_grid_blocks(const bolan_nested *nested, nested_block *out, uint32_t capacity) {
    block_list to = {out, 0, capacity};
    const uint32_t n = nested->cells, half = n / 2;
    for (uint32_t l = 0; l + 1 < nested->levels; ++l) {
        const uint32_t i = nested->level[l].hole_i, j = nested->level[l].hole_j;
        cut(&to, l, 0, n, 0, j);
        cut(&to, l, 0, n, j + half, n);
        cut(&to, l, 0, i, j, j + half);
        cut(&to, l, i + half, n, j, j + half);
    }
    cut(&to, nested->levels - 1, 0, n, 0, n);
    return to.count;
}

// Its box, as far as the waves reach over it.
static bool is_hidden(const nested_grid *g, const nested_block *b, const bolan_surface_view *v,
                      const bolan_mat4 *view_projection) {
    const bolan_nested_level *level = &g->placed.level[(uint32_t)b->level];
    const double d = level->spacing, west = level->x0 + d * (double)b->i - g->eye.x,
                 south = level->y0 + d * (double)b->j - g->eye.y, east = west + d * (double)b->columns,
                 north = south + d * (double)b->rows;
    const double far_x = fmax(fabs(west), fabs(east)), far_y = fmax(fabs(south), fabs(north));
    const double drop = earth_drop(far_x * far_x + far_y * far_y, BOLAN_EARTH_RADIUS);
    const float low[] = {(float)(west - v->horizontal), (float)(south - v->horizontal),
                         (float)(-g->eye.z - drop - v->vertical)},
                high[] = {(float)(east + v->horizontal), (float)(north + v->horizontal),
                          (float)(-g->eye.z + v->vertical)};
    return bolan_outside_frustum(view_projection, low, high);
}

void bolan_nested_grid_place(nested_grid *g, const bolan_nested *nested, const bolan_surface_view *view,
                             const bolan_mat4 *view_projection) {
    BOLAN_ASSERT(nested->cells == g->cells);
    g->placed = *nested;
    g->eye = bolan_dv3(view->eye.x, view->eye.y, view->eye.z - view->water_level);
    const uint32_t all = bolan_nested_grid_blocks(nested, g->list, g->capacity);
    g->count = g->triangles = 0;
    for (uint32_t k = 0; k < all; ++k) {
        const nested_block b = g->list[k];
        if (is_hidden(g, &b, view, view_projection)) continue;
        g->list[g->count++] = b;
        g->triangles += 2 * (uint32_t)b.columns * (uint32_t)b.rows;
    }
    g->edge_count = g->count > 0 ? nested->levels - 1 : 0;
    if (g->count > 0) bolan_gl_buffer_update(&g->blocks, 0, g->count * sizeof *g->list, g->list);
}

// Spacings rise between the hole, where it has ended for certain, and one cell before the border: see spacing_at() in
// surface/nested_vertices.c.
static vec4 centre_of(const bolan_nested *p, bolan_dvec2 anchor) {
    const double n = p->cells, from = nested_rise_from(n), to = nested_rise_to(n);
    return (vec4){(float)(p->centre.x - anchor.x), (float)(p->centre.y - anchor.y), (float)from,
                  to > from ? (float)(1.0 / (to - from)) : 0.0f};
}

void bolan_nested_grid_fill(const nested_grid *g, struct water_block *b) {
    const bolan_nested *p = &g->placed;
    const double finest = p->level[p->levels - 1].spacing;
    const bolan_dvec2 anchor = {floor(g->eye.x / finest + 0.5) * finest, floor(g->eye.y / finest + 0.5) * finest};
    b->nested_centre = centre_of(p, anchor);
    b->nested_eye =
        (vec4){(float)(g->eye.x - anchor.x), (float)(g->eye.y - anchor.y), (float)g->eye.z, (float)p->least_spacing};
    for (uint32_t l = 0; l < p->levels; ++l) {
        const bolan_nested_level *level = &p->level[l];
        b->nested_level[l] = (vec4){(float)(level->x0 - anchor.x), (float)(level->y0 - anchor.y), (float)level->spacing,
                                    (float)p->cells};
    }
}

void bolan_nested_grid_draw(const nested_grid *g) {
    if (g->count == 0) return;
    bolan_gl_mesh_draw_instances(&g->block, 6 * NESTED_BLOCK * NESTED_BLOCK, g->count);
    bolan_gl_mesh_draw_instances(&g->edge, 3 * 2 * g->cells, g->edge_count);
}

void bolan_nested_grid_free(nested_grid *g) {
    bolan_gl_mesh_free(&g->block);
    bolan_gl_mesh_free(&g->edge);
    gl_buffer *const buffers[] = {&g->corners, &g->indices, &g->edge_corners, &g->edge_indices, &g->blocks, &g->edges};
    for (size_t i = 0; i < sizeof buffers / sizeof buffers[0]; ++i) bolan_gl_buffer_free(buffers[i]);
    bolan_release(g->list, g->capacity * sizeof *g->list);
    *g = (nested_grid){0};
}
