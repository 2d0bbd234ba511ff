// SPDX-License-Identifier: MIT
// The vertex shader's path through the water against the library's.
#include "probe.h"

#include "bolan/scene.h"

#include <math.h>

static void raised_bottoms_match_the_library(void **state) {
    (void)state;
    enum { COUNT = 240 };
    float in[COUNT][4], out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = 0.1f + 12.0f * (float)(i % 8);      // eye over the water
        in[i][1] = -0.05f - 4.0f * (float)(i / 8 % 5); // the point, under it
        in[i][2] = 0.2f * (float)pow(4.0, i / 40);     // aside
        in[i][3] = 1.34f;
    }
    probe_run("#include \"shared/refraction.glsl\"",
              "vec4 probe(vec4 x) { return vec4(apparent_height(x.x, x.y, x.z, x.w)); }", in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        const double depth = -(double)in[i][1];
        const double expected = bolan_apparent_depth((double)in[i][0], depth, (double)in[i][2], (double)in[i][3]);
        // acceptance: within 1 %; four steps of Newton leave most of it unused, near the start of the steep part most
        // is left
        assert_true(fabs(-(double)out[i][0] - expected) < 0.004 * expected + 1e-4);
    }
}

static void trees_on_the_bank_stand_where_a_diver_sees_them(void **state) {
    (void)state;
    enum { COUNT = 60 };
    float in[COUNT][4], out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = -0.3f - (float)(i % 4);
        in[i][1] = 0.5f + 3.0f * (float)(i / 4 % 5);
        in[i][2] = 2.0f + 15.0f * (float)(i / 20);
        in[i][3] = 1.34f;
    }
    probe_run("#include \"shared/refraction.glsl\"",
              "vec4 probe(vec4 x) { return vec4(apparent_height(x.x, x.y, x.z, x.w)); }", in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        const double air = (double)in[i][1], water = -(double)in[i][0], aside = (double)in[i][2];
        const double x = bolan_refraction_crossing(air, water, aside, 1.34); // the same path, walked from the other end
        const double in_water = (aside - x) / water;                         // tangent
        const double seen = aside / in_water - water;
        assert_true(fabs((double)out[i][0] - seen) < 0.004 * seen + 1e-3); // as above
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(raised_bottoms_match_the_library),
        IN_BOTH_APIS(trees_on_the_bank_stand_where_a_diver_sees_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
