// SPDX-License-Identifier: MIT
// Angles, vectors, matrices and the depth numbers of the projection.
#include "support.h"

#include "bolan/math.h"

static void degrees_wrap_into_one_turn(void **state) {
    (void)state;
    assert_near(bolan_wrap_degrees(-90.0), 270.0, 0.0);
    assert_near(bolan_wrap_degrees(720.0), 0.0, 0.0);
    assert_near(bolan_wrap_degrees(359.5), 359.5, 0.0);
    assert_true(bolan_wrap_degrees(-1e-30) < 360.0); // which in floating point is 360 more than it
}

static void a_wind_from_the_west_sends_waves_east(void **state) {
    (void)state;
    const double tolerance = 1e-15; // one rounding of an angle below 2 pi
    assert_near(bolan_compass_from_to_math(270.0), 0.0, tolerance);
    assert_near(bolan_compass_from_to_math(180.0), BOLAN_PI / 2.0, tolerance); // from the south: north
    assert_near(bolan_compass_from_to_math(90.0), BOLAN_PI, tolerance);        // from the east: west
    assert_near(bolan_compass_from_to_math(0.0), 1.5 * BOLAN_PI, tolerance);   // from the north: south
    assert_near(bolan_compass_from_to_math(225.0), BOLAN_PI / 4.0, tolerance); // from the south-west: north-east
}

static void compass_and_mathematical_angles_are_inverse(void **state) {
    (void)state;
    for (double from = 0.0; from < 360.0; from += 7.5) {
        const double there = bolan_compass_from_to_math(from);
        assert_true(there >= 0.0 && there < 2.0 * BOLAN_PI);
        assert_near(bolan_math_to_compass_from(there), from, 1e-12); // 360 times a few 2^-53
    }
}

static void assert_row(bolan_mat4 m, int row, double x, double y, double z) {
    const double tolerance = 1.2e-7; // a float of size 1, rounded
    assert_near(m.m[row], x, tolerance);
    assert_near(m.m[4 + row], y, tolerance);
    assert_near(m.m[8 + row], z, tolerance);
}

static void a_level_view_north_has_east_on_its_right(void **state) {
    (void)state;
    const bolan_mat4 m = bolan_m4_view(0.0, 0.0, 0.0);
    assert_row(m, 0, 1, 0, 0);  // right is east
    assert_row(m, 1, 0, 0, 1);  // up is up
    assert_row(m, 2, 0, -1, 0); // the camera looks along its -z: north
}

static void a_view_east_has_south_on_its_right(void **state) {
    (void)state;
    const bolan_mat4 m = bolan_m4_view(90.0, 0.0, 0.0);
    assert_row(m, 0, 0, -1, 0);
    assert_row(m, 2, -1, 0, 0);
}

static void pitch_up_looks_at_the_sky(void **state) {
    (void)state;
    const bolan_mat4 m = bolan_m4_view(30.0, 90.0, 0.0);
    const bolan_vec4 zenith = bolan_m4_mul_v4(m, (bolan_vec4){0, 0, 1, 0});
    assert_near(zenith.z, -1.0, 1.2e-7);
}

static void a_clockwise_roll_lowers_the_right_wing(void **state) {
    (void)state;
    const bolan_mat4 m = bolan_m4_view(0.0, 0.0, 90.0);
    assert_row(m, 0, 0, 0, -1);
    assert_row(m, 1, 1, 0, 0);
}

static void a_view_is_a_rotation(void **state) {
    (void)state;
    const bolan_mat4 m = bolan_m4_view(123.0, -35.0, 12.0);
    const bolan_mat4 product = bolan_m4_mul(m, bolan_m4_transpose(m));
    const bolan_mat4 identity = bolan_m4_identity();
    for (int i = 0; i < 16; i++) assert_near(product.m[i], identity.m[i], 2.5e-7); // three products of rounded floats
}

static void a_matrix_times_its_inverse_is_the_identity(void **state) {
    (void)state;
    const bolan_mat4 a = {{2, 0.5f, -1, 0.25f, 0, 3, 1, -0.5f, 1, -2, 4, 0, 5, 7, -3, 1}};
    const bolan_mat4 product = bolan_m4_mul(a, bolan_m4_inverse(a));
    const bolan_mat4 identity = bolan_m4_identity();
    // The inverse is exact to half an ulp; the product sums four terms of up to 10.
    for (int i = 0; i < 16; i++) assert_near(product.m[i], identity.m[i], 4e-6);
}

static void the_second_factor_of_a_product_comes_first(void **state) {
    (void)state;
    const bolan_mat4 a = bolan_m4_view(40.0, 10.0, 0.0), b = bolan_m4_projection(1.0, 1.5, 0.5, 1);
    const bolan_vec4 v = {3, -2, 7, 1};
    const bolan_vec4 at_once = bolan_m4_mul_v4(bolan_m4_mul(b, a), v);
    const bolan_vec4 in_turn = bolan_m4_mul_v4(b, bolan_m4_mul_v4(a, v));
    assert_near(at_once.x, in_turn.x, 4e-6); // numbers up to 15: a few float ulp
    assert_near(at_once.y, in_turn.y, 4e-6);
    assert_near(at_once.w, in_turn.w, 4e-6);
}

static double window_depth(double distance, double near_m, int zero_to_one) {
    const bolan_mat4 p = bolan_m4_projection(bolan_radians(60.0), 16.0 / 9.0, near_m, zero_to_one);
    const bolan_vec4 clip = bolan_m4_mul_v4(p, (bolan_vec4){0, 0, (float)-distance, 1});
    const double ndc = (double)clip.z / (double)clip.w;
    return zero_to_one ? ndc : 0.5 * ndc + 0.5;
}

static void reversed_depth_is_near_over_distance(void **state) {
    (void)state;
    assert_near(window_depth(0.1, 0.1, 1), 1.0, 1e-7);
    assert_near(window_depth(0.2, 0.1, 1), 0.5, 1e-7);
    assert_near(window_depth(100e3, 0.1, 1), 1e-6, 1e-13); // float z and w: relative 2^-24
    assert_near(window_depth(1e30, 0.1, 1), 0.0, 1e-30);
    // The [-1, 1] form has the same window depth, but its subtraction from w costs the precision far away.
    assert_near(window_depth(0.1, 0.1, 0), 1.0, 1e-7);
    assert_near(window_depth(0.2, 0.1, 0), 0.5, 1e-7);
    assert_near(window_depth(100e3, 0.1, 0), 1e-6, 6e-8);
}

static void the_field_of_view_is_the_vertical_one(void **state) {
    (void)state;
    const double fov = bolan_radians(60.0);
    const bolan_mat4 p = bolan_m4_projection(fov, 2.0, 0.1, 1);
    const bolan_vec4 top = bolan_m4_mul_v4(p, (bolan_vec4){0, (float)tan(0.5 * fov), -1, 1});
    const bolan_vec4 side = bolan_m4_mul_v4(p, (bolan_vec4){2.0f * (float)tan(0.5 * fov), 0, -1, 1});
    assert_near(top.y / top.w, 1.0, 2e-7); // two float roundings
    assert_near(side.x / side.w, 1.0, 2e-7);
}

static void vectors_follow_the_right_hand(void **state) {
    (void)state;
    const bolan_vec3 z = bolan_v3_cross(bolan_v3(1, 0, 0), bolan_v3(0, 1, 0));
    assert_near(z.z, 1.0, 0.0);
    assert_near(bolan_v3_length(bolan_v3_normalize(bolan_v3(3, 4, 12))), 1.0, 1.2e-7);
    assert_near(bolan_v3_dot(bolan_v3_sub(bolan_v3(3, 2, 1), bolan_v3(1, 1, 1)), bolan_v3(1, 1, 1)), 3.0, 0.0);
}

RUN_TESTS(cmocka_unit_test(degrees_wrap_into_one_turn), cmocka_unit_test(a_wind_from_the_west_sends_waves_east),
          cmocka_unit_test(compass_and_mathematical_angles_are_inverse),
          cmocka_unit_test(a_level_view_north_has_east_on_its_right),
          cmocka_unit_test(a_view_east_has_south_on_its_right), cmocka_unit_test(pitch_up_looks_at_the_sky),
          cmocka_unit_test(a_clockwise_roll_lowers_the_right_wing), cmocka_unit_test(a_view_is_a_rotation),
          cmocka_unit_test(a_matrix_times_its_inverse_is_the_identity),
          cmocka_unit_test(the_second_factor_of_a_product_comes_first),
          cmocka_unit_test(reversed_depth_is_near_over_distance),
          cmocka_unit_test(the_field_of_view_is_the_vertical_one), cmocka_unit_test(vectors_follow_the_right_hand))
