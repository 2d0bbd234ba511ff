// SPDX-License-Identifier: MIT
// Rough water by square roots (shaders/common/rough.glsl) against the same integrals done the long way, and against published numbers.
#include "probe.h"

#include <math.h>

#define INCLUDES "#include \"common/fresnel.glsl\"\n#include \"common/rough.glsl\""

static void by_quadrature(double elevation, double sigma, double *area, double *shift) {
    double h = cos(elevation), z = sin(elevation), m0 = 0, m1 = 0;
    for (int i = -4000; i < 4000; ++i) {
        double t = (i + 0.5) * 8.0 * sigma / 4000.0, w = fmax(0.0, z + t * h) * exp(-0.5 * t * t / (sigma * sigma));
        m0 += w, m1 += w * t;
    }
    *area = m0 * 8.0 * sigma / 4000.0 / (sigma * sqrt(2 * BOLAN_PI)), *shift = m1 / m0;
}

static void facets_in_sight_are_nearly_those_of_a_gaussian(void **state) {
    (void)state;
    enum { COUNT = 40 };
    float in[COUNT][4], out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = (float)((0.5 + (i % 10) * 9) * BOLAN_PI / 180.0);
        in[i][1] = 0.03f + 0.07f * (float)(i / 10);
    }
    probe_run(
        INCLUDES,
        "vec4 probe(vec4 x) { rough_facets f = rough_seen(vec3(0.6 * cos(x.x), 0.8 * cos(x.x), sin(x.x)), vec2(0.0), "
        "vec3(x.y * x.y, 0.0, x.y * x.y)); return vec4(f.area, f.shift, f.sigma, 0.0); }",
        in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        double area, shift;
        by_quadrature((double)in[i][0], (double)in[i][1], &area, &shift);
        assert_near(out[i][0], area, 0.065 * area);             // at u = 1: (1 + sqrt(1.64)) / 2 for 1.0833
        assert_near(out[i][1], shift, 0.09 * (double)in[i][1]); // at u = 0.3: 1.17 for 1.09
    }
}

static void reflectance_at_85_degrees_falls_with_roughness_as_published(void **state) {
    (void)state;
    // .42, .30, .22 for slope variances .01, .03, .062 (Bruneton, Neyret & Holzschuch 2010); the mirror has .58352
    float in[4][4] = {{0.01f}, {0.03f}, {0.062f}, {1e-7f}}, out[4][4];
    const double expected[4] = {.42, .30, .22, .58352};
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { vec3 v = vec3(0.99619470, 0.0, 0.08715574), c = vec3(x.x, 0.0, x.x); return "
              "vec4(rough_fresnel(v, vec2(0.0), rough_seen(v, vec2(0.0), c), 1.333)); }",
              in, 4, out);
    for (int i = 0; i < 4; ++i) assert_near(out[i][0], expected[i], i == 3 ? 2e-3 : 0.015); // two digits are given
}

// The sun's light that water mirrors upwards is F of it, however rough the water: over all directions the glint, weighed by their
// cosine, gives the irradiance back. The lattice is over slopes, which the mirrored directions follow.
static void the_glint_has_the_suns_energy_whatever_the_roughness(void **state) {
    (void)state;
    for (int rough = 0; rough < 3; ++rough) {
        const double variance = (double[]){3e-4, 3e-3, 0.02}[rough], sun_z = 0.8, sun_x = 0.6;
        const double step = sqrt(variance) * 9.0 / 16.0;
        float in[256][4] = {{0}}, out[256][4];
        double weight[256];
        for (int i = 0; i < 256; ++i) {
            double sx = (i % 16 - 7.5) * step, sy = (i / 16 - 7.5) * step, n = sqrt(1 + sx * sx + sy * sy);
            double nx = -sx / n, ny = -sy / n, nz = 1 / n, c = nx * sun_x + nz * sun_z;
            in[i][0] = (float)(2 * c * nx - sun_x), in[i][1] = (float)(2 * c * ny),
            in[i][2] = (float)(2 * c * nz - sun_z);
            // d(solid angle) = 4 c d(solid angle of the normal), and that is nz^3 d(slope)
            weight[i] = fmax((double)in[i][2], 0.0) * 4.0 * c * nz * nz * nz * step * step;
        }
        char body[256];
        snprintf(body, sizeof body,
                 "vec4 probe(vec4 x) { vec3 c = vec3(%.6f, 0.0, %.6f); return vec4(rough_glint(x.xyz, vec3(0.6, 0.0, "
                 "0.8), vec2(0.0), "
                 "c, rough_seen(x.xyz, vec2(0.0), c), 1.333)); }",
                 variance, variance);
        probe_run(INCLUDES, body, in, 256, out);
        double sum = 0;
        for (int i = 0; i < 256; ++i) sum += (double)out[i][0] * weight[i];
        // irradiance 1 on a plane across the sun is sun_z on the water; F(36.87 deg) = .0231. The facets' areas are good to 6.5 %, twice
        assert_near(sum, 0.0231 * sun_z, 0.13 * 0.0231 * sun_z);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(facets_in_sight_are_nearly_those_of_a_gaussian),
        IN_BOTH_APIS(reflectance_at_85_degrees_falls_with_roughness_as_published),
        IN_BOTH_APIS(the_glint_has_the_suns_energy_whatever_the_roughness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
