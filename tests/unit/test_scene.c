// SPDX-License-Identifier: MIT
// The default scene, its validation, its wind, the techniques, and where the sun stands.
#include "bolan/scene.h"
#include "io_support.h"

static void test_the_default_scene_is_valid(void **state) {
    (void)state;
    const bolan_scene scene = bolan_scene_default();
    assert_int_equal(bolan_scene_validate(&scene), BOLAN_OK);
    assert_int_equal(scene.terrain.kind, BOLAN_GROUND_NONE);
    assert_near(scene.camera.position.z, 3.0, 0.0);
    assert_near(scene.sky.sun_elevation_deg, 35.0, 0.0);
}

// The numbers that scene.h promises; a picture shows only some of them.
static void test_the_default_look_is_the_documented_one(void **state) {
    (void)state;
    const bolan_look look = bolan_look_default(), scene = bolan_scene_default().look;
    assert_false(look.paper);
    assert_int_equal(look.effects, 0xfff);
    assert_int_equal(look.show, BOLAN_SHOW_PICTURE);
    assert_near(look.distortion, 1.0, 0.0);
    assert_near(look.blend, 0.85, 0.0);
    assert_near(look.ambient, 1.0, 0.0);
    assert_near(look.diffuse, 0.05, 0.0);
    assert_near(look.specular, 1.0, 0.0);
    assert_near(look.shininess, 300.0, 0.0);
    assert_int_equal(scene.effects, look.effects);
    assert_int_equal(scene.paper, look.paper);
    assert_int_equal(scene.show, look.show);
    assert_near(scene.distortion, look.distortion, 0.0);
    assert_near(scene.blend, look.blend, 0.0);
    assert_near(scene.ambient, look.ambient, 0.0);
    assert_near(scene.diffuse, look.diffuse, 0.0);
    assert_near(scene.specular, look.specular, 0.0);
    assert_near(scene.shininess, look.shininess, 0.0);
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
    s = bolan_scene_default();
    s.sea.sea_state.current_x = NAN;
    refuse(&s, "current_x", BOLAN_LOG_NOT_FINITE);
    s = bolan_scene_default();
    s.sea.sea_state.current_y = -5.5;
    refuse(&s, "current_y", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default();
    s = bolan_scene_default(), s.sea.resolution = 300;
    refuse(&s, "sea.resolution", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.sea.sea_state.wind_speed = 71.0;
    refuse(&s, "wind_speed", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.time = (double)INFINITY;
    refuse(&s, "time", BOLAN_LOG_NOT_FINITE);
    s = bolan_scene_default(), memset(s.spectrum_path, 'x', sizeof s.spectrum_path);
    refuse(&s, "spectrum_path", BOLAN_LOG_BAD_ARGUMENT);
    s = bolan_scene_default(), s.terrain.kind = BOLAN_GROUND_GENERATED, s.terrain.generator.radius = 100.0;
    refuse(&s, "terrain.generator.radius", BOLAN_LOG_OUT_OF_RANGE);
    s = bolan_scene_default(), s.terrain.kind = BOLAN_GROUND_RASTER, s.terrain.raster.latitude = 91.0;
    refuse(&s, "terrain.raster.latitude", BOLAN_LOG_OUT_OF_RANGE);
}

static void test_another_wind_keeps_the_swell(void **state) {
    (void)state;
    bolan_scene s = bolan_scene_default();
    s.sea.sea_state = bolan_sea_state_from_wind(8.0, 240.0, s.fetch);
    s.sea.sea_state.depth = 50.0;
    s.sea.sea_state.current_x = 1.5;
    s.sea.sea_state.current_y = -0.5;
    s.sea.sea_state.frame = BOLAN_FRAME_STILL;
    assert_int_equal(bolan_sea_state_add_swell(&s.sea.sea_state, 2.0, 14.0, 300.0, 40.0), BOLAN_OK);
    bolan_scene_set_wind(&s, 15.0, 200.0);
    const bolan_sea_state *sea = &s.sea.sea_state;
    assert_int_equal(sea->system_count, 2);
    assert_near(sea->wind_speed, 15.0, 0.0);
    assert_near(sea->systems[0].from_deg, 200.0, 0.0);
    assert_near(sea->systems[1].hs, 2.0, 0.0);
    assert_near(sea->depth, 50.0, 0.0);
    assert_true(sea->current_x == 1.5 && sea->current_y == -0.5 && sea->frame == BOLAN_FRAME_STILL);
    const double young = sea->systems[0].hs;
    s.wind_spectrum = BOLAN_SPECTRUM_PIERSON_MOSKOWITZ;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_true(sea->systems[0].hs > young); // 200 km do not raise the full sea of 15 m/s
    s.wind_spectrum = BOLAN_SPECTRUM_TMA;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_int_equal(sea->systems[0].kind, BOLAN_SPECTRUM_TMA);
    s.wind_spectrum = BOLAN_SPECTRUM_DONELAN;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_int_equal(sea->systems[0].kind, BOLAN_SPECTRUM_DONELAN);
    assert_true(sea->systems[0].hs == bolan_sea_state_from_donelan(15.0, 200.0, s.fetch).systems[0].hs);
    s.wind_spectrum = BOLAN_SPECTRUM_ELFOUHAILY;
    bolan_scene_set_wind(&s, 15.0, 200.0);
    assert_int_equal(sea->systems[0].kind, BOLAN_SPECTRUM_ELFOUHAILY);
    assert_true(sea->systems[0].hs == bolan_sea_state_from_elfouhaily(15.0, 200.0, s.fetch).systems[0].hs);
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

// Reda & Andreas, Solar Position Algorithm, NREL/TP-560-34302 (2008), appendix A.5: 2003-10-17 12:30:30 UTC-7 at
// 39.742476 N 105.1786 W: azimuth 194.34024, topocentric zenith 50.11162 with 0.016 deg of refraction at 820 mbar and
// 11 C. The low precision formulas promise 0.01 deg for the sun's place and leave out the parallax of 0.002 deg.
static void test_the_sun_stands_where_nrel_says(void **state) {
    (void)state;
    double azimuth = 0.0, elevation = 0.0;
    bolan_sun_position(1066419030.0, 39.742476, -105.1786, &azimuth, &elevation);
    assert_near(azimuth, 194.34024, 0.02);
    assert_near(elevation, 90.0 - 50.11162 - 0.016, 0.02);
}

// Meeus, "Astronomical Algorithms" (1998), chapter 25, whose longitude is good to 0.01 degrees: at the sub-solar point
// by it the sun stands in the zenith. The equation of centre has a second term of up to 0.020 degrees, which the 18th
// of February has whole.
static void the_sun_follows_the_equation_of_centre(void **state) {
    (void)state;
    for (int day = 0; day < 365; day += 11) {
        const double unix_time = 1767225600.0 + 86400.0 * day, days = unix_time / 86400.0 - 10957.5, t = days / 36525.0;
        const double m = bolan_radians(357.52911 + 35999.05029 * t), deg = BOLAN_PI / 180.0;
        const double centre = (1.914602 - 0.004817 * t) * sin(m) + 0.019993 * sin(2.0 * m) + 0.000289 * sin(3.0 * m);
        const double node = (125.04 - 1934.136 * t) * deg;
        const double l = (280.46646 + 36000.76983 * t + centre - 0.00569 - 0.00478 * sin(node)) * deg;
        const double e = (23.439291 - 0.0130042 * t + 0.00256 * cos(node)) * deg;
        const double declination = asin(sin(e) * sin(l)) / deg, ascension = atan2(cos(e) * sin(l), cos(l)) / deg;
        const double longitude = remainder(ascension - (280.46061837 + 360.98564736629 * days), 360.0);
        double azimuth, elevation;
        bolan_sun_position(unix_time, declination, longitude, &azimuth, &elevation);
        assert_near(elevation, 90.0, 0.0135); // 0.01 of the almanac's formula, and nutation, 0.005
    }
}

static bolan_scene with_path(void) {
    bolan_scene s = bolan_scene_default();
    s.camera_key_count = 3;
    for (int i = 0; i < 3; i++) s.camera_keys[i] = (bolan_camera_key){10.0 * i, s.camera};
    s.camera_keys[0].camera.position.z = 1000.0;
    s.camera_keys[1].camera.position.z = 100.0;
    s.camera_keys[2].camera.position.z = 3.0;
    s.camera_keys[0].camera.heading_deg = 350.0;
    s.camera_keys[1].camera.heading_deg = 10.0;
    s.camera_keys[2].camera.heading_deg = 40.0;
    return s;
}

static void the_camera_passes_through_its_keys(void **state) {
    (void)state;
    const bolan_scene s = with_path();
    for (int i = 0; i < 3; i++) {
        const bolan_camera c = bolan_scene_camera_at(&s, 10.0 * i);
        assert_near(c.position.z, s.camera_keys[i].camera.position.z, 1e-9);
        assert_near(remainder(c.heading_deg - s.camera_keys[i].camera.heading_deg, 360.0), 0.0, 1e-9);
    }
    assert_near(bolan_scene_camera_at(&s, -5.0).position.z, 1000.0, 1e-9);
    assert_near(bolan_scene_camera_at(&s, 99.0).position.z, 3.0, 1e-9);
}

static void a_descent_only_descends(void **state) {
    (void)state;
    const bolan_scene s = with_path();
    double before = 1000.0;
    for (int i = 0; i <= 2000; i++) {
        const double z = bolan_scene_camera_at(&s, 0.01 * i).position.z;
        assert_true(z <= before + 1e-9 && z >= 3.0 - 1e-9);
        assert_true(before - z <
                    1.5 * 900.0 / 10.0 * 0.01 * 2.0); // no jump: at most 3 times the mean slope of its piece
        before = z;
    }
}

static void headings_turn_the_short_way(void **state) {
    (void)state;
    const bolan_scene s = with_path();
    for (int i = 0; i <= 100; i++) {
        const double heading = remainder(bolan_scene_camera_at(&s, 0.1 * i).heading_deg, 360.0);
        assert_true(heading >= -10.0 - 1e-9 && heading <= 10.0 + 1e-9);
    }
}

static void a_path_out_of_order_is_refused(void **state) {
    (void)state;
    bolan_scene s = with_path();
    assert_int_equal(bolan_scene_validate(&s), BOLAN_OK);
    s.camera_keys[2].time = 10.0;
    assert_int_equal(bolan_scene_validate(&s), BOLAN_ERROR_ARGUMENT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_default_scene_is_valid),
        cmocka_unit_test(test_the_default_look_is_the_documented_one),
        cmocka_unit_test(test_a_field_outside_its_range_is_named),
        cmocka_unit_test(test_another_wind_keeps_the_swell),
        cmocka_unit_test(test_techniques_are_found_by_name),
        cmocka_unit_test(test_the_sun_stands_where_nrel_says),
        cmocka_unit_test(the_sun_follows_the_equation_of_centre),
        cmocka_unit_test(the_camera_passes_through_its_keys),
        cmocka_unit_test(a_descent_only_descends),
        cmocka_unit_test(headings_turn_the_short_way),
        cmocka_unit_test(a_path_out_of_order_is_refused),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
