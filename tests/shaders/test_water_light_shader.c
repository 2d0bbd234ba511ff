// SPDX-License-Identifier: MIT
// Light out of the water and off its foam (shaders/common/water_light.glsl): Beer's law, a crest against the sun,
// Lambert's law.
#include "probe.h"

#include <math.h>

#define INCLUDES "#include \"common/water_light.glsl\""

static void a_bed_is_dimmed_both_ways_and_by_the_surface(void **state) {
    (void)state;
    // depth [m] and cosine of the refracted view; bed of radiance 1, 2, 3 under water of radiance .01, .02, .04
    float in[5][4] = {{0, 1}, {5, 1}, {5, 0.8f}, {20, 0.66f}, {1e4f, 1}}, out[5][4];
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { return vec4(radiance_of_bed(vec3(1.0, 2.0, 3.0), vec3(0.01, 0.02, 0.04), "
              "exp(-vec3(0.35, 0.08, 0.05) * bed_path(x.x, x.y))), 0.0); }",
              in, 5, out);
    const double kd[3] = {0.35, 0.08, 0.05}, bed[3] = {1, 2, 3}, deep[3] = {0.01, 0.02, 0.04};
    for (int i = 0; i < 5; ++i)
        for (int c = 0; c < 3; ++c) {
            const double passed = exp(-kd[c] * (double)in[i][0] * (1.0 + 1.0 / (double)in[i][1]));
            // .54: (1 - .021) .932 / 1.34^2 of it leaves, 0.51, and 1 / (1 - .475 .1) comes back from a bed of albedo
            // .1
            assert_near(out[i][c], 0.54 * bed[c] * passed + deep[c] * (1.0 - passed), 1e-5 * bed[c]);
        }
    assert_near(0.979 * 0.932 / (1.34 * 1.34) / (1.0 - 0.475 * 0.1), 0.54, 0.01);
}

static void a_crest_glows_towards_the_sun_and_from_the_side_only(void **state) {
    (void)state;
    // elevation of the view down [deg], its azimuth from the sun [deg], height, jacobian
    float in[9][4] = {{3, 0, 1, 0.7f},  {3, 90, 1, 0.7f}, {3, 180, 1, 0.7f}, {90, 0, 1, 0.7f}, {3, 0, 0.5f, 0.7f},
                      {3, 0, -1, 0.7f}, {3, 0, 1, 1.2f},  {60, 0, 1, 0.7f},  {3, 0, 2, 0.7f}},
          out[9][4];
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { float e = radians(x.x), a = radians(x.y); vec3 v = vec3(-cos(a) * cos(e), -sin(a) "
              "* cos(e), "
              "sin(e)); return vec4(crest_glow(vec3(0.001, 0.002, 0.003), vec3(2.0, 1.0, 0.5), v, vec3(0.98480775, "
              "0.0, 0.17364818), "
              "x.z, x.w), 0.0); }",
              in, 9, out);
    assert_near(out[0][0],
                0.002 * 0.5 * (0.6 + 5.0 * pow(cos(bolan_radians(13.0)), 3)) * pow(cos(bolan_radians(3.0)), 4), 1e-6);
    for (int i = 0; i < 9; ++i) { // the colour of the water times that of the sun
        assert_near(out[i][1], out[i][0], 1e-7);
        assert_near(out[i][2], 0.75 * (double)out[i][0], 1e-7);
    }
    assert_near(out[1][0], 0.002 * 0.5 * 0.6 * pow(cos(bolan_radians(3.0)), 4), 1e-6);
    assert_near(out[2][0], out[1][0], 1e-7);
    assert_near(out[3][0], 0.0, 1e-9); // straight down
    assert_near(out[4][0], 0.5 * (double)out[0][0], 1e-7);
    assert_near(out[5][0], 0.0, 1e-9); // a trough
    assert_near(out[6][0], 0.0, 1e-9); // not pinched
    assert_true(out[7][0] < 0.05f * out[0][0]);
    assert_near(out[8][0], out[0][0], 1e-7); // no more than a full crest's
}

static void foam_is_lambertian(void **state) {
    (void)state;
    float in[3][4] = {{0.5f}, {1.0f}, {-0.5f}}, out[3][4];
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { return vec4(foam_radiance(vec3(3.0, 2.0, 1.0), x.x, vec3(0.1, 0.2, 0.3)), "
              "FOAM_ALBEDO); }",
              in, 3, out);
    for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 3; ++c)
            assert_near(out[i][c], ((3.0 - c) * fmax((double)in[i][0], 0.0) + 0.1 * (c + 1)) / BOLAN_PI, 1e-6);
    assert_true(out[0][3] >= 0.5f && out[0][3] <= 0.8f); // thick foam
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(a_bed_is_dimmed_both_ways_and_by_the_surface),
        IN_BOTH_APIS(a_crest_glows_towards_the_sun_and_from_the_side_only),
        IN_BOTH_APIS(foam_is_lambertian),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
