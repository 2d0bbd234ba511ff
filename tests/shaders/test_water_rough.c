// SPDX-License-Identifier: MIT
// Rough water by square roots (shaders/common/rough.glsl) against the same integrals done the long way, and against
// published numbers.
#include "probe.h"

#include <math.h>

#include "bolan/scene.h"

#define INCLUDES "#include \"shared/fresnel.glsl\"\n#include \"common/rough.glsl\""

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
        assert_near(out[i][0], area, 0.055 * area); // the bounds of facing_fast()
        assert_near(out[i][1], shift, 0.08 * shift + 1e-4);
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

// The sun's light that water mirrors upwards is F of it, however rough the water: over all directions the glint,
// weighed by their cosine, gives the irradiance back. The lattice is over slopes, which the mirrored directions follow.
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
        // irradiance 1 on a plane across the sun is sun_z on the water; F(36.87 deg) = .0231. The facets' areas are
        // good to 6.5 %, twice
        assert_near(sum, 0.0231 * sun_z, 0.13 * 0.0231 * sun_z);
    }
}

// ---- leaning water whose covariance is turned by 30 degrees ---------------------------------------------------------

typedef struct tilted {
    double mx, my, xx, xy, yy; // mean slope and covariance
} tilted;

// Rms slopes 0.2 and 0.1 along axes 30 degrees from the world's.
static tilted turned_water(double mx, double my) {
    const double c = cos(BOLAN_PI / 6), s = sin(BOLAN_PI / 6), along = 0.04, across = 0.01;
    return (tilted){mx, my, c * c * along + s * s * across, c * s * (along - across), s * s * along + c * c * across};
}

static double density_of(const tilted *w, double x, double y) {
    const double det = w->xx * w->yy - w->xy * w->xy, dx = x - w->mx, dy = y - w->my;
    return exp(-0.5 * (w->yy * dx * dx - 2.0 * w->xy * dx * dy + w->xx * dy * dy) / det) / (2.0 * BOLAN_PI * sqrt(det));
}

// Over all slopes in two dimensions: the area seen, the mean and the rms slope of what is seen, along the view.
static void seen_by_quadrature(const tilted *w, const double v[3], double out[3]) {
    const double step = 0.01, flat = hypot(v[0], v[1]), hx = v[0] / flat, hy = v[1] / flat;
    double m0 = 0.0, m1 = 0.0, m2 = 0.0;
    for (double y = -1.2; y < 1.2; y += step)
        for (double x = -1.2; x < 1.2; x += step) {
            const double weight = fmax(0.0, v[2] - x * v[0] - y * v[1]) * density_of(w, x, y) * step * step;
            const double t = -((x - w->mx) * hx + (y - w->my) * hy);
            m0 += weight, m1 += weight * t, m2 += weight * t * t;
        }
    out[0] = m0, out[1] = m1 / m0, out[2] = sqrt(m2 / m0 - m1 * m1 / m0 / m0);
}

enum { VIEWS = 24 };

static void views_of(float (*in)[4], double (*v)[3]) {
    for (int i = 0; i < VIEWS; ++i) {
        const double azimuth = 2.0 * BOLAN_PI * (i % 8) / 8.0 + 0.2, elevation = (double[]){0.35, 0.7, 1.2}[i / 8];
        v[i][0] = cos(elevation) * cos(azimuth), v[i][1] = cos(elevation) * sin(azimuth), v[i][2] = sin(elevation);
        for (int k = 0; k < 3; ++k) in[i][k] = (float)v[i][k];
    }
}

// As good as on level, round water.
static void facets_of_leaning_turned_water_are_those_of_the_integral(void **state) {
    (void)state;
    const tilted w = turned_water(0.06, -0.09);
    float in[VIEWS][4] = {{0}}, rough[VIEWS][4];
    double v[VIEWS][3];
    char body[512];
    views_of(in, v);
    snprintf(
        body, sizeof body,
        "vec4 probe(vec4 x) { rough_facets f = rough_seen(x.xyz, vec2(%.6f, %.6f), vec3(%.6f, %.6f, %.6f)); return "
        "vec4(f.area, f.shift, f.sigma, 0.0); }",
        w.mx, w.my, w.xx, w.xy, w.yy);
    probe_run(INCLUDES, body, in, VIEWS, rough);
    for (int i = 0; i < VIEWS; ++i) {
        double want[3];
        seen_by_quadrature(&w, v[i], want);
        assert_near(rough[i][0], want[0], 0.06 * want[0]);
        assert_near(rough[i][1], want[1], 0.08 * want[1] + 0.002);
        assert_near(rough[i][2], want[2], 0.1 * want[2]);
    }
}

// The glint's radiance at a slope goes with the density there: mean and covariance of the slopes that mirror the sun
// come back.
static void the_glint_of_turned_water_lies_where_its_slopes_are(void **state) {
    (void)state;
    const tilted w = turned_water(0.06, -0.09);
    const double sun[3] = {0.15, 0.2, 0.9682458}, step = 0.1;
    float in[256][4] = {{0}}, out[256][4];
    double sum = 0.0, mean[2] = {0}, square[3] = {0}, weight[256];
    for (int i = 0; i < 256; ++i) {
        const double sx = w.mx + (i % 16 - 7.5) * step, sy = w.my + (i / 16 - 7.5) * step,
                     n = sqrt(1 + sx * sx + sy * sy);
        const double c = (-sx * sun[0] - sy * sun[1] + sun[2]) / n;
        const double to[3] = {-2 * c * sx / n - sun[0], -2 * c * sy / n - sun[1], 2 * c / n - sun[2]};
        for (int k = 0; k < 3; ++k) in[i][k] = (float)to[k];
        // the facet's brightness is F p / (4 nz^4 area): without F and the area seen, which the test above has, the
        // density is left
        weight[i] = to[2] > 0.05 && c > 0.05 ? 4.0 / (n * n * n * n) / (double)bolan_fresnel((float)c, 1.333f) : 0.0;
    }
    char body[512];
    snprintf(body, sizeof body,
             "vec4 probe(vec4 x) { vec2 m = vec2(%.6f, %.6f); vec3 c = vec3(%.6f, %.6f, %.6f); rough_facets f = "
             "rough_seen(x.xyz, m, c); return vec4(rough_glint(x.xyz, vec3(%.7f, %.7f, %.7f), m, c, f, 1.333) * "
             "max(f.area, 0.01)); }",
             w.mx, w.my, w.xx, w.xy, w.yy, sun[0], sun[1], sun[2]);
    probe_run(INCLUDES, body, in, 256, out);
    for (int i = 0; i < 256; ++i) {
        const double x = (i % 16 - 7.5) * step, y = (i / 16 - 7.5) * step, a = (double)out[i][0] * weight[i];
        sum += a, mean[0] += a * x, mean[1] += a * y;
        square[0] += a * x * x, square[1] += a * x * y, square[2] += a * y * y;
    }
    assert_near(mean[0] / sum, 0.0, 0.006); // slopes that would mirror the sun downwards are missing
    assert_near(mean[1] / sum, 0.0, 0.006);
    assert_near(square[0] / sum, w.xx, 0.03 * w.xx); // a lattice of 0.1 to slopes of 0.1 rms: 1 %; floats
    assert_near(square[1] / sum, w.xy, 0.03 * w.xx);
    assert_near(square[2] / sum, w.yy, 0.03 * w.xx);
}

// Over the facets that the eye sees of round water, by their areas.
static double mean_reflectance(double elevation, double sigma) {
    const double flat = cos(elevation), up = sin(elevation), step = sigma / 8.0;
    double light = 0.0, area = 0.0;
    for (int j = -40; j <= 40; ++j)
        for (int i = -40; i <= 40; ++i) {
            const double x = i * step, y = j * step, facing = up - x * flat;
            if (facing <= 0.0) continue;
            const double weight = facing * exp(-0.5 * (i * i + j * j) / 64.0);
            light += weight * (double)bolan_fresnel((float)(facing / sqrt(1.0 + x * x + y * y)), 1.34f);
            area += weight;
        }
    return light / area;
}

// The exact dielectric's mean over the facets in sight, which the fit follows to 5 % (at a rms slope of 0.03).
// Schlick's curve alone would be 13 % low at 60 degrees.
static void nearly_flat_water_reflects_as_the_exact_dielectric(void **state) {
    (void)state;
    enum { ANGLES = 3, SIGMAS = 3 };
    const double elevations[ANGLES] = {1.0, 0.5, 0.3}, sigmas[SIGMAS] = {0.001, 0.01, 0.03};
    float in[ANGLES * SIGMAS][4] = {{0}}, out[ANGLES * SIGMAS][4];
    for (int i = 0; i < ANGLES * SIGMAS; ++i)
        in[i][0] = (float)elevations[i / SIGMAS], in[i][1] = (float)sigmas[i % SIGMAS];
    probe_run("#include \"common/slopes.glsl\"\n#include \"shared/fresnel.glsl\"\n#include \"common/rough.glsl\"",
              "vec4 probe(vec4 x) { vec3 v = vec3(cos(x.x), 0.0, sin(x.x)), c = vec3(x.y * x.y, 0.0, x.y * x.y);\n"
              "    return vec4(rough_fresnel(v, vec2(0.0), rough_seen(v, vec2(0.0), c), 1.34)); }",
              in, ANGLES * SIGMAS, out);
    for (int i = 0; i < ANGLES * SIGMAS; ++i) {
        const double want = mean_reflectance(elevations[i / SIGMAS], sigmas[i % SIGMAS]);
        assert_near(out[i][0], want, 0.06 * want);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(facets_in_sight_are_nearly_those_of_a_gaussian),
        IN_BOTH_APIS(reflectance_at_85_degrees_falls_with_roughness_as_published),
        IN_BOTH_APIS(the_glint_has_the_suns_energy_whatever_the_roughness),
        IN_BOTH_APIS(facets_of_leaning_turned_water_are_those_of_the_integral),
        IN_BOTH_APIS(the_glint_of_turned_water_lies_where_its_slopes_are),
        IN_BOTH_APIS(nearly_flat_water_reflects_as_the_exact_dielectric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
