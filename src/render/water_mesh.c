// SPDX-License-Identifier: MIT
// See water_mesh.h. Buffers have the size of the largest mesh from the start: later frames allocate nothing.
#include "water_mesh.h"
#include "memory.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"
#include "shared/grid.glsl"

#include <math.h>
#include <string.h>

#define MESH "the mesh of the water" // in the log

static const struct {
    double pixels_per_vertex;
    uint32_t max_vertices, nested_cells;
    bolan_surface_size coarse; // columns and rows for optics that need few vertices: whole blocks
} quality_table[] = {
    [BOLAN_QUALITY_LOW] = {8.0, 40000, 32, {97, 81}},
    [BOLAN_QUALITY_MEDIUM] = {6.0, 100000, 32, {129, 97}},
    [BOLAN_QUALITY_HIGH] = {3.0, 300000, 64, {257, 193}},
    [BOLAN_QUALITY_ULTRA] = {2.0, 700000, 128, {513, 385}},
};

enum {
    BLOCK_SIDE = GRID_BLOCK + 1,
    BLOCK_VERTICES = BLOCK_SIDE * BLOCK_SIDE,
    BLOCK_INDICES = 6 * GRID_BLOCK * GRID_BLOCK
};

static bolan_result allocate(water_mesh *m) {
    const size_t n = m->capacity;
    m->index_capacity = 6 * m->capacity;
    const bool all = (m->cpu_vertices = allocate_for(MESH, n * sizeof *m->cpu_vertices)) &&
                     (m->cpu_waves = allocate_for(MESH, n * sizeof *m->cpu_waves)) &&
                     (m->cpu_rest = allocate_for(MESH, n * sizeof *m->cpu_rest)) &&
                     (m->cpu_spacing = allocate_for(MESH, n * sizeof *m->cpu_spacing)) &&
                     (m->cpu_visible = allocate_for(MESH, n)) &&
                     (m->cpu_indices = allocate_for(MESH, m->index_capacity * sizeof *m->cpu_indices));
    return all ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

// Uploaded once (Ni, Zhang & Tan: the sampling grid lies in video memory, and is not sent again in each frame).
static bolan_result create_block(water_mesh *m) {
    static const uint8_t corner[] = {2};
    const bolan_surface_size size = {BLOCK_SIDE, BLOCK_SIDE};
    float corners[BLOCK_VERTICES][2];
    uint32_t indices[BLOCK_INDICES];
    for (uint32_t i = 0; i < BLOCK_VERTICES; ++i) {
        corners[i][0] = (float)(i % BLOCK_SIDE);
        corners[i][1] = (float)(i / BLOCK_SIDE);
    }
    bolan_surface_grid_indices(size, indices);
    bolan_result r =
        bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, sizeof corners, corners, &m->block_vertices);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, sizeof indices, indices, &m->block_indices);
    if (r == BOLAN_OK)
        r = bolan_gl_mesh_create(&m->block_vertices, &m->block_indices, corner, 1, sizeof corners[0], &m->block);
    return r;
}

// The vertices and their waves, by these indices.
static bolan_result create_mesh(const water_mesh *m, const gl_buffer *indices, gl_mesh *out) {
    static const uint8_t vertex[] = {4, 2}, wave[] = {3, 4};
    bolan_result r = bolan_gl_mesh_create(&m->vertices, indices, vertex, 2, sizeof(bolan_surface_vertex), out);
    if (r == BOLAN_OK) bolan_gl_mesh_attach(out, &m->waves, 2, wave, 2, sizeof(bolan_sea_sample));
    return r;
}

static uint32_t whole_blocks(double vertices) {
    const uint32_t blocks = (uint32_t)vertices / GRID_BLOCK;
    return (blocks > 0 ? blocks : 1) * GRID_BLOCK + 1;
}

// As the quality has it, or as much smaller each way as the bound asks.
static bolan_surface_size coarse_within(bolan_surface_size size, uint32_t max_vertices) {
    const double share = sqrt((double)max_vertices / ((double)size.columns * size.rows));
    if (share >= 1.0) return size;
    return (bolan_surface_size){whole_blocks(size.columns * share - 1.0), whole_blocks(size.rows * share - 1.0)};
}

bolan_result bolan_water_mesh_create(water_mesh *m, bolan_quality quality, uint32_t max_vertices) {
    *m = (water_mesh){.projected = bolan_surface_desc_default(), .nested = bolan_nested_desc_default()};
    m->projected.pixels_per_vertex = quality_table[quality].pixels_per_vertex;
    m->projected.max_vertices = max_vertices > 0 ? max_vertices : quality_table[quality].max_vertices;
    m->nested.cells = quality_table[quality].nested_cells;
    m->capacity = quality_table[quality].max_vertices; // the bound is not one of the nested levels
    if (m->capacity < m->projected.max_vertices) m->capacity = m->projected.max_vertices;
    bolan_result r = allocate(m);
    const size_t n = m->capacity;
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STREAM, n * sizeof *m->cpu_vertices, NULL, &m->vertices);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STREAM, n * sizeof *m->cpu_waves, NULL, &m->waves);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STREAM, m->index_capacity * sizeof(uint32_t), NULL,
                                   &m->indices);
    if (r == BOLAN_OK) r = create_mesh(m, &m->indices, &m->mesh);
    if (r == BOLAN_OK) r = bolan_nested_grid_create(&m->levels, m->nested.cells);
    m->coarse = coarse_within(quality_table[quality].coarse, m->projected.max_vertices);
    return r == BOLAN_OK ? create_block(m) : r;
}

void bolan_water_mesh_free(water_mesh *m) {
    const size_t n = m->capacity;
    bolan_gl_mesh_free(&m->mesh);
    bolan_gl_mesh_free(&m->edges);
    bolan_gl_buffer_free(&m->lines);
    bolan_gl_buffer_free(&m->vertices);
    bolan_gl_buffer_free(&m->waves);
    bolan_gl_buffer_free(&m->indices);
    bolan_gl_mesh_free(&m->block);
    bolan_gl_buffer_free(&m->block_vertices);
    bolan_gl_buffer_free(&m->block_indices);
    bolan_nested_grid_free(&m->levels);
    bolan_release(m->cpu_vertices, n * sizeof *m->cpu_vertices);
    bolan_release(m->cpu_waves, n * sizeof *m->cpu_waves);
    bolan_release(m->cpu_rest, n * sizeof *m->cpu_rest);
    bolan_release(m->cpu_spacing, n * sizeof *m->cpu_spacing);
    bolan_release(m->cpu_visible, n);
    bolan_release(m->cpu_indices, m->index_capacity * sizeof *m->cpu_indices);
}

bolan_surface_view bolan_water_mesh_view(const render_view *v) {
    const view_lens *lens = &v->lens;
    bolan_surface_view view = {.eye = v->eye,
                               .heading_deg = lens->heading_deg,
                               .pitch_deg = lens->pitch_deg,
                               .roll_deg = lens->roll_deg,
                               .fov_y = lens->fov_y,
                               .aspect = lens->aspect,
                               .shift_x = lens->shift_x,
                               .shift_y = lens->shift_y,
                               .pixel_height = lens->pixel_height,
                               .water_level = v->frame->level};
    bolan_water_bounds(&v->frame->water, &view.vertical, &view.horizontal);
    return view;
}

// ---- the three surfaces ---------------------------------------------------------------------------------------------
// Each fills vertices, and indices where they changed, and returns the number of vertices.

static void upload_indices(water_mesh *m, uint32_t count) {
    bolan_gl_buffer_update(&m->indices, 0, sizeof(uint32_t) * (count + m->seam_count), m->cpu_indices);
    m->index_count = count;
}

// The grid of this view, whoever makes its vertices.
static bolan_surface_size place_grid(water_mesh *m, const bolan_surface_view *view, bool coarse) {
    m->projector = bolan_surface_projector_of(view);
    if (!m->projector.visible) return (bolan_surface_size){0, 0};
    return coarse ? m->coarse : bolan_surface_projector_size(&m->projected, view, GRID_BLOCK, &m->projector);
}

static uint32_t build_projected(water_mesh *m, const bolan_surface_view *view, bool coarse) {
    const bolan_surface_size size = place_grid(m, view, coarse);
    if (size.rows > 0) bolan_surface_projector_vertices(&m->projector, size, m->cpu_vertices);
    bool same = m->kind == BOLAN_SURFACE_PROJECTED && size.columns == m->grid.columns && size.rows == m->grid.rows;
    m->grid = size;
    if (!same) {
        m->seam_count = 0;
        upload_indices(m, bolan_surface_grid_indices(size, m->cpu_indices));
    }
    memset(m->cpu_visible, 1, (size_t)size.columns * size.rows);
    for (uint32_t i = 0; i < size.columns * size.rows; ++i)
        m->cpu_rest[i] =
            (bolan_dvec2){view->eye.x + (double)m->cpu_vertices[i].x, view->eye.y + (double)m->cpu_vertices[i].y};
    return size.columns * size.rows;
}

static uint32_t bolan_build_quad(water_mesh *m, const bolan_surface_view *view) {
    bolan_surface_quad(view, m->cpu_vertices);
    if (m->kind != BOLAN_SURFACE_QUAD) {
        memcpy(m->cpu_indices, bolan_surface_quad_indices, sizeof bolan_surface_quad_indices);
        m->seam_count = 0;
        upload_indices(m, 6);
    }
    return 4;
}

// The holes move with the eye, and the triangles round them.
static bool same_shape(const bolan_nested *a, const bolan_nested *b) {
    bool same = a->cells == b->cells && a->levels == b->levels;
    for (uint32_t l = 0; same && l < a->levels; ++l)
        same = a->level[l].hole_i == b->level[l].hole_i && a->level[l].hole_j == b->level[l].hole_j;
    return same;
}

// Where a level ends, its odd vertices lie on its parent's edges but for rounding, and a pixel on such an edge may
// belong to neither side. A triangle of no area between the three points of each edge shares their edges, and then
// nothing is left out.
static uint32_t fill_seams(const bolan_nested *placed, uint32_t *out) {
    const uint32_t n = placed->cells, row = n + 1;
    uint32_t count = 0;
    for (uint32_t l = 1; l < placed->levels; ++l) {
        const uint32_t first = l * row * row;
        const uint32_t start[4] = {first, first + n * row, first, first + n}, step[4] = {1, 1, row, row};
        for (int side = 0; side < 4; ++side)
            for (uint32_t i = 0; i < n; i += 2)
                for (uint32_t k = 0; k < 3; ++k) out[count++] = start[side] + (i + k) * step[side];
    }
    return count;
}

static uint32_t build_nested(water_mesh *m, const bolan_surface_view *view, const mesh_rules *rules) {
    const bolan_nested_desc desc = rules != NULL ? rules->levels(view) : m->nested;
    bolan_nested placed = bolan_surface_nested_place(&desc, view);
    bool same = m->kind == BOLAN_SURFACE_NESTED && same_shape(&placed, &m->placed);
    m->placed = placed;
    bolan_surface_nested_vertices(&placed, view, m->cpu_rest, m->cpu_vertices, m->cpu_visible);
    if (rules != NULL) rules->choose(m, view);
    if (!same) {
        uint32_t count = 0;
        for (uint32_t l = 0; l < placed.levels; ++l)
            for (uint32_t part = 0; part < BOLAN_NESTED_PARTS; ++part)
                count += bolan_surface_nested_indices(&placed, l, part, m->cpu_indices + count);
        m->seam_count = fill_seams(&placed, m->cpu_indices + count);
        upload_indices(m, count);
    }
    return bolan_surface_nested_vertex_count(&placed);
}

// ---- waves made on the CPU ------------------------------------------------------------------------------------------

// Waves only where the view can see them: packs the visible vertices to the front, samples, and spreads them out again
// from the end (Liu, Xu & Chen 2009, section 4: the others lie flat).
static void sample_waves(water_mesh *m, const bolan_sea *sea, uint32_t count) {
    uint32_t seen = 0;
    for (uint32_t i = 0; i < count; ++i) {
        if (!m->cpu_visible[i]) continue;
        m->cpu_rest[seen] = m->cpu_rest[i];
        m->cpu_spacing[seen++] = m->cpu_vertices[i].spacing;
    }
    bolan_sea_sample_grid(sea, m->cpu_rest, m->cpu_spacing, seen, m->cpu_waves);
    for (uint32_t i = count; i-- > 0;)
        m->cpu_waves[i] = m->cpu_visible[i] ? m->cpu_waves[--seen] : (bolan_sea_sample){.jacobian = 1.0f};
}

static float mean(float a, float b) { return 0.5f * (a + b); }

// A stitched vertex lies between its neighbours along the border of its level.
static void stitch_waves(water_mesh *m, uint32_t count) {
    uint32_t row = m->placed.cells + 1;
    for (uint32_t i = 0; i < count; ++i) {
        const bolan_surface_vertex *v = &m->cpu_vertices[i];
        if (v->stitch_x == 0.0f && v->stitch_y == 0.0f) continue;
        uint32_t step = v->stitch_x != 0.0f ? 1 : row;
        const bolan_sea_sample *a = &m->cpu_waves[i - step], *b = &m->cpu_waves[i + step];
        m->cpu_waves[i] = (bolan_sea_sample){mean(a->height, b->height),   mean(a->dx, b->dx),
                                             mean(a->dy, b->dy),           mean(a->slope_x, b->slope_x),
                                             mean(a->slope_y, b->slope_y), mean(a->jacobian, b->jacobian),
                                             mean(a->foam, b->foam)};
    }
}

static void build_fixed(water_mesh *m, const bolan_surface_view *view, bool coarse) {
    const bolan_surface_size size = m->fixed_size = place_grid(m, view, coarse);
    m->index_count = size.rows > 0 ? 6 * (size.columns - 1) * (size.rows - 1) : 0;
    m->seam_count = 0;
    m->grid = (bolan_surface_size){0, 0}; // the other buffers' indices count no longer
}

// The index buffer holds nothing of it.
static void build_levels(water_mesh *m, const render_view *v, const bolan_surface_view *view) {
    const bolan_nested placed = bolan_surface_nested_place(&m->nested, view);
    bolan_nested_grid_place(&m->levels, &placed, view, &v->block.view_projection);
    m->index_count = 3 * m->levels.triangles;
    m->seam_count = 0;
    m->placed.levels = 0;
    m->grid = (bolan_surface_size){0, 0};
}

bool bolan_water_mesh_is_fixed(bolan_surface_kind kind, water_waves waves, mesh_wishes wishes,
                               const mesh_rules *rules) {
    const bool made = kind == BOLAN_SURFACE_PROJECTED || (kind == BOLAN_SURFACE_NESTED && rules == NULL);
    return made && waves != WATER_MESH && !wishes.on_cpu;
}

void bolan_water_mesh_build(water_mesh *m, const render_view *v, bolan_surface_kind kind, water_waves waves,
                            mesh_wishes wishes, const mesh_rules *rules) {
    bolan_surface_view view = bolan_water_mesh_view(v);
    m->fixed = bolan_water_mesh_is_fixed(kind, waves, wishes, rules);
    if (m->fixed) {
        if (kind == BOLAN_SURFACE_NESTED)
            build_levels(m, v, &view);
        else
            build_fixed(m, &view, wishes.coarse);
        m->kind = kind;
        return;
    }
    uint32_t count = kind == BOLAN_SURFACE_QUAD     ? bolan_build_quad(m, &view)
                     : kind == BOLAN_SURFACE_NESTED ? build_nested(m, &view, rules)
                                                    : build_projected(m, &view, wishes.coarse && waves != WATER_MESH);
    m->kind = kind;
    if (count < 3) {
        m->index_count = m->seam_count = 0;
        m->grid = (bolan_surface_size){0, 0};
        return;
    }
    bolan_gl_buffer_update(&m->vertices, 0, sizeof(bolan_surface_vertex) * count, m->cpu_vertices);
    if (waves != WATER_MESH) return;
    sample_waves(m, v->frame->sea, count);
    if (kind == BOLAN_SURFACE_NESTED) {
        stitch_waves(m, count);
        if (rules != NULL) rules->slopes(m, count);
    }
    bolan_gl_buffer_update(&m->waves, 0, sizeof(bolan_sea_sample) * count, m->cpu_waves);
}

void bolan_water_mesh_fill(const water_mesh *m, water_block *b) {
    float grid[8];
    if (!m->fixed) return;
    if (m->kind == BOLAN_SURFACE_NESTED) {
        bolan_nested_grid_fill(&m->levels, b);
        return;
    }
    bolan_surface_projector_uniforms(&m->projector, m->fixed_size, grid);
    b->grid_reach = (vec4){grid[0], grid[1], grid[2], grid[3]};
    b->grid_azimuth = (vec4){grid[4], grid[5], grid[6], grid[7]};
    b->grid_cells = (vec2){(float)(m->fixed_size.columns - 1), (float)(m->fixed_size.rows - 1)};
}

void bolan_water_mesh_draw(const water_mesh *m) {
    if (m->fixed && m->kind == BOLAN_SURFACE_NESTED)
        bolan_nested_grid_draw(&m->levels);
    else if (m->fixed)
        bolan_gl_mesh_draw_instances(&m->block, BLOCK_INDICES, m->index_count / BLOCK_INDICES);
    else
        bolan_gl_mesh_draw(&m->mesh, 0, m->index_count + m->seam_count);
}

uint32_t bolan_water_mesh_triangles(const water_mesh *m) { return m->index_count / 3; }

// ---- edges ----------------------------------------------------------------------------------------------------------

// Two triangles share most edges, in opposite directions: one of them draws it.
static uint32_t fill_lines(const water_mesh *m, uint32_t *lines) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < m->index_count; ++i) {
        uint32_t a = m->cpu_indices[i], b = m->cpu_indices[i % 3 == 2 ? i - 2 : i + 1];
        if (a > b && m->kind != BOLAN_SURFACE_QUAD) continue;
        lines[count++] = a;
        lines[count++] = b;
    }
    return count;
}

bool bolan_water_mesh_find_edges(water_mesh *m) {
    const size_t bytes = 2 * sizeof(uint32_t) * m->index_capacity;
    if (m->lines.id == 0 &&
        (bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STREAM, bytes, NULL, &m->lines) != BOLAN_OK ||
         create_mesh(m, &m->lines, &m->edges) != BOLAN_OK))
        return false;
    uint32_t *lines = allocate_for(MESH, bytes); // to look at a mesh is not what a frame is for: it may allocate
    if (lines == NULL) return false;
    m->line_count = fill_lines(m, lines);
    bolan_gl_buffer_update(&m->lines, 0, sizeof(uint32_t) * m->line_count, lines);
    bolan_release(lines, bytes);
    return true;
}

void bolan_water_mesh_draw_edges(const water_mesh *m) { bolan_gl_mesh_draw_lines(&m->edges, m->line_count); }
