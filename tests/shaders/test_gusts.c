// SPDX-License-Identifier: MIT
// Gusts: what they do to the mean, in light winds the patches with glass between them, and the way they go.
#include "probe.h"

#include "bolan/waves.h"
#include "render/frame.h"

#include <math.h>

typedef struct gusts {
    double mean, square, least, most, first;
} gusts;

static void bind(const gl_program *program, const void *uniforms) {
    (void)program;
    bolan_blocks_bind(uniforms);
}

static const bolan_vec3 here = {0.0f, 0.0f, 1.0f};

// The factor at 32768 places of the whole period, each moved by shift.x and .y, with footprints of shift.z [m].
static gusts look(block_buffers *u, float wind, bolan_vec2 travel, bolan_vec3 shift) {
    static float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
    bolan_blocks_upload_frame(u, &(frame_block){.wind_speed = wind, .gust_travel = travel});
    for (int i = 0; i < PROBE_WIDTH; i++)
        in[i][0] = 512.0f * (float)i + shift.x, in[i][1] = shift.y, in[i][2] = shift.z;
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/gusts.glsl\"",
                   "vec4 probe(vec4 x) {\n"
                   "    vec4 sum = vec4(0.0, 0.0, 1e9, 0.0);\n"
                   "    for (int i = 0; i < 128; ++i) {\n"
                   "        float g = gustiness(x.xy + vec2(31.0, 1024.0) * float(i), x.z);\n"
                   "        sum = vec4(sum.xy + vec2(g, g * g) / 128.0, min(sum.z, g), max(sum.w, g));\n"
                   "    }\n"
                   "    return sum;\n"
                   "}",
                   NULL, bind, u, in, PROBE_WIDTH, out);
    gusts all = {.least = 1e9, .first = (double)out[0][0]};
    for (int i = 0; i < PROBE_WIDTH; i++) {
        all.mean += (double)out[i][0] / PROBE_WIDTH, all.square += (double)out[i][1] / PROBE_WIDTH;
        all.least = fmin(all.least, (double)out[i][2]), all.most = fmax(all.most, (double)out[i][3]);
    }
    return all;
}

static void gusts_leave_the_mean(void **state) {
    (void)state;
    block_buffers uniforms = {0};
    assert_int_equal(bolan_blocks_create(&uniforms), BOLAN_OK);
    const gusts breeze = look(&uniforms, 8.0f, (bolan_vec2){0}, here);
    const gusts light = look(&uniforms, 1.0f, (bolan_vec2){0}, here);
    print_message("8 m/s: mean %.4f, of squares %.4f, %.2f to %.2f; 1 m/s: %.4f, %.4f, %.2f to %.2f\n", breeze.mean,
                  breeze.square, breeze.least, breeze.most, light.mean, light.square, light.least, light.most);
    // the largest patches are 4 km wide, a thousand in the period: 1 % of chance
    assert_near(breeze.mean, 1.0, 0.02);
    assert_true(breeze.least > 0.6 && breeze.most < 1.4);
    assert_near(light.square, 1.0, 0.08);                 // the slope variance is that of Cox & Munk in the mean
    assert_true(light.least < 0.16 && light.most > 1.45); // glass, and paws
    bolan_blocks_free(&uniforms);
}

// A footprint wider than all patches has the slope variance of the mean, everywhere; before the horizon of a calm sea
// single patches would lie as strips.
static void wide_footprints_see_no_patches(void **state) {
    (void)state;
    block_buffers uniforms = {0};
    assert_int_equal(bolan_blocks_create(&uniforms), BOLAN_OK);
    for (int i = 0; i < 2; i++) {
        const gusts wide = look(&uniforms, i ? 8.0f : 1.0f, (bolan_vec2){0}, (bolan_vec3){0.0f, 0.0f, 4100.0f});
        assert_near(wide.least, 1.0, 1e-6);
        assert_near(wide.most, 1.0, 1e-6);
    }
    bolan_blocks_free(&uniforms);
}

// Places that went with the wind for as long as the gusts did see what they saw; without that, something else.
static void gusts_go_with_the_wind(void **state) {
    (void)state;
    block_buffers uniforms = {0};
    assert_int_equal(bolan_blocks_create(&uniforms), BOLAN_OK);
    const bolan_vec2 far = {4096.0f, 1536.0f};
    const bolan_vec3 gone = {far.x, far.y, 1.0f};
    const gusts now = look(&uniforms, 1.0f, (bolan_vec2){0}, here);
    const gusts with = look(&uniforms, 1.0f, far, gone), without = look(&uniforms, 1.0f, far, here);
    assert_near(with.first, now.first, 1e-4);
    assert_true(fabs(without.first - now.first) > 0.01);
    bolan_blocks_free(&uniforms);
}

// x: tangent of the angle of a ray below the level. Gusts that a row sees there, and those at y metres with footprints
// of z metres.
static const char *const row_body =
    "vec4 probe(vec4 x) {\n"
    "    vec3 ray = normalize(vec3(0.6, 0.8, -x.x));\n"
    "    return vec4(gusts_seen(ray, 0.0), gustiness(eye_wrapped_wide + x.y * vec2(0.6, 0.8), x.z), 0.0, 0.0);\n"
    "}\n";

// An eye at 10 m, on a flat earth, rows of 4 mrad: the last one that meets water has its middle 2 mrad below the
// horizon, at 5 km, where a row covers 4 mrad (5 km)^2 / 10 m = 10 km. Gusts average over 0.15 of that.
static void the_last_row_sees_the_gusts_at_its_middle(void **state) {
    (void)state;
    static const float below[] = {0.0005f, 0.0f, -0.003f};
    block_buffers uniforms = {0};
    block_values blocks = {
        .frame = {.wind_speed = 8.0f, .earth_radius = 1e15f},
        .view = {.eye_height = 10.0f, .radians_per_pixel = 0.001f, .eye_wrapped_wide = {300.0f, 70.0f}}};
    assert_int_equal(bolan_blocks_create(&uniforms), BOLAN_OK);
    bolan_blocks_upload(&uniforms, &blocks);
    float in[4][4] = {{0.004f, 2500.0f, 0.15f * 2500.0f}}, out[4][4];
    for (int i = 0; i < 3; ++i) in[i + 1][0] = below[i], in[i + 1][1] = 5000.0f, in[i + 1][2] = 0.15f * 10000.0f;
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/mean_water.glsl\"", row_body, NULL, bind,
                   &uniforms, in, 4, out);
    assert_true(fabs((double)out[1][1] - 1.0) > 0.01); // there are gusts
    for (int i = 0; i < 4; ++i) assert_near(out[i][0], out[i][1], 1e-3);
    bolan_blocks_free(&uniforms);
}

// Wind from the west by south (250 degrees), 6 m/s: in 100 s the gusts go 600 m, 563.8 m east and 205.2 m north.
static void the_frame_carries_the_gusts_downwind(void **state) {
    (void)state;
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(6.0, 250.0, 50e3);
    d.resolution = 64;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    bolan_sea_step(sea, 100.0);
    frame f = {.sea = sea};
    bolan_frame_fill(&f);
    assert_near(f.block.gust_travel.x, 563.8, 0.1);
    assert_near(f.block.gust_travel.y, 205.2, 0.1);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(gusts_leave_the_mean), IN_BOTH_APIS(wide_footprints_see_no_patches),
                                       IN_BOTH_APIS(gusts_go_with_the_wind),
                                       IN_BOTH_APIS(the_last_row_sees_the_gusts_at_its_middle),
                                       cmocka_unit_test(the_frame_carries_the_gusts_downwind)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
