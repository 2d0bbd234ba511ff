// SPDX-License-Identifier: MIT
// The slopes that pixels shade (shaders/common/waves.glsl with SPLINES) are those of the normals that queries return,
// in open water and on beaches, whichever backend makes the fields.
#include "bolan/ground.h"
#include "bolan/query.h"
#include "probe.h"

#include "query/block.h"
#include "render/sea_gpu.h"
#include "render/shore_map.h"

enum { COUNT = 256 };

typedef struct rig {
    bolan_sea *sea;
    bolan_ground *ground;
    bolan_wave_layer *layer;
    bolan_water water;
    gl_caps caps;
    frame step;
    render_view view;
    sea_gpu fields;
    sea_compute compute;
    shore_builder shore;
    water_block_buffers *blocks, own_blocks;
} rig;

typedef struct sample {
    uint32_t n, order;
    double beach; // rise of the bed over its run; 0: open water
    bool compute;
    bool layer; // a train of waves, too
} sample;

#define DEEP_END 20.0 // [m], of a beach, which rises as much above the water

static void make_beach(rig *r, double slope) {
    enum { WIDE = 64 };
    static float grid[WIDE * 2];
    const double length = 2.0 * DEEP_END / slope;
    bolan_ground_desc d = bolan_ground_desc_default();
    for (int i = 0; i < 2 * WIDE; i++) grid[i] = (float)(DEEP_END * (2.0 * (i % WIDE) / (WIDE - 1.0) - 1.0));
    d.field = (bolan_heightfield){WIDE, 2, 0.0, -1e3, length / (WIDE - 1), 2e3, grid};
    d.detail = 0.0;
    d.edge_elevation = -DEEP_END;
    assert_int_equal(bolan_ground_create(&d, &r->ground), BOLAN_OK);
}

static void make_layer(rig *r) {
    bolan_wave_train_desc d = bolan_wave_train_desc_default();
    d.from_deg = 250.0, d.length = 60.0, d.height = 3.0, d.phase_deg = 35.0;
    assert_int_equal(bolan_wave_layer_create_train(&d, &r->layer), BOLAN_OK);
}

static void rig_open(rig *r, const sample *s) {
    memset(r, 0, sizeof *r);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(9.0, 20.0, 200e3);
    desc.resolution = s->n;
    desc.choppiness = 0.9;
    desc.order = s->order;
    assert_int_equal(bolan_sea_create(&desc, &r->sea), BOLAN_OK);
    bolan_sea_step(r->sea, 4321.5);
    if (s->beach > 0.0) make_beach(r, s->beach);
    if (s->layer) make_layer(r);
    r->water = bolan_water_default();
    r->water.sea = r->sea;
    r->water.ground = r->ground;
    r->water.layers = (const bolan_wave_layer *const *)&r->layer;
    r->water.layer_count = r->layer ? 1 : 0;
    r->caps = bolan_gl_get_caps();
    if (s->compute && !r->caps.compute) skip();
    r->step = (frame){.caps = &r->caps,
                      .sea = r->sea,
                      .ground = r->ground,
                      .water = r->water,
                      .lighting = bolan_lighting_default(),
                      .compute = s->compute ? &r->compute : NULL,
                      .time = bolan_sea_time(r->sea)};
    const bolan_dvec3 eye =
        s->beach > 0.0 ? bolan_dv3(16.5 / s->beach, -700.0, 5.0) : bolan_dv3(123456.7, -98765.4, 5.0);
    r->view = (render_view){.frame = &r->step, .eye = eye, .shore = &r->shore.map};
    assert_int_equal(bolan_shore_builder_create(&r->shore), BOLAN_OK);
    bolan_shore_builder_update(&r->shore, &r->view);
    assert_int_equal(bolan_sea_gpu_create(&r->fields), BOLAN_OK);
    assert_int_equal(bolan_water_blocks_create(&r->own_blocks), BOLAN_OK);
    r->blocks = &r->own_blocks;
    assert_true(bolan_sea_gpu_prepare(&r->fields, &r->step, WATER_TEXTURES_ALL));
    bolan_sea_gpu_view(&r->fields, &r->view, WATER_CASCADES);
}

static void rig_close(rig *r) {
    bolan_sea_gpu_free(&r->fields);
    bolan_sea_compute_free(&r->compute);
    bolan_shore_builder_free(&r->shore);
    bolan_water_blocks_free(&r->own_blocks);
    bolan_wave_layer_destroy(&r->layer);
    bolan_ground_destroy(&r->ground);
    bolan_sea_destroy(&r->sea);
}

static void set_waves(const gl_program *program, const void *context) {
    const rig *r = context;
    (void)program;
    bolan_sea_gpu_bind(&r->fields, WATER_CASCADES);
    bolan_gl_texture_bind(&r->shore.map.texture, UNIT_SHORE);
    water_block block = {.cascade_count = 0};
    bolan_sea_gpu_fill(&block, &r->view, WATER_CASCADES);
    bolan_water_blocks_upload(r->blocks, &block);
}

// Within 200 m of the eye; over a beach in 1 to 6 m of water.
static void choose_points(const rig *r, double beach, bolan_dvec2 xy[COUNT]) {
    for (int i = 0; i < COUNT; i++) {
        const double u = fmod((i + 1) * 0.75487766, 1.0) - 0.5, v = fmod((i + 1) * 0.56984029, 1.0) - 0.5;
        xy[i].x = r->view.eye.x + (beach > 0.0 ? 5.0 / beach : 400.0) * u;
        xy[i].y = r->view.eye.y + 400.0 * v;
    }
}

// rms difference of the slopes of pixels whose footprint is `width` wide and of normals, as a share of the rms slope.
static double difference(const rig *r, const sample *s, double width, bool splines) {
    static const char *const body =
        "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), x.w, x.w);\n"
        "return vec4(waves_at(x.xy, place_of(x.xy), f, 1.0, x.z, vec4(0.0)).slope, 0.0, 0.0); }";
    bolan_dvec2 xy[COUNT];
    bolan_query_point want[COUNT];
    bolan_vec2 offset[COUNT];
    float height[COUNT], in[COUNT][4], out[COUNT][4];
    query q;
    choose_points(r, s->beach, xy);
    bolan_query_surface(&r->water, xy, COUNT, want);
    bolan_query_prepare(&r->water, &q);
    bolan_query_rest_points(&q, xy, COUNT, height, offset);
    for (int i = 0; i < COUNT; i++) {
        const double x = xy[i].x + (double)offset[i].x, y = xy[i].y + (double)offset[i].y;
        in[i][0] = (float)(x - r->view.eye.x), in[i][1] = (float)(y - r->view.eye.y);
        in[i][2] = r->ground ? (float)-bolan_ground_elevation(r->ground, x, y, 0.0) : 1e3f;
        in[i][3] = (float)width;
    }
    char defines[96];
    snprintf(defines, sizeof defines, "TAPS 4\n%s%s%s%s", r->layer ? "LAYERS 1\n" : "", splines ? "SPLINES 1\n" : "",
             r->ground ? "LAND 1\n" : "", s->order > 1 ? "BOUND_WAVES 1\n" : "");
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/waves.glsl\"", body, defines, set_waves, r, in,
                   COUNT, out);
    double error = 0.0, energy = 0.0;
    int plain = 0;
    for (int i = 0; i < COUNT; i++) {
        const double sx = -(double)(want[i].normal.x / want[i].normal.z),
                     sy = -(double)(want[i].normal.y / want[i].normal.z);
        if (want[i].jacobian < 0.4f || hypot(sx, sy) > 1.15) continue; // there the shader bounds slopes
        error += pow((double)out[i][0] - sx, 2.0) + pow((double)out[i][1] - sy, 2.0);
        energy += sx * sx + sy * sy;
        plain++;
    }
    assert_true(plain > COUNT * 9 / 10);
    return sqrt(error / energy);
}

// Linear fetches, of low and medium quality, leave images of the waves: 10 to 11 % were measured. A coast that did not
// lean the water would leave 20 %.
#define LINEAR_ERROR 0.13

static void check(sample s, double tolerance) {
    rig r;
    rig_open(&r, &s);
    const double error = difference(&r, &s, 1e-3, true);
    print_message("N %u, order %u, beach %g, %s%s: pixels are %.4f of the rms slope off\n", s.n, s.order, s.beach,
                  s.layer ? "with a train, " : "", s.compute ? "compute" : "cpu", error);
    assert_true(error < tolerance);
    if (s.beach > 0.1 && s.n == 128) assert_true(difference(&r, &s, 1e-3, false) < LINEAR_ERROR);
    rig_close(&r);
}

// Half floats round heights to 2^-12 of themselves, which is 0.1 % of the slopes; the warp is undone to 0.7 % of what
// the coast adds.
static void pixels_shade_the_normals_of_queries(void **state) {
    (void)state;
    check((sample){128, 1, 0.0, false, false}, 0.005);
    check((sample){256, 1, 0.0, false, false}, 0.005);
    check((sample){128, 2, 0.0, false, false}, 0.005);
}

static void pixels_lean_over_the_coast(void **state) {
    (void)state;
    check((sample){128, 1, 1.0 / 30.0, false, false}, 0.005);
    check((sample){256, 1, 1.0 / 5.0, false, false}, 0.005);
    check((sample){128, 2, 1.0 / 5.0, false, false}, 0.005);
    check((sample){128, 1, 1.0 / 5.0, false, true}, 0.005);
}

static void fields_of_compute_shaders_have_the_same_normals(void **state) {
    (void)state;
    check((sample){128, 1, 0.0, true, false}, 0.005);
    check((sample){128, 1, 1.0 / 5.0, true, false}, 0.005);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(pixels_shade_the_normals_of_queries),
                                       IN_BOTH_APIS(pixels_lean_over_the_coast),
                                       IN_BOTH_APIS(fields_of_compute_shaders_have_the_same_normals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
