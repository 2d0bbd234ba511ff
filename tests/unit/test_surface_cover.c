// SPDX-License-Identifier: MIT
// The projected grid covers the image from side to side, however coarse the image and wherever the camera looks: its
// columns are snapped to steps of the compass, and what that costs at one side must not show.
#include "../support.h"
#include "bolan/surface.h"

enum { MOST = 20000 };
static bolan_surface_vertex vertices[MOST];

// Azimuths of the last row [rad from the heading], first and last column.
static void reach_of(const bolan_surface_view *view, double pixels_per_vertex, double *left, double *right) {
    bolan_surface_desc desc = bolan_surface_desc_default();
    desc.pixels_per_vertex = pixels_per_vertex;
    desc.max_vertices = MOST;
    const bolan_surface_size size = bolan_surface_projected(&desc, view, vertices);
    assert_true(size.columns >= 2 && size.rows >= 2);
    const bolan_surface_vertex *row = vertices + (size_t)(size.rows - 1) * size.columns;
    const double heading = bolan_radians(view->heading_deg);
    *left = remainder(atan2((double)row[0].x, (double)row[0].y) - heading, 2.0 * BOLAN_PI);
    *right =
        remainder(atan2((double)row[size.columns - 1].x, (double)row[size.columns - 1].y) - heading, 2.0 * BOLAN_PI);
}

static void the_far_rows_reach_both_sides(void **state) {
    (void)state;
    static const double heights[] = {48.0, 96.0, 180.0, 1080.0}, spacings[] = {2.0, 6.0, 8.0};
    for (int h = 0; h < 4; ++h)
        for (int s = 0; s < 3; ++s)
            for (double heading = 0.0; heading < 360.0; heading += 7.3) {
                const bolan_surface_view view = {.eye = {0.0, 0.0, 30.0},
                                                 .heading_deg = heading,
                                                 .fov_y = 0.5 * BOLAN_PI,
                                                 .aspect = 1.0,
                                                 .pixel_height = (uint32_t)heights[h],
                                                 .vertical = 1.0,
                                                 .horizontal = 1.0};
                const double side = 0.25 * BOLAN_PI + view.fov_y / heights[h]; // and a pixel, for shifted samples
                double left, right;
                reach_of(&view, spacings[s], &left, &right);
                if (!(left <= -side && right >= side))
                    fail_msg("%g rows, %g pixels a vertex, heading %g: from %.2f to %.2f degrees", heights[h],
                             spacings[s], heading, bolan_degrees(left), bolan_degrees(right));
            }
}

RUN_TESTS(cmocka_unit_test(the_far_rows_reach_both_sides))
