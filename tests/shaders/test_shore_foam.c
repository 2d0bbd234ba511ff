// SPDX-License-Identifier: MIT
// The depth from where the bed alters nothing (is_shallow() of shaders/common/shore_foam.glsl) against what it alters:
// each kind of wave, their lean, and foam at the shore.
#include "probe.h"

#include "render/blocks.h"
#include "render/frame.h"
#include "render/water_block.h"

enum { COUNT = 256 };

typedef struct sea_over_bed {
    const char *what;
    float hs, shore_height, bands[2], layer_height; // [m]
    float depth;                                    // from where the bed alters nothing, by hand [m]
} sea_over_bed;

// 4.9 / 0.6 heights of waves and 0.05 m; 2.6 heights of bores; 0.8 m and the rise of 3 in 1 over 5 m to rocks.
static const sea_over_bed cases[] = {
    {"the sea", 5.0f, 4.0f, {0.0f, 0.0f}, 0.0f, 40.88f}, {"its bands", 0.5f, 0.5f, {3.0f, 4.0f}, 0.0f, 40.88f},
    {"a layer", 0.5f, 0.5f, {0.3f, 0.4f}, 6.0f, 49.05f}, {"bores", 0.5f, 10.0f, {0.3f, 0.4f}, 0.0f, 26.0f},
    {"rocks", 0.5f, 0.5f, {0.3f, 0.4f}, 0.0f, 15.8f},
};

static void set_sea(const gl_program *program, const void *context) {
    const sea_over_bed *c = context;
    (void)program;
    const gl_texture_desc desc = {
        .format = GL_FMT_R16F, .width = 2, .height = 2, .depth = 4, .array = true, .filter = GL_FILTER_LINEAR};
    const float at_the_level[2 * 2] = {0.0f};
    block_buffers uniforms; // these are gone with the test's context
    water_block_buffers buffers;
    gl_texture map;
    assert_int_equal(bolan_gl_texture_create(&desc, &map), BOLAN_OK);
    for (int layer = 0; layer < 4; ++layer) bolan_gl_texture_upload(&map, 0, layer, at_the_level, false);
    bolan_gl_texture_bind(&map, UNIT_SHORE);
    water_block b = {.significant_height = c->hs, .shore_height = c->shore_height, .shore_present = 1};
    for (int i = 0; i < 2; ++i) b.cascade_band[i].x = c->bands[i];
    b.layer_count = c->layer_height > 0.0f;
    b.layer_extent[0].w = c->layer_height;
    b.shore_level[0] = (bolan_vec4){-1000.0f, -1000.0f, 2000.0f, 1.0f};
    assert_int_equal(bolan_blocks_create(&uniforms), BOLAN_OK);
    bolan_blocks_upload_frame(&uniforms, &(frame_block){.surf_time = 0.0f});
    bolan_blocks_bind(&uniforms);
    assert_int_equal(bolan_water_blocks_create(&buffers), BOLAN_OK);
    bolan_water_blocks_upload(&buffers, &b);
}

// Waves, at that depth and where their lean is measured, and foam, with rocks beside.
static const char *const body =
    "float lost(float depth) {\n"
    "    vec4 bands = coast_attenuations(depth, vec4(cascade_band[0].x, cascade_band[1].x, 0.0, 0.0));\n"
    "    float keep = min(min(bands.x, bands.y), coast_attenuation(depth, significant_height));\n"
    "    for (int i = 0; i < layer_count; ++i) keep = min(keep, coast_attenuation(depth, layer_extent[i].w));\n"
    "    return 1.0 - keep;\n"
    "}\n"
    "vec4 probe(vec4 x) {\n"
    "    float waves = max(lost(x.x), lost(x.x - LEAN_STEP)), foam = shore_cover(vec2(0.0), x.x, 100.0, x.yz);\n"
    "    return vec4(is_shallow(x.x) ? 1.0 : 0.0, waves, foam, 0.0);\n"
    "}\n";

static void deep_water_is_what_the_bed_leaves_alone(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        float in[COUNT][4], out[COUNT][4];
        for (int i = 0; i < COUNT; ++i) { // each depth within half a percent, and noises to both ends
            in[i][0] = cases[k].depth * (0.8f + 0.4f * ((float)(i / 2) + 0.5f) / (COUNT / 2));
            in[i][1] = i % 2 == 0 ? 0.0f : (float)(i % 19) / 18.0f;
            in[i][2] = (float)(i % 23) / 22.0f;
        }
        probe_run_with("#include \"common/frame.glsl\"\n#include \"common/shore_foam.glsl\"", body, NULL, set_sea,
                       &cases[k], in, COUNT, out);
        float deepest = 0.0f;
        for (int i = 0; i < COUNT; ++i) {
            const bool altered = out[i][1] != 0.0f || out[i][2] != 0.0f;
            if (altered && out[i][0] == 0.0f) fail_msg("%s: altered %g m deep", cases[k].what, (double)in[i][0]);
            if (fabsf(in[i][0] / cases[k].depth - 1.0f) > 1e-3f) // the depths by hand have four digits
                assert_true((out[i][0] == 1.0f) == (in[i][0] < cases[k].depth));
            if (altered) deepest = fmaxf(deepest, in[i][0]);
        }
        print_message("%s: altered down to %.2f m, shallow to %.2f m\n", cases[k].what, (double)deepest,
                      (double)cases[k].depth);
        assert_true(deepest > 0.99f * cases[k].depth); // the places are 0.3 % apart
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(deep_water_is_what_the_bed_leaves_alone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
