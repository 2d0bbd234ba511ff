// SPDX-License-Identifier: MIT
// Waves and grids as C and shaders share them (shaders/shared/): the exponential of a cosine, attenuation over a bed,
// rows of the projected grid, tiles, half floats.
#include "cascade_twin.h"
#include "support.h"

#include "bolan/query.h"
#include "math/half.h"
#include "shared/attenuation.glsl"
#include "shared/cascade.glsl"
#include "shared/constants.glsl"
#include "shared/exp_cosine.glsl"
#include "shared/grid.glsl"
#include "waves/sum/exp_cosine.h"

// Height of unit amplitude in the form with zero mean and range 2, and its derivative by the phase.
static double height_of(double s, double turns) {
    const double half = half_sine(within_half_a_turn(turns));
    return exp_cosine_scale(s) * exp(s) * (exp_cosine(s, half, 0.0) - exp(-s) * exp_cosine_mean(s));
}

static void the_exponential_of_a_cosine_has_zero_mean_and_range_two(void **state) {
    (void)state;
    for (double s = 0.1; s <= 2.0; s += 0.38) {
        enum { STEPS = 4096 };
        double mean = 0.0, low = 1e9, high = -1e9, slope2 = 0.0;
        for (int i = 0; i < STEPS; ++i) {
            const double turns = (i + 0.25) / STEPS - 3.0, x = within_half_a_turn(turns), h = height_of(s, turns);
            const double th = 2.0 * PI * turns, plain = exp(s * (cos(th) - 1.0));
            const double slope = exp_cosine_slope(s, half_sine(x), half_cosine(x), 0.0);
            assert_near(exp_cosine(s, half_sine(x), 0.0), plain, 2e-5); // half_sine() is good to 4e-6
            assert_near(slope, -s * sin(th) * plain, 5e-5);
            mean += h / STEPS, low = fmin(low, h), high = fmax(high, h), slope2 += slope * slope / STEPS;
        }
        assert_near(mean, 0.0, 2e-5);
        assert_near(high - low, 2.0, 1e-4);
        assert_near(slope2, exp(-2.0 * s) * exp_cosine_slope_variance(s), 1e-4);
    }
    // the paper's s = 1: e^{cos} from 1/e to e about I0(1), slope at most 1.4585285 where cos th = (sqrt 5 - 1) / 2
    assert_near(exp(1.0) * exp_cosine(1.0, half_sine(0.5), 0.0), 0.3678794, 1e-5);
    assert_near(exp(1.0) * exp_cosine(1.0, half_sine(0.0), 0.0), 2.7182818, 1e-7);
    const double steep = acos(0.5 * (sqrt(5.0) - 1.0)) / (2.0 * PI);
    assert_near(-exp(1.0) * exp_cosine_slope(1.0, half_sine(steep), half_cosine(steep), 0.0), 1.4585285, 1e-5);
    assert_near(exp_cosine(0.7, 0.3, -3.0), 0.125 * exp_cosine(0.7, 0.3, 0.0), 1e-12); // faded by octaves
}

static void half_phases_are_good_to_their_bound(void **state) {
    (void)state;
    for (double turns = -0.5; turns <= 0.5; turns += 1.0 / 512.0) {
        assert_near(half_sine(turns), sin(PI * turns), 5e-6);
        assert_near(half_cosine(turns), cos(PI * turns), 5e-6);
    }
    assert_near(within_half_a_turn(17.75), -0.25, 1e-12);
    assert_near(within_half_a_turn(-3.3), -0.3, 1e-12);
}

static void shallow_water_leaves_the_hyperbolic_tangent(void **state) {
    (void)state;
    for (float x = 0.0f; x < 12.0f; x += 0.01f)
        assert_near(rational_tanh(x), tanh((double)x), x < 3.4f ? 4e-6 : 1.3e-4);
    for (float depth = 0.05f; depth < 200.0f; depth *= 1.7f)
        for (float hs = 0.1f; hs < 20.0f; hs *= 2.3f)
            assert_near(coast_attenuation(depth, hs), tanh(0.6 * (double)depth / (double)hs), 1.4e-4);
    assert_true(coast_attenuation(0.0f, 1.0f) == 0.0f && coast_attenuation(NAN, 1.0f) == 0.0f);
    assert_true(coast_attenuation(1.0f, 0.0f) == 1.0f && coast_attenuation(1e30f, 1.0f) == 1.0f);
    assert_near(coast_share2(0.5f, 9.0f, 4.0f), 0.5625, 1e-7);
}

static void rows_of_the_grid_go_back_and_forth(void **state) {
    (void)state;
    for (double x = 1e-3; x < 1e6; x *= 1.3) {
        const double s = grid_parameter(x), e = 1e-6;
        assert_near(grid_distance(s), x, 1e-9 * x);
        assert_near((grid_distance(s + e) - grid_distance(s - e)) / (2.0 * e), grid_steepness(x),
                    1e-4 * grid_steepness(x));
    }
    // where both laws meet, value and slope are the same
    assert_near(grid_distance(GRID_FAR_ANGLE - 1e-12), GRID_FAR_FROM, 1e-9);
    assert_near(grid_distance(GRID_FAR_ANGLE), GRID_FAR_FROM, 1e-12);
    assert_near(1.0 + GRID_FAR_FROM * GRID_FAR_FROM, GRID_FAR_SHARE * GRID_FAR_FROM, 1e-12);
    assert_near(GRID_FAR_ANGLE, atan(GRID_FAR_FROM), 1e-15);
    assert_near(grid_half_angle(0.5, 20.0, 10.0), PI, 1e-12);                     // a circle within the guard
    assert_near(grid_half_angle(0.5, 20.0, 80.0), 0.5 + (PI - 0.5) / 8.0, 1e-12); // (1/4)^1.5 of the rest
}

static void tiles_are_turned_counter_clockwise(void **state) {
    (void)state;
    const double c = cos(0.4), s = sin(0.4);
    assert_near(along_tile(c, s, c, s), 1.0, 1e-15); // the tile's own first axis
    assert_near(across_tile(c, s, c, s), 0.0, 1e-15);
    assert_near(along_tile(-s, c, c, s), 0.0, 1e-15);
    assert_near(across_tile(-s, c, c, s), 1.0, 1e-15);
}

// Query and samples find the sample (i, j) of a cascade where along_tile() and across_tile() are i, j of n: the turn,
// the side and the order of the axes that shaders use; all of it over the warped plane.
static void cascades_lie_over_the_world_as_tiles_do(void **state) {
    (void)state;
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.fft.cascade_count = 2;
    desc.resolution = 64;
    desc.choppiness = 0.0; // nothing moves sideways
    desc.sea_state = bolan_sea_state_from_wind(8.0, 205.0, 200e3);
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 3.0);
    const bolan_cascade_view first = bolan_sea_cascade(sea, 0), v = bolan_sea_cascade(sea, 1);
    const double c = cos(v.angle), s = sin(v.angle);
    assert_true(fabs(s) > 0.05 && fabs(c) > 0.05); // else a turn of the wrong sign would pass
    bolan_water water = bolan_water_default();
    water.sea = sea;
    for (uint32_t k = 0; k < 200; ++k) {
        const uint32_t i = k * 7 % v.n, j = k * 11 % v.n;
        const double tile = v.length * ((int)(k % 5) - 2), u = tile + i * v.length / v.n, w = j * v.length / v.n - tile;
        const bolan_dvec2 at = {u * c - w * s, u * s + w * c};
        assert_near(along_tile(at.x, at.y, c, s), u, 1e-9);
        assert_near(across_tile(at.x, at.y, c, s), w, 1e-9);
        float height = 0.0f;
        bolan_sea_sample sample;
        bolan_query_heights(&water, &at, 1, &height);
        bolan_sea_sample_rest(sea, &at, 1, &sample);
        double gradient[4];
        const bolan_dvec2 read = bolan_sea_place_read(sea, at.x, at.y, gradient);
        assert_true(hypot(read.x - at.x, read.y - at.y) > 1e-3); // else the plane would not be warped
        const twin_place there[] = {twin_place_in(&first, read), twin_place_in(&v, read)};
        const double want =
            twin_cubic(TWIN_TEXELS(&first, height), &there[0]) + twin_cubic(TWIN_TEXELS(&v, height), &there[1]);
        assert_near((double)height, want, 1e-5); // the place to 1e-9 cells, heights of a few metres in float
        assert_near((double)sample.height, want, 1e-5);
    }
    bolan_sea_destroy(&sea);
}

static void half_floats_come_back(void **state) {
    (void)state;
    for (uint32_t half = 0; half < 0x10000u; ++half) {
        if ((half & 0x7c00u) == 0x7c00u && (half & 0x3ffu)) continue; // no number
        assert_int_equal(half_from_float(float_from_half((uint16_t)half)), half);
    }
    assert_true(isnan(float_from_half(0x7e00)) && isinf(float_from_half(0xfc00)) && float_from_half(0xfc00) < 0.0f);
    assert_true(float_from_half(0x3c00) == 1.0f && float_from_half(0x7bff) == HALF_LARGEST);
    assert_true(float_from_half(0x0001) == 0x1p-24f && float_from_half(0xc100) == -2.5f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exponential_of_a_cosine_has_zero_mean_and_range_two),
        cmocka_unit_test(half_phases_are_good_to_their_bound),
        cmocka_unit_test(shallow_water_leaves_the_hyperbolic_tangent),
        cmocka_unit_test(rows_of_the_grid_go_back_and_forth),
        cmocka_unit_test(tiles_are_turned_counter_clockwise),
        cmocka_unit_test(cascades_lie_over_the_world_as_tiles_do),
        cmocka_unit_test(half_floats_come_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
