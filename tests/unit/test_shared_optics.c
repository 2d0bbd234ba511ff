// SPDX-License-Identifier: MIT
// Light at the water as C and shaders share it (shaders/shared/): limits, published values, closed forms, and how far
// the fast forms are off.
#include "support.h"

#include "shared/bed.glsl"
#include "shared/constants.glsl"
#include "shared/fresnel.glsl"
#include "shared/refraction.glsl"

static double radians_of(double degrees) { return degrees * PI / 180.0; }

// Degrees, reflectance: exact dielectric of index 1.333, from Born & Wolf's equations in other hands; the air's side
// and the water's.
static const double from_air[][2] = {{0, .020373}, {30, .02144}, {40, .02450}, {50, .03367}, {60, .05969},
                                     {70, .13348}, {75, .21238}, {80, .34792}, {85, .58352}, {89, .89628}};
static const double from_water[][2] = {{30, .02552}, {40, .05558}, {45, .13946},
                                       {47, .26136}, {48, .43308}, {48.5, .70031}};

static void reflectance_is_that_of_the_published_table(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof from_air / sizeof *from_air; ++i)
        assert_near(fresnel(cos(radians_of(from_air[i][0])), 1.333), from_air[i][1], 6e-6); // five digits are printed
    for (size_t i = 0; i < sizeof from_water / sizeof *from_water; ++i)
        assert_near(fresnel(cos(radians_of(from_water[i][0])), 1.0 / 1.333), from_water[i][1], 6e-6);
    assert_true(fresnel(cos(radians_of(48.61)), 1.0 / 1.333) == 1.0); // total from 48.6066 degrees on
    assert_true(fresnel(cos(radians_of(48.60)), 1.0 / 1.333) < 1.0);
    assert_near(fresnel(0.0, 1.333), 1.0, 1e-15);
    assert_near(fresnel(1.0, 1.0), 0.0, 1e-15); // no surface
    assert_near(fresnel_normal(1.34), fresnel(1.0, 1.34), 1e-15);
}

// Of light from all sides: 0.06641 at index 1.333, 0.06751 at 1.34; 0.47459 from below, as reciprocity asks.
static void diffuse_light_is_reflected_as_published(void **state) {
    (void)state;
    const double indices[] = {1.333, 1.34, 1.0 / 1.333}, want[] = {.06641, .06751, .47459};
    for (int k = 0; k < 3; ++k) {
        double sum = 0.0;
        enum { STEPS = 200000 };
        for (int i = 0; i < STEPS; ++i) {
            const double c = (i + 0.5) / STEPS;
            sum += 2.0 * c * fresnel(c, indices[k]) / STEPS;
        }
        assert_near(sum, want[k], 1e-5);
    }
}

static void schlicks_curve_is_as_far_off_as_stated(void **state) {
    (void)state;
    double over = 0.0, under = 0.0, over_at = 0.0, under_at = 0.0;
    for (double degrees = 0.0; degrees < 90.0; degrees += 0.05) {
        const double c = cos(radians_of(degrees)), exact = fresnel(c, 1.333), fast = fresnel_fast(c, 1.333);
        if (fast - exact > over) over = fast - exact, over_at = degrees;
        if (1.0 - fast / exact > under) under = 1.0 - fast / exact, under_at = degrees;
    }
    assert_near(over, 0.0592, 2e-4); // published: +.0592 at 83.8 degrees, -22.7 % at 51
    assert_near(over_at, 83.8, 0.2);
    assert_near(under, 0.227, 1e-3);
    assert_near(under_at, 51.0, 0.5);
    assert_near(fresnel_fast(0.0, 1.333), 1.0, 1e-15);
    assert_near(fresnel_fast(1.0, 1.333), .020373, 6e-6);
    assert_near(fresnel_mean_fast(0.3, 0.0, 1.34), fresnel_fast(0.3, 1.34), 1e-15); // of a mirror
    assert_true(fresnel_mean_fast(0.3, 0.2, 1.34) > fresnel_fast(0.3, 1.34));
}

// Fermat's path obeys Snell's law, its ends are where they should be, and four steps of Newton are within 0.4 %.
static void paths_through_the_surface_obey_snell(void **state) {
    (void)state;
    for (int i = 0; i < 240; ++i) {
        const double air = 0.1 + 12.0 * (i % 8), water = 0.05 + 4.0 * (i / 8 % 5), aside = 0.2 * pow(4.0, i / 40),
                     n = 1.34;
        double x = 0.0, low = 0.0, high = aside; // by bisection of Snell's law
        for (int k = 0; k < 200; ++k) {
            x = 0.5 * (low + high);
            if (x / hypot(x, air) < n * (aside - x) / hypot(aside - x, water))
                low = x;
            else
                high = x;
        }
        const double theta = atan2(x, air), k = cos(theta) / sqrt(n * n - sin(theta) * sin(theta)); // eq. 7
        const double seen = -apparent_height(air, -water, aside, n);
        assert_near(seen, water * k, 0.004 * water * k + 1e-4);
        assert_near(refraction_k(x / air, n), k, 1e-12);
        // the same path from the other end: a point over the water seems as much farther as one under it seems nearer
        const double up = aside / ((aside - x) / water) - water;
        assert_near(apparent_height(-water, air, aside, n), up, 0.004 * up + 1e-3);
    }
    assert_near(refraction_k(0.0, 1.333), 0.75019, 5e-6); // straight down: 1 / n
    assert_near(apparent_height(2.0, -1.0, 1e-9, 1.34), -1.0 / 1.34, 1e-6);
    assert_near(apparent_height(-2.0, -1.0, 1e-9, 1.34), -1.0, 2e-3); // on the eye's own side nothing is raised
}

static void light_bends_at_a_level_surface_by_snells_law(void **state) {
    (void)state;
    for (double degrees = 0.0; degrees <= 90.0; degrees += 7.5) {
        const double up = cos(radians_of(degrees)), down = refracted_cosine(up, 1.34);
        assert_near(1.34 * sin(acos(down)), sin(radians_of(degrees)), 1e-9);
    }
    assert_near(bed_path(3.0, 1.0), 6.0, 1e-15);                                 // straight down and up
    assert_near(bed_path(3.0, 0.5), 9.0, 1e-15);                                 // twice as long on the way up
    assert_near(BED_LEAVES, (1.0 - fresnel_normal(1.34)) / (1.34 * 1.34), 0.01); // as bed.glsl says
    assert_near(SKY_ENTERS, 1.0 - 0.068, 0.005);
    for (double degrees = 25.0; degrees <= 90.0; degrees += 5.0)
        assert_near(SUN_ENTERS, 1.0 - fresnel(sin(radians_of(degrees)), 1.34), 0.031 + (degrees < 35.0 ? 0.08 : 0.0));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reflectance_is_that_of_the_published_table),
        cmocka_unit_test(diffuse_light_is_reflected_as_published),
        cmocka_unit_test(schlicks_curve_is_as_far_off_as_stated),
        cmocka_unit_test(paths_through_the_surface_obey_snell),
        cmocka_unit_test(light_bends_at_a_level_surface_by_snells_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
