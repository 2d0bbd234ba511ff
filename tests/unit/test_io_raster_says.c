// SPDX-License-Identifier: MIT
// What a raster says of itself: unit, direction, scale, band, variable, mask, voids, coordinates; and what overrules
// it. Most are GDAL's VRT texts over tests/data/rasters/base.tif: a cone of 92.93 m (92.9289 in its float) on a plain
// at -200 m.
#include "bolan/io.h"
#include "io_support.h"

enum { MOST_WARNINGS = 8 };
static bolan_log_id warning_ids[MOST_WARNINGS];
static char warnings[MOST_WARNINGS][512], information[512];
static int warning_count;

static void keep(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    remember(user, level, id, sentence);
    if (level == BOLAN_LOG_INFO) snprintf(information, sizeof information, "%s", sentence);
    if (level != BOLAN_LOG_WARNING || warning_count == MOST_WARNINGS) return;
    warning_ids[warning_count] = id;
    snprintf(warnings[warning_count++], sizeof *warnings, "%s", sentence);
}

static int listen(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.log = keep});
    return 0;
}

static bolan_raster_desc desc_of(const char *path) {
    bolan_raster_desc d = bolan_raster_desc_default();
    snprintf(d.path, sizeof d.path, "%s", path);
    d.radius = 20e3;
    return d;
}

// A file of tests/data/rasters.
static bolan_raster_desc data_desc(const char *name) {
    char path[1024], below[256];
    snprintf(below, sizeof below, "rasters/%s", name);
    return desc_of(test_data(below, path, sizeof path));
}

static bolan_ground *load(const bolan_raster_desc *d) {
    bolan_ground *t = NULL;
    warning_count = 0;
    const bolan_result result = bolan_raster_load(d, &t);
    if (result) print_error("%s\n", last_sentence);
    assert_int_equal(result, BOLAN_OK);
    return t;
}

static double middle_of(const bolan_ground *t) {
    return (double)bolan_ground_elevation(t, 0, 0, bolan_ground_get_extent(t).step);
}

// The lowest and the highest value and that in the middle; @p within: what the numbers of the file are rounded to.
static void check_heights(const bolan_raster_desc *d, double low, double high, double middle, double within) {
    bolan_ground *t = load(d);
    const bolan_ground_extent e = bolan_ground_get_extent(t);
    assert_near(e.lowest, low, within);
    assert_near(e.highest, high, within);
    assert_near(middle_of(t), middle, within);
    bolan_ground_destroy(&t);
}

static void check_cone(const bolan_raster_desc *d, double within) {
    check_heights(d, -200.0, 92.9289, 92.9289, within);
}

static void expect_warning(bolan_log_id id, const char *words) {
    const bool good = warning_count == 1 && warning_ids[0] == id && strstr(warnings[0], words);
    for (int i = 0; !good && i < warning_count; i++) print_error("%d %s\n", (int)warning_ids[i], warnings[i]);
    if (!good) print_error("expected one warning, %d, \"%s\"\n", (int)id, words);
    assert_true(good);
}

static void expect_no_warning(void) {
    for (int i = 0; i < warning_count; i++) print_error("%d %s\n", (int)warning_ids[i], warnings[i]);
    assert_int_equal(warning_count, 0);
}

// A VRT of one band over base.tif, with its own CRS and more in the band and its source.
static void write_vrt_in(const char *path, const char *crs, const char *in_band, const char *in_source) {
    char text[4096], base[1024];
    snprintf(text, sizeof text,
             "<VRTDataset rasterXSize=\"60\" rasterYSize=\"60\">%s"
             "<VRTRasterBand dataType=\"Float32\" band=\"1\">%s<ComplexSource>"
             "<SourceFilename>%s</SourceFilename><SourceBand>1</SourceBand>%s</ComplexSource></VRTRasterBand>"
             "</VRTDataset>",
             crs, in_band, test_data("rasters/base.tif", base, sizeof base), in_source);
    write_text(path, text);
}

#define IN_HAWAII "<GeoTransform>-156, 0.0016666666666667, 0, 19.5, 0, -0.0016666666666667</GeoTransform>"

static void write_vrt(const char *path, const char *in_band, const char *in_source) {
    write_vrt_in(path, "<SRS>EPSG:4326</SRS>" IN_HAWAII, in_band, in_source);
}

// Two bands over base.tif, the first of them twice as high.
static void write_bands(const char *path, const char *in_first, const char *in_second) {
    char text[4096], base[1024];
    test_data("rasters/base.tif", base, sizeof base);
    snprintf(text, sizeof text,
             "<VRTDataset rasterXSize=\"60\" rasterYSize=\"60\"><SRS>EPSG:4326</SRS>" IN_HAWAII
             "<VRTRasterBand dataType=\"Float32\" band=\"1\">%s<ComplexSource><SourceFilename>%s</SourceFilename>"
             "<SourceBand>1</SourceBand><ScaleRatio>2</ScaleRatio></ComplexSource></VRTRasterBand>"
             "<VRTRasterBand dataType=\"Float32\" band=\"2\">%s<SimpleSource><SourceFilename>%s</SourceFilename>"
             "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>",
             in_first, base, in_second, base);
    write_text(path, text);
}

// ---- unit, direction, scale -----------------------------------------------------------------------------------------

static void test_the_plain_raster(void **state) {
    (void)state;
    const bolan_raster_desc d = data_desc("base.tif");
    check_cone(&d, 1e-4);
    expect_no_warning();
    assert_non_null(strstr(information, "base.tif: band 1, unit \"none\" at 1 m upwards, in WGS 84, 61x64 elevations"));
    bolan_ground *t = load(&d);
    // 59 of the 60 cells of 1/600 degree lie between the middles: WGS 84 at 19.45 degrees north.
    assert_near(bolan_ground_get_extent(t).east, 0.5 * 59.0 / 600.0 * 105021.0, 15.0);
    assert_near(bolan_ground_get_extent(t).north, 0.5 * 59.0 / 600.0 * 110696.0, 15.0);
    bolan_ground_destroy(&t);
}

static void test_units(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("usft.tif");
    check_cone(&d, 1e-3);
    expect_no_warning();
    d = data_desc("cm.nc");
    check_cone(&d, 1e-3);
    expect_no_warning();
    static const struct {
        const char *unit;
        double metres;
    } units[] = {{"ft", 0.3048},
                 {"Foot", 0.3048},
                 {"US survey foot", 1200.0 / 3937.0},
                 {"dm", 0.1},
                 {"centimeters", 0.01},
                 {"m", 1.0},
                 {"fathoms", 1.8288},
                 {"fathom", 1.8288},
                 {"metres above sea level", 1.0},
                 {"US_survey_foot", 1200.0 / 3937.0},
                 {"yd", 0.9144},
                 {"inch", 0.0254},
                 {"mm", 0.001}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        char band[128];
        snprintf(band, sizeof band, "<UnitType>%s</UnitType>", units[i].unit);
        write_vrt("unit.vrt", band, "");
        d = desc_of("unit.vrt");
        check_heights(&d, -200.0 * units[i].metres, 92.9289 * units[i].metres, 92.9289 * units[i].metres, 1e-4);
        bolan_ground *t = load(&d); // a US foot is 2e-6 longer than a foot: floats of 61 m tell them apart
        assert_near(bolan_ground_get_extent(t).lowest, -200.0 * units[i].metres, 1.6e-5);
        bolan_ground_destroy(&t);
        expect_no_warning();
    }
    write_vrt("unit.vrt", "<UnitType>kelvin</UnitType>", "");
    check_cone(&d, 1e-4);
    expect_warning(BOLAN_LOG_RASTER_UNIT, "its unit is \"kelvin\", which is no known unit of length");
    d.vertical_scale = 2.0; // says what the unit cannot
    check_heights(&d, -400.0, 185.8578, 185.8578, 2e-4);
    expect_no_warning();
    // Unit of the vertical part of the CRS (EPSG:6360, NAVD88 height in US survey feet), and a depth (EPSG:5715).
    write_vrt_in("unit.vrt", "<SRS>EPSG:4326+6360</SRS>" IN_HAWAII, "", "");
    d = desc_of("unit.vrt");
    check_heights(&d, -200.0 * 1200.0 / 3937.0, 92.9289 * 1200.0 / 3937.0, 92.9289 * 1200.0 / 3937.0, 1e-4);
    write_vrt_in("unit.vrt", "<SRS>EPSG:4326+5715</SRS>" IN_HAWAII, "", "");
    check_heights(&d, -92.9289, 200.0, -92.9289, 1e-4);
    remove("unit.vrt");
}

static void test_depths_are_turned_over(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("depth.nc");
    check_cone(&d, 1e-4);
    expect_no_warning();
    d.vertical_scale = 1.0; // the file is overruled
    check_heights(&d, -92.9289, 200.0, -92.9289, 1e-4);
    d.vertical_scale = -2.0;
    check_heights(&d, -400.0, 185.8578, 185.8578, 2e-4);
    static const struct {
        const char *metadata;
        bool down;
    } said[] = {
        {"<MDI key=\"positive\">down</MDI>", true},
        {"<MDI key=\"positive\">up</MDI><MDI key=\"NETCDF_VARNAME\">depth</MDI>", false},
        {"<MDI key=\"standard_name\">sea_floor_depth_below_mean_sea_level</MDI>", true},
        {"<MDI key=\"standard_name\">sea_floor_depth_below_geoid</MDI><MDI key=\"positive\">up</MDI>", false},
        {"<MDI key=\"NETCDF_VARNAME\">h</MDI><MDI key=\"long_name\">bathymetry at RHO-points</MDI>", true},
        {"<MDI key=\"standard_name\">height_above_mean_sea_level</MDI>", false},
        {"<MDI key=\"NETCDF_VARNAME\">elevation</MDI>", false},
    };
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        char band[256];
        snprintf(band, sizeof band, "<Metadata>%s</Metadata>", said[i].metadata);
        write_vrt("down.vrt", band, "");
        d = desc_of("down.vrt");
        check_heights(&d, said[i].down ? -92.9289 : -200.0, said[i].down ? 200.0 : 92.9289,
                      said[i].down ? -92.9289 : 92.9289, 1e-4);
        expect_no_warning();
    }
    // Called a depth and no more: by the sign of most values, which are negative here, and positive below.
    write_vrt("down.vrt", "<Description>depth</Description>", "");
    check_cone(&d, 1e-4);
    expect_no_warning();
    write_vrt("down.vrt", "<Description>Depth</Description>", "<ScaleRatio>-1</ScaleRatio>");
    check_cone(&d, 1e-4);
    expect_warning(BOLAN_LOG_RASTER_UNIT, "Depth is called a depth and is mostly positive");
    remove("down.vrt");
}

static void test_scale_and_offset_of_the_file(void **state) {
    (void)state;
    write_vrt("scaled.vrt", "<Offset>30</Offset><Scale>0.5</Scale>", "");
    bolan_raster_desc d = desc_of("scaled.vrt");
    check_heights(&d, -70.0, 92.9289 * 0.5 + 30.0, 92.9289 * 0.5 + 30.0, 1e-4); // value * scale + offset
    write_vrt("scaled.vrt", "<Offset>-100</Offset>", "");
    check_heights(&d, -300.0, -7.0711, -7.0711, 1e-4);
    write_vrt("scaled.vrt", "<Offset>1000</Offset><Scale>2</Scale><UnitType>ft</UnitType>", ""); // then the unit
    check_heights(&d, 600.0 * 0.3048, (185.8578 + 1000.0) * 0.3048, (185.8578 + 1000.0) * 0.3048, 2e-4);
    d.vertical_scale = -0.1;
    check_heights(&d, -118.58578, -60.0, -118.58578, 1e-4);
    remove("scaled.vrt");
    d = data_desc("scaled.tif"); // hundredths of a metre over -100 m in 16 bits
    check_cone(&d, 6e-3);
    expect_no_warning();
}

// Latitudes 0.01 degrees apart in the south and up to 0.06 in the north: GDAL lays them out evenly and warns.
static void test_what_gdal_warns_of_is_handed_on(void **state) {
    (void)state;
    const bolan_raster_desc d = data_desc("irreg.nc");
    bolan_ground *t = load(&d);
    expect_warning(BOLAN_LOG_RASTER_LIBRARY, "irreg.nc: GDAL warns: Latitude grid not spaced evenly");
    bolan_ground_destroy(&t);
}

// ---- variables and bands --------------------------------------------------------------------------------------------

static void test_the_variable_that_is_an_elevation(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("multi.nc");
    bolan_ground *t = NULL;
    check_cone(&d, 1e-4);
    expect_no_warning();
    assert_non_null(strstr(information, "band 1 z, unit \"m\""));
    snprintf(d.variable, sizeof d.variable, "z");
    check_cone(&d, 1e-4);
    snprintf(d.variable, sizeof d.variable, "Interpolation_Flag");
    check_heights(&d, 0.0, 1.0, 1.0, 0.0);
    snprintf(d.variable, sizeof d.variable, "zz");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_CHOICE,
                   "it has no such variable; expected one of: 1 interpolation_flag, 2 z");
    d = data_desc("depth.nc"); // one variable, which has another name
    snprintf(d.variable, sizeof d.variable, "z");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_CHOICE, "it has: 1 depth");
    char path[1024];
    snprintf(path, sizeof path, "NETCDF:\"%s/tests/data/rasters/multi.nc\":z", BOLAN_SOURCE_DIR);
    d = desc_of(path);
    check_cone(&d, 1e-4);
    snprintf(path, sizeof path, "NETCDF:%s/tests/data/rasters/none.nc:z", BOLAN_SOURCE_DIR);
    d = desc_of(path);
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN, "No such file");
}

static void test_a_scene_names_a_variable_beside_it(void **state) {
    (void)state;
    char path[1024];
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load(test_data("rasters/sub.yaml", path, sizeof path), &scene), BOLAN_OK);
    scene.terrain.raster.radius = 20e3;
    assert_int_equal(bolan_world_load_scene(&scene, &world), BOLAN_OK);
    assert_near(bolan_ground_get_extent(bolan_world_water(world)->ground).highest, 92.9289, 1e-4);
    bolan_world_destroy(&world);
    static const struct {
        const char *written, *read;
    } names[] = {
        {"NETCDF:f.nc:z", "NETCDF:./f.nc:z"},
        {"'NETCDF:\"f.nc\":z'", "NETCDF:\"./f.nc\":z"},
        {"'NETCDF:\"/a/f.nc\":z'", "NETCDF:\"/a/f.nc\":z"},
        {"NETCDF:/a/f.nc:z", "NETCDF:/a/f.nc:z"},
        {"HDF5:f.h5://a/b", "HDF5:./f.h5://a/b"},
        {"GTIFF_DIR:2:f.tif", "GTIFF_DIR:2:./f.tif"},
        {"GTIFF_DIR:off:408:f.tif", "GTIFF_DIR:off:408:./f.tif"},
        {"GTIFF_DIR:2:/f.tif", "GTIFF_DIR:2:/f.tif"},
        {"/vsizip/a.zip/f.tif", "/vsizip/a.zip/f.tif"},
        {"f:1.tif", "./f:1.tif"},
        {"a/f.tif", "./a/f.tif"},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char text[256];
        snprintf(text, sizeof text, "terrain:\n  raster:\n    file: %s\n", names[i].written);
        write_text("named.yaml", text);
        assert_int_equal(bolan_scene_load("./named.yaml", &scene), BOLAN_OK);
        assert_string_equal(scene.terrain.raster.path, names[i].read);
    }
    remove("named.yaml");
}

static void test_the_band_that_is_an_elevation(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("twoband.tif");
    bolan_ground *t = NULL;
    check_cone(&d, 1e-4);
    assert_non_null(strstr(information, "band 2 elevation"));
    d.band = 1;
    check_heights(&d, 0.3, 0.3, 0.3, 1e-6);
    d.band = 2;
    check_cone(&d, 1e-4);
    d.band = 3;
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_CHOICE,
                   "it has no band 3; expected 1 to 2");
    d.band = 0;
    snprintf(d.variable, sizeof d.variable, "uncertainty");
    check_heights(&d, 0.3, 0.3, 0.3, 1e-6);
    d.variable[0] = '\0';
    // Two bands that say nothing of themselves, or are colours.
    static const char *const said[] = {"<ColorInterp>Undefined</ColorInterp>", "<ColorInterp>Red</ColorInterp>"};
    static const char *const sentences[] = {"choose with band: 1, 2", "its bands are colours"};
    for (int i = 0; i < 2; i++) {
        write_bands("bands.vrt", said[i], "");
        d = desc_of("bands.vrt");
        assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_CHOICE, sentences[i]);
        d.band = 1;
        check_heights(&d, -400.0, 185.8578, 185.8578, 2e-4);
    }
    // The second is the elevation, whatever the first is called.
    static const char *const others[] = {"elevation_error", "depth uncertainty", "TID", "temperature",
                                         "source_elevation"};
    for (int i = 0; i < 5; i++) {
        char first[128];
        snprintf(first, sizeof first, "<Description>%s</Description>", others[i]);
        write_bands("bands.vrt", first, "<Description>Elevation</Description>");
        d = desc_of("bands.vrt");
        check_cone(&d, 1e-4);
    }
    write_bands("bands.vrt", "<Description>error of elevation</Description>",
                "<Description>ground elevation</Description>");
    check_cone(&d, 1e-4);
    write_bands("bands.vrt", "<Description>elevation</Description><UnitType>K</UnitType>", "<UnitType>m</UnitType>");
    check_cone(&d, 1e-4);
    write_bands("bands.vrt", "<Description>elevation</Description>", "<Description>height</Description>");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_CHOICE,
                   "choose with band: 1 elevation, 2 height");
    remove("bands.vrt");
}

// ---- holes ----------------------------------------------------------------------------------------------------------

static void test_masks_and_voids_are_holes(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("mask.tif");
    check_cone(&d, 1e-4);
    expect_warning(BOLAN_LOG_RASTER_HOLES, "11.1 % of its samples are no-data");
    d.nodata = BOLAN_NODATA_FILL;
    check_cone(&d, 1e-4);
    expect_no_warning();
    d = data_desc("void_undeclared.tif"); // whole metres
    d.nodata = BOLAN_NODATA_FILL;
    check_heights(&d, -200.0, 93.0, 93.0, 0.0);
    expect_warning(BOLAN_LOG_RASTER_VALUES, "400 samples are below -12000 m");
    d.nodata_value = -32768.0;
    check_heights(&d, -200.0, 93.0, 93.0, 0.0);
    expect_no_warning();
    // What is too high, a lone -9999, and a value that only the caller knows.
    write_vrt("void.vrt", "", "<LUT>-200:9001,-199.999:-199.999,93:93</LUT>");
    d = desc_of("void.vrt");
    d.nodata = BOLAN_NODATA_FILL;
    bolan_ground *t = load(&d);
    assert_true(bolan_ground_get_extent(t).highest < 93.0);
    expect_warning(BOLAN_LOG_RASTER_VALUES, "below -12000 m, above 9000 m");
    bolan_ground_destroy(&t);
    write_vrt("void.vrt", "", "<LUT>-200:-9999,-199.999:-199.999,93:93</LUT>");
    t = load(&d);
    assert_true(bolan_ground_get_extent(t).lowest > -200.0);
    expect_warning(BOLAN_LOG_RASTER_VALUES, "a lone -9999");
    bolan_ground_destroy(&t);
    write_vrt("void.vrt", "", "<LUT>-200:-77,-199.999:-199.999,93:93</LUT>");
    t = load(&d);
    assert_true(bolan_ground_get_extent(t).lowest < -100.0);
    const double with_it = middle_of(t), rim = (double)bolan_ground_elevation(t, -5000, -5000, 200);
    assert_near(rim, -77.0, 1e-3);
    bolan_ground_destroy(&t);
    d.nodata_value = -77.0;
    t = load(&d);
    assert_near(middle_of(t), with_it, 1e-4);
    assert_true(fabs((double)bolan_ground_elevation(t, -5000, -5000, 200) + 77.0) > 50.0);
    bolan_ground_destroy(&t);
    remove("void.vrt");
}

static void test_land_only_elevations(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("landonly.tif");
    bolan_ground *t = load(&d);
    expect_warning(BOLAN_LOG_RASTER_HOLES, "91.2 % reach the rim and become sea");
    assert_near(middle_of(t), 92.9289, 1e-4);
    const double places[4][2] = {{4000, 0}, {-4000, 0}, {0, 4000}, {0, -4000}};
    for (int i = 0; i < 4; i++) {
        const double z = (double)bolan_ground_elevation(t, places[i][0], places[i][1], 200);
        // 317 cells of 0.175 x 0.184 km are land, a radius of 1.8 km: Dean's profile 2.2 km out, give or take a cell.
        assert_near(z, -0.1 * cbrt(2200.0 * 2200.0), 0.9);
    }
    bolan_ground_destroy(&t);
    d.nodata = BOLAN_NODATA_FILL;
    t = load(&d);
    expect_no_warning();
    assert_true(bolan_ground_get_extent(t).lowest > 0.0);
    bolan_ground_destroy(&t);
    d = data_desc("sea0.tif");
    t = load(&d);
    expect_warning(BOLAN_LOG_RASTER_VALUES, "91 % of its elevations are exactly 0");
    assert_near(bolan_ground_get_extent(t).lowest, 0.0, 0.0);
    bolan_ground_destroy(&t);
    d.zero = BOLAN_ZERO_SEA;
    t = load(&d);
    expect_no_warning();
    assert_near(bolan_ground_elevation(t, 0, -4000, 200), -0.1 * cbrt(2200.0 * 2200.0), 0.9);
    bolan_ground_destroy(&t);
}

// Cells that are twice as wide as they are high: the bed falls off by metres, not by cells.
static void test_the_bed_falls_off_in_metres(void **state) {
    (void)state;
    char text[2048], base[1024];
    snprintf(text, sizeof text,
             "<VRTDataset rasterXSize=\"60\" rasterYSize=\"60\"><GeoTransform>9000, 100, 0, 9000, 0, -50</GeoTransform>"
             "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename>%s</SourceFilename>"
             "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>",
             test_data("rasters/sea0.tif", base, sizeof base));
    write_text("wide.vrt", text);
    bolan_raster_desc d = desc_of("wide.vrt");
    snprintf(d.crs, sizeof d.crs, "metres");
    d.zero = BOLAN_ZERO_SEA;
    bolan_ground *t = load(&d);
    // The land reaches 10 cells: 1000 m east, 500 m north. Give or take a cell.
    assert_near(bolan_ground_elevation(t, 2500, 0, 50), -0.1 * cbrt(1500.0 * 1500.0), 0.6);
    assert_near(bolan_ground_elevation(t, 0, 1250, 50), -0.1 * cbrt(750.0 * 750.0), 0.4);
    bolan_ground_destroy(&t);
    remove("wide.vrt");
}

// ---- coordinates ----------------------------------------------------------------------------------------------------

static void check_size(const bolan_raster_desc *d, double side, double within) {
    bolan_ground *t = load(d);
    const bolan_ground_extent e = bolan_ground_get_extent(t);
    assert_near(e.east - e.west, side, within);
    assert_near(e.north - e.south, side, within);
    assert_near(middle_of(t), 92.93, 2e-3);
    bolan_ground_destroy(&t);
}

static void test_coordinates_that_are_metres(void **state) {
    (void)state;
    bolan_raster_desc d = data_desc("small_local.asc");
    check_size(&d, 59.0, 1e-6);
    expect_warning(BOLAN_LOG_RASTER_CRS, "it has no CRS, and by its numbers they are taken as metres");
    snprintf(d.crs, sizeof d.crs, "metres");
    check_size(&d, 59.0, 1e-6);
    expect_no_warning();
    snprintf(d.crs, sizeof d.crs, "EPSG:32604"); // far west of its zone, where the scale of the map is 1.02
    check_size(&d, 59.0, 1.5);
    expect_no_warning();
    snprintf(d.crs, sizeof d.crs, "degrees");
    bolan_ground *t = load(&d);
    assert_true(bolan_ground_get_extent(t).step > 10e3);
    bolan_ground_destroy(&t);
    snprintf(d.crs, sizeof d.crs, "/etc/hostname");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_PROJECTION,
                   "there is no CRS \"/etc/hostname\"; expected metres, degrees");
    d = data_desc("local_cs.tif");
    check_size(&d, 590.0, 1e-6);
    expect_no_warning();
    // The same in feet: LOCAL_CS with another unit.
    write_vrt_in("local.vrt",
                 "<SRS>LOCAL_CS[\"Site\",UNIT[\"foot\",0.3048]]</SRS>"
                 "<GeoTransform>1000, 10, 0, 2000, 0, -10</GeoTransform>",
                 "", "");
    d = desc_of("local.vrt");
    check_size(&d, 590.0 * 0.3048, 1e-6);
    // Fine steps without a CRS are degrees: of a cell in Hawaii.
    write_vrt_in("local.vrt", IN_HAWAII, "", "");
    t = load(&d);
    expect_warning(BOLAN_LOG_RASTER_CRS, "they are taken as degrees");
    assert_near(bolan_ground_get_extent(t).north, 5443.0, 15.0);
    bolan_ground_destroy(&t);
    remove("local.vrt");
}

static bolan_result load_land_only(void) {
    bolan_ground *t = NULL;
    const bolan_raster_desc d = data_desc("landonly.tif");
    const bolan_result result = bolan_raster_load(&d, &t);
    assert_true((result == BOLAN_OK) == (t != NULL));
    bolan_ground_destroy(&t);
    return result;
}

static bolan_result load_filled(void) {
    bolan_ground *t = NULL;
    bolan_raster_desc d = data_desc("mask.tif");
    d.nodata = BOLAN_NODATA_FILL;
    const bolan_result result = bolan_raster_load(&d, &t);
    bolan_ground_destroy(&t);
    return result;
}

static void test_memory_that_runs_out_is_called_so(void **state) {
    (void)state;
    assert_memory_failures(load_land_only);
    assert_memory_failures(load_filled);
    listen(NULL);
}

static void test_what_is_no_raster(void **state) {
    (void)state;
    bolan_ground *t = NULL;
    FILE *file = fopen("packed.zip", "wb");
    assert_non_null(file);
    fwrite("PK\3\4 and more", 1, 13, file);
    fclose(file);
    bolan_raster_desc d = desc_of("packed.zip");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_FORMAT, BOLAN_LOG_RASTER_OPEN,
                   "it is a zip archive; name a raster in it, as in /vsizip/packed.zip/NAME");
    remove("packed.zip");
    d = desc_of("");
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "path is empty");
    d = data_desc("base.tif");
    d.nodata = (bolan_raster_nodata)3;
    assert_refusal(bolan_raster_load(&d, &t), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "nodata 3");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_plain_raster),
        cmocka_unit_test(test_units),
        cmocka_unit_test(test_depths_are_turned_over),
        cmocka_unit_test(test_scale_and_offset_of_the_file),
        cmocka_unit_test(test_what_gdal_warns_of_is_handed_on),
        cmocka_unit_test(test_the_bed_falls_off_in_metres),
        cmocka_unit_test(test_the_variable_that_is_an_elevation),
        cmocka_unit_test(test_a_scene_names_a_variable_beside_it),
        cmocka_unit_test(test_the_band_that_is_an_elevation),
        cmocka_unit_test(test_masks_and_voids_are_holes),
        cmocka_unit_test(test_land_only_elevations),
        cmocka_unit_test(test_coordinates_that_are_metres),
        cmocka_unit_test(test_memory_that_runs_out_is_called_so),
        cmocka_unit_test(test_what_is_no_raster),
    };
    return cmocka_run_group_tests(tests, listen, NULL);
}
