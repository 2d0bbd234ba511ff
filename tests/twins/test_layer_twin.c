// SPDX-License-Identifier: MIT
// Wave layers as the shaders have them (shaders/common/layers.glsl) against the CPU: vertices, pixels, the coast, and
// what a mesh or a pixel's footprint leaves out. Stated error: phases of some 600 rad in floats are good to 6e-5, times
// amplitudes of 2 m and slopes of 0.3: 2e-4 of height and 1e-4 of slope.
#include "bolan/coast.h"
#include "bolan/query.h"
#include "shaders/probe.h"

#include "render/water_block.h"
#include "render/wave_layers.h"

enum { COUNT = 256 };
#define REACH 900.0f // from the eye [m]
#define HEIGHT_ERROR 2e-4
#define SLOPE_ERROR 1e-4

typedef struct rig {
    bolan_sea *sea;
    bolan_wave_layer *layers[2];
    bolan_water water;
    bolan_dvec3 eye;
    double time;
    water_block_buffers *blocks;
} rig;

// Two trains across each other around an eye far from the origin: one everywhere, one in an area beside the eye.
static void rig_open(rig *r, double time, water_block_buffers *blocks) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(0.0, 0.0, 1e5);
    desc.resolution = 32;
    *r = (rig){.eye = {1e6 + 0.3, -2e6 - 7.7, 12.0}, .time = time, .blocks = blocks};
    assert_int_equal(bolan_sea_create(&desc, &r->sea), BOLAN_OK);
    bolan_sea_step(r->sea, time);
    bolan_wave_train_desc one = bolan_wave_train_desc_default(), two = one;
    one.from_deg = 250.0, one.length = 90.0, one.height = 4.0, one.phase_deg = 35.0;
    two.from_deg = 340.0, two.length = 30.0, two.height = 1.2, two.half_length = 500.0, two.half_width = 300.0;
    two.edge = 0.6, two.centre = (bolan_dvec2){r->eye.x + 200.0, r->eye.y - 150.0};
    assert_int_equal(bolan_wave_layer_create_train(&one, &r->layers[0]), BOLAN_OK);
    assert_int_equal(bolan_wave_layer_create_train(&two, &r->layers[1]), BOLAN_OK);
    r->water = bolan_water_default();
    r->water.sea = r->sea;
    r->water.layers = (const bolan_wave_layer *const *)r->layers;
    r->water.layer_count = 2;
}

static void rig_close(rig *r) {
    bolan_wave_layer_destroy(&r->layers[0]);
    bolan_wave_layer_destroy(&r->layers[1]);
    bolan_sea_destroy(&r->sea);
}

static void set_layers(const gl_program *program, const void *context) {
    const rig *r = context;
    water_block block = {.cascade_count = 0};
    (void)program;
    block.layer_count =
        bolan_wave_layers_fill(&r->water, r->eye, block.layer_wave, block.layer_area, block.layer_extent);
    bolan_water_blocks_upload(r->blocks, &block);
}

static void run(const rig *r, const char *body, float (*in)[4], float (*out)[4]) {
    probe_run_with("#include \"common/frame.glsl\"\n#define VERTEX\n#include \"common/waves.glsl\"\n#undef VERTEX",
                   body, "LAND 1\nLAYERS 1\nTAPS 1\n", set_layers, r, in, COUNT, out);
}

static void scatter(float (*in)[4], float z, float w) {
    uint32_t h = 7;
    for (int i = 0; i < COUNT; ++i) {
        for (int k = 0; k < 2; ++k) {
            h = h * 1664525u + 1013904223u;
            in[i][k] = ((float)(h >> 8) / 8388608.0f - 1.0f) * REACH;
        }
        in[i][2] = z, in[i][3] = w;
    }
}

// Both layers at a place relative to the eye, each by `keep`.
static bolan_wave_layer_sample twin(const rig *r, const float *place, const double keep[2]) {
    const bolan_dvec2 p = {r->eye.x + (double)place[0], r->eye.y + (double)place[1]};
    bolan_wave_layer_sample sum = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i < 2; ++i) {
        bolan_wave_layer_sample one;
        bolan_wave_layer_sample_at(r->layers[i], r->time, &p, 1, &one);
        sum.height += (float)keep[i] * one.height;
        sum.slope_x += (float)keep[i] * one.slope_x;
        sum.slope_y += (float)keep[i] * one.slope_y;
    }
    return sum;
}

static void check_vertices(float spacing, float depth, const double keep[2]) {
    static const double times[2] = {0.0, 12345.6};
    for (int t = 0; t < 2; ++t) {
        rig r;
        float in[COUNT][4], out[COUNT][4];
        water_block_buffers blocks;
        assert_int_equal(bolan_water_blocks_create(&blocks), BOLAN_OK);
        rig_open(&r, times[t], &blocks);
        scatter(in, spacing, depth);
        run(&r,
            "vec4 probe(vec4 x) { vec4 f; vec3 o = wave_offset(x.xy, place_of(x.xy), x.z, x.w, f); "
            "return vec4(o.z, f.xy, length(o.xy)); }",
            in, out);
        for (int i = 0; i < COUNT; ++i) {
            const bolan_wave_layer_sample want = twin(&r, in[i], keep);
            assert_near(out[i][0], want.height, HEIGHT_ERROR);
            assert_near(out[i][1], want.slope_x, SLOPE_ERROR);
            assert_near(out[i][2], want.slope_y, SLOPE_ERROR);
            assert_near(out[i][3], 0.0, 0.0); // nothing moves sideways
        }
        rig_close(&r);
        bolan_water_blocks_free(&blocks);
    }
}

static void vertices_carry_the_layers(void **state) {
    (void)state;
    check_vertices(0.01f, 1e4f, (const double[2]){1.0, 1.0});
}

static void a_coarse_mesh_leaves_short_waves_to_the_pixels(void **state) {
    (void)state;
    // 10 m apart: 9 to a wave of 90 m, all; 3 to one of 30 m: 3/2 - 1 = half. 20 m apart: all, for 4.5 are enough;
    // none.
    check_vertices(10.0f, 1e4f, (const double[2]){1.0, 0.5});
    check_vertices(20.0f, 1e4f, (const double[2]){1.0, 0.0});
}

static void the_coast_takes_of_each_by_its_height(void **state) {
    (void)state;
    check_vertices(0.01f, 2.0f, (const double[2]){tanh(0.6 * 2.0 / 4.0), tanh(0.6 * 2.0 / 1.2)});
    check_vertices(0.01f, -0.1f, (const double[2]){0.0, 0.0});
}

static void pixels_have_the_slopes_and_what_they_hide_is_roughness(void **state) {
    (void)state;
    rig r;
    float in[COUNT][4], out[COUNT][4];
    water_block_buffers blocks;
    assert_int_equal(bolan_water_blocks_create(&blocks), BOLAN_OK);
    rig_open(&r, 40.0, &blocks);
    scatter(in, 0.05f, 0.02f); // a pixel of centimetres
    run(&r,
        "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), x.z, x.w);"
        " return vec4(layers_slope(x.xy, f, 1e4), waves_at(x.xy, place_of(x.xy), f, 1.0, 1e4, vec4(0.0)).slope); }",
        in, out);
    for (int i = 0; i < COUNT; ++i) {
        const bolan_wave_layer_sample want = twin(&r, in[i], (const double[2]){1.0, 1.0});
        assert_near(out[i][0], want.slope_x, SLOPE_ERROR);
        assert_near(out[i][1], want.slope_y, SLOPE_ERROR);
        assert_near(out[i][2], want.slope_x, SLOPE_ERROR); // waves_at() adds them
        assert_near(out[i][3], want.slope_y, SLOPE_ERROR);
    }
    // A wide pixel: a Gaussian of 0.4 of the widths, long towards the east. What is lost of the mean square is hidden.
    scatter(in, 60.0f, 8.0f);
    run(&r,
        "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), x.z, x.w);"
        " return vec4(layers_hidden(x.xy, f, 1e4), layers_slope(x.xy, f, 1e4).x); }",
        in, out);
    double going[2], k[2] = {2.0 * BOLAN_PI / 90.0, 2.0 * BOLAN_PI / 30.0}, keep[2];
    going[0] = bolan_compass_from_to_math(250.0), going[1] = bolan_compass_from_to_math(340.0);
    for (int i = 0; i < 2; ++i)
        keep[i] = exp(-0.5 * k[i] * k[i] * (24.0 * 24.0 * pow(cos(going[i]), 2) + 3.2 * 3.2 * pow(sin(going[i]), 2)));
    for (int i = 0; i < COUNT; ++i) {
        const bolan_wave_layer_sample want = twin(&r, in[i], keep);
        assert_near(out[i][3], want.slope_x, SLOPE_ERROR);
        // Beyond the second one's area only the first is hidden.
        if (hypot((double)in[i][0] - 200.0, (double)in[i][1] + 150.0) < 600.0) continue;
        const double square = 0.5 * 2.0 * 2.0 * k[0] * k[0] * (1.0 - keep[0] * keep[0]), c = cos(going[0]),
                     s = sin(going[0]);
        assert_near(out[i][0], square * c * c, 1e-6);
        assert_near(out[i][1], square * c * s, 1e-6);
        assert_near(out[i][2], square * s * s, 1e-6);
    }
    rig_close(&r);
    bolan_water_blocks_free(&blocks);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(vertices_carry_the_layers),
        IN_BOTH_APIS(a_coarse_mesh_leaves_short_waves_to_the_pixels),
        IN_BOTH_APIS(the_coast_takes_of_each_by_its_height),
        IN_BOTH_APIS(pixels_have_the_slopes_and_what_they_hide_is_roughness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
