// SPDX-License-Identifier: MIT
// The facets and the fine waves of the reference path tracer (tests/reference/facets.h, fine.h) against figures that it
// does not use: sums over facets made elsewhere, closed forms of the mean tilt, of the visible share and of a single
// wave, and the energy of the sun's image.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "reference/facets.h"
#include "reference/fine.h"

#include <stdio.h>

enum { FACETS = 100000 };

// Covariance of slopes, and an eye `down` degrees over the horizon: the mean of what those facets reflect.
static double mean_reflectance(covariance c, vec to_eye, double *tilt) {
    uint64_t random = 1;
    double sum = 0.0, level = hypot(to_eye.x, to_eye.y);
    *tilt = 0.0;
    for (int i = 0; i < FACETS; ++i) {
        const vec n = visible_facet(&random, to_eye, 0.0, 0.0, c);
        sum += fresnel(fmin(dot3(n, to_eye), 1.0), WATER_INDEX) / FACETS;
        *tilt += (n.x * to_eye.x + n.y * to_eye.y) / (n.z * level * FACETS);
    }
    return sum;
}

// tests/data/light/mean_fresnel.csv has sums over facets, made by another program. 1 %: three standard errors of 100000
// facets are 0.7 %.
static void mean_reflectance_is_that_of_another_programs_facets(void **state) {
    (void)state;
    FILE *file = fopen(BOLAN_SOURCE_DIR "/tests/data/light/mean_fresnel.csv", "r");
    assert_non_null(file);
    char line[256];
    int rows = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        double along_wind, across, azimuth, down, want, tilt;
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf", &along_wind, &across, &azimuth, &down, &want) != 5) continue;
        const double a = azimuth * 0.017453292519943295, e = down * 0.017453292519943295;
        const vec to_eye = {cos(e) * cos(a), cos(e) * sin(a), sin(e)};
        const double got = mean_reflectance((covariance){along_wind, 0.0, across}, to_eye, &tilt);
        if (!(fabs(got / want - 1.0) < 0.01)) fail_msg("%g %g: %g, not %g", azimuth, down, got, want);
        ++rows;
    }
    fclose(file);
    assert_true(rows > 10);
}

static void facets_lean_towards_the_eye_as_the_closed_form_says(void **state) {
    (void)state;
    for (int down = 2; down <= 60; down *= 2) {
        double tilt;
        const double e = down * 0.017453292519943295, sigma = 0.15;
        mean_reflectance((covariance){sigma * sigma, 0.0, sigma * sigma}, (vec){cos(e), 0.0, sin(e)}, &tilt);
        assert_true(fabs(tilt - sigma * facing_exact(tan(e) / sigma).tilt) < 0.002); // three standard errors
    }
}

// Without waves there is one facet, which is level.
static void flat_water_is_a_mirror(void **state) {
    (void)state;
    uint64_t random = 1;
    const vec to_eye = unit((vec){0.6, 0.3, 0.4}), n = visible_facet(&random, to_eye, 0.0, 0.0, (covariance){0, 0, 0});
    assert_true(n.z > 1.0 - 1e-9);
    const vec d = mirrored(to_eye, n);
    assert_true(fabs(d.x + to_eye.x) + fabs(d.y + to_eye.y) + fabs(d.z - to_eye.z) < 1e-4);
}

// The sun overhead and an eye that looks straight down: all facets turned by half an angle send the light there. The
// image over all directions of the eye, weighted by what the plan shows, has the energy that the facets reflect:
// R(0) of it for smooth enough water, where R hardly depends on the angle. 1 %: R rises by that over these slopes.
static void the_image_of_the_sun_has_its_energy(void **state) {
    (void)state;
    const covariance c = {0.004, 0.0, 0.004};
    double sum = 0.0;
    const double step = 0.005;
    for (double theta = 0.5 * step; theta < 1.0; theta += step)
        sum += sun_by_facets((vec){sin(theta), 0.0, cos(theta)}, (vec){0.0, 0.0, 1.0}, 0.0, 0.0, c) * 6.283185307 *
               sin(theta) * cos(theta) * step;
    assert_true(fabs(sum / fresnel_normal(WATER_INDEX) - 1.0) < 0.01);
}

// All directions of an eye in the water together, weighted by what the plan shows: what Fresnel lets through of the sun
// on a level, for smooth water. 1 %: what the slopes change.
static void the_suns_image_from_below_has_what_the_surface_lets_through(void **state) {
    (void)state;
    const covariance c = {0.002, 0.0, 0.002};
    for (int height = 40; height <= 90; height += 25) {
        const double e = height * 0.017453292519943295, turn = 6.283185307179586 / 1000, step = 0.002;
        const vec to_sun = {cos(e), 0.0, sin(e)};
        double sum = 0.0;
        for (double theta = 0.5 * step; theta < 1.0; theta += step)
            for (double a = 0.5 * turn; a < 6.283; a += turn) {
                const vec view = {sin(theta) * cos(a), sin(theta) * sin(a), cos(theta)};
                sum += sun_through_facets(view, to_sun, 0.0, 0.0, c) * view.z * sin(theta) * step * turn;
            }
        assert_true(fabs(sum / (sin(e) * (1.0 - fresnel(sin(e), WATER_INDEX))) - 1.0) < 0.01);
    }
}

static void a_ray_is_refracted_by_snells_law(void **state) {
    (void)state;
    const vec n = normal_of(0.1, -0.2), to_eye = unit((vec){0.5, 0.3, 0.6}), down = {-n.x, -n.y, -n.z};
    const vec in = refracted(to_eye, n, WATER_INDEX),
              again = refracted((vec){in.x, in.y, in.z}, down, 1.0 / WATER_INDEX);
    const double before = sqrt(1.0 - pow(dot3(to_eye, n), 2.0)), after = sqrt(1.0 - pow(dot3(in, n), 2.0));
    assert_true(fabs(before / after - WATER_INDEX) < 1e-9);
    assert_true(fabs(again.x - to_eye.x) + fabs(again.y - to_eye.y) + fabs(again.z - to_eye.z) < 1e-9);
}

// Smith: the facets in sight show the area of the plane. So 1 + hidden over visible is the area that all facets turned
// to the eye show, over the plane's. 1 %: the rational form of the ratio.
static void facets_hide_by_the_area_that_they_show(void **state) {
    (void)state;
    const double sigma = 0.15, lean = 0.1;
    for (int down = 2; down <= 40; down += 2) {
        const double e = down * 0.017453292519943295;
        const vec to_eye = {cos(e), 0.0, sin(e)};
        const covariance c = {sigma * sigma, 0.0, sigma * sigma};
        const double u = (tan(e) + lean) / sigma, hidden = facets_hidden(to_eye, -lean, 0.0, c);
        assert_true(fabs((1.0 + hidden) / (facing_exact(u).area / u) - 1.0) < 0.01);
        assert_true(fabs(facets_lit(to_eye, to_eye, -lean, 0.0, c) - (1.0 + hidden) / (1.0 + 2.0 * hidden)) < 1e-9);
    }
    assert_true(facets_lit((vec){0.0, 0.0, 1.0}, (vec){1.0, 0.0, 0.0}, 0.1, 0.0, (covariance){0.01, 0.0, 0.01}) < 1e-5);
}

// Rms of a wave read linearly between samples, over that of the wave: the mean over all places between two samples.
static double kept_by_linear_reading(int wave, int n) {
    const double phase = 6.283185307179586 * wave / n;
    double power = 0.0;
    for (int i = 0; i < 100; ++i) {
        const double a = (i + 0.5) / 100;
        power += ((1 - a) * (1 - a) + a * a + 2 * a * (1 - a) * cos(phase)) / 100;
    }
    return sqrt(power);
}

// One wave of amplitude 1 mm on a turned tile, whose slopes are raised as those of bolan_sea_fine() are: height and
// slope between the samples. 2 %: read linearly at 4 x 32 samples, of which a wave along the diagonal has some 20.
static void fine_waves_have_the_height_of_their_slopes(void **state) {
    (void)state;
    enum { N = 32, P = 4, Q = -5 };
    const double length = 0.9, angle = 0.7, amplitude = 1e-3, unit_k = 6.283185307179586 / length;
    const double kx = unit_k * (P * cos(angle) - Q * sin(angle)), ky = unit_k * (P * sin(angle) + Q * cos(angle));
    static float sx[N * N], sy[N * N];
    for (int j = 0; j < N; ++j)
        for (int i = 0; i < N; ++i) {
            const double s = -amplitude * sin(6.283185307179586 * (P * i + Q * j) / N) / kept_by_linear_reading(P, N) /
                             kept_by_linear_reading(Q, N);
            sx[j * N + i] = (float)(kx * s), sy[j * N + i] = (float)(ky * s);
        }
    const bolan_sea_fine_view view = {.n = N, .length = length, .angle = angle, .slope_x = sx, .slope_y = sy};
    fine_waves f = fine_open(&view);
    uint64_t random = 1;
    for (int i = 0; i < 1000; ++i) {
        const bolan_dvec2 at = {10.0 * uniform(&random), 10.0 * uniform(&random)};
        const fine_point p = fine_at(&f, at);
        const double phase = kx * at.x + ky * at.y;
        assert_true(fabs((double)p.height - amplitude * cos(phase)) < 0.02 * amplitude);
        assert_true(fabs((double)p.sx + kx * amplitude * sin(phase)) < 0.02 * amplitude * fabs(kx));
        assert_true(fabs((double)p.sy + ky * amplitude * sin(phase)) < 0.02 * amplitude * fabs(ky));
    }
    free(f.samples);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(mean_reflectance_is_that_of_another_programs_facets),
                                       cmocka_unit_test(facets_lean_towards_the_eye_as_the_closed_form_says),
                                       cmocka_unit_test(flat_water_is_a_mirror),
                                       cmocka_unit_test(the_image_of_the_sun_has_its_energy),
                                       cmocka_unit_test(the_suns_image_from_below_has_what_the_surface_lets_through),
                                       cmocka_unit_test(a_ray_is_refracted_by_snells_law),
                                       cmocka_unit_test(facets_hide_by_the_area_that_they_show),
                                       cmocka_unit_test(fine_waves_have_the_height_of_their_slopes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
