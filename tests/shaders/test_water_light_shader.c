// SPDX-License-Identifier: MIT
// Light out of the water and off its foam (shaders/common/water_light.glsl): Beer's law, a crest against the sun,
// Lambert's law.
#include "probe.h"

#include "shared/fournier_forand.glsl"

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

// The way through a crest of a cosine wave, from its phase on one side to the same on the other.
static void the_way_through_a_crest_is_that_of_its_wave(void **state) {
    (void)state;
    enum { COUNT = 24 };
    float in[COUNT][4], out[COUNT][4];
    const double k = 0.3, amplitude = 1.2;
    for (int i = 0; i < COUNT; ++i) {
        const double phase = -1.4 + 2.8 * i / (COUNT - 1);
        in[i][0] = (float)(amplitude * cos(phase)), in[i][1] = (float)(amplitude * k * sin(phase));
        in[i][2] = (float)(amplitude * k * cos(phase)), in[i][3] = 0.0f;
    }
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { return vec4(crest_path(x.x, x.y, x.z), crest_path(-x.x, x.y, x.z), "
              "crest_path(x.x, x.y, -x.z), 0.0); }",
              in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        const double phase = -1.4 + 2.8 * i / (COUNT - 1);
        assert_near(out[i][0], fmax(2.0 * phase / k, 0.0), 2e-3);
        assert_near(out[i][1], 0.0, 1e-9);                                // a trough
        assert_true(in[i][1] <= 0.01f || out[i][2] > 3000.0f * in[i][0]); // not pinched: it is no crest
    }
}

// b beta(angle) path exp(-K path) / n^2, forwards most.
static void a_crest_glows_before_the_sun(void **state) {
    (void)state;
    float in[5][4] = {{0.9f, 2.0f}, {0.9f, 4.0f}, {-0.9f, 2.0f}, {0.9f, 0.0f}, {0.9f, 5000.0f}}, out[5][4];
    const double b[3] = {0.2, 0.22, 0.26}, k[3] = {0.4, 0.08, 0.06}, sun[3] = {3.0, 2.0, 1.0};
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { return vec4(crest_light(vec3(0.2, 0.22, 0.26), vec3(0.4, 0.08, 0.06), vec3(3.0, "
              "2.0, 1.0), x.x, x.y, 1.34), 0.0); }",
              in, 5, out);
    // Fournier & Forand with n = 1.1, m = 3.5835: 0.0789 / sr at a cosine of 0.9 (Petzold's mean has 0.07 to 0.09)
    const double phase = fournier_forand(0.9, fournier_forand_index(3.5835), 3.5835);
    assert_true(phase > 0.05 && phase < 0.12);
    for (int c = 0; c < 3; ++c) {
        const double want = 0.95 * sun[c] * b[c] * phase / (1.34 * 1.34);
        assert_near(out[0][c], want * 2.0 * exp(-2.0 * k[c]), 2e-4 * want);
        assert_near(out[1][c], want * 4.0 * exp(-4.0 * k[c]), 4e-4 * want);
        assert_true(out[2][c] < 0.1f * out[0][c]); // with the sun behind the eye
        assert_true(out[3][c] == 0.0f && out[4][c] == 0.0f);
    }
    assert_true(out[1][0] / out[1][1] < out[0][0] / out[0][1]); // red goes first
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
        IN_BOTH_APIS(the_way_through_a_crest_is_that_of_its_wave),
        IN_BOTH_APIS(a_crest_glows_before_the_sun),
        IN_BOTH_APIS(foam_is_lambertian),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
