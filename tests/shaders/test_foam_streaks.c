// SPDX-License-Identifier: MIT
// Old foam is drawn out along the wind (shaders/common/foam.glsl): streaks 2.5 times as long as they are wide,
// whichever way it blows.
#include "probe.h"

#include "render/foam_texture.h"
#include "render/frame.h"

typedef struct rig {
    gl_texture detail;
    block_buffers uniforms;
    block_values blocks;
} rig;

static void set_foam(const gl_program *program, const void *context) {
    const rig *r = context;
    (void)program;
    bolan_blocks_bind(&r->uniforms);
    bolan_gl_texture_bind(&r->detail, UNIT_FOAM_DETAIL);
}

// Mean squared difference of the streaks at places `apart` from each other: xy along, zw across the wind.
static const char *const probe_body =
    "vec4 probe(vec4 x) {\n"
    "    vec4 sum = vec4(0.0);\n"
    "    for (int i = 0; i < 2048; ++i) {\n"
    "        vec2 at = 300.0 * fract(float(i) * vec2(0.75487766, 0.56984029));\n"
    "        float here = foam_look_up(at, 0.02).streak.r;\n"
    "        float along = foam_look_up(at + x.x * wind_direction, 0.02).streak.r - here;\n"
    "        float across = foam_look_up(at + x.x * vec2(-wind_direction.y, wind_direction.x), 0.02).streak.r - here;\n"
    "        float broad = foam_look_up(at, 0.02).broad.r;\n"
    "        float east = foam_look_up(at + vec2(x.x, 0.0), 0.02).broad.r - broad;\n"
    "        float north = foam_look_up(at + vec2(0.0, x.x), 0.02).broad.r - broad;\n"
    "        sum += vec4(along * along, across * across, east * east, north * north) / 2048.0;\n"
    "    }\n"
    "    return sum;\n"
    "}\n";

static void old_foam_is_drawn_out_along_the_wind(void **state) {
    (void)state;
    const double winds[] = {0.3, 1.9, -2.6};
    for (int k = 0; k < 3; ++k) {
        rig r = {.blocks = {
                     .frame = {.wind_direction = {(float)cos(winds[k]), (float)sin(winds[k])},
                               .streak_scale = {1.0f / 16.0f, 0.4f / 16.0f}},
                     .view = {.eye_wrapped = {700.0f, 100.0f}, .water_wrapped = {700.0f, 100.0f}, .eye_height = 3.0f}}};
        r.blocks.view.streak_place =
            bolan_frame_streaks(bolan_dv3(700.0, 100.0, 3.0), winds[k], r.blocks.frame.streak_scale);
        float in[2][4] = {{0.1f}, {0.25f}}, out[2][4];
        assert_int_equal(bolan_foam_noise_create(&r.detail), BOLAN_OK);
        assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
        bolan_blocks_upload(&r.uniforms, &r.blocks);
        probe_run_with("#include \"common/frame.glsl\"\n#include \"common/slopes.glsl\"\n#include \"common/foam.glsl\"",
                       probe_body, NULL, set_foam, &r, in, 2, out);
        // 0.25 m along the wind is what 0.1 m is across it; 2048 places, and a texture that is nearly the same along
        // its two axes
        assert_near(out[1][0] / out[0][1], 1.0, 0.15);
        assert_true(out[0][0] < 0.6f * out[0][1]);
        assert_near(out[0][2] / out[0][3], 1.0, 0.15); // fresh foam is not
        bolan_blocks_free(&r.uniforms);
        bolan_gl_texture_free(&r.detail);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(old_foam_is_drawn_out_along_the_wind)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
