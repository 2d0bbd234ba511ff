// SPDX-License-Identifier: MIT
// Levels of detail that trilinear fetches are made at.
#include "probe.h"

#include <math.h>

enum { COUNT = 256, PER_OCTAVE = 32 };

static void no_setup(const gl_program *program, const void *context) {
    (void)program;
    (void)context;
}

static void levels(const char *defines, float (*in)[4], float (*out)[4]) {
    for (int i = 0; i < COUNT; ++i) in[i][0] = ((float)i + 0.5f) / PER_OCTAVE;
    probe_run_with("#include \"common/level.glsl\"", "vec4 probe(vec4 x) { return vec4(fetched_level(x.x)); }", defines,
                   no_setup, NULL, in, COUNT, out);
}

static void three_quarters_of_an_octave_are_one_level(void **state) {
    (void)state;
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    levels("TAPS 2\n", in, out);
    int blended = 0;
    for (int i = 0; i < COUNT; ++i) {
        const float level = out[i][0];
        blended += level != floorf(level);
        assert_true(fabsf(level - in[i][0]) <= 0.375f); // half of the octave less half of what is blended
        assert_true(i == 0 || level >= out[i - 1][0]);
    }
    assert_int_equal(blended, COUNT / 4);
}

static void high_qualities_keep_the_level(void **state) {
    (void)state;
    static const char *const defines[] = {"TAPS 4\n", NULL};
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    for (int k = 0; k < 2; ++k) {
        levels(defines[k], in, out);
        for (int i = 0; i < COUNT; ++i) assert_true(out[i][0] == in[i][0]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(three_quarters_of_an_octave_are_one_level),
        IN_BOTH_APIS(high_qualities_keep_the_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
