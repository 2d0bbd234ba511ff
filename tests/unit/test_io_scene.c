// SPDX-License-Identifier: MIT
// Scenes from YAML: every key arrives, everything else is refused with file, line and key, and the built-in scenes
// load.
#include "bolan/io.h"
#include "io_support.h"

static bolan_result parse(const char *text, bolan_scene *scene) {
    return bolan_scene_parse("test.yaml", text, strlen(text), scene);
}

static void test_an_empty_document_is_the_default_scene(void **state) {
    (void)state;
    bolan_scene scene, expected = bolan_scene_default();
    static const char *const empty[] = {"", "\n\n", "# nothing\n", "---\n", "{}", "sea:\nsky:\n"};
    for (size_t i = 0; i < sizeof empty / sizeof *empty; i++) {
        assert_int_equal(parse(empty[i], &scene), BOLAN_OK);
        assert_string_equal(scene.name, "test.yaml");
        assert_near(scene.camera.position.z, expected.camera.position.z, 0.0);
        assert_near(scene.sea.sea_state.wind_speed, expected.sea.sea_state.wind_speed, 0.0);
        assert_int_equal(scene.terrain.kind, BOLAN_GROUND_NONE);
        assert_int_equal(scene.water.type, expected.water.type);
    }
}

static const char *const everything =
    "description: \"all keys\"\n"
    "technique: ocean\n"
    "sea:\n"
    "  wind: {speed: 11, from: 250}\n"
    "  fetch_km: 120\n"
    "  swell:\n"
    "    - {hs: 2, tp: 13, from: 300, spread: 40}\n"
    "    - {hs: 0.5, tp: 9}\n"
    "  spectrum: {shape: tma}\n"
    "  depth: 30\n"
    "  seed: 42\n"
    "  resolution: 128\n"
    "  cascades: 3\n"
    "  length: 900\n"
    "  choppiness: 0.9\n"
    "  loop: 60\n"
    "  texture_loop: 3.5\n"
    "  foam_decay: 5\n"
    "  frequencies: 20\n"
    "  directions: 6\n"
    "  split: equal-width\n"
    "  waves: 12\n"
    "  sharpness: 0.8\n"
    "  loop_frames: 24\n"
    "look:\n"
    "  paper: true\n"
    "  effects: [reflection, bump, fog]\n"
    "  show: mask\n"
    "  distortion: 2\n"
    "  blend: 0.5\n"
    "  ambient: 0.9\n"
    "  diffuse: 0.1\n"
    "  specular: 3\n"
    "  shininess: 100\n"
    "objects:\n"
    "  - {model: \"builtin:boat\", position: [1, 2, -0.5], heading: 30, scale: 2, floats: true}\n"
    "  - {model: things/house.obj}\n"
    "water: {type: 3c, level: -1.5, foam: 0.5}\n"
    "sky:\n"
    "  sun: {azimuth: 100, elevation: 12}\n"
    "  visibility_km: 25\n"
    "  clouds: {cover: 0.6, base: 900, seed: 5}\n"
    "terrain:\n"
    "  island: {seed: 3, radius: 1500, peak: 400, sea_floor: -300, lagoon_from: 90}\n"
    "camera: {position: [1, -2, 30.5], heading: 45, pitch: -3, roll: 2, fov: 60}\n"
    "time: 12.5\n"
    "exposure: -1\n";

static const char *const several =
    "sea:\n"
    "  wind: {speed: 12, from: 250}\n"
    "  systems:\n"
    "    - {shape: donelan, hs: 2.5, tp: 7, wind: 12, spreading: donelan-banner, swell: 0.25}\n"
    "    - {hs: 1.5, tp: 14, from: 300, gamma: 6, spreading: cos2s, spread: 45}\n"
    "    - {shape: ochi-hubble, hs: 1, tp: 10, lambda: 2.5, from: -20}\n"
    "  swell: [{hs: 0.5, tp: 18}]\n";

static void test_systems_stand_in_place_of_the_wind_sea(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(parse(several, &s), BOLAN_OK);
    const bolan_sea_state *sea = &s.sea.sea_state;
    assert_int_equal(sea->system_count, 4);
    assert_true(sea->wind_speed == 12.0 && !s.wind_sea);
    const bolan_wave_system *w = sea->systems;
    assert_int_equal(w[0].kind, BOLAN_SPECTRUM_DONELAN);
    assert_int_equal(w[0].spreading, BOLAN_SPREADING_DONELAN_BANNER);
    assert_true(w[0].hs == 2.5 && w[0].wind_speed == 12.0 && w[0].swell == 0.25);
    assert_near(w[0].peak_omega, 2 * BOLAN_PI / 7, 1e-12);
    assert_true(w[0].from_deg == 250.0); // without a direction it comes with the wind
    assert_int_equal(w[1].kind, BOLAN_SPECTRUM_JONSWAP);
    assert_int_equal(w[1].spreading, BOLAN_SPREADING_COS2S);
    assert_true(w[1].from_deg == 300.0 && w[1].gamma == 6.0 && w[1].spread_s == 45.0 && w[1].wind_speed == 0.0);
    assert_true(w[2].kind == BOLAN_SPECTRUM_OCHI_HUBBLE && w[2].lambda == 2.5 && w[2].from_deg == -20.0);
    assert_true(w[3].hs == 0.5);
    bolan_scene_set_wind(&s, 20.0, 90.0); // the waves stay, also the one with a wind
    assert_int_equal(s.sea.sea_state.system_count, 4);
    assert_true(s.sea.sea_state.systems[0].hs == 2.5 && s.sea.sea_state.wind_speed == 20.0);
    assert_int_equal(parse("sea: {wind: {sea: true}, fetch_km: 50, systems: [{hs: 1, tp: 12}]}\n", &s), BOLAN_OK);
    assert_true(s.sea.sea_state.system_count == 2 && s.wind_sea && s.sea.sea_state.systems[1].hs == 1.0);
    assert_int_equal(parse("sea: {wind: {speed: 9, sea: false}}\n", &s), BOLAN_OK);
    assert_true(s.sea.sea_state.system_count == 0 && s.sea.sea_state.wind_speed == 9.0);
}

static void test_two_peaks_stand_in_place_of_the_wind_sea(void **state) {
    (void)state;
    bolan_scene s;
    bolan_sea_state expected = bolan_sea_state_default();
    assert_int_equal(parse("sea: {wind: {from: 200}, ochi_hubble: {hs: 4, member: 3}}\n", &s), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_ochi_hubble(&expected, 4.0, 3, 200.0), BOLAN_OK);
    assert_int_equal(s.sea.sea_state.system_count, 2);
    assert_memory_equal(s.sea.sea_state.systems, expected.systems, 2 * sizeof *expected.systems);
    expected = bolan_sea_state_default();
    assert_int_equal(parse("sea: {torsethaugen: {hs: 3, tp: 14, from: 310}}\n", &s), BOLAN_OK);
    assert_int_equal(bolan_sea_state_add_torsethaugen(&expected, 3.0, 14.0, 310.0), BOLAN_OK);
    assert_int_equal(s.sea.sea_state.system_count, 2);
    assert_memory_equal(s.sea.sea_state.systems, expected.systems, 2 * sizeof *expected.systems);
}

static void test_every_key_arrives(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(parse(everything, &s), BOLAN_OK);
    assert_string_equal(s.description, "all keys");
    assert_string_equal(s.technique.name, "ocean");
    const bolan_sea_state *sea = &s.sea.sea_state;
    assert_near(sea->wind_speed, 11, 0);
    assert_near(sea->wind_from_deg, 250, 0);
    assert_near(s.fetch, 120e3, 0);
    assert_int_equal(sea->system_count, 3);
    assert_int_equal(sea->systems[0].kind, BOLAN_SPECTRUM_TMA);
    assert_near(sea->systems[1].hs, 2, 0);
    assert_near(sea->systems[1].peak_omega, 2 * BOLAN_PI / 13, 1e-12);
    assert_near(sea->systems[1].from_deg, 300, 0);
    assert_near(sea->systems[1].spread_s, 40, 0);
    assert_near(sea->systems[2].from_deg, 250, 0); // a swell without a direction comes with the wind
    assert_near(sea->depth, 30, 0);
    assert_true(s.sea.seed == 42 && s.sea.resolution == 128 && s.sea.fft.cascade_count == 3);
    assert_near(s.sea.length, 900, 0);
    assert_near(s.sea.choppiness, 0.9, 0);
    assert_near(s.sea.loop_period, 60, 0);
    assert_near(s.sea.foam_decay, 5, 0);
    assert_true(s.sea.cosines.frequencies == 20 && s.sea.cosines.directions == 6);
    assert_true(s.sea.exp_cosine.wave_count == 12);
    assert_true(s.sea.textures.frames == 24 && s.sea.textures.period == 3.5);
    assert_int_equal(s.sea.cosines.split, BOLAN_SPLIT_EQUAL_WIDTH);
    assert_near(s.sea.exp_cosine.sharpness, 0.8, 0);
    assert_true(s.look.paper);
    assert_int_equal(s.look.effects, BOLAN_EFFECT_REFLECTION | BOLAN_EFFECT_BUMP | BOLAN_EFFECT_FOG);
    assert_int_equal(s.look.show, BOLAN_SHOW_MASK);
    assert_near(s.look.distortion, 2, 0);
    assert_near(s.look.blend, 0.5, 0);
    assert_near(s.look.ambient, 0.9, 0);
    assert_near(s.look.diffuse, 0.1, 0);
    assert_near(s.look.specular, 3, 0);
    assert_near(s.look.shininess, 100, 0);
    assert_int_equal(s.object_count, 2);
    assert_string_equal(s.objects[0].model, "builtin:boat");
    assert_near(s.objects[0].position.z, -0.5, 0);
    assert_near(s.objects[0].heading_deg, 30, 0);
    assert_true(s.objects[0].floats);
    assert_string_equal(s.objects[1].model, "things/house.obj"); // a text has no folder: the path stays
    assert_near(s.objects[1].scale, 1, 0);
    assert_int_equal(s.water.type, BOLAN_JERLOV_3C);
    assert_near(s.water.level, -1.5, 0);
    assert_near(s.water.foam, 0.5, 0);
    assert_near(s.sky.sun_azimuth_deg, 100, 0);
    assert_near(s.sky.sun_elevation_deg, 12, 0);
    assert_near(s.sky.visibility, 25e3, 0);
    assert_near(s.sky.cloud_cover, 0.6, 0);
    assert_near(s.sky.cloud_base, 900, 0);
    assert_true(s.sky.cloud_seed == 5 && s.terrain.generator.seed == 3);
    assert_int_equal(s.terrain.kind, BOLAN_GROUND_GENERATED);
    assert_string_equal(s.terrain.generator.name, "island");
    assert_false(s.terrain.shown_by_object);
    assert_near(s.terrain.generator.radius, 1500, 0);
    assert_near(s.terrain.generator.peak, 400, 0);
    assert_near(s.terrain.generator.sea_floor, -300, 0);
    assert_near(s.terrain.generator.lagoon_from_deg, 90, 0);
    assert_near(s.camera.position.x, 1, 0);
    assert_near(s.camera.position.y, -2, 0);
    assert_near(s.camera.position.z, 30.5, 0);
    assert_near(s.camera.heading_deg, 45, 0);
    assert_near(s.camera.pitch_deg, -3, 0);
    assert_near(s.camera.roll_deg, 2, 0);
    assert_near(s.camera.fov_deg, 60, 0);
    assert_near(s.time, 12.5, 0);
    assert_near(s.exposure, -1, 0);
}

static void test_a_raster_and_a_spectrum_file(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(parse("terrain:\n  raster: {file: a.tif, at: [19.6, -156], radius_km: 80, vertical_scale: -0.01,\n"
                           "    variable: z, band: 3, crs: EPSG:32604, nodata: sea, nodata_value: -99, zero_is: land}\n"
                           "sea: {spectrum: {file: b.spec, record: 3}, wind: {speed: 9}}\n",
                           &s),
                     BOLAN_OK);
    assert_int_equal(s.terrain.kind, BOLAN_GROUND_RASTER);
    assert_string_equal(s.terrain.raster.path, "a.tif");
    assert_near(s.terrain.raster.latitude, 19.6, 1e-12);
    assert_near(s.terrain.raster.longitude, -156, 0);
    assert_near(s.terrain.raster.radius, 80e3, 0);
    assert_near(s.terrain.raster.vertical_scale, -0.01, 0);
    assert_string_equal(s.terrain.raster.variable, "z");
    assert_int_equal(s.terrain.raster.band, 3);
    assert_string_equal(s.terrain.raster.crs, "EPSG:32604");
    assert_int_equal(s.terrain.raster.nodata, BOLAN_NODATA_SEA);
    assert_near(s.terrain.raster.nodata_value, -99, 0);
    assert_int_equal(s.terrain.raster.zero, BOLAN_ZERO_LAND);
    assert_string_equal(s.spectrum_path, "b.spec");
    assert_int_equal(s.spectrum.record, 3);
    assert_string_equal(s.spectrum.time, "");
    assert_true(isnan(s.spectrum.from_deg) && isnan(s.spectrum.spread_s) && isnan(s.spectrum.place[0]));
    assert_int_equal(s.sea.sea_state.system_count, 0); // the waves are the file's
    assert_near(s.sea.sea_state.wind_speed, 9, 0);
}

static void refuse_scene(const char *text, const char *words) {
    bolan_scene scene;
    assert_refusal(parse(text, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE, words);
}

static void test_what_is_read_of_a_spectrum_file(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(
        parse("sea: {spectrum: {file: b.spec, record: 2018-01-01T06:00, location: 2, from: 30, spread: 50}}\n", &s),
        BOLAN_OK);
    assert_string_equal(s.spectrum.time, "2018-01-01T06:00");
    assert_int_equal(s.spectrum.location, 2);
    assert_near(s.spectrum.from_deg, 30, 0);
    assert_near(s.spectrum.spread_s, 50, 0);
    assert_int_equal(parse("sea:\n  spectrum:\n    file: b.spec\n    location: 174.67, -38.17\n", &s), BOLAN_OK);
    assert_int_equal(s.spectrum.location, 0);
    assert_near(s.spectrum.place[0], 174.67, 0);
    assert_near(s.spectrum.place[1], -38.17, 0);
    s.spectrum.from_deg = 361;
    assert_refusal(bolan_scene_validate(&s), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_OUT_OF_RANGE, "from_deg is 361");
    refuse_scene("sea: {spectrum: {file: b.spec, record: 2018-02-30}}\n", "sea.spectrum.record is neither");
    refuse_scene("sea: {spectrum: {file: b.spec, record: -1}}\n", "sea.spectrum.record is neither");
    refuse_scene("sea: {spectrum: {file: b.spec, location: 0}}\n", "sea.spectrum.location is neither");
    refuse_scene("sea: {spectrum: {file: b.spec, from: 400}}\n", "sea.spectrum.from is 400");
    refuse_scene("sea: {spectrum: {file: b.spec, spread: 201}}\n", "sea.spectrum.spread is 201");
    static const char *const lone[] = {"record: 1", "location: 2", "from: 3", "spread: 4"};
    for (int i = 0; i < 4; i++) {
        char text[128];
        snprintf(text, sizeof text, "sea:\n  spectrum: {%s}\n", lone[i]);
        refuse_scene(text, "but no file");
    }
}

static void test_tables_and_dates(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(parse("sea: {beaufort: 7, wind: {from: 10}}", &s), BOLAN_OK);
    assert_near(s.sea.sea_state.wind_speed, 0.836 * pow(7, 1.5), 1e-9); // WMO: v = 0.836 B^1.5
    assert_near(s.sea.sea_state.wind_from_deg, 10, 0);
    assert_int_equal(parse("sea: {douglas: 5}", &s), BOLAN_OK);
    assert_near(s.sea.sea_state.systems[0].hs, 3.25, 0.01); // the middle of 2.5 to 4 m
    // NREL's example (see test_scene.c), in local time.
    assert_int_equal(parse("sky: {sun: {date: \"2003-10-17T12:30:30-07:00\", place: [39.742476, -105.1786]}}", &s),
                     BOLAN_OK);
    assert_near(s.sky.sun_azimuth_deg, 194.34, 0.02);
    assert_int_equal(parse("sky: {sun: {date: \"2003-10-17T19:30Z\", place: [39.742476, -105.1786]}}", &s), BOLAN_OK);
    assert_near(s.sky.sun_azimuth_deg, 194.2, 0.1);
}

static void test_effects_as_words(void **state) {
    (void)state;
    static const struct {
        const char *text;
        uint32_t effects;
    } good[] = {
        {"look: {effects: \"foam,caustics\"}", BOLAN_EFFECT_FOAM | BOLAN_EFFECT_CAUSTICS},
        {"look: {effects: foam}", BOLAN_EFFECT_FOAM},
        {"look: {effects: none}", 0},
        {"look: {effects: []}", 0},
        {"look: {effects: all}", BOLAN_EFFECTS_ALL},
        {"look: {paper: no}", BOLAN_EFFECTS_ALL},
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        bolan_scene s;
        assert_int_equal(parse(good[i].text, &s), BOLAN_OK);
        assert_int_equal(s.look.effects, good[i].effects);
        assert_false(s.look.paper);
    }
    bolan_scene s;
    assert_int_equal(parse("terrain:\n  pond:\nsea: {spectrum: {shape: phillips}}\n", &s), BOLAN_OK);
    assert_int_equal(s.terrain.kind, BOLAN_GROUND_GENERATED);
    assert_string_equal(s.terrain.generator.name, "pond");
    assert_true(s.terrain.shown_by_object);
    assert_int_equal(s.wind_spectrum, BOLAN_SPECTRUM_PHILLIPS);
}

static void test_a_key_of_the_path_keeps_what_it_does_not_say(void **state) {
    (void)state;
    bolan_scene s;
    assert_int_equal(parse("time: 5\ncamera:\n  fov: 40\n  path:\n    - {time: 0, position: [0, 0, 100], pitch: -10}\n"
                           "    - {time: 10, position: [0, 50, 20]}\n",
                           &s),
                     BOLAN_OK);
    assert_int_equal(s.camera_key_count, 2);
    assert_near(s.camera_keys[1].camera.pitch_deg, -10.0, 0.0);
    assert_near(s.camera_keys[1].camera.fov_deg, 40.0, 0.0);
    assert_near(s.camera.position.y, 25.0, 1e-9); // half-way at half the time: two keys make a straight line
    assert_near(s.camera.position.z, 60.0, 1e-9);
}

static void test_what_is_wrong_is_refused_with_line_and_key(void **state) {
    (void)state;
    static const struct {
        const char *text, *words;
        bolan_log_id id;
    } bad[] = {
        {"sea:\n  wnd: {speed: 3}\n", "test.yaml:2: unknown key sea.wnd; expected one of wind, ",
         BOLAN_LOG_SCENE_UNKNOWN_KEY},
        {"colour: red\n", "test.yaml:1: unknown key colour; expected one of description, ",
         BOLAN_LOG_SCENE_UNKNOWN_KEY},
        {"sea:\n  wind:\n    speed: 99\n", "test.yaml:3: sea.wind.speed is 99; expected a number from 0 to 70 m/s",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: .nan\n", "test.yaml:1: time is .nan; expected a number", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: nan\n", "time is nan", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: 1e999\n", "time is 1e999", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: 0x10\n", "time is 0x10", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time:\n", "time is nothing; expected a number", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: [1]\n", "time is a list; expected a number", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: 3\n", "sea is 3; expected a map", BOLAN_LOG_SCENE_BAD_VALUE},
        {"\n\nwater: {type: 2C}\n", "test.yaml:3: water.type is 2C; expected I, IA", BOLAN_LOG_SCENE_BAD_VALUE},
        {"technique: lava\n", "technique is lava; expected ocean", BOLAN_LOG_SCENE_BAD_VALUE},
        {"camera: {position: [1, 2]}\n", "camera.position is a list; expected a list of 3 numbers",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"camera: {position: [1, 2, x]}\n", "test.yaml:1: camera.position.z is x; expected a number",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"camera: {position: [0, 0, -5000]}\n",
         "test.yaml:1: camera.position.z is -5000; expected a number from -1000 to 1000000 m",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"camera:\n  path:\n    - {position: [0, 0, 5]}\n", "test.yaml:3: camera.path[0] needs time; expected a number",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"camera:\n  path:\n    - {time: 3}\n    - {time: 3}\n", "test.yaml:4: a key of camera.path is not later",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {seed: 1.5}\n", "sea.seed is 1.5; expected a whole number", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {seed: -1}\n", "sea.seed is -1; expected a whole number", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {resolution: 100}\n", "test.yaml:1: sea.resolution is 100; expected a power of two from 32 to 1024",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea:\n  swell:\n    - {hs: 2}\n", "test.yaml:3: sea.swell[0] needs tp; expected a number from 1 to 60 s",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea:\n  swell:\n    - {hs: 2, tp: 12, size: 4}\n", "test.yaml:3: unknown key sea.swell[0].size",
         BOLAN_LOG_SCENE_UNKNOWN_KEY},
        {"sea:\n  systems:\n    - {hs: 2}\n",
         "test.yaml:3: sea.systems[0] needs tp; expected a number from 0.2 to 60 s", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea:\n  systems:\n    - {tp: 9}\n", "test.yaml:3: sea.systems[0] needs hs; expected a number from 0 to 40 m",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {systems: [{hs: 2, tp: 9, shape: bretschneider}]}\n",
         "sea.systems[0].shape is bretschneider; expected pierson-moskowitz, jonswap, ", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {systems: [{hs: 2, tp: 9, gamma: .nan}]}\n",
         "sea.systems[0].gamma is .nan; expected a number from 1 to 10", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {systems: [{hs: 2, tp: 9, spreading: wide}]}\n",
         "sea.systems[0].spreading is wide; expected cos2, cos2s", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {systems: [{hs: 2, tp: 9, period: 3}]}\n", "unknown key sea.systems[0].period",
         BOLAN_LOG_SCENE_UNKNOWN_KEY},
        {"sea: {systems: [{hs: 2, tp: 9}], fetch_km: 9}\n", "sea.fetch_km and sea.spectrum.shape are of the wind sea",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {ochi_hubble: {member: 2}}\n", "sea.ochi_hubble needs hs", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {ochi_hubble: {hs: 2, member: 11}}\n",
         "sea.ochi_hubble.member is 11; expected a whole number from 0 to 10", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {torsethaugen: {hs: 2}}\n", "sea.torsethaugen needs hs and tp", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {spectrum: {shape: torsethaugen}}\n", "sea.spectrum.shape is torsethaugen; expected pierson-moskowitz",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {wind: {speed: 5}, beaufort: 3}\n", "more than one of wind.speed, beaufort", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {spectrum: {shape: tma}}\n", "tma needs sea.depth", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {beaufort: 3, fetch_km: 10}\n", "sea.fetch_km does not go with", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: 1\ntime: 2\n", "test.yaml:2: time is given twice", BOLAN_LOG_SCENE_BAD_VALUE},
        {"terrain: {island: {}, raster: {file: a}}\n", "more than one of island, raster and pond",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"terrain: {pond: {}, island: {}}\n", "more than one of island, raster and pond", BOLAN_LOG_SCENE_BAD_VALUE},
        {"terrain: {pond: {depth: 3}}\n", "unknown key terrain.pond.depth; expected none", BOLAN_LOG_SCENE_UNKNOWN_KEY},
        {"objects:\n  - {position: [0, 0, 0]}\n", "test.yaml:2: objects[0] needs model; expected a text",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"objects:\n  - {model: \"builtin:boot\"}\n", "test.yaml:2: there is no model builtin:boot; expected",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"objects:\n  - {model: a.obj, scale: 0}\n", "objects[0].scale is 0; expected a number from 0.001",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"objects:\n  - {model: a.obj, position: [0, 0, 20000]}\n", "test.yaml:2: objects[0].position.z is 20000",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"objects: {model: a.obj}\n", "objects is a map; expected a list", BOLAN_LOG_SCENE_BAD_VALUE},
        {"objects: [{model: a.obj, floats: maybe}]\n", "objects[0].floats is maybe; expected true or false",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"look: {effects: \"foam, smoke\"}\n", "look.effects is foam, smoke; expected all, none, or some of reflection",
         BOLAN_LOG_SCENE_BAD_VALUE},
        {"look: {effects: [[foam]]}\n", "look.effects is a list; expected all, none", BOLAN_LOG_SCENE_BAD_VALUE},
        {"look: {effects: {foam: 1}}\n", "look.effects is a map; expected all, none", BOLAN_LOG_SCENE_BAD_VALUE},
        {"look: {blend: 2}\n", "look.blend is 2; expected a number from 0 to 1", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {frequencies: 0}\n", "sea.frequencies is 0; expected a whole number from 1", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {split: even}\n", "sea.split is even; expected equal-energy, equal-width", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sky: {sun: {date: \"2026-06-21T12:00Z\"}}\n", "date and place", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sky: {sun: {date: yesterday, place: [1, 2]}}\n", "sky.sun.date is no date", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sky: {sun: {date: \"2026-13-21T12:00Z\", place: [1, 2]}}\n", "is no date", BOLAN_LOG_SCENE_BAD_VALUE},
        {"description: \"\"\n", "description is nothing; expected a text", BOLAN_LOG_SCENE_BAD_VALUE},
        {"time: 1\n---\ntime: 2\n", "test.yaml:3: a second document", BOLAN_LOG_SCENE_BAD_VALUE},
        {"- a\n- b\n", "the document is a list; expected a map", BOLAN_LOG_SCENE_BAD_VALUE},
        {"sea: {wind: {speed: 5}\n", "not YAML: did not find expected ',' or '}'", BOLAN_LOG_SCENE_SYNTAX},
        {"a: b: c\n", "test.yaml:1: not YAML: ", BOLAN_LOG_SCENE_SYNTAX},
        {"\xff\xfe\xfd", "not YAML", BOLAN_LOG_SCENE_SYNTAX},
        {"\x01\x02", "not YAML", BOLAN_LOG_SCENE_SYNTAX},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bolan_scene scene;
        memset(&scene, 0x5a, sizeof scene);
        const bolan_scene before = scene;
        assert_refusal(parse(bad[i].text, &scene), BOLAN_ERROR_FORMAT, bad[i].id, bad[i].words);
        assert_memory_equal(&scene, &before, sizeof scene); // untouched
    }
}

// The sun at a moment that is written in two ways is the same; a date that no calendar has is refused.
static void test_dates_are_those_of_the_calendar(void **state) {
    (void)state;
    static const char *const good[] = {"2028-02-29T12:00Z", "2000-02-29T00:00:00Z", "2026-12-31T23:59:60Z",
                                       "1900-01-01T00:00+14:00", "2100-12-31T23:59-00:30"};
    static const char *const bad[] = {"2026-02-31T12:00Z",
                                      "2026-02-29T12:00Z",
                                      "2100-02-29T12:00Z",
                                      "2026-04-31T12:00Z",
                                      "2026-11-31T12:00Z",
                                      "2026-00-10T12:00Z",
                                      "2026-06-00T12:00Z",
                                      "2026-06-21T24:00Z",
                                      "2026-06-21T12:60Z",
                                      "2026-06-21T12:00:61Z",
                                      "2026-06-21T 8: 0Z",
                                      "2026-06-21T+8:-0Z",
                                      "2026-06-21T8:00Z",
                                      "2026-6-21T08:00Z",
                                      "2026-06-21 12:00Z",
                                      "2026-06-21T12:00",
                                      "2026-06-21T12:00z",
                                      "2026-06-21T12:00ZZ",
                                      "2026-06-21T12:00Z ",
                                      " 2026-06-21T12:00Z",
                                      "-026-06-21T12:00Z",
                                      "1899-06-21T12:00Z",
                                      "2101-06-21T12:00Z",
                                      "2026-06-21T12:00+15:00",
                                      "2026-06-21T12:00+2:00",
                                      "2026-06-21T12:00+02:60",
                                      "2026-06-21T12:00+02",
                                      "2026-06-21T12:00:Z",
                                      "2026-06-21"};
    bolan_scene s;
    char text[128];
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        snprintf(text, sizeof text, "sky: {sun: {date: \"%s\", place: [10, 20]}}", good[i]);
        assert_int_equal(parse(text, &s), BOLAN_OK);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(text, sizeof text, "time: 1\nsky: {sun: {date: \"%s\", place: [10, 20]}}", bad[i]);
        assert_refusal(parse(text, &s), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE, ":2: sky.sun.date is no date");
    }
    static const char *const same[] = {"2026-06-21T18:20:00Z", "2026-06-21T20:20+02:00", "2026-06-21T14:50:00-03:30",
                                       "2026-06-22T00:05+05:45"};
    double azimuth = 0.0, elevation = 0.0;
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        snprintf(text, sizeof text, "sky: {sun: {date: \"%s\", place: [10, 20]}}", same[i]);
        assert_int_equal(parse(text, &s), BOLAN_OK);
        if (i == 0) azimuth = s.sky.sun_azimuth_deg, elevation = s.sky.sun_elevation_deg;
        assert_true(s.sky.sun_azimuth_deg == azimuth && s.sky.sun_elevation_deg == elevation);
    }
    // A second is 1/240 of a degree of the sky.
    snprintf(text, sizeof text, "sky: {sun: {date: \"2026-06-21T18:20:30Z\", place: [10, 20]}}");
    assert_int_equal(parse(text, &s), BOLAN_OK);
    assert_near(fabs(s.sky.sun_elevation_deg - elevation), 30.0 / 240.0 * cos(bolan_radians(10.0)) * 0.92, 0.01);
}

static void test_aliases_and_nesting_cost_nothing(void **state) {
    (void)state;
    // The "billion laughs": ten levels of ten references each. And a map that holds itself.
    static const char *const bomb = "a: &a [x, x]\nb: &b [*a, *a, *a, *a]\nc: &c [*b, *b, *b, *b]\ntime: *c\n";
    bolan_scene scene;
    assert_refusal(parse(bomb, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_UNKNOWN_KEY, "unknown key a");
    assert_refusal(parse("&m {sea: *m}", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_UNKNOWN_KEY,
                   "unknown key sea.sea");
    enum { DEEP = 50000 };
    char *deep = malloc(DEEP);
    assert_non_null(deep);
    memset(deep, '[', DEEP);
    error_count = 0;
    assert_int_equal(bolan_scene_parse("deep", deep, DEEP, &scene), BOLAN_ERROR_FORMAT);
    assert_int_equal(error_count, 1);
    free(deep);
    // The line of an error is a line of the text, also at its end and for bytes that are no UTF-8.
    assert_refusal(parse("time: 1\n[", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_SYNTAX, "test.yaml:2: not YAML");
    assert_refusal(parse("time: 1\n[\n", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_SYNTAX, "test.yaml:2: not YAML");
    assert_refusal(parse("time: 1\n\n# \xff\n", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_SYNTAX,
                   "test.yaml:3: not YAML");
    assert_refusal(parse("time: 1\ntime: [\n]}\ntime: 2\n", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_SYNTAX,
                   "test.yaml:3: not YAML");
    // A seed that no double holds is not rounded to another.
    assert_int_equal(parse("sea: {seed: 9007199254740993}", &scene), BOLAN_OK);
    assert_true(scene.sea.seed == 9007199254740993u);
    assert_refusal(parse("sea: {seed: 18446744073709551616}", &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "sea.seed is 18446744073709551616; expected a whole number");
}

static void test_limits_of_the_text(void **state) {
    (void)state;
    static char text[300000];
    bolan_scene scene;
    // Brackets in quotes and comments count as well: a text cannot hide them.
    int length = snprintf(text, sizeof text, "description: \"");
    memset(text + length, '[', 4096), length += 4096;
    snprintf(text + length, sizeof text - (size_t)length, "\"\n");
    assert_refusal(parse(text, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE, "description is [[[");
    text[length] = '{', snprintf(text + length + 1, 8, "\"\n");
    assert_refusal(parse(text, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_TOO_DEEP,
                   "test.yaml:1: more than 4096 brackets");
    // Anchors and aliases; stars and ampersands that name nothing do not count.
    length = 0;
    for (int i = 0; i < 5000; i++) length += snprintf(text + length, sizeof text - (size_t)length, "# ** & **\n");
    assert_int_equal(parse(text, &scene), BOLAN_OK);
    length = 0;
    for (int i = 0; i < 4097; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, "- %ca\n", i % 2 ? '*' : '&');
    assert_refusal(parse(text, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_TOO_DEEP,
                   "test.yaml:4097: more than 4096 anchors and aliases");
    // 256 KiB, and one byte more.
    memset(text, '#', 256 << 10);
    text[256 << 10] = '\0';
    assert_int_equal(parse(text, &scene), BOLAN_OK);
    text[256 << 10] = '#', text[(256 << 10) + 1] = '\0';
    assert_refusal(parse(text, &scene), BOLAN_ERROR_FORMAT, BOLAN_LOG_FILE_TOO_LARGE, "expected at most 256 KiB");
}

static void test_built_in_scenes_load(void **state) {
    (void)state;
    static const char *const expected[] = {"island", "open-sea", "storm", "coast",
                                           "measured", "pond",     "reef",  "underwater",
                                           "calm"};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        bolan_scene scene;
        assert_int_equal(bolan_scene_load(expected[i], &scene), BOLAN_OK);
        assert_string_equal(scene.name, expected[i]);
        assert_true(scene.description[0] != '\0');
        bool listed = false;
        for (uint32_t k = 0; bolan_scene_builtin_name(k); k++)
            listed = listed || strcmp(bolan_scene_builtin_name(k), expected[i]) == 0;
        assert_true(listed);
    }
}

static void test_paths_count_from_the_scenes_folder(void **state) {
    (void)state;
    write_text("with_paths.yaml", "sea: {spectrum: {file: buoy.spec}}\nterrain: {raster: {file: /data/dem.tif}}\n");
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("./with_paths.yaml", &scene), BOLAN_OK);
    assert_string_equal(scene.spectrum_path, "./buoy.spec");
    assert_string_equal(scene.terrain.raster.path, "/data/dem.tif");
    assert_string_equal(scene.name, "with_paths.yaml");
    remove("with_paths.yaml");
    assert_refusal(bolan_scene_load("no-such-scene", &scene), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_UNKNOWN_NAME,
                   "no-such-scene: there is no such scene; expected approach, calm, coast, island");
    assert_refusal(bolan_scene_load("./no.yaml", &scene), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN,
                   "./no.yaml: cannot be read");
    assert_refusal(bolan_scene_load("/", &scene), BOLAN_ERROR_IO, BOLAN_LOG_FILE_OPEN, "it is a folder");
}

// The shipped spectrum was made from two systems of 1.6 m and 1.3 m.
static void test_the_measured_scene_needs_no_data(void **state) {
    (void)state;
    bolan_world *world = NULL;
    assert_int_equal(bolan_world_load("measured", &world), BOLAN_OK);
    bolan_sea_state sea = bolan_sea_state_default();
    sea.measured = bolan_world_sea_desc(world).sea_state.measured;
    assert_non_null(sea.measured);
    // 1 % for the integers of the format and the rule of integration.
    assert_near(bolan_sea_state_summary(&sea).hs, sqrt(1.6 * 1.6 + 1.3 * 1.3), 0.02);
    bolan_world_destroy(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_empty_document_is_the_default_scene),
        cmocka_unit_test(test_systems_stand_in_place_of_the_wind_sea),
        cmocka_unit_test(test_two_peaks_stand_in_place_of_the_wind_sea),
        cmocka_unit_test(test_every_key_arrives),
        cmocka_unit_test(test_a_raster_and_a_spectrum_file),
        cmocka_unit_test(test_what_is_read_of_a_spectrum_file),
        cmocka_unit_test(test_tables_and_dates),
        cmocka_unit_test(test_effects_as_words),
        cmocka_unit_test(test_a_key_of_the_path_keeps_what_it_does_not_say),
        cmocka_unit_test(test_what_is_wrong_is_refused_with_line_and_key),
        cmocka_unit_test(test_dates_are_those_of_the_calendar),
        cmocka_unit_test(test_aliases_and_nesting_cost_nothing),
        cmocka_unit_test(test_limits_of_the_text),
        cmocka_unit_test(test_built_in_scenes_load),
        cmocka_unit_test(test_paths_count_from_the_scenes_folder),
        cmocka_unit_test(test_the_measured_scene_needs_no_data),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
