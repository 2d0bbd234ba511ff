// SPDX-License-Identifier: MIT
// Terrains made of grids: interpolation, detail, bounds.
#include "support.h"

#include "bolan/ground.h"
#include "ground/ground.h"
#include "ground/noise.h"

#define W 33
#define H 27
static float data[W * H];

// Hills and a basin, with a sharp coast in the west.
static bolan_ground_desc hills(double step, double detail) {
    for (int j = 0; j < H; j++) {
        for (int i = 0; i < W; i++) {
            double z = 180.0 * sin(0.37 * i) * cos(0.29 * j) + 60.0 * sin(1.1 * i + 0.7 * j);
            data[j * W + i] = (float)(i < 6 ? -1500.0 : z);
        }
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){W, H, -5000.0, -3000.0, step, step * 1.25, data};
    d.detail = detail;
    d.edge_elevation = -700.0;
    return d;
}

static bolan_ground *create(const bolan_ground_desc *d) {
    bolan_ground *t = NULL;
    assert_int_equal(bolan_ground_create(d, &t), BOLAN_OK);
    return t;
}

static void the_data_alone_are_met_at_every_node(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 0.0);
    bolan_ground *t = create(&d);
    for (int n = 0; n < W * H; n++) {
        double x = -5000.0 + n % W * 300.0, y = -3000.0 + n / W * 375.0;
        assert_near(bolan_ground_elevation(t, x, y, 0.0), data[n], 2e-3); // float rounding of 1500 m in a cubic
    }
    bolan_ground_destroy(&t);
    assert_null(t);
}

static void interpolation_does_not_overshoot_a_cliff(void **state) {
    (void)state;
    float cliff[8 * 8];
    for (int n = 0; n < 64; n++) {
        cliff[n] = n % 8 < 4 ? -1000.0f : 5.0f;
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){8, 8, 0.0, 0.0, 100.0, 100.0, cliff};
    d.detail = 0.0;
    bolan_ground *t = create(&d);
    float before = -1000.0f;
    for (double x = 0.0; x <= 700.0; x += 3.0) {
        float z = bolan_ground_elevation(t, x, 333.0, 0.0);
        assert_true(z >= before - 1e-3f && z <= 5.001f); // monotone where the data are
        before = z;
    }
    bolan_ground_destroy(&t);
}

static void a_plane_stays_a_plane(void **state) {
    (void)state;
    float plane[40 * 40];
    for (int n = 0; n < 1600; n++) {
        plane[n] = (float)(0.3 * (n % 40) * 50.0 - 0.2 * (n / 40) * 50.0);
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){40, 40, 0.0, 0.0, 50.0, 50.0, plane};
    d.detail = 0.0;
    bolan_ground *t = create(&d);
    for (double resolution = 0.0; resolution < 120.0;
         resolution += 17.0) { // low-passing keeps a plane too, off the rim
        assert_near(bolan_ground_elevation(t, 987.6, 1012.3, resolution), 0.3 * 987.6 - 0.2 * 1012.3, 1e-3);
    }
    bolan_ground_destroy(&t);
}

// z = x y has the twist 1 / m and no curvature along either axis: the bicubic patch of the right twist is the surface.
// Off the middle of the cell, where the twists of its corners cancel. 1e-3 m: float rounding of 100 m in a cubic.
static void a_saddle_stays_a_saddle(void **state) {
    (void)state;
    static float saddle[20 * 20];
    for (int n = 0; n < 400; n++) {
        saddle[n] = (float)((100.0 + n % 20 * 50.0) * (30.0 + n / 20 * 20.0) * 1e-3);
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){20, 20, 100.0, 30.0, 50.0, 20.0, saddle};
    d.detail = 0.0;
    bolan_ground *t = create(&d);
    height_cursor c;
    bolan_height_cursor_start(&c, t);
    for (int n = 0; n < 400; n++) {
        double x = 160.0 + n % 20 * 43.0, y = 54.0 + n / 20 * 17.1; // 43 / 50 and 17.1 / 20: every part of a cell
        assert_near(bolan_ground_elevation(t, x, y, 0.0), x * y * 1e-3, 1e-3);
        surface_point p = bolan_height_cursor_at(&c, x, y, 0.0);
        assert_near(p.dx, y * 1e-3, 1e-5);
        assert_near(p.dy, x * 1e-3, 1e-5);
    }
    bolan_ground_destroy(&t);
}

// Height of an octave whose lattice is turned by 37 degrees, at world metres; (*dx, *dy) receives its own gradient.
static float turned_octave(double x, double y, float gully, float rubble, float *dx, float *dy) {
    const double c = 0.8, s = 0.6, wavelength = 40.0;
    const detail_lattice o = {
        (c * x - s * y) / wavelength, (s * x + c * y) / wavelength, (float)c, (float)s, (float)wavelength, 3u};
    *dx = 0.24f, *dy = -0.1f;
    float z = bolan_detail_octave(&o, 0.26f, gully, rubble, dx, dy);
    *dx -= 0.24f, *dy += 0.1f;
    return z;
}

static double octave_alone(double x, double y, float gully, float rubble) {
    float dx, dy;
    return (double)turned_octave(x, y, gully, rubble, &dx, &dy);
}

static void check_gradient(double x, double y, float gully, float rubble) {
    const double h = 0.02;
    float dx, dy;
    turned_octave(x, y, gully, rubble, &dx, &dy);
    // Central differences of floats of some metres over 4 cm, slopes up to 1; the cosine of the waves is good to 2e-4.
    assert_near(dx, (octave_alone(x + h, y, gully, rubble) - octave_alone(x - h, y, gully, rubble)) / (2.0 * h), 1e-3);
    assert_near(dy, (octave_alone(x, y + h, gully, rubble) - octave_alone(x, y - h, gully, rubble)) / (2.0 * h), 1e-3);
}

// The gradient that steers the next octave is that of the height, in the world's axes. Of gullies at the corners of the
// lattice, where one wave alone is left and its gradient is the whole one.
static void an_octave_returns_the_gradient_of_its_height(void **state) {
    (void)state;
    for (int n = 0; n < 60; n++) {
        check_gradient(3.0 + 7.3 * n, 400.0 - 11.9 * n, 0.0f, 0.2f);
        const double u = n % 8 * 40.0, v = n / 8 * 40.0; // lattice -> world: turned back
        check_gradient(0.8 * u + 0.6 * v, -0.6 * u + 0.8 * v, 0.15f, 1e-30f);
    }
}

static void elevation_is_continuous_everywhere(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *t = create(&d);
    // A walk across cells, the rim and the blend outside. A millimetre may rise a decimetre: the cliff of 1500 m in 300
    // m has a slope of 10, and gullies on its flank a few times that; a step in the surface would be metres.
    for (double y = -3170.0; y < 7000.0; y += 1171.0) {
        for (double x = -8000.0; x < 8000.0; x += 3.7) {
            float a = bolan_ground_elevation(t, x, y, 0.0), b = bolan_ground_elevation(t, x + 0.001, y, 0.0);
            assert_true(isfinite(a) && fabsf(b - a) < 0.1f);
        }
    }
    bolan_ground_destroy(&t);
}

static void elevation_is_continuous_in_the_resolution(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *t = create(&d);
    float before = bolan_ground_elevation(t, 1234.5, 987.6, 0.0);
    assert_near(bolan_ground_elevation(t, 1234.5, 987.6, 0.1), before, 1e-4); // the shortest wavelength is longer
    before = bolan_ground_elevation(t, 1234.5, 987.6, 0.2);
    for (double resolution = 0.2; resolution < 3000.0; resolution *= 1.001) {
        float z = bolan_ground_elevation(t, 1234.5, 987.6, resolution);
        assert_true(fabsf(z - before) < 2.0f); // a thousandth of an octave of relief of some hundred metres
        before = z;
    }
    bolan_ground_destroy(&t);
}

static void detail_leaves_as_the_resolution_grows(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *rough = create(&d);
    d.detail = 0.0;
    bolan_ground *smooth = create(&d);
    double before = 1e30;
    for (double resolution = 10.0; resolution < 700.0; resolution *= 2.0) {
        double sum = 0.0;
        for (int n = 0; n < 2000; n++) {
            double x = -2500.0 + 3.7 * n, y = -1500.0 + 3.1 * n;
            double added =
                bolan_ground_elevation(rough, x, y, resolution) - bolan_ground_elevation(smooth, x, y, resolution);
            sum += added * added / 2000.0;
        }
        double rms = sqrt(sum);
        assert_true(rms <= before);
        before = rms * 1.1; // octaves are steered by each other, so the sum is not quite monotonic
        if (resolution < 25.0) assert_true(rms > 3.0);
        if (resolution > 375.0) assert_true(rms == 0.0); // the longest wavelength is twice the coarser spacing, 375 m
    }
    bolan_ground_destroy(&rough);
    bolan_ground_destroy(&smooth);
}

static void it_is_finite_and_settled_far_away(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *t = create(&d);
    const double far_away[] = {3e4, -3e4, 1e7, -1e9, 1e15, -1e300};
    for (int n = 0; n < 36; n++) {
        assert_true(bolan_ground_elevation(t, far_away[n % 6], far_away[n / 6], 0.0) == -700.0f);
    }
    bolan_ground_destroy(&t);
}

static void a_grid_equals_single_calls_for_any_number_of_threads(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *t = create(&d);
    static float one[60 * 50], many[60 * 50];
    bolan_set_threads(1);
    bolan_ground_elevations(t, -2000.0, -1500.0, 37.0, 60, 50, one);
    bolan_set_threads(3);
    bolan_ground_elevations(t, -2000.0, -1500.0, 37.0, 60, 50, many);
    bolan_set_threads(1);
    for (int n = 0; n < 3000; n++) {
        assert_true(one[n] == many[n]);
        assert_true(one[n] == bolan_ground_elevation(t, -2000.0 + n % 60 * 37.0, -1500.0 + n / 60 * 37.0, 37.0));
    }
    bolan_ground_destroy(&t);
}

static void bounds_hold_every_elevation(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *t = create(&d);
    for (int n = 0; n < 60; n++) {
        double west = -6000.0 + 190.0 * n, south = -4000.0 + 170.0 * n, size = 40.0 * (1 + n % 23);
        float low, high;
        bolan_ground_bounds(t, west, south, size, &low, &high);
        for (int k = 0; k < 400; k++) {
            float z =
                bolan_ground_elevation(t, west + k % 20 * size / 19.0, south + k / 20 * size / 19.0, k % 3 * 10.0);
            assert_true(z >= low && z <= high);
        }
    }
    bolan_ground_destroy(&t);
}

static void the_id_tells_terrains_apart(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 1.0);
    bolan_ground *a = create(&d), *b = create(&d);
    assert_true(bolan_ground_id(a) == bolan_ground_id(b));
    bolan_ground_destroy(&b);
    d.seed++;
    b = create(&d);
    assert_true(bolan_ground_id(a) != bolan_ground_id(b));
    bolan_ground_destroy(&b);
    d.seed--;
    data[77] += 0.001f;
    b = create(&d);
    assert_true(bolan_ground_id(a) != bolan_ground_id(b));
    bolan_ground_destroy(&b);
    bolan_ground_destroy(&a);
}

static bolan_log_id last_id;
static void keep_log(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)sentence;
    last_id = id;
}

static void refuses(const bolan_ground_desc *d, bolan_log_id id) {
    bolan_ground *t = (bolan_ground *)&last_id;
    last_id = (bolan_log_id)0;
    assert_int_equal(bolan_ground_create(d, &t), BOLAN_ERROR_ARGUMENT);
    assert_null(t);
    assert_int_equal(last_id, id);
}

static void wrong_descriptions_are_refused(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = keep_log});
    bolan_ground_desc good = hills(300.0, 1.0), d = good;
    d.field.width = 1, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.step_y = 0.0, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.step_x = 0.99e-3, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.step_y = NAN, refuses(&d, BOLAN_LOG_NOT_FINITE), d = good;
    const double long_steps[] = {1.01e7, 1e30, 1e308};
    for (int n = 0; n < 3; n++) {
        d.field.step_x = long_steps[n], refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
        d.field.step_y = long_steps[n], refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    }
    d.field.west = NAN, refuses(&d, BOLAN_LOG_NOT_FINITE), d = good;
    d.field.west = -1.01e8, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.west = 1e308, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.south = -1e308, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.field.south = 1e8 - 26 * 374.0, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good; // the last row, not the first
    d.field.west = 1e8 - 32 * 299.0, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.edge_elevation = -1.01e6, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    data[3] = 3e38f, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), good = hills(300.0, 1.0), d = good;
    d.field.elevation = NULL, refuses(&d, BOLAN_LOG_BAD_ARGUMENT), d = good;
    d.detail = 2.5, refuses(&d, BOLAN_LOG_OUT_OF_RANGE), d = good;
    d.edge_elevation = INFINITY, refuses(&d, BOLAN_LOG_NOT_FINITE), d = good;
    data[100] = NAN, refuses(&d, BOLAN_LOG_NOT_FINITE);
    bolan_set_hooks(NULL);
    assert_int_equal(bolan_memory_in_use(), 0);
}

// The widest grid that is taken: every look-up ends and is finite.
static void the_largest_terrain_is_finite(void **state) {
    (void)state;
    bolan_ground_desc d = hills(300.0, 2.0);
    d.field.width = d.field.height = 11;
    d.field.step_x = d.field.step_y = 1e7;
    d.field.west = -1e8, d.field.south = 0.0;
    bolan_ground *t = create(&d);
    const double places[] = {-1e8, -3e7, 0.0, 1e7, 1.9e8, 1e308, -1e308, INFINITY, NAN};
    for (int n = 0; n < 81; n++) {
        assert_true(isfinite(bolan_ground_elevation(t, places[n % 9], places[n / 9], 0.0)));
    }
    bolan_ground_destroy(&t);
}

RUN_TESTS(cmocka_unit_test(a_saddle_stays_a_saddle), cmocka_unit_test(an_octave_returns_the_gradient_of_its_height),
          cmocka_unit_test(the_largest_terrain_is_finite), cmocka_unit_test(the_data_alone_are_met_at_every_node),
          cmocka_unit_test(interpolation_does_not_overshoot_a_cliff), cmocka_unit_test(a_plane_stays_a_plane),
          cmocka_unit_test(elevation_is_continuous_everywhere),
          cmocka_unit_test(elevation_is_continuous_in_the_resolution),
          cmocka_unit_test(detail_leaves_as_the_resolution_grows), cmocka_unit_test(it_is_finite_and_settled_far_away),
          cmocka_unit_test(a_grid_equals_single_calls_for_any_number_of_threads),
          cmocka_unit_test(bounds_hold_every_elevation), cmocka_unit_test(the_id_tells_terrains_apart),
          cmocka_unit_test(wrong_descriptions_are_refused))
