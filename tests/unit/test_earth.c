// SPDX-License-Identifier: MIT
// The round earth against closed forms: circles, almanac values of dip and horizon, the spherical law of cosines.
#include "support.h"

#include "bolan/earth.h"
#include "shared/earth.glsl"

#include <math.h>

#define R 6371000.0

// Height of the eye [m], dip [deg], distance to the horizon [km]: acos(R / (R + h)) and sqrt(2 R h + h^2).
static const double horizons[][3] = {{2.0, 0.0454, 5.05},
                                     {10.0, 0.1015, 11.29},
                                     {100.0, 0.3210, 35.70},
                                     {1000.0, 1.0151, 112.9},
                                     {10000.0, 3.2081, 357.1}};

static void the_horizon_is_that_of_the_sphere(void **state) {
    (void)state;
    for (int i = 0; i < 5; ++i) {
        const double h = horizons[i][0];
        assert_near(bolan_degrees(bolan_earth_dip_exact(h)), horizons[i][1], 5e-5); // printed digits
        assert_near(1e-3 * bolan_earth_horizon_exact(h), horizons[i][2], 5e-4 * horizons[i][2]);
        assert_near(bolan_earth_dip_exact(h), acos(R / (R + h)), 1e-9 / sqrt(h / R)); // acos loses digits near 1
        assert_near(bolan_earth_horizon_exact(h), R * tan(bolan_earth_dip_exact(h)), 1e-6);
    }
    assert_true(bolan_earth_dip_exact(0.0) == 0.0 && bolan_earth_horizon_exact(0.0) == 0.0);
}

static void the_parabola_is_as_near_the_sphere_as_stated(void **state) {
    (void)state;
    for (double r = 1000.0; r < 4e5; r *= 1.7) {
        const double exact = bolan_earth_drop_exact(r), circle = R * (1.0 - cos(asin(r / R)));
        assert_near(exact, circle, 2e-9); // the circle's difference has an ulp of 1e-9 m
        const double over = exact - bolan_earth_drop(r), stated = pow(r, 4.0) / (8.0 * pow(R, 3.0));
        assert_near(over, stated, 0.01 * stated + 1e-9); // the next term is r^2 / 2R^2 of it: 0.2 %
    }
    assert_near(bolan_earth_drop(5000.0), 1.96, 0.005); // the table's drops
    assert_near(bolan_earth_drop(50000.0), 196.0, 0.5);
    assert_near(bolan_earth_drop_exact(2.0 * R), R, 1e-6); // |r| beyond R counts as R
    for (int i = 0; i < 4; ++i) {                          // up to 1 km: the horizons differ by h / 4R
        const double h = horizons[i][0];
        assert_near(bolan_earth_horizon(h), bolan_earth_horizon_exact(h),
                    (h / (3.9 * R)) * bolan_earth_horizon(h) + 1e-9);
        assert_near(bolan_earth_dip(h), tan(bolan_earth_dip_exact(h)), 1.01 * h / R * bolan_earth_dip(h));
    }
}

static void a_ray_meets_the_parabola_where_it_crosses_it(void **state) {
    (void)state;
    for (double h = 0.5; h < 2e4; h *= 5.0)
        for (double steep = 1.001; steep < 1e4; steep *= 3.0) {
            const double slope = steep * bolan_earth_dip(h), r = bolan_earth_meets(slope, h);
            assert_near(slope * r, h + bolan_earth_drop(r), 1e-9 * h + 1e-12); // on both lines
            assert_true(r <= bolan_earth_horizon(h) && r > 0.0);               // and on the near side of the horizon
        }
    assert_true(isinf(bolan_earth_meets(0.999 * bolan_earth_dip(30.0), 30.0)));
    assert_true(isinf(bolan_earth_meets(-0.1, 30.0)));
    assert_near(bolan_earth_meets(1.0, 30.0), 30.0, 1e-3); // steep: as over a plane
}

static void great_circles_have_their_lengths(void **state) {
    (void)state;
    assert_near(bolan_earth_distance(0, 0, 90, 0), 0.5 * BOLAN_PI * R, 1e-6);
    assert_near(bolan_earth_distance(10, 20, 10, 21), bolan_radians(1.0) * R, 1e-6);
    assert_near(bolan_earth_distance(-170, 0, 170, 0), bolan_radians(20.0) * R, 1e-6); // over the date line
    assert_near(bolan_earth_distance(5, 89, 185, 89), bolan_radians(2.0) * R, 1e-6);   // over the pole
    assert_near(bolan_earth_distance(0, 0, 180, 0), BOLAN_PI * R, 1e-6);
    // by the spherical law of cosines
    const double a = bolan_radians(51.5), b = bolan_radians(40.7), d = bolan_radians(73.9);
    const double law = R * acos(sin(a) * sin(b) + cos(a) * cos(b) * cos(d));
    assert_near(bolan_earth_distance(0.0, 51.5, -73.9, 40.7), law, 1e-3);
    assert_true(bolan_earth_distance(12.3, 45.6, 12.3, 45.6) == 0.0);
}

// An eye at height h sees a mast top, of height m on the sphere, at the level distance (R + m) sin a and the elevation
// (R + m) cos a - (R + h): the height over mean water that comes out is the mast's.
static void heights_over_the_water_are_those_of_masts(void **state) {
    (void)state;
    for (double h = 2.0; h < 3000.0; h *= 7.0)
        for (double angle = 0.0; angle < 0.005; angle += 0.0007)
            for (double mast = -5.0; mast <= 45.0; mast += 25.0) {
                const double r = (R + mast) * sin(angle), half = sin(0.5 * angle);
                const double z = mast - h - 2.0 * (R + mast) * half * half;
                // the parabola's error, and a mast that leans away by its angle
                const double allowed = pow(r, 4.0) / (7.9 * pow(R, 3.0)) + 50.0 * angle * angle + 1e-8;
                assert_near(earth_height(z, h, r * r, R), mast, allowed);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_horizon_is_that_of_the_sphere),
        cmocka_unit_test(the_parabola_is_as_near_the_sphere_as_stated),
        cmocka_unit_test(a_ray_meets_the_parabola_where_it_crosses_it),
        cmocka_unit_test(heights_over_the_water_are_those_of_masts),
        cmocka_unit_test(great_circles_have_their_lengths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
