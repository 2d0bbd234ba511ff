// SPDX-License-Identifier: MIT
// Exported fields, read back by netCDF-C and OpenEXR: values of queries and of the sea, coordinates, times, rows the
// right way up.
#include "io_support.h"

#include "bolan/export.h"
#include "bolan/io.h"
#include "bolan/query.h"

#include <OpenEXR/openexr.h>
#include <netcdf.h>
#include <stdlib.h>

enum { COLUMNS = 11, ROWS = 6, POINTS = COLUMNS * ROWS, FRAMES = 3 };

static bolan_world *open_world(void) {
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    assert_int_equal(bolan_world_load_scene(&scene, &world), BOLAN_OK);
    return world;
}

static bolan_export_fields_desc small_grid(void) {
    bolan_export_fields_desc d = bolan_export_fields_desc_default();
    d.resampled = true;
    d.grid = (bolan_export_grid){{40.0, -7.0}, {60.0, 3.0}, 2.0};
    return d;
}

static bolan_dvec2 place(uint32_t i) { return (bolan_dvec2){40.0 + 2.0 * (i % COLUMNS), -7.0 + 2.0 * (i / COLUMNS)}; }

static int variable(int file, const char *name) {
    int id = -1;
    assert_int_equal(nc_inq_varid(file, name, &id), NC_NOERR);
    return id;
}

static void assert_text(int file, int id, const char *name, const char *expected) {
    char text[128] = "";
    assert_int_equal(nc_get_att_text(file, id, name, text), NC_NOERR);
    assert_string_equal(text, expected);
}

static void netcdf_has_what_queries_say_at_each_time(void **state) {
    (void)state;
    bolan_export_fields_desc d = small_grid();
    d.frames = (bolan_export_frames){.count = FRAMES, .fps = 2.0};
    bolan_world *world = open_world();
    const double start = bolan_world_scene(world)->time;
    assert_int_equal(bolan_export_fields(world, &d, "grid.nc"), BOLAN_OK);
    int file;
    double x[COLUMNS], y[ROWS], time[FRAMES];
    static float height[FRAMES][POINTS], speed[FRAMES][POINTS], foam[FRAMES][POINTS];
    assert_int_equal(nc_open("grid.nc", NC_NOWRITE, &file), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "x"), x), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "y"), y), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "time"), time), NC_NOERR);
    assert_int_equal(nc_get_var_float(file, variable(file, "height"), &height[0][0]), NC_NOERR);
    assert_int_equal(nc_get_var_float(file, variable(file, "velocity_y"), &speed[0][0]), NC_NOERR);
    assert_int_equal(nc_get_var_float(file, variable(file, "foam"), &foam[0][0]), NC_NOERR);
    assert_text(file, variable(file, "height"), "standard_name", "sea_surface_height_above_mean_sea_level");
    assert_text(file, variable(file, "height"), "units", "m");
    assert_text(file, variable(file, "velocity_y"), "standard_name", "sea_water_y_velocity");
    assert_text(file, variable(file, "x"), "standard_name", "projection_x_coordinate");
    assert_text(file, NC_GLOBAL, "Conventions", "CF-1.8");
    for (uint32_t i = 0; i < POINTS; i++) assert_true(x[i % COLUMNS] == place(i).x && y[i / COLUMNS] == place(i).y);
    bolan_world_settle(world, start);
    for (uint32_t f = 0; f < FRAMES; f++) {
        assert_true(time[f] == start + 0.5 * f);
        bolan_world_step(world, time[f]);
        bolan_flow *flow = NULL;
        bolan_water water = *bolan_world_water(world);
        assert_int_equal(bolan_flow_create(water.sea, &flow), BOLAN_OK);
        water.flow = flow;
        for (uint32_t i = 0; i < POINTS; i++) {
            const bolan_dvec2 at = place(i);
            bolan_surface_motion m;
            float h, k;
            bolan_query_heights(&water, &at, 1, &h);
            bolan_query_foam(&water, &at, 1, &k);
            bolan_query_motion(&water, NULL, &at, 1, &m);
            assert_float_equal(height[f][i], h, 1e-5f);
            assert_float_equal(speed[f][i], m.velocity.y, 1e-5f);
            assert_float_equal(foam[f][i], k, 1e-5f);
        }
        bolan_flow_destroy(&flow);
    }
    nc_close(file);
    remove("grid.nc");
    bolan_world_destroy(&world);
}

// Values at the samples of a tile are what the sea has at the rest points that are read there, and the direct sum over
// all modes.
static void netcdf_has_the_cascades(void **state) {
    (void)state;
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sea.fft.cascade_count = 1;
    scene.sea.choppiness = 0.0; // no lift
    assert_int_equal(bolan_world_load_scene(&scene, &world), BOLAN_OK);
    const bolan_export_fields_desc d = bolan_export_fields_desc_default();
    assert_int_equal(bolan_export_fields(world, &d, "cascade.nc"), BOLAN_OK);
    int file;
    double u[64], v[64], angle, origin[2];
    static float height[64][64];
    assert_int_equal(nc_open("cascade.nc", NC_NOWRITE, &file), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "u_0"), u), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "v_0"), v), NC_NOERR);
    assert_int_equal(nc_get_var_float(file, variable(file, "height_0"), &height[0][0]), NC_NOERR);
    assert_int_equal(nc_get_att_double(file, variable(file, "height_0"), "tile_angle", &angle), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "origin_x_0"), &origin[0]), NC_NOERR);
    assert_int_equal(nc_get_var_double(file, variable(file, "origin_y_0"), &origin[1]), NC_NOERR);
    nc_close(file);
    const bolan_sea *sea = bolan_world_water(world)->sea;
    const double hs = bolan_sea_get_summary(sea)->hs;
    for (uint32_t k = 0; k < 12; k++) {
        const uint32_t i = 5 * k % 64, j = (11 * k + 3) % 64;
        const double px = u[i] * cos(angle) - v[j] * sin(angle), py = u[i] * sin(angle) + v[j] * cos(angle);
        // The rest point that is read there: the warp is inverted by its fixed point.
        double x = px, y = py, gradient[4];
        for (int step = 0; step < 200; step++) {
            const bolan_dvec2 at = bolan_sea_place_read(sea, x + origin[0], y + origin[1], gradient);
            x += 0.5 * (px - at.x), y += 0.5 * (py - at.y);
        }
        const bolan_dvec2 rest = {x + origin[0], y + origin[1]};
        const bolan_sea_sample direct = bolan_sea_sample_direct(sea, rest.x, rest.y, bolan_sea_time(sea));
        bolan_sea_sample s;
        bolan_sea_sample_rest(sea, &rest, 1, &s);
        assert_float_equal(height[j][i], s.height, 1e-4f);
        assert_float_equal(height[j][i], direct.height, (float)(0.01 * hs)); // what 64 samples a side interpolate
    }
    remove("cascade.nc");
    bolan_world_destroy(&world);
}

// ---- EXR ------------------------------------------------------------------------------------------------------------

// Channel `name` of a part, as floats, row 0 at the top.
static void read_channel(exr_context_t file, int part, const char *name, uint32_t width, uint32_t height, float *out) {
    int32_t lines = 0;
    exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_get_scanlines_per_chunk(file, part, &lines), EXR_ERR_SUCCESS);
    for (uint32_t y = 0; y < height; y += (uint32_t)lines) {
        exr_chunk_info_t block;
        assert_int_equal(exr_read_scanline_chunk_info(file, part, (int)y, &block), EXR_ERR_SUCCESS);
        assert_int_equal(y ? exr_decoding_update(file, part, &block, &decoder)
                           : exr_decoding_initialize(file, part, &block, &decoder),
                         EXR_ERR_SUCCESS);
        for (int c = 0; c < decoder.channel_count; c++) {
            exr_coding_channel_info_t *channel = &decoder.channels[c];
            const bool wanted = strcmp(channel->channel_name, name) == 0;
            channel->decode_to_ptr = wanted ? (uint8_t *)(out + (size_t)y * width) : NULL;
            channel->user_pixel_stride = sizeof(float);
            channel->user_line_stride = (int32_t)(width * sizeof(float));
            channel->user_bytes_per_element = sizeof(float);
            channel->user_data_type = EXR_PIXEL_FLOAT;
        }
        if (y == 0) assert_int_equal(exr_decoding_choose_default_routines(file, part, &decoder), EXR_ERR_SUCCESS);
        assert_int_equal(exr_decoding_run(file, part, &decoder), EXR_ERR_SUCCESS);
    }
    exr_decoding_destroy(file, &decoder);
}

static exr_context_t open_exr(const char *path) {
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    exr_context_t file = NULL;
    assert_int_equal(exr_start_read(&file, path, &initializer), EXR_ERR_SUCCESS);
    return file;
}

static void exr_has_north_at_its_top(void **state) {
    (void)state;
    bolan_export_fields_desc d = small_grid();
    bolan_world *world = open_world();
    for (int half = 0; half < 2; half++) {
        static float height[POINTS], normal[POINTS];
        d.half = half;
        assert_int_equal(bolan_export_fields(world, &d, "grid.exr"), BOLAN_OK);
        exr_context_t file = open_exr("grid.exr");
        read_channel(file, 0, "height", COLUMNS, ROWS, height);
        read_channel(file, 0, "normal_x", COLUMNS, ROWS, normal);
        double south = 0.0;
        const exr_attribute_t *attribute = NULL;
        assert_int_equal(exr_get_attribute_by_name(file, 0, "south", &attribute), EXR_ERR_SUCCESS);
        south = attribute->d;
        assert_true(south == -7.0);
        for (uint32_t i = 0; i < POINTS; i++) {
            const uint32_t pixel = (ROWS - 1 - i / COLUMNS) * COLUMNS + i % COLUMNS;
            const bolan_dvec2 at = place(i);
            bolan_query_point q;
            bolan_query_surface(bolan_world_water(world), &at, 1, &q);
            assert_float_equal(height[pixel], q.height, half ? 1e-3f : 1e-6f);
            assert_float_equal(normal[pixel], q.normal.x, half ? 1e-3f : 1e-6f);
        }
        exr_finish(&file);
        remove("grid.exr");
    }
    bolan_world_destroy(&world);
}

static void exr_has_a_part_for_each_cascade(void **state) {
    (void)state;
    bolan_world *world = open_world();
    const bolan_export_fields_desc d = bolan_export_fields_desc_default();
    assert_int_equal(bolan_export_fields(world, &d, "parts.exr"), BOLAN_OK);
    exr_context_t file = open_exr("parts.exr");
    int parts = 0;
    assert_int_equal(exr_get_count(file, &parts), EXR_ERR_SUCCESS);
    const bolan_sea *sea = bolan_world_water(world)->sea;
    assert_int_equal(parts, bolan_sea_cascade_count(sea));
    for (int c = 0; c < parts; c++) {
        static float slope[64 * 64], foam[64 * 64];
        const bolan_cascade_view v = bolan_sea_cascade(sea, (uint32_t)c);
        const exr_attribute_t *length = NULL;
        read_channel(file, c, "slope_x", 64, 64, slope);
        read_channel(file, c, "foam", 64, 64, foam);
        assert_int_equal(exr_get_attribute_by_name(file, c, "length", &length), EXR_ERR_SUCCESS);
        assert_true(length->d == v.length);
        for (uint32_t j = 0; j < 64; j++)
            for (uint32_t i = 0; i < 64; i++) {
                assert_true(slope[(63 - j) * 64 + i] == v.slope_x[j * 64 + i]);
                assert_true(foam[(63 - j) * 64 + i] == v.foam[j * 64 + i]);
            }
    }
    exr_finish(&file);
    remove("parts.exr");
    bolan_world_destroy(&world);
}

static void skies_have_the_sun_in_their_header(void **state) {
    (void)state;
    enum { WIDTH = 8, HEIGHT = 4 };
    float rgb[3 * WIDTH * HEIGHT], red[WIDTH * HEIGHT], blue[WIDTH * HEIGHT];
    for (int i = 0; i < 3 * WIDTH * HEIGHT; i++) rgb[i] = (float)i;
    const bolan_sky_light light = {{0.5f, -0.5f, 0.70710678f}, {0.7f, 0.6f, 0.5f}, {0.1f, 0.2f, 0.3f}};
    assert_int_equal(bolan_export_sky("sky.exr", WIDTH, HEIGHT, rgb, &light), BOLAN_OK);
    exr_context_t file = open_exr("sky.exr");
    read_channel(file, 0, "R", WIDTH, HEIGHT, red);
    read_channel(file, 0, "B", WIDTH, HEIGHT, blue);
    for (int i = 0; i < WIDTH * HEIGHT; i++) assert_true(red[i] == rgb[3 * i] && blue[i] == rgb[3 * i + 2]);
    const exr_attribute_t *a = NULL;
    assert_int_equal(exr_get_attribute_by_name(file, 0, "sunAzimuth", &a), EXR_ERR_SUCCESS);
    assert_true(fabs(a->d - 135.0) < 1e-4); // south-east
    assert_int_equal(exr_get_attribute_by_name(file, 0, "sunElevation", &a), EXR_ERR_SUCCESS);
    assert_true(fabs(a->d - 45.0) < 1e-4);
    assert_int_equal(exr_get_attribute_by_name(file, 0, "sunIrradiance", &a), EXR_ERR_SUCCESS);
    assert_true(a->v3f->x == 0.7f && a->v3f->y == 0.6f && a->v3f->z == 0.5f);
    exr_finish(&file);
    remove("sky.exr");
}

static void what_cannot_be_exported_is_refused(void **state) {
    (void)state;
    bolan_world *world = open_world();
    bolan_export_fields_desc d = small_grid();
    assert_refusal(bolan_export_fields(world, &d, "x.png"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   ".exr or .nc");
    d.frames.count = 2;
    assert_refusal(bolan_export_fields(world, &d, "x.exr"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT,
                   "several frames");
    d = small_grid();
    d.grid.to.x = -50.0;
    assert_refusal(bolan_export_fields(world, &d, "x.nc"), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, "rectangle");
    bolan_world_destroy(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(netcdf_has_what_queries_say_at_each_time),
        cmocka_unit_test(netcdf_has_the_cascades),
        cmocka_unit_test(exr_has_north_at_its_top),
        cmocka_unit_test(exr_has_a_part_for_each_cascade),
        cmocka_unit_test(skies_have_the_sun_in_their_header),
        cmocka_unit_test(what_cannot_be_exported_is_refused),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
