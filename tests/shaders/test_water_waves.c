// SPDX-License-Identifier: MIT
// The sums of waves as the shader makes them (shaders/common/waves.glsl) against their twins on the CPU: the sum in
// double and the kernels of src/waves.
#include "probe.h"

#include "render/sea_gpu.h"
#include "render/shore_map.h"

#define EYE_X 123456.7
#define EYE_Y (-98765.4)
#define TIME 4321.5

typedef struct rig {
    bolan_sea *sea;
    shore_map shore;
    frame step;
    render_view f;
    sea_gpu fields;
    water_block_buffers *blocks;
    water_block_buffers own_blocks;
    water_waves waves;
} rig;

// Without horizontal displacement a rest point is a point of the surface, and the slopes are plain derivatives.
static void rig_open(rig *r, bolan_wave_model model, uint32_t wave_count, double sharpness) {
    memset(r, 0, sizeof *r);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(9.0, 250.0, 200e3);
    desc.waves = model;
    desc.exp_cosine.wave_count = wave_count;
    desc.exp_cosine.sharpness = sharpness;
    desc.choppiness = 0.0;
    assert_int_equal(bolan_sea_create(&desc, &r->sea), BOLAN_OK);
    bolan_sea_step(r->sea, TIME);
    r->step = (frame){.sea = r->sea, .lighting = bolan_lighting_default(), .time = TIME};
    r->f = (render_view){.frame = &r->step, .eye = {EYE_X, EYE_Y, 5.0}, .shore = &r->shore};
    r->waves = model == BOLAN_WAVES_EXP_COSINE ? WATER_EXP : WATER_SUM;
    assert_int_equal(bolan_sea_gpu_create(&r->fields), BOLAN_OK);
    assert_int_equal(bolan_water_blocks_create(&r->own_blocks), BOLAN_OK);
    r->blocks = &r->own_blocks;
    bolan_sea_gpu_prepare(&r->fields, &r->step, WATER_TEXTURES_ALL);
    bolan_sea_gpu_view(&r->fields, &r->f, r->waves);
}

static void rig_close(rig *r) {
    bolan_sea_gpu_free(&r->fields);
    bolan_water_blocks_free(&r->own_blocks);
    bolan_sea_destroy(&r->sea);
}

static void set_waves(const gl_program *program, const void *context) {
    const rig *r = context;
    bolan_sea_gpu_bind(&r->fields, r->waves);
    (void)program;
    water_block block = {.cascade_count = 0};
    bolan_sea_gpu_fill(&block, &r->f, r->waves);
    bolan_water_blocks_upload(r->blocks, &block);
}

// Both stages' functions in one; the number of waves as the programs of the water have it.
static void run(const rig *r, const char *body, float (*in)[4], uint32_t count, float (*out)[4]) {
    char defines[64], waves[24] = "";
    if (r->waves == WATER_EXP) snprintf(waves, sizeof waves, "WAVE_COUNT %u\n", bolan_sea_component_count(r->sea));
    snprintf(defines, sizeof defines, "%s%s", bolan_water_waves_define(r->waves), waves);
    probe_run_with("#include \"common/frame.glsl\"\n#define VERTEX\n#include \"common/waves.glsl\"\n#undef VERTEX",
                   body, defines, set_waves, r, in, count, out);
}

enum { COUNT = 256 };
#define REACH 1500.0f // from the eye [m]

static void scatter(float (*in)[4]) {
    uint32_t h = 1;
    for (int i = 0; i < COUNT; ++i)
        for (int k = 0; k < 2; ++k) {
            h = h * 1664525u + 1013904223u;
            in[i][k] = ((float)(h >> 8) / 8388608.0f - 1.0f) * REACH;
        }
}

// A phase of k REACH is known to half an ulp of float for each of two products and two sums, less than 4 * 2^-24 of it,
// and the polynomials to 4e-6: that much of every wave's height, and of its slope, whose derivative is at most e^s
// times as great.
static void tolerance(const rig *r, double *height, double *slope) {
    *height = *slope = 1e-6;
    for (uint32_t i = 0; i < bolan_sea_component_count(r->sea); ++i) {
        bolan_sea_component w = bolan_sea_get_component(r->sea, i);
        const double k = hypot(w.kx, w.ky), phase = k * REACH * 1.5 * 4.0 * 0x1p-24 + 1e-5;
        *height += 2.0 * w.amplitude * phase;
        *slope += 4.0 * w.amplitude * k * phase;
    }
}

static void compare(const rig *r) {
    float in[COUNT][4] = {{0}}, height[COUNT][4], slope[COUNT][4];
    scatter(in);
    if (r->waves == WATER_EXP) // the shader of the vertices has no sum of cosines: the CPU makes those
        run(r,
            "vec4 probe(vec4 x) { vec4 fields; return vec4(wave_offset(x.xy, place_of(x.xy), 1e-3, 1e3, fields), "
            "fields.x); }",
            in, COUNT, height);
    run(r,
        "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), 1e-4, 1e-4); "
        "wave_fields w = waves_at(x.xy, place_of(x.xy), f, 1.0, 1e3, vec4(0.0)); "
        "return vec4(w.slope, w.jacobian, w.foam); }",
        in, COUNT, slope);
    double height_error, slope_error;
    tolerance(r, &height_error, &slope_error);
    assert_true(height_error < 2e-3 && slope_error < 1e-3); // else the test says nothing: metres, and slopes of 0.1
    for (int i = 0; i < COUNT; ++i) {
        const bolan_dvec2 at = {EYE_X + (double)in[i][0], EYE_Y + (double)in[i][1]};
        const bolan_sea_sample exact = bolan_sea_sample_direct(r->sea, at.x, at.y, TIME);
        bolan_sea_sample kernel;
        bolan_sea_sample_rest(r->sea, &at, 1, &kernel);
        if (r->waves == WATER_EXP) {
            assert_near(height[i][2], exact.height, height_error);
            assert_near(height[i][2], kernel.height, height_error);
            assert_near(height[i][3], exact.slope_x, slope_error);
        }
        assert_near(slope[i][0], exact.slope_x, slope_error);
        assert_near(slope[i][1], exact.slope_y, slope_error);
        assert_near(slope[i][0], kernel.slope_x, slope_error);
        assert_near(slope[i][1], kernel.slope_y, slope_error);
    }
}

static void eight_waves_of_exp_cosine_are_those_of_the_cpu(void **state) {
    (void)state;
    const double sharpness[] = {0.1, 0.5, 1.0, 2.0};
    for (int i = 0; i < 4; ++i) {
        rig r;
        rig_open(&r, BOLAN_WAVES_EXP_COSINE, 8, sharpness[i]);
        compare(&r);
        rig_close(&r);
    }
}

static void a_hundred_cosines_are_those_of_the_cpu(void **state) {
    (void)state;
    rig r;
    rig_open(&r, BOLAN_WAVES_COSINES, 8, 0.5);
    assert_int_equal(bolan_sea_component_count(r.sea), 128);
    compare(&r);
    rig_close(&r);
}

static void one_wave_of_amplitude_one_has_the_papers_numbers(void **state) {
    (void)state;
    rig r;
    rig_open(&r, BOLAN_WAVES_EXP_COSINE, 1, 1.0);
    // Liu & Xie 2010 with s = 1: e^cos has the mean 1.26607, from .36788 to 2.71828; its slope is 1.45853 at most,
    // where cos = .61803
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) in[i][0] = (float)(i * BOLAN_PI / 128.0);
    in[1][0] = (float)acos(0.5 * (sqrt(5.0) - 1.0));
    run(&r, "vec4 probe(vec4 x) { return vec4(wave_height(x.x, 0.0), wave_slope(x.x, 0.0), 0.0, 0.0); }", in, COUNT,
        out);
    const double e = exp(1.0); // the shader's shape is e^(cos - 1)
    double mean = 0.0;
    for (int i = 0; i < COUNT; ++i) mean += i == 1 ? 0.0 : e * (double)out[i][0] / (COUNT - 1);
    assert_near(e * (double)out[0][0], 2.7182818 - 1.2660659, 1e-5);
    assert_near(e * (double)out[128][0], 0.3678794 - 1.2660659, 1e-5);
    assert_near(e * (double)out[1][1], -1.4585285, 2e-5); // 4e-6 in sine and in cosine, each times e
    assert_near(mean, 0.0, 6e-3);                         // one of 256 is not of the lattice: 1.45 / 255
    rig_close(&r);
}

// keep^2 of the power is what the table of unresolved slopes does not have.
static void what_a_footprint_takes_from_a_wave_is_in_the_table(void **state) {
    (void)state;
    rig r;
    rig_open(&r, BOLAN_WAVES_EXP_COSINE, 1, 0.5);
    bolan_sea_component w = bolan_sea_get_component(r.sea, 0);
    const double k = hypot(w.kx, w.ky);
    float none[3], all[3], in[40][4] = {{0}}, out[40][4];
    bolan_sea_unresolved_slopes(r.sea, 0.0, 0.0, 0.0, none);
    bolan_sea_unresolved_slopes(r.sea, 1e4, 1e4, 0.0, all);
    for (int i = 0; i < 40; ++i) {
        in[i][0] = (float)(0.25 * (i % 10) / k / 0.4);                       // width along
        in[i][1] = in[i][0] * (i >= 20 ? 0.25f : 1.0f);                      // and across
        in[i][2] = (float)(i / 10 % 2 == 0 ? 0.0 : atan2(w.ky, w.kx) + 0.6); // direction of the long side
    }
    run(&r,
        "float slope_under(footprint f) { vec2 at = vec2(1.0, 2.0); "
        "return waves_at(at, place_of(at), f, 1.0, 1e3, vec4(0.0)).slope.x; }\n"
        "vec4 probe(vec4 x) { vec2 a = vec2(cos(x.z), sin(x.z)); "
        "return vec4(slope_under(footprint(a, x.x, x.y)) / slope_under(footprint(a, 1e-5, 1e-5))); }",
        in, 40, out);
    for (int i = 0; i < 40; ++i) {
        float left[3];
        bolan_sea_unresolved_slopes(r.sea, 0.4 * (double)in[i][0], 0.4 * (double)in[i][1], (double)in[i][2], left);
        const double kept =
            1.0 - (double)(left[0] + left[2] - none[0] - none[2]) / (double)(all[0] + all[2] - none[0] - none[2]);
        // the table gathers waves by 16 directions over half a turn and gives all of a bin the direction of its middle,
        // 0.1 rad off at most; of a slant footprint exp(-x) changes by 0.1 at most for that
        const bool slant = i >= 20;
        assert_near((double)out[i][0] * (double)out[i][0], kept, slant ? 0.1 : 2e-3);
    }
    rig_close(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(eight_waves_of_exp_cosine_are_those_of_the_cpu),
        IN_BOTH_APIS(a_hundred_cosines_are_those_of_the_cpu),
        IN_BOTH_APIS(one_wave_of_amplitude_one_has_the_papers_numbers),
        IN_BOTH_APIS(what_a_footprint_takes_from_a_wave_is_in_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
