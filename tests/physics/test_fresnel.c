// SPDX-License-Identifier: MIT
// Fresnel reflectance against tables computed by hand from the textbook's formula with n = 1.333 and n = 1.34.
#include "bolan/scene.h"
#include "io_support.h"

// The tables have five decimals, so half a unit of the last; the float argument adds 1e-7 times the slope (at most 60).
#define TABLE_ERROR 1e-5

typedef struct row {
    double degrees, reflectance;
} row;

static void compare(const row *rows, size_t count, double eta) {
    for (size_t i = 0; i < count; i++) {
        const double found = (double)bolan_fresnel((float)cos(bolan_radians(rows[i].degrees)), (float)eta);
        assert_near(found, rows[i].reflectance, TABLE_ERROR);
    }
}

static void test_from_air_into_fresh_water(void **state) {
    (void)state;
    static const row rows[] = {{0, .020373}, {30, .02144}, {40, .02450}, {50, .03367}, {60, .05969},
                               {70, .13348}, {75, .21238}, {80, .34792}, {85, .58352}, {89, .89628}};
    compare(rows, sizeof rows / sizeof *rows, 1.333);
}

static void test_from_air_into_sea_water(void **state) {
    (void)state;
    static const row rows[] = {{0, .021112}, {60, .06100}};
    compare(rows, sizeof rows / sizeof *rows, 1.34);
}

static void test_from_below(void **state) {
    (void)state;
    // The last row of the table, 48.5 degrees, lies 0.1 degree from total reflection, where the curve rises 2.6 per
    // degree.
    static const row rows[] = {{30, .02552}, {40, .05558}, {45, .13946}, {47, .26136}, {48, .43308}, {48.5, .70031}};
    compare(rows, sizeof rows / sizeof *rows, 1.0 / 1.333);
}

static double first_total_angle(double n) {
    double low = 40.0, high = 60.0;
    while (high - low > 1e-4) {
        const double middle = 0.5 * (low + high);
        *(bolan_fresnel((float)cos(bolan_radians(middle)), (float)(1.0 / n)) >= 1.0f ? &high : &low) = middle;
    }
    return high;
}

static void test_snells_window_ends_where_total_reflection_begins(void **state) {
    (void)state;
    assert_near(first_total_angle(1.333), 48.6066, 0.01);
    assert_near(first_total_angle(1.34), 48.2682, 0.01);
}

// The integral of F(mu) 2 mu dmu over the hemisphere by the midpoint rule; 20000 steps are good to 1e-6.
static double hemispherical(double eta) {
    enum { STEPS = 20000 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        const double mu = (i + 0.5) / STEPS;
        sum += (double)bolan_fresnel((float)mu, (float)eta) * 2.0 * mu / STEPS;
    }
    return sum;
}

static void test_diffuse_reflectance(void **state) {
    (void)state;
    assert_near(hemispherical(1.333), .06641, TABLE_ERROR);
    assert_near(hemispherical(1.34), .06751, TABLE_ERROR);
    assert_near(hemispherical(1.0 / 1.333), .47459,
                2e-5); // the jump of slope at the edge costs the rule a little
}

static void test_edges(void **state) {
    (void)state;
    assert_near((double)bolan_fresnel(0.0f, 1.34f), 1.0, 0.0);
    assert_near((double)bolan_fresnel(0.0f, 1.0f / 1.34f), 1.0, 0.0);
    assert_near((double)bolan_fresnel(1.0f, 1.0f), 0.0, 0.0);
    assert_near((double)bolan_fresnel(1.5f, 1.34f), .021112, TABLE_ERROR); // a cosine rounded above 1
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_from_air_into_fresh_water),
        cmocka_unit_test(test_from_air_into_sea_water),
        cmocka_unit_test(test_from_below),
        cmocka_unit_test(test_snells_window_ends_where_total_reflection_begins),
        cmocka_unit_test(test_diffuse_reflectance),
        cmocka_unit_test(test_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
