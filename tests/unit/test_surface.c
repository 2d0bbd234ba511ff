// SPDX-License-Identifier: MIT
// The projected grid covers all the water in view, follows the round earth, and stands still where it must.
#include "bolan/earth.h"
#include "bolan/surface.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#define CAPACITY 200000
static bolan_surface_vertex vertices[CAPACITY];

static bolan_surface_view view_at(double height, double heading, double pitch) {
    return (bolan_surface_view){.eye = {120.5, -33.25, height},
                                .heading_deg = heading,
                                .pitch_deg = pitch,
                                .fov_y = 0.9,
                                .aspect = 16.0 / 9.0,
                                .pixel_height = 720,
                                .vertical = 3.0,
                                .horizontal = 3.0};
}

static bolan_surface_size build(const bolan_surface_view *view) {
    bolan_surface_desc desc = bolan_surface_desc_default();
    return bolan_surface_projected(&desc, view, vertices);
}

// Largest elevation angle [rad] at which a vertex is seen.
static double top_angle(bolan_surface_size size) {
    double top = -9.0;
    for (uint32_t i = 0; i < size.columns * size.rows; ++i) {
        const bolan_surface_vertex *v = &vertices[i];
        top = fmax(top, atan2(v->z, hypot(v->x, v->y)));
    }
    return top;
}

// Published dips of the geometric horizon, R = 6371 km.
static void the_horizon_lies_at_its_dip(void **state) {
    (void)state;
    const double table[][2] = {{2, .0454}, {10, .1015}, {100, .3210}, {1000, 1.0151}, {10000, 3.2081}};
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i) {
        bolan_surface_view view = view_at(table[i][0], 0, 0);
        view.vertical = view.horizontal = 0.0;
        bolan_surface_size size = build(&view);
        assert_true(size.columns > 0);
        // 0.01 deg: the acceptance bound for the horizon
        assert_true(fabs(bolan_degrees(-top_angle(size)) - table[i][1]) < 0.01);
    }
}

static void the_earth_drops_away(void **state) {
    (void)state;
    bolan_surface_view view = view_at(1000, 0, -5);
    bolan_surface_size size = build(&view);
    for (uint32_t i = 0; i < size.columns * size.rows; ++i) {
        double d = hypot(vertices[i].x, vertices[i].y), drop = -vertices[i].z - 1000.0;
        // d^2 / 2R; 1e-4 of the height is the rounding of float
        assert_true(fabs(drop - d * d / (2 * 6371000.0)) < 0.1 + drop * 1e-5);
    }
}

// Every ray of the picture that meets mean water meets it between the first and the last row, within the azimuths.
static void every_visible_point_of_mean_water_lies_on_the_grid(void **state) {
    (void)state;
    srand(5);
    int tried = 0;
    for (int k = 0; k < 300; ++k) {
        double height = pow(10.0, 0.3 + 3.7 * rand() / RAND_MAX), heading = 360.0 * rand() / RAND_MAX;
        double pitch = -90.0 + 110.0 * rand() / RAND_MAX;
        bolan_surface_view view = view_at(height, heading, pitch);
        view.roll_deg = -40.0 + 80.0 * rand() / RAND_MAX;
        bolan_surface_size size = build(&view);
        bolan_mat4 camera = bolan_m4_transpose(bolan_m4_view(heading, pitch, view.roll_deg)); // camera -> world
        for (int i = 0; i < 40; ++i) {
            double t = tan(0.45), x = (2.0 * rand() / RAND_MAX - 1.0) * t * view.aspect,
                   y = (2.0 * rand() / RAND_MAX - 1.0) * t;
            bolan_vec4 d = bolan_m4_mul_v4(camera, (bolan_vec4){(float)x, (float)y, -1.0f, 0.0f});
            double horizontal = hypot(d.x, d.y), slope = -d.z / horizontal;
            // slope * r = height + r^2 / 2R
            double under = slope * slope - 2.0 * height / BOLAN_EARTH_RADIUS;
            if (slope <= 0.0 || under < 0.0) continue;
            double r = BOLAN_EARTH_RADIUS * (slope - sqrt(under));
            assert_true(size.columns > 0);
            ++tried;
            uint32_t row = 0;
            while (row < size.rows && hypot(vertices[row * size.columns].x, vertices[row * size.columns].y) < r) ++row;
            assert_true(row < size.rows);
            double near_r = hypot(vertices[0].x, vertices[0].y);
            assert_true(near_r <= r * 1.001);
            double azimuth = bolan_wrap_degrees(bolan_degrees(atan2(d.x, d.y)) - heading + 180.0) - 180.0;
            const bolan_surface_vertex *first = &vertices[row * size.columns], *last = first + size.columns - 1;
            double left = bolan_wrap_degrees(bolan_degrees(atan2(first->x, first->y)) - heading + 180.0) - 180.0;
            double right = bolan_wrap_degrees(bolan_degrees(atan2(last->x, last->y)) - heading + 180.0) - 180.0;
            // a full circle has its seam behind the camera
            if (right - left > 1.0) assert_true(azimuth >= left - 0.01 && azimuth <= right + 0.01);
        }
    }
    assert_true(tried > 2000);
}

// A picture that does not reach the horizon has its last row just beyond its upper edge, so that no row is spent in
// vain.
static void rows_end_where_the_picture_does(void **state) {
    (void)state;
    bolan_surface_view view = view_at(10000, 0, -60);
    bolan_surface_size size = build(&view);
    double far = hypot(vertices[size.columns * (size.rows - 1)].x, vertices[size.columns * (size.rows - 1)].y);
    // the upper corners (+-0.859, 0.483) look 26.42 deg down: 10 km / tan = 20.1 km; the guard angle of 0.02 adds 6 %
    assert_true(far > 20100.0 && far < 21500.0);
}

static void a_grid_of_any_size_spans_the_same_water(void **state) {
    (void)state;
    bolan_surface_view view = view_at(30, 75, -12);
    bolan_surface_projector p = bolan_surface_projector_of(&view);
    assert_true(p.visible);
    const bolan_surface_size sizes[] = {{2, 2}, {65, 33}, {129, 97}};
    double near = 0, far = 0;
    for (int k = 0; k < 3; ++k) {
        bolan_surface_projector_vertices(&p, sizes[k], vertices);
        uint32_t last = sizes[k].columns * (sizes[k].rows - 1);
        double n = hypot(vertices[0].x, vertices[0].y), f = hypot(vertices[last].x, vertices[last].y);
        // float's rounding
        if (k > 0) assert_true(fabs(n - near) < 1e-5 * near + 1e-6 && fabs(f - far) < 1e-5 * far);
        near = n, far = f;
    }
    // steps never shrink outward, and beyond x1 none is longer than 7 steps of s times the distance
    for (uint32_t j = 1; j < 97; ++j) {
        double a = hypot(vertices[129 * (j - 1)].x, vertices[129 * (j - 1)].y),
               b = hypot(vertices[129 * j].x, vertices[129 * j].y);
        assert_true(b > a && b - a < 7.6 * b * p.range / 96 + 1.5 * p.height * p.range / 96);
    }
}

// A grid of whole blocks is as fine as was asked for, or as the bound allows, and never coarser than a block more.
static void a_grid_is_made_of_whole_blocks(void **state) {
    (void)state;
    bolan_surface_desc desc = bolan_surface_desc_default();
    const uint32_t blocks[] = {1, 4, BOLAN_SURFACE_MAX_BLOCK}, bounds[] = {1024, 5000, 60000, 200000};
    for (int k = 0; k < 12; ++k) {
        const uint32_t block = blocks[k % 3];
        bolan_surface_view view = view_at(20, 200, -8);
        bolan_surface_projector p = bolan_surface_projector_of(&view), plain = p;
        desc.max_vertices = bounds[k / 3];
        const bolan_surface_size whole = bolan_surface_projector_size(&desc, &view, block, &p);
        const bolan_surface_size free = bolan_surface_projector_size(&desc, &view, 1, &plain);
        assert_int_equal((whole.columns - 1) % block, 0);
        assert_int_equal((whole.rows - 1) % block, 0);
        assert_true((uint64_t)whole.columns * whole.rows <= desc.max_vertices);
        assert_true(whole.columns + block > free.columns && whole.rows + block > free.rows);
        assert_true(p.half >= plain.half || block > 1);
        if (desc.max_vertices == 200000) { // the bound is no bound: the angle asked for
            const double angle = view.fov_y / view.pixel_height * desc.pixels_per_vertex;
            assert_true(p.range / (whole.rows - 1) <= angle);
            assert_true(2.0 * p.half / (whole.columns - 1) <= angle);
            assert_true(p.range / (whole.rows - 1 - block) > 0.95 * angle);
        }
    }
}

static void looking_up_from_above_the_waves_draws_nothing(void **state) {
    (void)state;
    bolan_surface_view view = view_at(50, 0, 60);
    assert_int_equal(build(&view).columns, 0);
}

static void rows_are_the_same_for_any_pitch_and_columns_for_a_small_turn(void **state) {
    (void)state;
    bolan_surface_view view = view_at(30, 40, -8);
    view.horizontal = 0.0;
    bolan_surface_size size = build(&view);
    double step =
        atan2(vertices[size.columns * (size.rows - 1) + 1].x, vertices[size.columns * (size.rows - 1) + 1].y) -
        atan2(vertices[size.columns * (size.rows - 1)].x, vertices[size.columns * (size.rows - 1)].y);
    bolan_surface_vertex before = vertices[size.columns * (size.rows - 1)];
    view.heading_deg += bolan_degrees(step);
    build(&view);
    bolan_surface_vertex after = vertices[size.columns * (size.rows - 1)];
    // the first column is now where the second was: a turn moves whole columns
    double turned = atan2(after.x, after.y) - atan2(before.x, before.y);
    assert_true(fabs(turned - step) < 1e-3 * step + 1e-7);
}

static void indices_are_counter_clockwise_and_cover_each_cell_twice(void **state) {
    (void)state;
    bolan_surface_view view = view_at(12, 75, -10);
    bolan_surface_size size = build(&view);
    uint32_t count = bolan_surface_grid_indices(size, NULL);
    assert_int_equal(count, 6 * (size.columns - 1) * (size.rows - 1));
    uint32_t *indices = malloc(count * sizeof *indices);
    assert_int_equal(bolan_surface_grid_indices(size, indices), count);
    for (uint32_t i = 0; i < count; i += 3) {
        bolan_surface_vertex a = vertices[indices[i]], b = vertices[indices[i + 1]], c = vertices[indices[i + 2]];
        double area = ((double)b.x - a.x) * ((double)c.y - a.y) - ((double)b.y - a.y) * ((double)c.x - a.x);
        assert_true(area > -1e-3);
    }
    free(indices);
}

static void the_grid_fits_the_callers_buffer(void **state) {
    (void)state;
    bolan_surface_desc desc = bolan_surface_desc_default();
    desc.max_vertices = 1024;
    for (double pitch = -90; pitch <= 30; pitch += 15) {
        bolan_surface_view view = view_at(300, 0, pitch);
        bolan_surface_size size = bolan_surface_projected(&desc, &view, vertices);
        assert_true((uint64_t)size.columns * size.rows <= 1024);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_horizon_lies_at_its_dip),
        cmocka_unit_test(the_earth_drops_away),
        cmocka_unit_test(every_visible_point_of_mean_water_lies_on_the_grid),
        cmocka_unit_test(rows_end_where_the_picture_does),
        cmocka_unit_test(a_grid_of_any_size_spans_the_same_water),
        cmocka_unit_test(a_grid_is_made_of_whole_blocks),
        cmocka_unit_test(looking_up_from_above_the_waves_draws_nothing),
        cmocka_unit_test(rows_are_the_same_for_any_pitch_and_columns_for_a_small_turn),
        cmocka_unit_test(indices_are_counter_clockwise_and_cover_each_cell_twice),
        cmocka_unit_test(the_grid_fits_the_callers_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
