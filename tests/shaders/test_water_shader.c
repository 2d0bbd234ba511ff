// SPDX-License-Identifier: MIT
// The water's optics as the shader computes them, against published numbers and quadrature.
#include "probe.h"

#include <math.h>

static void fresnel_matches_the_table_from_both_sides(void **state) {
    (void)state;
    // n = 1.333; exact dielectric, unpolarised: degrees, reflectance. Rows after the ninth: from below.
    const double table[][2] = {{0, .020373}, {30, .02144}, {40, .02450}, {50, .03367},   {60, .05969}, {70, .13348},
                               {75, .21238}, {80, .34792}, {85, .58352}, {89, .89628},   {30, .02552}, {40, .05558},
                               {45, .13946}, {47, .26136}, {48, .43308}, {48.5, .70031}, {48.62, 1.0}, {60, 1.0}};
    enum { COUNT = sizeof table / sizeof table[0], FROM_AIR = 10 };
    float in[COUNT][4], out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = (float)cos(table[i][0] * BOLAN_PI / 180.0);
        in[i][1] = i < FROM_AIR ? 1.333f : 1.0f / 1.333f;
    }
    probe_run("#include \"shared/fresnel.glsl\"", "vec4 probe(vec4 x) { return vec4(fresnel(x.x, x.y)); }", in, COUNT,
              out);
    for (int i = 0; i < COUNT; ++i)
        // the table's last digit is 1e-5; next to the edge of total reflection float's cosine costs 2e-4
        assert_true(fabs(out[i][0] - table[i][1]) < (i >= 14 && table[i][1] < 1.0 ? 3e-4 : 1.1e-5));
}

// Quadrature over the tilt: the same integrals, done the long way.
static void facets_by_quadrature(double elevation, double sigma, double *area, double *shift, double *deviation) {
    double h = cos(elevation), z = sin(elevation), m0 = 0, m1 = 0, m2 = 0;
    for (int i = -4000; i < 4000; ++i) {
        double t = (i + 0.5) * 8.0 * sigma / 4000.0, w = fmax(0.0, z + t * h) * exp(-0.5 * t * t / (sigma * sigma));
        m0 += w, m1 += w * t, m2 += w * t * t;
    }
    double p = 8.0 * sigma / 4000.0 / (sigma * sqrt(2 * BOLAN_PI));
    *area = m0 * p, *shift = m1 / m0, *deviation = sqrt(m2 / m0 - (m1 / m0) * (m1 / m0));
}

static void visible_facets_match_quadrature(void **state) {
    (void)state;
    enum { COUNT = 40 };
    float in[COUNT][4], out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = (float)((1 + (i % 10) * 9) * BOLAN_PI / 180.0);
        in[i][1] = 0.03f + 0.07f * (float)(i / 10);
    }
    probe_run("#include \"common/slopes.glsl\"",
              "vec4 probe(vec4 x) { visible_facets f = facets_seen(vec3(0.6 * cos(x.x), 0.8 * cos(x.x), sin(x.x)), "
              "vec2(0.0), "
              "vec3(x.y * x.y, 0.0, x.y * x.y)); return vec4(f.area, f.shift, f.sigma, 0.0); }",
              in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        double area, shift, deviation;
        facets_by_quadrature(in[i][0], in[i][1], &area, &shift, &deviation);
        // the distribution function is good to 2e-4; relative to the area at grazing that is 1 %
        assert_true(fabs(out[i][0] - area) < 0.01 * area + 1e-4);
        assert_true(fabs(out[i][1] - shift) < 0.01 * in[i][1] + 1e-4);
        assert_true(fabs(out[i][2] - deviation) < 0.02 * in[i][1] + 1e-4);
    }
}

static void slope_density_integrates_to_one(void **state) {
    (void)state;
    // a 16 x 16 lattice over +-6 standard deviations of an anisotropic, correlated law
    float in[256][4], out[256][4];
    const double step = 6.0 * 2.0 * 0.25 / 16.0;
    for (int i = 0; i < 256; ++i) {
        in[i][0] = (float)((i % 16 - 7.5) * step);
        in[i][1] = (float)((i / 16 - 7.5) * step);
    }
    probe_run("#include \"common/slopes.glsl\"",
              "vec4 probe(vec4 x) { return vec4(slope_density(x.x - 0.02, x.y + 0.05, 0.06, 0.015, 0.04)); }",
              in, 256, out);
    double sum = 0;
    for (int i = 0; i < 256; ++i) sum += out[i][0] * step * step;
    assert_true(fabs(sum - 1.0) <
                0.005); // the lattice rule converges past all orders; the tails beyond 6 sigma are nothing
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(fresnel_matches_the_table_from_both_sides),
        IN_BOTH_APIS(visible_facets_match_quadrature),
        IN_BOTH_APIS(slope_density_integrates_to_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
