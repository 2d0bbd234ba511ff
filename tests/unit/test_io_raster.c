// SPDX-License-Identifier: MIT
// Terrain from rasters: places and distances on the ellipsoid, holes, seams, refusals. The rasters are ESRI text grids
// written here; distances are those of WGS 84 (one degree of latitude at the equator is 110574 m, of longitude 111320
// m).
#include "bolan/io.h"
#include "io_support.h"

enum { COLUMNS = 41, ROWS = 41 };

typedef double height_fn(double longitude, double latitude);

// COLUMNS x ROWS nodes around (longitude, latitude), @p step degrees apart; NAN is written as no-data.
static void write_grid(const char *path, int columns, int rows, double longitude, double latitude, double step,
                       height_fn *f) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    const double west = longitude - 0.5 * (columns - 1) * step, south = latitude - 0.5 * (rows - 1) * step;
    fprintf(file, "ncols %d\nnrows %d\nxllcenter %.10f\nyllcenter %.10f\ncellsize %.10f\nNODATA_value -9999\n", columns,
            rows, west, south, step);
    for (int j = rows - 1; j >= 0; j--) // north first
        for (int i = 0; i < columns; i++) {
            const double z = f(west + i * step, south + j * step);
            fprintf(file, "%.4f%c", isnan(z) ? -9999.0 : z, i + 1 < columns ? ' ' : '\n');
        }
    fclose(file);
}

static double slope_in_degrees(double longitude, double latitude) {
    return 1000.0 * longitude + 300.0 * latitude - 500.0;
}

static bolan_terrain *load(const char *path, double latitude, double longitude, double radius) {
    bolan_terrain *terrain = NULL;
    const bolan_result result = bolan_raster_load(path, latitude, longitude, radius, 1.0, &terrain);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    return terrain;
}

// At the scale of the grid, so that no detail is added below it.
static double height_at(const bolan_terrain *terrain, double x, double y) {
    return (double)bolan_terrain_elevation(terrain, x, y, bolan_terrain_get_extent(terrain).step);
}

static void test_a_degree_has_its_length(void **state) {
    (void)state;
    write_grid("plane.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, slope_in_degrees);
    bolan_terrain *t = load("plane.asc", 0.0, 0.0, 150e3);
    // The grid is a plane in degrees; over 1 degree it rises 1000 m to the east, 300 m to the north. 0.3 m is what the map's
    // curvature over a cell of 11 km leaves; on a sphere of the mean radius the figures would be off by 1.1 and 1.7 m.
    const double middle = height_at(t, 0, 0);
    assert_near(middle, -500.0, 0.3);
    assert_near(height_at(t, 111320.0, 0) - middle, 1000.0, 0.3);
    assert_near(height_at(t, 0, 110574.0) - middle, 300.0, 0.3);
    assert_near(height_at(t, -55660.0, 0) - middle, -500.0, 0.3);
    bolan_terrain_destroy(&t);
    remove("plane.asc");
}

static void test_at_60_north_a_degree_of_longitude_is_half_as_long(void **state) {
    (void)state;
    write_grid("north.asc", COLUMNS, ROWS, 10.0, 60.0, 0.05, slope_in_degrees);
    bolan_terrain *t = load("north.asc", (double)NAN, (double)NAN, 30e3);
    const bolan_terrain_extent e = bolan_terrain_get_extent(t);
    assert_near(e.west, -30e3, 1.0);
    // One degree of longitude at 60 N is 55800 m on WGS 84.
    const double rise = (height_at(t, 20e3, 0) - height_at(t, -20e3, 0)) / 40e3 * 55800.0;
    assert_near(rise, 1000.0, 5.0);
    bolan_terrain_destroy(&t);
    remove("north.asc");
}

static double ridge_at_the_date_line(double longitude, double latitude) {
    (void)latitude;
    const double d = fabs(longitude < 0.0 ? longitude + 360.0 : longitude) - 180.0;
    return 100.0 - 10.0 * d * d;
}

static void test_a_globe_has_no_seam(void **state) {
    (void)state;
    // Nodes -179.5 .. 179.5: the date line lies between the last column and the first.
    write_grid("globe.asc", 360, 181, 0.0, 0.0, 1.0, ridge_at_the_date_line);
    bolan_terrain *t = load("globe.asc", 0.0, 180.0, 500e3);
    assert_near(height_at(t, 111320.0, 0), 90.0, 3.0);
    assert_near(height_at(t, -111320.0, 0), 90.0, 3.0);
    assert_near(height_at(t, 222640.0, 0), 60.0, 3.0);
    bolan_terrain_destroy(&t);
    t = load("globe.asc", 0.0, -179.0, 500e3);
    assert_near(height_at(t, -222640.0, 0) - height_at(t, 0, 0), 0.0, 1.0); // 179 E and 179 W
    bolan_terrain_destroy(&t);
    remove("globe.asc");
}

static double plane_with_a_hole(double longitude, double latitude) {
    return fabs(longitude) < 0.35 && fabs(latitude) < 0.35 ? (double)NAN : -100.0 + 10.0 * longitude;
}

static void test_holes_take_the_height_around_them(void **state) {
    (void)state;
    write_grid("hole.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, plane_with_a_hole);
    bolan_terrain *t = load("hole.asc", 0.0, 0.0, 150e3);
    assert_near(height_at(t, 0, 0), -100.0, 5.0); // the plane there; without filling it would be -9999
    assert_true(bolan_terrain_get_extent(t).lowest > -200.0);
    bolan_terrain_destroy(&t);
    remove("hole.asc");
}

static double nothing_but_holes(double longitude, double latitude) {
    return (void)longitude, (void)latitude, (double)NAN;
}

static void test_refusals(void **state) {
    (void)state;
    bolan_terrain *t = NULL;
    const double nan = (double)NAN;
    assert_refusal(bolan_raster_load("none.tif", nan, nan, 1e4, 1, &t), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "none.tif: the raster cannot be read: No such file");
    write_text("not.tif", "this is no raster\n");
    assert_refusal(bolan_raster_load("not.tif", nan, nan, 1e4, 1, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_OPEN,
                   "not.tif: not a raster that GDAL reads");
    remove("not.tif");
    write_grid("plane.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, slope_in_degrees);
    assert_refusal(bolan_raster_load("plane.asc", 40, 50, 1e4, 1, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "lies outside the raster, which covers -2.05 to 2.05 north");
    assert_refusal(bolan_raster_load("plane.asc", 91, 0, 1e4, 1, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "latitude 91");
    assert_refusal(bolan_raster_load("plane.asc", nan, 3, 1e4, 1, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "latitude");
    assert_refusal(bolan_raster_load("plane.asc", 0, 0, nan, 1, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "radius");
    remove("plane.asc");
    write_grid("empty.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, nothing_but_holes);
    assert_refusal(bolan_raster_load("empty.asc", 0, 0, 1e4, 1, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_EMPTY,
                   "empty.asc: there is no elevation");
    remove("empty.asc");
    assert_null(t);
}

static void test_metres_without_a_projection_stay_metres(void **state) {
    (void)state;
    // 2 m cells far from the origin: no degrees. The slope is 1000 units a metre to the east, at a millimetre a unit.
    write_grid("metres.asc", COLUMNS, ROWS, 5000.0, 9000.0, 2.0, slope_in_degrees);
    bolan_terrain *t = NULL;
    assert_int_equal(bolan_raster_load("metres.asc", (double)NAN, (double)NAN, 1e4, 1e-3, &t), BOLAN_OK);
    assert_near(height_at(t, 20, 0) - height_at(t, -20, 0), 40.0, 0.5);
    assert_near(bolan_terrain_get_extent(t).west, -40.0, 1e-6); // the middles of the outer cells
    bolan_terrain_destroy(&t);
    assert_refusal(bolan_raster_load("metres.asc", 1, 2, 1e4, 1, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_PROJECTION,
                   "it has no map projection");
    remove("metres.asc");
}

static void test_hawaii(void **state) {
    (void)state;
    char path[1024];
    bolan_terrain *t = load(test_data("dem/hawaii_2min_int16.tif", path, sizeof path), 19.8206, -155.4681, 100e3);
    // Mauna Kea, 4207 m, on cells of 3.7 km.
    assert_true(height_at(t, 0, 0) > 3500.0);
    assert_true(height_at(t, 60e3, 60e3) < -1000.0);
    bolan_terrain_destroy(&t);
    t = load(path, 19.8206, 204.5319, 100e3); // the same place, counted to the east
    assert_true(height_at(t, 0, 0) > 3500.0);
    bolan_terrain_destroy(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_degree_has_its_length),
        cmocka_unit_test(test_at_60_north_a_degree_of_longitude_is_half_as_long),
        cmocka_unit_test(test_a_globe_has_no_seam),
        cmocka_unit_test(test_holes_take_the_height_around_them),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_metres_without_a_projection_stay_metres),
        cmocka_unit_test(test_hawaii),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
