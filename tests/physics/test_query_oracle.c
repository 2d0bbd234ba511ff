// SPDX-License-Identifier: MIT
// Heights and normals against the sum over every wave of the sea, inverted here in double precision by plain fixed
// point.
//
// The one error of the query is that it interpolates the fields bilinearly. For a wave with phase advance p = k h from
// sample to sample the mean square error of linear interpolation is p^4 / 120 of its variance (the mean of (t (1 - t) /
// 2)^2 is 1/120), for bilinear interpolation at most (k h)^4 / 120 whatever its direction. Over a cascade with spacing
// h, slope variance mss and waves up to k_max that sums to at most h^4 k_max^2 mss / 120 for the height; for the
// horizontal displacement, which has the same spectrum, the same, and it moves the height by the slope; for the slopes
// h^4 k_max^4 mss / 120.
#include "bolan/query.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

enum { POINTS = 20 };

typedef struct truth {
    bolan_sea_sample sample;
    double rest_x, rest_y;
} truth;

// Solves x0 + D(x0) = x: D contracts by 1 - J or so, so that 60 steps leave nothing where J > 0.3.
static truth invert(const bolan_sea *sea, bolan_dvec2 x) {
    truth t = {.rest_x = x.x, .rest_y = x.y};
    const double time = bolan_sea_time(sea);
    for (int i = 0; i < 60; i++) {
        t.sample = bolan_sea_sample_direct(sea, t.rest_x, t.rest_y, time);
        const double rx = t.rest_x + (double)t.sample.dx - x.x, ry = t.rest_y + (double)t.sample.dy - x.y;
        if (hypot(rx, ry) < 1e-4) break; // a hundredth of the error below
        t.rest_x -= rx;
        t.rest_y -= ry;
    }
    return t;
}

typedef struct bounds {
    double height, slope; // root mean square
} bounds;

static bounds interpolation_bounds(const bolan_sea *sea) {
    double height = 0.0, slope = 0.0, mss = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); c++) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        const double h = v.length / v.n, k = fmin(v.k_max, BOLAN_PI / h * 1.4143); // corner of the tile's spectrum
        height += pow(h, 4.0) * k * k * v.mss / 120.0;
        slope += pow(h * k, 4.0) * v.mss / 120.0;
        mss += v.mss;
    }
    return (bounds){sqrt(height * (1.0 + mss)), sqrt(slope)};
}

static void check(double wind, double choppiness, double x0, double y0) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.sea_state = bolan_sea_state_from_wind(wind, 200.0, 200e3);
    d.resolution = 256;
    d.choppiness = choppiness;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    bolan_sea_step(sea, 7.25);

    bolan_dvec2 xy[POINTS];
    bolan_query_point answer[POINTS];
    for (int i = 0; i < POINTS; i++)
        xy[i] = (bolan_dvec2){x0 + 17.31 * (i % 7) + 0.37 * i, y0 + 23.77 * (i / 7) - 0.53 * i};
    bolan_query_surface(&(bolan_water){.sea = sea}, xy, POINTS, answer);

    double height = 0.0, slope = 0.0, variance = 0.0;
    int used = 0;
    for (int i = 0; i < POINTS; i++) {
        const truth t = invert(sea, xy[i]);
        if (t.sample.jacobian < 0.3f) continue;
        const bolan_vec3 n = answer[i].normal;
        height += pow((double)(answer[i].height - t.sample.height), 2.0);
        slope += pow((double)(-n.x / n.z - t.sample.slope_x), 2.0) + pow((double)(-n.y / n.z - t.sample.slope_y), 2.0);
        variance += pow((double)t.sample.height, 2.0);
        used++;
    }
    assert_true(used > POINTS * 3 / 4);
    height = sqrt(height / used), slope = sqrt(slope / used), variance = sqrt(variance / used);
    const bounds b = interpolation_bounds(sea);
    print_message("wind %g m/s, choppiness %g, at %g m: height rms %.3f m, error %.5f m (bound %.5f); slope error %.4f "
                  "(bound %.4f)\n",
                  wind, choppiness, hypot(x0, y0), variance, height, b.height, slope, b.slope);
    // The displaced slope divides by J, on the average by 1: choppiness adds its own share.
    assert_true(height < b.height);
    assert_true(slope < (1.0 + choppiness) * b.slope);
    assert_true(height < 0.1 * variance); // so that the bound itself is worth something
    bolan_sea_destroy(&sea);
}

static void test_heights_agree_with_the_sum_over_all_waves(void **state) {
    (void)state;
    check(6.0, 1.0, 0.0, 0.0);
    check(12.0, 1.0, 0.0, 0.0);
    check(12.0, 0.0, -500.0, 300.0);
}

static void test_they_agree_a_thousand_kilometres_from_the_origin(void **state) {
    (void)state;
    check(12.0, 1.0, 1e6, -1e6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_heights_agree_with_the_sum_over_all_waves),
        cmocka_unit_test(test_they_agree_a_thousand_kilometres_from_the_origin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
