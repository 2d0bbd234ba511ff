// SPDX-License-Identifier: MIT
// Mirrors and raised bottoms against the numbers of Ma, Zhu & Gong 2006 and of Fermat's principle solved by other
// means.
#include "bolan/scene.h"
#include "support.h"

#include <math.h>

#define PAPER_INDEX 1.333

static void the_reflected_ray_keeps_its_length_and_turns_its_normal_part(void **state) {
    (void)state;
    const bolan_vec3 flat = bolan_reflect(bolan_v3(0.6f, 0.0f, -0.8f), bolan_v3(0.0f, 0.0f, 1.0f));
    assert_near(flat.x, 0.6, 1e-7); // the printed sign gives (.6, 0, -2.4)
    assert_near(flat.z, 0.8, 1e-7);
    for (int i = 0; i < 50; i++) {
        const double a = 0.7 * i, b = 0.05 + 0.02 * i;
        const bolan_vec3 n = {(float)(cos(a) * sin(b)), (float)(sin(a) * sin(b)), (float)cos(b)};
        const bolan_vec3 in = {0.36f, 0.48f, -0.8f}, out = bolan_reflect(in, n);
        assert_near(sqrtf(bolan_v3_dot(out, out)), 1.0, 1e-6); // a few roundings of floats
        assert_near(bolan_v3_dot(out, n), -bolan_v3_dot(in, n), 1e-6);
    }
}

static void the_raising_factor_follows_the_table_of_both_equations(void **state) {
    (void)state;
    static const double rows[][3] = {
        {0, .75019, .75000},  {10, .74514, .72207}, {20, .72936, .69415}, {30, .70085, .66622}, {40, .65598, .63830},
        {50, .58923, .56187}, {60, .49341, .42224}, {70, .36176, .28262}, {80, .19330, .14299}, {85, .09840, .07318}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double theta = bolan_radians(rows[i][0]);
        assert_near(bolan_refraction_k(theta, PAPER_INDEX), rows[i][1], 6e-6); // five decimals are given
        assert_near(bolan_refraction_k_paper(theta), rows[i][2], 6e-6);
    }
    assert_near(bolan_refraction_k_paper(0.8), 0.622, 1e-6); // the left end of the step of .002
}

// The largest distance of the two equations on [from, to] and where it is, in degrees.
static double worst(double from, double to, double *where) {
    double most = 0.0;
    for (int i = 0; i <= 100000; i++) {
        const double theta = from + (to - from) * i / 100000.0;
        const double error = fabs(bolan_refraction_k(theta, PAPER_INDEX) - bolan_refraction_k_paper(theta));
        if (error > most) most = error, *where = bolan_degrees(theta);
    }
    return most;
}

static void the_straight_lines_are_as_wrong_as_documented(void **state) {
    (void)state;
    double where = 0.0;
    assert_near(worst(0.0, 0.8, &where), .0367, 6e-5); // four decimals are given
    assert_near(where, 24.7, 0.06);
    assert_near(worst(0.8001, 1.57, &where), .0808, 6e-5);
    assert_near(where, 67.1, 0.06);
}

static void fermats_path_is_found_and_raises_the_point_by_equation_7(void **state) {
    (void)state;
    // eye height, depth, distance; crossing, angle [deg], apparent depth over depth
    static const double rows[][6] = {
        {2, 1, 1, .73284, 20.124, .72909}, {2, 1, 3, 2.31117, 49.128, .59609}, {10, 5, 30, 25.13911, 68.308, .38672}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *r = rows[i];
        const double x = bolan_refraction_crossing(r[0], r[1], r[2], PAPER_INDEX), theta = atan(x / r[0]);
        assert_near(x, r[3], 6e-6);
        assert_near(bolan_degrees(theta), r[4], 6e-4);
        const double raised = bolan_apparent_depth(r[0], r[1], r[2], PAPER_INDEX) / r[1];
        assert_near(raised, r[5], 6e-6);
        assert_near(raised, bolan_refraction_k(theta, PAPER_INDEX), 1e-12); // the same law in other words
    }
}

static void the_path_is_found_for_every_place(void **state) {
    (void)state;
    static const double heights[] = {0.05, 2.0, 1000.0}, depths[] = {0.0, 0.3, 40.0},
                        distances[] = {0.0, 0.5, 60.0, 3e4};
    for (int i = 0; i < 36; i++) {
        const double h = heights[i % 3], d = depths[i / 3 % 3], away = distances[i / 9];
        const double x = bolan_refraction_crossing(h, d, away, 1.34);
        assert_true(x >= 0.0 && x <= away * (1.0 + 1e-12));
        if (d > 0.0 && away > 0.0)                                                      // Fermat: n1 sin = n2 sin
            assert_near(x / hypot(x, h), 1.34 * (away - x) / hypot(away - x, d), 1e-9); // 12 steps converge to rounding
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_reflected_ray_keeps_its_length_and_turns_its_normal_part),
        cmocka_unit_test(the_raising_factor_follows_the_table_of_both_equations),
        cmocka_unit_test(the_straight_lines_are_as_wrong_as_documented),
        cmocka_unit_test(fermats_path_is_found_and_raises_the_point_by_equation_7),
        cmocka_unit_test(the_path_is_found_for_every_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
