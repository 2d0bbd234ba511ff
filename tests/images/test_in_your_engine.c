// SPDX-License-Identifier: MIT
// The picture of examples/04_in_your_engine.c, which the example itself makes in a window under a virtual X server: the
// waterline at the cube is the query's, the cube is reflected below it, what is under water is seen and tinted, things
// stand before and behind the waves. The numbers of its frame are repeated here.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>

#include "bolan/query.h"

enum { WIDTH = 640, HEIGHT = 360 };
static uint8_t rgb[HEIGHT][WIDTH][3];

static bool make_picture(void) {
    const char *folder = getenv("BOLAN_EXAMPLES");
    char command[1024];
    if (folder == NULL || system("command -v xvfb-run >/dev/null") != 0) return false;
    snprintf(command, sizeof command,
             "xvfb-run -a -s '-screen 0 1280x1024x24' '%s/04_in_your_engine' --picture in_your_engine.ppm", folder);
    if (system(command) != 0) return false;
    FILE *file = fopen("in_your_engine.ppm", "rb");
    int width = 0, height = 0;
    assert_non_null(file);
    assert_int_equal(fscanf(file, "P6 %d %d 255", &width, &height), 2);
    (void)fgetc(file);
    assert_true(width == WIDTH && height == HEIGHT && fread(rgb, sizeof rgb, 1, file) == 1);
    fclose(file);
    return true;
}

// Column and row of a place in the world, by the example's eye, pitch and off-centre projection.
static void pixel_of(double x, double y, double z, int *column, int *row) {
    const double pitch = bolan_radians(-6.0), right = x - 1.0, ahead = y, up = z - 3.0;
    const double away = ahead * cos(pitch) + up * sin(pitch), high = up * cos(pitch) - ahead * sin(pitch);
    const double u = right / (0.42 * WIDTH / HEIGHT) / away - 0.1, v = high / 0.42 / away;
    *column = (int)floor((0.5 + 0.5 * u) * WIDTH);
    *row = (int)floor((0.5 - 0.5 * v) * HEIGHT);
}

static int mean_of(int column, int row, int half, int channel) {
    int sum = 0;
    for (int j = row - half; j <= row + half; j++)
        for (int i = column - half; i <= column + half; i++) sum += rgb[j][i][channel];
    return sum / (2 * half + 1) / (2 * half + 1);
}

static double query(double x, double y) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    bolan_sea *sea = NULL;
    bolan_query_point point;
    desc.sea_state = bolan_sea_state_from_wind(5.0, 240.0, 50e3);
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 30.0);
    bolan_query_surface(&(bolan_water){.sea = sea}, &(bolan_dvec2){x, y}, 1, &point);
    bolan_sea_destroy(&sea);
    return (double)point.height;
}

// Its front is at y = 12.5, x from -1.5 to 1.5: down each column the bright red ends where the water stands.
static void waterline_is_the_querys(void **state) {
    (void)state;
    for (double x = -1.2; x < 1.3; x += 0.4) {
        int column, row, found = 0;
        pixel_of(x, 12.5, 1.0, &column, &row); // well above it
        while (row + found < HEIGHT && rgb[row + found][column][0] > 170) found++;
        pixel_of(x, 12.5, query(x, 12.5), &column, &row);
        int top;
        pixel_of(x, 12.5, 1.0, &column, &top);
        if (abs(top + found - row) > 3) fail_msg("waterline at x %.1f: row %d, not %d", x, top + found, row);
    }
}

// Red over blue, against that of open water at the same height of the picture.
static double redness(int column, int row) {
    return (double)mean_of(column, row, 4, 0) / (mean_of(column, row, 4, 2) + 1);
}

static void the_cube_is_reflected_below_the_waterline(void **state) {
    (void)state;
    int column, row;
    pixel_of(0.0, 12.5, -0.3, &column, &row);
    const double cube = redness(column, row + 12), open = redness(column + 250, row + 12);
    if (!(cube > 1.4 * open)) fail_msg("red over blue is %.2f below the cube and %.2f beside it", cube, open);
}

// A white cube under water: brighter than the water beside it, and less red than green and blue.
static void what_is_under_water_is_seen_and_tinted(void **state) {
    (void)state;
    int column, row;
    pixel_of(3.6, 8.3, -1.3, &column, &row);
    const int r = mean_of(column, row, 4, 0), g = mean_of(column, row, 4, 1), b = mean_of(column, row, 4, 2);
    assert_true(g > 1.5 * mean_of(column + 150, row, 4, 1));
    assert_true(b > r + 10 && g > r + 10);
}

// The far cube stands in the water: its top is seen above the horizon's water, and its foot, 2 m below, is not.
static void waves_stand_before_what_is_behind_them(void **state) {
    (void)state;
    int column, row;
    pixel_of(9.0, 57.0, 3.0, &column, &row);
    assert_true(mean_of(column, row, 1, 0) > 150 && mean_of(column, row, 1, 2) < 120); // yellow
    pixel_of(9.0, 57.0, -1.6, &column, &row);
    assert_true(mean_of(column, row, 1, 0) < mean_of(column, row, 1, 2) + 60); // water
    pixel_of(-7.0, 23.5, 5.0, &column, &row);
    assert_true(mean_of(column, row, 3, 1) > mean_of(column, row, 3, 0) + 40); // green, in the air
}

int main(void) {
    if (!make_picture()) {
        printf("skipped: no window here\n");
        return 77;
    }
    const struct CMUnitTest tests[] = {cmocka_unit_test(waterline_is_the_querys),
                                       cmocka_unit_test(the_cube_is_reflected_below_the_waterline),
                                       cmocka_unit_test(what_is_under_water_is_seen_and_tinted),
                                       cmocka_unit_test(waves_stand_before_what_is_behind_them)};
    return cmocka_run_group_tests_name("in your engine", tests, NULL, NULL);
}
