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

static bolan_raster_desc desc_at(const char *path, double latitude, double longitude, double radius) {
    bolan_raster_desc d = bolan_raster_desc_default();
    snprintf(d.path, sizeof d.path, "%s", path);
    d.latitude = latitude, d.longitude = longitude, d.radius = radius;
    return d;
}

static bolan_result load_at(const char *path, double latitude, double longitude, double radius, bolan_ground **out) {
    const bolan_raster_desc d = desc_at(path, latitude, longitude, radius);
    return bolan_raster_load(&d, out);
}

static bolan_ground *load(const char *path, double latitude, double longitude, double radius) {
    bolan_ground *terrain = NULL;
    const bolan_result result = load_at(path, latitude, longitude, radius, &terrain);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    return terrain;
}

// At the scale of the grid, so that no detail is added below it.
static double height_at(const bolan_ground *terrain, double x, double y) {
    return (double)bolan_ground_elevation(terrain, x, y, bolan_ground_get_extent(terrain).step);
}

// A grid whose rows are not as its columns: a scale, an offset or an axis that is mixed up shows.
static double column_and_row(double longitude, double latitude) { return 3.0 * longitude - 7.0 * latitude; }

static void test_a_vertical_scale_multiplies_and_turns_over(void **state) {
    (void)state;
    write_grid("scale.asc", COLUMNS, ROWS, 5000.0, 9000.0, 2.0, column_and_row);
    bolan_ground *t = NULL;
    bolan_raster_desc d = desc_at("scale.asc", (double)NAN, (double)NAN, 1e4);
    const double factors[] = {0.1, -0.1, 0.04, -0.01};
    for (int n = 0; n < 4; n++) {
        d.vertical_scale = factors[n];
        assert_int_equal(bolan_raster_load(&d, &t), BOLAN_OK);
        // 15000 - 63000 in the middle; the text has four decimals, and the float of 4800 m half a millimetre.
        assert_near(height_at(t, 0, 0), -48000.0 * factors[n], 1e-3);
        assert_near(height_at(t, 20, 0) - height_at(t, 0, 0), 60.0 * factors[n], 2e-3);
        assert_near(height_at(t, 0, 20) - height_at(t, 0, 0), -140.0 * factors[n], 2e-3);
        bolan_ground_destroy(&t);
    }
    d.vertical_scale = 0.0005;
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "vertical scale 0.0005");
    d.vertical_scale = -1001.0;
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "vertical scale -1001");
    remove("scale.asc");
}

// 41 x 4 cells of 100 m, of which 1030 m to both sides are asked for: 21 steps of 98.1 m to the east, 3 of 100 to the
// north.
static void test_steps_to_the_east_and_to_the_north_differ(void **state) {
    (void)state;
    write_grid("steps.asc", 41, 4, 50e3, 9000.0, 100.0, column_and_row);
    bolan_ground *t = NULL;
    bolan_raster_desc d = desc_at("steps.asc", (double)NAN, (double)NAN, 1030.0);
    d.vertical_scale = 0.01;
    assert_int_equal(bolan_raster_load(&d, &t), BOLAN_OK);
    const bolan_ground_extent e = bolan_ground_get_extent(t);
    assert_near(e.east, 1030.0, 1e-6);
    assert_near(e.north, 150.0, 1e-6);
    assert_near(e.step, 100.0, 1e-6);
    // The plane, in floats of 870 m.
    assert_near(height_at(t, 0, 150) - height_at(t, 0, -150), -7.0 * 3.0, 1e-3);
    assert_near(height_at(t, 900, 0) - height_at(t, -900, 0), 3.0 * 18.0, 1e-3); // within the rim of cells
    bolan_ground_destroy(&t);
    remove("steps.asc");
}

static double rim_of_sea_and_land(double longitude, double latitude) {
    const bool south = latitude<9000.0 - 39.0, west = longitude<5000.0 - 39.0, east = longitude> 5000.0 + 39.0,
                                north = latitude> 9000.0 +
                       39.0;
    return south ? -60.0 : north ? 40.0 : west ? -20.0 : east ? -100.0 : 5.0;
}

static double plain(double longitude, double latitude) { return (void)longitude, (void)latitude, 7.0; }
static double shallow(double longitude, double latitude) { return (void)longitude, (void)latitude, -3.0; }

// Beyond the raster lies the mean depth of the rim's sea, land left out; at least 10 m, and 50 m where all is land.
static void test_the_depth_beyond_is_that_of_the_rim(void **state) {
    (void)state;
    static const struct {
        height_fn *f;
        double beyond;
    } cases[] = {
        {rim_of_sea_and_land, -(41.0 * 60.0 + 39.0 * 20.0 + 39.0 * 100.0) / 119.0}, {plain, -50.0}, {shallow, -10.0}};
    for (int n = 0; n < 3; n++) {
        write_grid("rim.asc", COLUMNS, ROWS, 5000.0, 9000.0, 2.0, cases[n].f);
        bolan_ground *t = load("rim.asc", (double)NAN, (double)NAN, 1e4);
        assert_near(height_at(t, 1e6, 0), cases[n].beyond, 1e-3); // float of 60
        assert_near(height_at(t, 0, -1e6), cases[n].beyond, 1e-3);
        bolan_ground_destroy(&t);
    }
    remove("rim.asc");
}

// Cells of 111 km, and 400 km asked for: the grid covers all of it, to the east and to the north too.
static void test_coarse_cells_cover_the_whole_area(void **state) {
    (void)state;
    write_grid("coarse.asc", 360, 181, 0.0, 0.0, 1.0, plain);
    bolan_ground *t = load("coarse.asc", 0.0, 0.0, 200e3);
    const bolan_ground_extent e = bolan_ground_get_extent(t);
    assert_near(e.west, -200e3, 1e-3);
    assert_near(e.east, 200e3, 1e-3);
    assert_near(e.south, -200e3, 1e-3);
    assert_near(e.north, 200e3, 1e-3);
    assert_near(e.step, 100e3, 1e-3); // four steps where 3.6 of the cells would do
    bolan_ground_destroy(&t);
    remove("coarse.asc");
}

static void test_a_degree_has_its_length(void **state) {
    (void)state;
    write_grid("plane.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, slope_in_degrees);
    bolan_ground *t = load("plane.asc", 0.0, 0.0, 150e3);
    // The grid is a plane in degrees; over 1 degree it rises 1000 m to the east, 300 m to the north. 0.3 m is what the
    // map's curvature over a cell of 11 km leaves; on a sphere of the mean radius the figures would be off by 1.1 and
    // 1.7 m.
    const double middle = height_at(t, 0, 0);
    assert_near(middle, -500.0, 0.3);
    assert_near(height_at(t, 111320.0, 0) - middle, 1000.0, 0.3);
    assert_near(height_at(t, 0, 110574.0) - middle, 300.0, 0.3);
    assert_near(height_at(t, -55660.0, 0) - middle, -500.0, 0.3);
    bolan_ground_destroy(&t);
    remove("plane.asc");
}

static double slope_from_10_east_60_north(double longitude, double latitude) {
    return slope_in_degrees(longitude - 10.0, latitude - 60.0);
}

static void test_at_60_north_a_degree_of_longitude_is_half_as_long(void **state) {
    (void)state;
    write_grid("north.asc", COLUMNS, ROWS, 10.0, 60.0, 0.05, slope_from_10_east_60_north);
    bolan_ground *t = load("north.asc", (double)NAN, (double)NAN, 30e3);
    const bolan_ground_extent e = bolan_ground_get_extent(t);
    assert_near(e.west, -30e3, 1.0);
    // One degree of longitude at 60 N is 55800 m on WGS 84.
    const double rise = (height_at(t, 20e3, 0) - height_at(t, -20e3, 0)) / 40e3 * 55800.0;
    assert_near(rise, 1000.0, 5.0);
    bolan_ground_destroy(&t);
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
    bolan_ground *t = load("globe.asc", 0.0, 180.0, 500e3);
    assert_near(height_at(t, 111320.0, 0), 90.0, 3.0);
    assert_near(height_at(t, -111320.0, 0), 90.0, 3.0);
    assert_near(height_at(t, 222640.0, 0), 60.0, 3.0);
    bolan_ground_destroy(&t);
    t = load("globe.asc", 0.0, -179.0, 500e3);
    assert_near(height_at(t, -222640.0, 0) - height_at(t, 0, 0), 0.0, 1.0); // 179 E and 179 W
    bolan_ground_destroy(&t);
    remove("globe.asc");
}

static double plane_with_a_hole(double longitude, double latitude) {
    return fabs(longitude) < 0.35 && fabs(latitude) < 0.35 ? (double)NAN : -100.0 + 10.0 * longitude;
}

static void test_holes_take_the_height_around_them(void **state) {
    (void)state;
    write_grid("hole.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, plane_with_a_hole);
    bolan_ground *t = load("hole.asc", 0.0, 0.0, 150e3);
    assert_near(height_at(t, 0, 0), -100.0, 5.0); // the plane there; without filling it would be -9999
    assert_true(bolan_ground_get_extent(t).lowest > -200.0);
    bolan_ground_destroy(&t);
    remove("hole.asc");
}

// A canal in land of 20 m, a cell wide: from the north to the middle, from there to the east and to the west, and at
// its ends north again and south. A pond beside it is not connected.
static double canals(double longitude, double latitude) {
    const double x = rint((longitude - 50e3) / 100.0), y = rint((latitude - 90e3) / 100.0);
    const bool stem = x == 0.0 && y >= 0.0, bar = y == 0.0 && fabs(x) <= 10.0;
    const bool up = x == 10.0 && y >= 0.0 && y <= 8.0, down = x == -10.0 && y <= 0.0 && y >= -8.0;
    const bool pond = x >= 4.0 && x <= 6.0 && y >= 4.0 && y <= 6.0;
    return stem || bar || up || down || pond ? (double)NAN : 20.0;
}

static void test_no_data_is_followed_from_the_rim_round_corners(void **state) {
    (void)state;
    write_grid("canals.asc", COLUMNS, ROWS, 50e3, 90e3, 100.0, canals);
    bolan_ground *t = load("canals.asc", (double)NAN, (double)NAN, 1e4);
    const double wet = -0.1 * cbrt(50.0 * 50.0); // half a cell from the land
    assert_near(height_at(t, 0, 1900), wet, 1e-4);
    assert_near(height_at(t, 1000, 700), wet, 1e-4);
    assert_near(height_at(t, -1000, -700), wet, 1e-4);
    assert_near(height_at(t, 500, 500), 20.0, 1e-4);
    bolan_ground_destroy(&t);
    remove("canals.asc");
}

static double nothing_but_holes(double longitude, double latitude) {
    return (void)longitude, (void)latitude, (double)NAN;
}

// Land of 20 m, 21 x 21 cells of 100 m; all around no-data, and a hole of no-data in its middle.
static double island_with_a_hole(double longitude, double latitude) {
    const double d = fmax(fabs(longitude - 50e3), fabs(latitude - 90e3));
    return d < 150.0 || d > 1050.0 ? (double)NAN : 20.0;
}

static bolan_ground *load_nodata(const char *path, bolan_raster_nodata nodata, bolan_raster_zero zero) {
    bolan_ground *t = NULL;
    bolan_raster_desc d = desc_at(path, (double)NAN, (double)NAN, 1e4);
    d.nodata = nodata, d.zero = zero;
    assert_int_equal(bolan_raster_load(&d, &t), BOLAN_OK);
    return t;
}

// Dean 1991: 0.1 m^(1/3) distance^(2/3); the coast lies half a cell beyond the last cell with data, at 1050 m.
static double dean(double from_middle) { return -0.1 * cbrt((from_middle - 1050.0) * (from_middle - 1050.0)); }

static void check_sea_around(const bolan_ground *t, double east, double north) {
    for (double d = 1300.0; d < 1950.0; d += 100.0) assert_near(height_at(t, d * east, d * north), dean(d), 1e-4);
}

static void test_no_data_around_land_is_sea_and_within_it_land(void **state) {
    (void)state;
    write_grid("isle.asc", COLUMNS, ROWS, 50e3, 90e3, 100.0, island_with_a_hole);
    bolan_ground *t = load_nodata("isle.asc", BOLAN_NODATA_AUTO, BOLAN_ZERO_AUTO);
    assert_near(height_at(t, 0, 0), 20.0, 1e-4);
    assert_near(height_at(t, 1000, 0), 20.0, 1e-4);
    check_sea_around(t, 1, 0), check_sea_around(t, -1, 0), check_sea_around(t, 0, 1), check_sea_around(t, 0, -1);
    // At a corner the way to the land is the diagonal, not the sum nor the longer of both.
    assert_near(height_at(t, 1400, 1300), dean(1000.0 + hypot(400.0, 300.0)), 1e-4);
    assert_near(height_at(t, -1300, -1900), dean(1000.0 + hypot(300.0, 900.0)), 1e-4);
    bolan_ground_destroy(&t);
    t = load_nodata("isle.asc", BOLAN_NODATA_FILL, BOLAN_ZERO_AUTO);
    assert_near(height_at(t, 1900, -1700), 20.0, 1e-4);
    bolan_ground_destroy(&t);
    t = load_nodata("isle.asc", BOLAN_NODATA_SEA, BOLAN_ZERO_AUTO);
    assert_near(height_at(t, 0, 0), -0.1 * cbrt(150.0 * 150.0), 1e-4); // 200 m to the data
    check_sea_around(t, 1, 0);
    bolan_ground_destroy(&t);
    remove("isle.asc");
}

// The same island, where the sea is 0 and not no-data.
static double island_in_zeros(double longitude, double latitude) {
    const double z = island_with_a_hole(longitude, latitude);
    return isnan(z) ? 0.0 : z;
}

static void test_zero_is_sea_where_it_is_said(void **state) {
    (void)state;
    write_grid("zeros.asc", COLUMNS, ROWS, 50e3, 90e3, 100.0, island_in_zeros);
    bolan_ground *t = load_nodata("zeros.asc", BOLAN_NODATA_AUTO, BOLAN_ZERO_SEA);
    check_sea_around(t, 1, 0), check_sea_around(t, 0, -1);
    assert_near(height_at(t, 1000, -1000), 20.0, 1e-4);
    bolan_ground_destroy(&t);
    t = load_nodata("zeros.asc", BOLAN_NODATA_AUTO, BOLAN_ZERO_LAND);
    assert_near(height_at(t, 1900, 0), 0.0, 0.0);
    bolan_ground_destroy(&t);
    remove("zeros.asc");
}

// A hole in the survey of a deep sea, at its rim: as deep as the sea around it, no shelf.
static double deep_with_a_corner_missing(double longitude, double latitude) {
    return longitude > 51e3 && latitude > 91e3 ? (double)NAN : -300.0;
}

static void test_a_hole_in_deep_water_stays_deep(void **state) {
    (void)state;
    write_grid("deep.asc", COLUMNS, ROWS, 50e3, 90e3, 100.0, deep_with_a_corner_missing);
    bolan_ground *t = load_nodata("deep.asc", BOLAN_NODATA_AUTO, BOLAN_ZERO_AUTO);
    assert_near(bolan_ground_get_extent(t).highest, -300.0, 1e-3);
    bolan_ground_destroy(&t);
    remove("deep.asc");
    // Open water only, where the sea is said to be no-data: the shelf.
    write_grid("deep.asc", COLUMNS, ROWS, 50e3, 90e3, 100.0, nothing_but_holes);
    t = load_nodata("deep.asc", BOLAN_NODATA_SEA, BOLAN_ZERO_AUTO);
    assert_near(bolan_ground_get_extent(t).highest, -50.0, 0.0);
    bolan_ground_destroy(&t);
    remove("deep.asc");
}

static void test_refusals(void **state) {
    (void)state;
    bolan_ground *t = NULL;
    const double nan = (double)NAN;
    assert_refusal(load_at("none.tif", nan, nan, 1e4, &t), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "none.tif: the raster cannot be read: No such file");
    write_text("not.tif", "this is no raster\n");
    assert_refusal(load_at("not.tif", nan, nan, 1e4, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_OPEN,
                   "not.tif: not a raster that GDAL reads");
    remove("not.tif");
    write_grid("plane.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, slope_in_degrees);
    assert_refusal(load_at("plane.asc", 40, 50, 1e4, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE,
                   "lies outside the raster, which covers -2.05 to 2.05 north");
    assert_refusal(load_at("plane.asc", 91, 0, 1e4, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "latitude 91");
    assert_refusal(load_at("plane.asc", nan, 3, 1e4, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "latitude");
    assert_refusal(load_at("plane.asc", 0, 0, nan, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "radius");
    remove("plane.asc");
    write_grid("empty.asc", COLUMNS, ROWS, 0.0, 0.0, 0.1, nothing_but_holes);
    assert_refusal(load_at("empty.asc", 0, 0, 1e4, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_EMPTY,
                   "empty.asc: there is no elevation");
    remove("empty.asc");
    assert_null(t);
}

static void test_metres_without_a_projection_stay_metres(void **state) {
    (void)state;
    // 2 m cells far from the origin: no degrees. The slope is 1000 units a metre to the east, at a millimetre a unit.
    write_grid("metres.asc", COLUMNS, ROWS, 5000.0, 9000.0, 2.0, slope_in_degrees);
    bolan_ground *t = NULL;
    bolan_raster_desc d = desc_at("metres.asc", (double)NAN, (double)NAN, 1e4);
    d.vertical_scale = 1e-3;
    assert_int_equal(bolan_raster_load(&d, &t), BOLAN_OK);
    assert_near(height_at(t, 20, 0) - height_at(t, -20, 0), 40.0, 0.5);
    assert_near(bolan_ground_get_extent(t).west, -40.0, 1e-6); // the middles of the outer cells
    bolan_ground_destroy(&t);
    assert_refusal(load_at("metres.asc", 1, 2, 1e4, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_PROJECTION,
                   "it has no map projection");
    remove("metres.asc");
}

static void test_hawaii(void **state) {
    (void)state;
    char path[1024];
    bolan_ground *t = load(test_data("dem/hawaii_2min_int16.tif", path, sizeof path), 19.8206, -155.4681, 100e3);
    // Mauna Kea, 4207 m, on cells of 3.7 km.
    assert_true(height_at(t, 0, 0) > 3500.0);
    assert_true(height_at(t, 60e3, 60e3) < -1000.0);
    bolan_ground_destroy(&t);
    t = load(path, 19.8206, 204.5319, 100e3); // the same place, counted to the east
    assert_true(height_at(t, 0, 0) > 3500.0);
    bolan_ground_destroy(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_vertical_scale_multiplies_and_turns_over),
        cmocka_unit_test(test_steps_to_the_east_and_to_the_north_differ),
        cmocka_unit_test(test_the_depth_beyond_is_that_of_the_rim),
        cmocka_unit_test(test_coarse_cells_cover_the_whole_area),
        cmocka_unit_test(test_no_data_around_land_is_sea_and_within_it_land),
        cmocka_unit_test(test_zero_is_sea_where_it_is_said),
        cmocka_unit_test(test_no_data_is_followed_from_the_rim_round_corners),
        cmocka_unit_test(test_a_hole_in_deep_water_stays_deep),
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
