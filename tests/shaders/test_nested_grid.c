// SPDX-License-Identifier: MIT
// The nested levels that the vertex shader makes (shaders/common/nested.glsl, src/render/nested_grid.c) against those
// of surface.h: the same vertices; two levels share theirs to the last bit; the blocks cover all cells; what a view
// shows is never left out.
#include "probe.h"

#include "bolan/earth.h"
#include "bolan/surface.h"
#include "render/nested_grid.h"
#include "render/water_block.h"

enum { SAMPLES = 256, MOST_BLOCKS = 4096, CAPACITY = 300000 };

static double uniform(double low, double high) { return low + (high - low) * ((double)rand() / RAND_MAX); }

static bolan_surface_view random_view(void) {
    return (bolan_surface_view){.eye = {uniform(-1e6, 1e6), uniform(-1e6, 1e6), pow(10.0, uniform(-0.3, 4.0)) + 7.0},
                                .heading_deg = uniform(0, 360),
                                .pitch_deg = uniform(-80, 20),
                                .fov_y = uniform(0.2, 1.4),
                                .aspect = 16.0 / 9.0,
                                .pixel_height = 720,
                                .vertical = 3.0,
                                .horizontal = 3.0,
                                .water_level = 7.0};
}

static bolan_nested place(uint32_t cells, uint32_t levels, const bolan_surface_view *view) {
    const bolan_nested_desc desc = {.cells = cells, .levels = levels};
    return bolan_surface_nested_place(&desc, view);
}

// ---- blocks ---------------------------------------------------------------------------------------------------------

static void blocks_cover_every_cell_but_the_holes_once(void **state) {
    (void)state;
    static nested_block blocks[MOST_BLOCKS];
    static uint8_t covered[BOLAN_NESTED_MAX_LEVELS][128][128];
    for (int k = 0; k < 60; ++k) {
        const bolan_surface_view view = random_view();
        const bolan_nested p = place((uint32_t[]){4, 12, 32, 64, 128}[k % 5], 1 + (uint32_t)k % 12, &view);
        memset(covered, 0, sizeof covered);
        const uint32_t count = bolan_nested_grid_blocks(&p, blocks, MOST_BLOCKS);
        for (uint32_t b = 0; b < count; ++b) {
            const nested_block *at = &blocks[b];
            assert_true(at->columns >= 1.0f && at->columns <= NESTED_BLOCK && at->rows >= 1.0f &&
                        at->rows <= NESTED_BLOCK);
            for (int j = 0; j < (int)at->rows; ++j)
                for (int i = 0; i < (int)at->columns; ++i) ++covered[(int)at->level][(int)at->j + j][(int)at->i + i];
        }
        for (uint32_t l = 0; l < p.levels; ++l)
            for (uint32_t j = 0; j < p.cells; ++j)
                for (uint32_t i = 0; i < p.cells; ++i) {
                    const uint32_t u = i - p.level[l].hole_i, v = j - p.level[l].hole_j;
                    const bool hole = l + 1 < p.levels && u < p.cells / 2 && v < p.cells / 2;
                    assert_int_equal(covered[l][j][i], !hole);
                }
    }
}

// Of the vertices that the paper's test of sight keeps, which is widened by a cell, those that stand in the picture by
// their clip coordinates lie in blocks that are drawn.
static void no_vertex_in_sight_is_left_out(void **state) {
    (void)state;
    static bolan_surface_vertex vertices[CAPACITY];
    nested_grid g;
    assert_int_equal(bolan_nested_grid_create(&g, 32), BOLAN_OK);
    uint32_t seen = 0, drawn = 0, all = 0;
    for (int k = 0; k < 40; ++k) {
        bolan_surface_view view = random_view();
        const bolan_nested p = place(32, 12, &view);
        bolan_surface_nested_vertices(&p, &view, NULL, vertices, NULL);
        const bolan_mat4 turned = bolan_m4_view(view.heading_deg, view.pitch_deg, 0.0);
        const bolan_mat4 lens = bolan_m4_projection(view.fov_y, view.aspect, 0.1, false);
        const bolan_mat4 m = bolan_m4_mul(lens, turned);
        bolan_nested_grid_place(&g, &p, &view, &m);
        all += bolan_nested_grid_blocks(&p, g.list + g.count, g.capacity - g.count);
        drawn += g.count;
        for (uint32_t v = 0; v < bolan_surface_nested_vertex_count(&p); ++v) {
            const float x = vertices[v].x, y = vertices[v].y, z = vertices[v].z;
            const float cx = m.m[0] * x + m.m[4] * y + m.m[8] * z + m.m[12],
                        cy = m.m[1] * x + m.m[5] * y + m.m[9] * z + m.m[13],
                        w = m.m[3] * x + m.m[7] * y + m.m[11] * z + m.m[15];
            if (!(w > 0.0f && fabsf(cx) < w && fabsf(cy) < w)) continue;
            const uint32_t level = v / (33 * 33), i = v % 33, j = v / 33 % 33;
            const uint32_t hi = i - p.level[level].hole_i, hj = j - p.level[level].hole_j;
            if (level + 1 < p.levels && hi - 1 < 15 && hj - 1 < 15) continue; // within the hole
            bool found = false;
            for (uint32_t b = 0; b < g.count && !found; ++b) {
                const nested_block *at = &g.list[b];
                found = (uint32_t)at->level == level && (float)i >= at->i && (float)i <= at->i + at->columns &&
                        (float)j >= at->j && (float)j <= at->j + at->rows;
            }
            assert_true(found);
            ++seen;
        }
    }
    assert_true(seen > 10000);
    assert_true(4 * drawn < 3 * all); // views are wide, and some look down: the others leave out most
    bolan_nested_grid_free(&g);
}

// ---- vertices -------------------------------------------------------------------------------------------------------

typedef struct rig {
    block_buffers uniforms;
    water_block_buffers water;
} rig;

static void set_blocks(const gl_program *program, const void *context) {
    const rig *r = context;
    (void)program;
    bolan_blocks_bind(&r->uniforms);
}

static const char *const includes = "#include \"common/frame.glsl\"\n#include \"common/water_block.glsl\"\n"
                                    "#include \"common/nested.glsl\"";

static void run(rig *r, const nested_grid *g, const char *body, float (*in)[4], uint32_t count, float (*out)[4]) {
    water_block block = {.choppiness = 0.0f};
    bolan_nested_grid_fill(g, &block);
    bolan_water_blocks_upload(&r->water, &block);
    probe_run_with(includes, body, NULL, set_blocks, r, in, count, out);
}

static void rig_open(rig *r) {
    const block_values blocks = {.frame = {.earth_radius = (float)BOLAN_EARTH_RADIUS}};
    assert_int_equal(bolan_blocks_create(&r->uniforms), BOLAN_OK);
    assert_int_equal(bolan_water_blocks_create(&r->water), BOLAN_OK);
    bolan_blocks_upload(&r->uniforms, &blocks);
}

static void rig_close(rig *r) {
    bolan_blocks_free(&r->uniforms);
    bolan_water_blocks_free(&r->water);
}

// Where half of the vertices stand on the border of a level.
static void some_vertices(const bolan_nested *p, float (*in)[4]) {
    for (int k = 0; k < SAMPLES; ++k) {
        const uint32_t n = p->cells, side = (uint32_t)rand() % 8;
        uint32_t i = (uint32_t)rand() % (n + 1), j = (uint32_t)rand() % (n + 1);
        if (side < 2) i = side * n;
        if (side / 2 == 1) j = side % 2 * n;
        in[k][0] = (float)i, in[k][1] = (float)j, in[k][2] = (float)((uint32_t)rand() % p->levels), in[k][3] = 0.0f;
    }
}

static void vertices_are_those_of_the_cpu(void **state) {
    (void)state;
    static bolan_surface_vertex vertices[CAPACITY];
    rig r;
    rig_open(&r);
    for (int k = 0; k < 6; ++k) {
        const bolan_surface_view view = random_view();
        const uint32_t n = k < 3 ? 32 : 12;
        nested_grid g = {.cells = n, .eye = {view.eye.x, view.eye.y, view.eye.z - view.water_level}};
        g.placed = place(n, (uint32_t[]){1, 6, 12}[k % 3], &view);
        bolan_surface_nested_vertices(&g.placed, &view, NULL, vertices, NULL);
        float in[SAMPLES][4], at[SAMPLES][4], stitch[SAMPLES][4];
        some_vertices(&g.placed, in);
        run(&r, &g, "vec4 probe(vec4 x) { return nested_vertex_of(x.xy, int(x.z)).at; }", in, SAMPLES, at);
        run(&r, &g, "vec4 probe(vec4 x) { return vec4(nested_vertex_of(x.xy, int(x.z)).stitch, 0.0, 0.0); }", in,
            SAMPLES, stitch);
        uint32_t stitched = 0;
        for (int s = 0; s < SAMPLES; ++s) {
            const bolan_surface_vertex *v =
                &vertices[((uint32_t)in[s][2] * (n + 1) + (uint32_t)in[s][1]) * (n + 1) + (uint32_t)in[s][0]];
            // Three roundings of floats: of the place over the anchor, of the eye, of the drop.
            const double far = hypot((double)v->x, (double)v->y), near = 3e-7 * far + 1e-6 * g.eye.z;
            assert_near(at[s][0], v->x, near);
            assert_near(at[s][1], v->y, near);
            assert_near(at[s][2], v->z, near);
            assert_near(at[s][3], v->spacing, 1e-5 * (double)v->spacing);
            assert_true(stitch[s][0] == v->stitch_x && stitch[s][1] == v->stitch_y);
            stitched += v->stitch_x != 0.0f || v->stitch_y != 0.0f;
        }
        assert_true(g.placed.levels == 1 ? stitched == 0 : stitched > 10);
    }
    rig_close(&r);
}

// Even vertices on the border of a level stand on its parent.
static void levels_share_vertices_to_the_last_bit(void **state) {
    (void)state;
    rig r;
    rig_open(&r);
    for (int k = 0; k < 6; ++k) {
        const bolan_surface_view view = random_view();
        nested_grid g = {.cells = 32, .eye = {view.eye.x, view.eye.y, view.eye.z - view.water_level}};
        g.placed = place(32, 12, &view);
        float inner[SAMPLES][4], outer[SAMPLES][4], out[2][SAMPLES][4];
        assert_true(g.placed.levels > 1);
        for (int s = 0; s < SAMPLES; ++s) {
            const uint32_t along = 2 * ((uint32_t)rand() % 17), side = (uint32_t)rand() % 4, end = side % 2 * 32,
                           l = 1 + (uint32_t)rand() % (g.placed.levels - 1);
            const bolan_nested_level *parent = &g.placed.level[l - 1];
            const float i = (float)(side < 2 ? along : end), j = (float)(side < 2 ? end : along);
            memcpy(inner[s], (float[]){i, j, (float)l, 0.0f}, sizeof inner[s]);
            memcpy(outer[s],
                   (float[]){(float)parent->hole_i + 0.5f * i, (float)parent->hole_j + 0.5f * j, (float)(l - 1), 0.0f},
                   sizeof outer[s]);
        }
        const char *const body = "vec4 probe(vec4 x) { return nested_vertex_of(x.xy, int(x.z)).at; }";
        run(&r, &g, body, inner, SAMPLES, out[0]);
        run(&r, &g, body, outer, SAMPLES, out[1]);
        assert_memory_equal(out[0], out[1], sizeof out[0]);
    }
    rig_close(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_cover_every_cell_but_the_holes_once), IN_BOTH_APIS(no_vertex_in_sight_is_left_out),
        IN_BOTH_APIS(vertices_are_those_of_the_cpu), IN_BOTH_APIS(levels_share_vertices_to_the_last_bit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
