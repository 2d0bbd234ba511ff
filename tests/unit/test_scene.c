// SPDX-License-Identifier: MIT
// The default scene, its validation, its wind, the techniques, and where the sun stands.
#include "bolan/scene.h"
#include "io_support.h"

static void test_the_default_scene_is_valid(void **state) {
    (void)state;
    const bolan_scene scene = bolan_scene_default();
    assert_int_equal(bolan_scene_validate(&scene), BOLAN_OK);
    assert_int_equal(scene.terrain.kind, BOLAN_TERRAIN_NONE);
    assert_near(scene.camera.position.z, 3.0, 0.0);
    assert_near(scene.sky.sun_elevation_deg, 35.0, 0.0);
}

static void refuse(const bolan_scene *scene, const char *field, bolan_log_id id) {
    assert_refusal(bolan_scene_validate(scene), BOLAN_ERROR_ARGUMENT, id, field);
}

static void test_a_field_outside_its_range_is_named(void **state) {
    (void)state;
    bolan_scene s = bolan_scene_default();
    s.camera.fov_deg = 151.0;
    refuse(&s, "camera.fov_deg", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.sky.visibility = (double)NAN;
    refuse(&s, "sky.visibility", BOLAN_LOG_NOT_FINITE);
    s = bolan_scene_default(), s.water.level = -21.0;
    refuse(&s, "water.level", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.sea.resolution = 300;
    refuse(&s, "sea.resolution", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.sea.sea_state.wind_speed = 71.0;
    refuse(&s, "wind_speed", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.time = (double)INFINITY;
    refuse(&s, "time", BOLAN_LOG_NOT_FINITE);
    s = bolan_scene_default(), memset(s.spectrum_path, 'x', sizeof s.spectrum_path);
    refuse(&s, "spectrum_path", BOLAN_LOG_BAD_ARGUMENT);
    s = bolan_scene_default(), s.terrain.kind = BOLAN_TERRAIN_ISLAND, s.terrain.island.radius = 100.0;
    refuse(&s, "terrain.island.radius", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.terrain.kind = BOLAN_TERRAIN_RASTER, s.terrain.latitude = 91.0;
    refuse(&s, "terrain.latitude", BOLAN_LOG_OUT_OF_RANGE);
}

static void test_another_wind_keeps_the_swell(void **state) {
    (void)state;
    bolan_scene s = bolan_scene_default();
    s.sea.sea_state = bolan_sea_state_from_wind(8.0, 240.0, s.fetch);
    s.sea.sea_state.depth = 50.0;
    assert_int_equal(bolan_sea_state_add_swell(&s.sea.sea_state, 2.0, 14.0, 300.0, 40.0), BOLAN_OK);
    bolan_scene_set_wind(&s, 15.0, 200.0);
    const bolan_sea_state *sea = &s.sea.sea_state;
    assert_int_equal(sea->system_count, 2);
    assert_near(sea->wind_speed, 15.0, 0.0);
    assert_near(sea->systems[0].from_deg, 200.0, 0.0);
    assert_near(sea->systems[1].hs, 2.0, 0.0);
    assert_near(sea->depth, 50.0, 0.0);
    const double young = sea->systems[0].hs;
    s.wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_true(sea->systems[0].hs > young); // 200 km do not raise the full sea of 15 m/s
    s.wind_spectrum = BOLAN_SPECTRUM_TMA;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_int_equal(sea->systems[0].kind, BOLAN_SPECTRUM_TMA);
    bolan_scene_set_wind(&s, 0.0, 200.0);
    assert_int_equal(sea->system_count, 1);
    snprintf(s.spectrum_path, sizeof s.spectrum_path, "buoy.spec");
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_int_equal(sea->system_count, 1); // the waves are the file's
    assert_near(sea->wind_speed, 15.0, 0.0);
}

static void test_techniques_are_found_by_name(void **state) {
    (void)state;
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    assert_true(count >= 1);
    for (uint32_t i = 0; i < count; i++) assert_ptr_equal(bolan_technique_find(all[i].name), &all[i]);
    assert_string_equal(all[0].name, bolan_technique_ocean.name);
    assert_null(bolan_technique_find("Ocean"));
}

// Reda & Andreas, Solar Position Algorithm, NREL/TP-560-34302 (2008), appendix A.5: 2003-10-17 12:30:30 UTC-7 at 39.742476
// N 105.1786 W: azimuth 194.34024, topocentric zenith 50.11162 with 0.016 deg of refraction at 820 mbar and 11 C. The low
// precision formulas promise 0.01 deg for the sun's place and leave out the parallax of 0.002 deg.
static void test_the_sun_stands_where_nrel_says(void **state) {
    (void)state;
    double azimuth = 0.0, elevation = 0.0;
    bolan_sun_position(1066419030.0, 39.742476, -105.1786, &azimuth, &elevation);
    assert_near(azimuth, 194.34024, 0.02);
    assert_near(elevation, 90.0 - 50.11162 - 0.016, 0.02);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_default_scene_is_valid),
        cmocka_unit_test(test_a_field_outside_its_range_is_named),
        cmocka_unit_test(test_another_wind_keeps_the_swell),
        cmocka_unit_test(test_techniques_are_found_by_name),
        cmocka_unit_test(test_the_sun_stands_where_nrel_says),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
