// SPDX-License-Identifier: MIT
// Visible facets, glints and the normal distribution as C and shaders share them (shaders/shared/): against the
// library's erfc and against integrals over slopes.
#include "support.h"

#include "shared/constants.glsl"
#include "shared/fresnel.glsl"
#include "shared/microfacets.glsl"

static double exact_cdf(double x) { return 0.5 * erfc(-x / sqrt(2.0)); }

static void normal_distributions_are_as_exact_as_stated(void **state) {
    (void)state;
    double worst_linear = 0.0;
    for (double x = -8.0; x <= 8.0; x += 0.01) {
        const double density = exp(-0.5 * x * x) / sqrt(2.0 * PI), pdf = normal_pdf(x);
        assert_near(pdf, density, 1e-8);
        assert_near(normal_below(x, density), exact_cdf(x),
                    fmin(1.2e-5, x < 0.0 ? (x < -1.5 ? 6.2e-3 : 6e-5) * density : 1.0));
        assert_near(normal_cdf(x), exact_cdf(x), 2e-4);
        worst_linear = fmax(worst_linear, fabs(normal_cdf_linear(3.0 * x, 9.0) - exact_cdf(x)));
    }
    assert_near(worst_linear, 0.11, 0.006);
    assert_near(normal_cdf_linear(1e-3, 1.0), 0.5 + 1e-3 / sqrt(2.0 * PI), 1e-9); // the tangent at 0
}

// area, tilt and kept by Simpson's rule over the tilts in sight.
static void by_quadrature(double u, double out[3]) {
    enum { STEPS = 20000 };
    double m[3] = {0};
    const double from = -u, step = (10.0 - fmin(from, 9.0)) / STEPS;
    for (int i = 0; i <= STEPS; ++i) {
        const double t = from + i * step, w = (i == 0 || i == STEPS ? 1.0 : i % 2 ? 4.0 : 2.0) * step / 3.0;
        const double weight = w * (u + t) * exp(-0.5 * t * t) / sqrt(2.0 * PI);
        m[0] += weight, m[1] += weight * t, m[2] += weight * t * t;
    }
    out[0] = m[0], out[1] = m[1] / m[0], out[2] = sqrt(m[2] / m[0] - out[1] * out[1]);
}

static void visible_facets_are_those_of_the_integral(void **state) {
    (void)state;
    for (double u = -2.4; u < 8.0; u += 0.1) {
        double want[3];
        by_quadrature(u, want);
        const facing_facets exact = facing_exact(u), fast = facing_fast(u);
        assert_near(exact.area, want[0], (u < -0.95 ? 1e-4 : 1e-4 * want[0]));
        if (u > -1.55) { // the bounds that the function states
            assert_near(exact.area, want[0], (u < -0.95 ? 4e-4 : 1e-4) * want[0]);
            assert_near(exact.tilt, want[1], (u < -0.95 ? 5e-4 : 1.5e-4) * want[1]);
            assert_near(exact.kept, want[2], (u < -0.95 ? 7e-3 : 1.3e-3) * want[2]);
        }
        if (u >= 0.0) {
            assert_true(fast.area > want[0] * (1.0 - 1e-6) - 1e-9 && fast.area < 1.053 * want[0]);
            assert_near(fast.tilt, want[1], 0.08 * want[1]);
            assert_near(fast.kept, want[2], 0.095 * want[2]);
        } else if (u >= -1.0) {
            assert_true(fast.area > want[0] && fast.area < want[0] + 0.07);
            assert_near(fast.tilt, want[1], 0.08 * want[1]);
            assert_near(fast.kept, want[2], 0.15 * want[2]);
        }
    }
    assert_near(facing_fast(0.0).area, 1.0 / sqrt(2.0 * PI), 1e-8); // exact at 0 and far
    assert_near(facing_fast(0.0).tilt, sqrt(0.5 * PI), 1e-8);
    assert_near(facing_fast(100.0).area, 100.0, 2e-3);
    assert_near(facing_fast(100.0).kept, 1.0, 1e-3);
    assert_near(facing_exact(100.0).area, 100.0, 1e-3);
    assert_near(facing_exact(1e6).area, 1e6, 1e-3); // a calm from straight above
    assert_true(facing_fast(-50.0).tilt >= 50.0);   // a facet that leans at least as far as hides it
}

// Of a Brownian motion from 0 to -tilt in unit time, the share that stays under u and over -w: its sines between the
// barriers, over the density without them (Borodin & Salminen 2002).
static double between_by_sines(double u, double w, double tilt) {
    const double l = u + w;
    double sum = 0.0;
    for (int k = 1; k < 60; ++k)
        sum += sin(k * PI * w / l) * sin(k * PI * (w - tilt) / l) * exp(-0.5 * k * k * PI * PI / (l * l));
    return 2.0 / l * sum * sqrt(2.0 * PI) * exp(0.5 * tilt * tilt);
}

static void waves_of_all_lengths_hide_as_barriers_of_a_brownian_motion_do(void **state) {
    (void)state;
    for (double u = 0.2; u < 3.0; u += 0.2)
        for (double tilt = -u + 0.1; tilt < 2.0; tilt += 0.3) {
            const double far = between_by_sines(u, 12.0, tilt), hidden = motion_hidden(u, tilt, 0.0);
            assert_near(1.0 - hidden, far, 1e-6);
            for (double w = fmax(fmax(0.8 - u, tilt + 0.05), 0.1); w < 3.0; w += 0.4) {
                const double opposite = motion_hidden(w, -tilt, 0.0), want = between_by_sines(u, w, tilt);
                assert_near(motion_between_exact(u, w, tilt, 0.0, hidden, opposite), want, 0.01);
                if (u + w >= 1.4) assert_near(motion_between_fast(u, w, tilt, 0.0, hidden, opposite), want, 0.02);
            }
        }
    assert_near(motion_hidden(0.5, 0.3, 0.1), motion_hidden(0.6, 0.3, 0.0), 1e-12); // a step moves the barrier
}

// What a ray sees of the facets is what it would see of the plane, and with one scale what Smith's function leaves.
static void hidden_facets_leave_the_area_of_the_plane(void **state) {
    (void)state;
    for (double u = 0.1; u < 4.0; u += 0.3) {
        double area = 0.0, stepped = 0.0;
        for (double t = -u + 5e-4; t < 8.0; t += 1e-3) {
            const double weight = 1e-3 * (u + t) * normal_pdf(t);
            area += weight * (1.0 - motion_hidden(u, t, 0.0));
            stepped += weight * (1.0 - motion_hidden(u, t, 0.2));
        }
        assert_near(area, u, 1e-4);
        assert_near(motion_area_exact(u, facing_exact(u).area, 0.0), u, 2.1e-3); // facing_exact(-2.5)
        assert_near(motion_area_exact(u, facing_exact(u).area, 0.2), stepped, 2.1e-3);
        assert_near(motion_lit_fast(u, 0.2), u / stepped, 0.1 * u / stepped);
        assert_near(motion_area_exact(u, facing_exact(u).area, 1e3), facing_exact(u).area, 2.1e-3);
    }
}

// Over the facets that the eye sees, by their areas.
static double mean_reflectance(double elevation, double sigma) {
    const double flat = cos(elevation), up = sin(elevation), step = sigma / 8.0;
    double light = 0.0, area = 0.0;
    for (int j = -40; j <= 40; ++j)
        for (int i = -40; i <= 40; ++i) {
            const double x = i * step, y = j * step, facing = up - x * flat;
            if (facing <= 0.0) continue;
            const double weight = facing * exp(-0.5 * (i * i + j * j) / 64.0);
            light += weight * fresnel(facing / sqrt(1.0 + x * x + y * y), 1.34);
            area += weight;
        }
    return light / area;
}

static void the_mean_reflectance_of_visible_facets_is_as_good_as_stated(void **state) {
    (void)state;
    const double degrees[] = {1, 3, 5, 10, 20, 45}, sigmas[] = {0.1, 0.17, 0.25};
    for (int k = 0; k < 18; ++k) {
        const double e = degrees[k / 3] * PI / 180.0, sigma = sigmas[k % 3], want = mean_reflectance(e, sigma);
        const facing_facets f = facing_fast(tan(e) / sigma);
        const double tilt = sigma * f.tilt, cosine = (sin(e) + tilt * cos(e)) / sqrt(1.0 + tilt * tilt);
        assert_near(fresnel_mean_fast(cosine, sigma * f.kept, 1.34), want, (degrees[k / 3] < 40 ? 0.125 : 0.31) * want);
    }
}

static void a_low_sun_lights_its_share_of_the_facets(void **state) {
    (void)state;
    for (double degrees = 1.0; degrees < 90.0; degrees += 4.0)
        for (double sigma = 0.05; sigma < 0.3; sigma += 0.1) {
            const double up = sin(degrees * PI / 180.0), flat = cos(degrees * PI / 180.0), u = up / (flat * sigma);
            double facets[3];
            by_quadrature(u, facets);
            const double want = up / (flat * sigma * facets[0]); // what falls on the plan over what the facets show
            assert_near(lit_fast(up, flat * sigma), want, 0.055 * want + 1e-3);
        }
    assert_near(lit_fast(1.0, 1e-9), 1.0, 1e-6);
    assert_true(lit_fast(-0.1, 0.1) == 0.0);
}

static void smiths_ratio_is_the_integral_it_stands_for(void **state) {
    (void)state;
    for (double u = 0.05; u < 2.2; u += 0.05) {
        const double want = exp(-0.5 * u * u) / sqrt(2.0 * PI) / u - exact_cdf(-u);
        assert_near(smith_ratio(u) / (1.0 + smith_ratio(u)), want / (1.0 + want), 0.005); // hidden share
    }
    assert_true(smith_ratio(-0.5) > 1000.0 && smith_ratio(5.0) == 0.0);
}

static void the_density_of_slopes_has_its_moments(void **state) {
    (void)state;
    const double xx = 0.03, xy = -0.012, yy = 0.02, step = 0.004;
    double sum = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
    for (double y = -1.2; y < 1.2; y += step)
        for (double x = -1.2; x < 1.2; x += step) {
            const double p = slope_density(x, y, xx, xy, yy) * step * step;
            sum += p, sxx += p * x * x, sxy += p * x * y, syy += p * y * y;
        }
    assert_near(sum, 1.0, 1e-6);
    assert_near(sxx, xx, 1e-6);
    assert_near(sxy, xy, 1e-6);
    assert_near(syy, yy, 1e-6);
}

// Over all directions the mirrored sun, weighed by their cosine, is the reflectance of what falls on the water. A high
// sun, so that nothing is hidden and no ray goes down; the lattice is over slopes, which the mirrored directions
// follow.
static void the_glint_returns_the_suns_energy(void **state) {
    (void)state;
    const double sun_x = 0.2, sun_z = sqrt(1.0 - 0.04);
    for (double variance = 3e-4; variance < 0.01; variance *= 5.0) {
        const double sigma = sqrt(variance), step = sigma / 12.0;
        double sum = 0.0, reflected = 0.0;
        for (int j = -72; j <= 72; ++j)
            for (int i = -72; i <= 72; ++i) {
                const double sx = i * step, sy = j * step, n = sqrt(1.0 + sx * sx + sy * sy), up = 1.0 / n;
                const double c = (-sx * sun_x + sun_z) * up,
                             z = 2.0 * c * up - sun_z; // of the facet, of the mirrored ray
                const double x = -2.0 * c * sx * up - sun_x, flat = fmax(hypot(x, 2.0 * c * sy * up), 1e-4);
                if (z <= 0.0 || c <= 0.0) continue;
                const double area = flat * sigma * facing_exact(z / (flat * sigma)).area;
                const double p = slope_density(sx, sy, variance, 0.0, variance), f = fresnel(c, 1.34);
                // d(solid angle) = 4 c d(solid angle of the normal), and that is up^3 d(slope)
                const double solid = 4.0 * c * up * up * up * step * step;
                sum += glint_radiance(p, f, up, area, 1.0) * z * solid;
                reflected += p * f * c / up * step * step; // what the facet of that slope mirrors
            }
        assert_near(sum, reflected, 2e-3 * reflected);
        assert_near(sum, fresnel(sun_z, 1.34) * sun_z, 0.03 * sum); // slopes turn Fresnel's angle a little
    }
    assert_true(glint_radiance(1e9, 1.0, 1.0, 1.0, 1.0) == MOST_GLINT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normal_distributions_are_as_exact_as_stated),
        cmocka_unit_test(visible_facets_are_those_of_the_integral),
        cmocka_unit_test(waves_of_all_lengths_hide_as_barriers_of_a_brownian_motion_do),
        cmocka_unit_test(hidden_facets_leave_the_area_of_the_plane),
        cmocka_unit_test(the_mean_reflectance_of_visible_facets_is_as_good_as_stated),
        cmocka_unit_test(a_low_sun_lights_its_share_of_the_facets),
        cmocka_unit_test(smiths_ratio_is_the_integral_it_stands_for),
        cmocka_unit_test(the_density_of_slopes_has_its_moments),
        cmocka_unit_test(the_glint_returns_the_suns_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
