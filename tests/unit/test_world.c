// SPDX-License-Identifier: MIT
// A world against its parts made by hand: the same bits. What it refuses leaves it as it was, and nothing leaks.
#include "content_support.h"
#include "io_support.h"

#include "bolan/query.h"
#include "bolan/world.h"

static bolan_scene small_scene(void) {
    bolan_scene scene = bolan_scene_default();
    scene.sea.resolution = 32;
    scene.sea.fft.cascade_count = 2;
    scene.time = 2.5;
    return scene;
}

static void name_model(bolan_object *object, const char *name) {
    snprintf(object->model, sizeof object->model, "builtin:%s", name);
    object->scale = 1.0;
}

// A pond with a boat that floats and a house that does not.
static bolan_scene pond_scene(void) {
    bolan_scene scene = small_scene();
    scene.terrain.kind = BOLAN_GROUND_GENERATED;
    scene.terrain.generator = generator_named("pond");
    scene.water.level = 0.25;
    scene.water.foam = 0.5;
    scene.water.type = BOLAN_JERLOV_5C;
    scene.object_count = 2;
    name_model(&scene.objects[0], "boat");
    scene.objects[0].floats = true;
    scene.objects[0].position = bolan_dv3(3.0, -2.0, 0.1);
    scene.objects[0].heading_deg = 30.0;
    scene.objects[0].scale = 1.5;
    name_model(&scene.objects[1], "house");
    scene.objects[1].position = bolan_dv3(60.0, 5.0, 3.0);
    scene.objects[1].heading_deg = 90.0;
    return scene;
}

static bolan_world_assets pond_assets(void) {
    const bolan_ground_generator pond = generator_named("pond");
    bolan_world_assets assets = {.model_count = 2};
    assert_int_equal(bolan_content_create_ground(&pond, &assets.ground), BOLAN_OK);
    assert_int_equal(bolan_content_create_model("boat", &assets.models[0]), BOLAN_OK);
    assert_int_equal(bolan_content_create_model("house", &assets.models[1]), BOLAN_OK);
    assets.object_models[0] = assets.models[0];
    assets.object_models[1] = assets.models[1];
    return assets;
}

static bolan_world *pond_world(void) {
    const bolan_scene scene = pond_scene();
    bolan_world_assets assets = pond_assets();
    bolan_world *world = NULL;
    assert_int_equal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &world), BOLAN_OK);
    return world;
}

static bolan_world *open_sea(void) {
    const bolan_scene scene = small_scene();
    bolan_world *world = NULL;
    bolan_world_desc desc = bolan_world_desc_default();
    desc.scene = &scene;
    assert_int_equal(bolan_world_create(&desc, &world), BOLAN_OK);
    return world;
}

static void assert_same_sea(const bolan_sea *got, const bolan_sea *expected) {
    char a[17], b[17];
    bolan_sea_hash(got, a);
    bolan_sea_hash(expected, b);
    assert_string_equal(a, b);
    assert_true(bolan_sea_time(got) == bolan_sea_time(expected));
}

// The foam memory, which the hash leaves out.
static void assert_same_foam(const bolan_sea *got, const bolan_sea *expected) {
    for (int i = 0; i < 64; i++) {
        const bolan_dvec2 at = {7.3 * i, 5.1 * i};
        bolan_sea_sample a, b;
        bolan_sea_sample_rest(got, &at, 1, &a);
        bolan_sea_sample_rest(expected, &at, 1, &b);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

static void it_has_the_bits_of_its_parts(void **state) {
    (void)state;
    const bolan_scene scene = small_scene();
    const bolan_sea_desc desc = bolan_scene_sea_desc(&scene);
    bolan_world *world = open_sea();
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
    bolan_sea_step(sea, 2.5);
    assert_same_sea(bolan_world_water(world)->sea, sea);
    bolan_world_settle(world, 7.0);
    bolan_sea_settle(sea, 7.0);
    for (int i = 1; i < 5; i++) {
        bolan_world_step(world, 7.0 + 0.1 * i);
        bolan_sea_step(sea, 7.0 + 0.1 * i);
        assert_same_sea(bolan_world_water(world)->sea, sea);
        assert_same_foam(bolan_world_water(world)->sea, sea);
        assert_true(bolan_world_scene(world)->time == 7.0 + 0.1 * i);
    }
    bolan_sea_destroy(&sea);
    bolan_world_destroy(&world);
    assert_null(world);
    bolan_world_destroy(&world);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void its_water_is_that_of_the_scene(void **state) {
    (void)state;
    bolan_world *world = pond_world();
    const bolan_water *water = bolan_world_water(world);
    const bolan_water_optics optics = bolan_water_optics_from_jerlov(BOLAN_JERLOV_5C);
    assert_true(water->level == 0.25 && water->foam == 0.5 && water->layer_count == 0);
    assert_memory_equal(&water->optics, &optics, sizeof optics);
    assert_non_null(water->ground);
    assert_near(bolan_ground_elevation(water->ground, 0.0, 0.0, 0.0), bolan_pond_elevation(0.0, 0.0), 1e-4);
    assert_null(bolan_world_tiles(world));
    bolan_world_destroy(&world);
    world = open_sea();
    assert_null(bolan_world_water(world)->ground);
    bolan_world_destroy(&world);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void it_takes_its_assets_over(void **state) {
    (void)state;
    bolan_scene scene = pond_scene();
    bolan_world_assets assets = pond_assets();
    const bolan_model *boat = assets.object_models[0];
    bolan_world *world = (bolan_world *)&scene;
    assert_int_equal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &world), BOLAN_OK);
    assert_null(assets.ground);
    assert_null(assets.models[1]);
    assert_int_equal(assets.model_count, 0);
    assert_ptr_equal(bolan_world_object_models(world)[0], boat);
    bolan_world_destroy(&world);
    // Also where it fails.
    assets = pond_assets();
    scene.water.level = 99.0;
    world = (bolan_world *)&scene;
    assert_refusal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &world), BOLAN_ERROR_ARGUMENT,
                   BOLAN_LOG_OUT_OF_RANGE, "water.level");
    assert_null(world);
    assert_null(assets.ground);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void an_object_needs_a_model(void **state) {
    (void)state;
    const bolan_scene scene = pond_scene();
    bolan_world_assets assets = pond_assets();
    assets.object_models[1] = NULL;
    bolan_world *world = NULL;
    assert_refusal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &world), BOLAN_ERROR_ARGUMENT,
                   BOLAN_LOG_WORLD_MODEL, "object 1 (builtin:house) has no model");
    assert_refusal(bolan_world_create(&(bolan_world_desc){.scene = &scene}, &world), BOLAN_ERROR_ARGUMENT,
                   BOLAN_LOG_WORLD_MODEL, "object 0");
    assert_null(world);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void another_scene_state_makes_another_sea(void **state) {
    (void)state;
    bolan_world *world = open_sea();
    bolan_world_settle(world, 5.0);
    bolan_scene scene = *bolan_world_scene(world);
    const uint64_t id = bolan_sea_id(bolan_world_water(world)->sea);
    scene.water.level = -0.5;
    scene.sky.sun_elevation_deg = 3.0;
    scene.time = 77.0; // the world stays at its own
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    assert_true(bolan_sea_id(bolan_world_water(world)->sea) == id);
    assert_true(bolan_world_water(world)->level == -0.5);
    assert_true(bolan_world_scene(world)->sky.sun_elevation_deg == 3.0 && bolan_world_scene(world)->time == 5.0);

    bolan_scene_set_wind(&scene, 17.0, 90.0);
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    const bolan_sea *fresh = bolan_world_water(world)->sea;
    assert_true(bolan_sea_id(fresh) != id);
    bolan_sea *expected = NULL;
    const bolan_sea_desc desc = bolan_scene_sea_desc(&scene);
    assert_int_equal(bolan_sea_create(&desc, &expected), BOLAN_OK);
    bolan_sea_settle(expected, 5.0);
    assert_same_sea(fresh, expected);
    assert_same_foam(fresh, expected);
    bolan_sea_destroy(&expected);
    bolan_world_destroy(&world);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void assert_stays(bolan_world *world, const bolan_scene *wrong, bolan_log_id id, const char *words) {
    const bolan_scene before = *bolan_world_scene(world);
    const uint64_t serial = bolan_sea_serial(bolan_world_water(world)->sea);
    assert_refusal(bolan_world_set_scene(world, wrong), BOLAN_ERROR_ARGUMENT, id, words);
    assert_memory_equal(bolan_world_scene(world), &before, sizeof before);
    assert_true(bolan_sea_serial(bolan_world_water(world)->sea) == serial);
}

static void what_the_assets_stand_for_does_not_change(void **state) {
    (void)state;
    bolan_world *world = pond_world();
    const bolan_scene scene = *bolan_world_scene(world);
    bolan_scene s = scene;
    s.terrain.kind = BOLAN_GROUND_NONE, assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "terrain.kind");
    s = scene, s.terrain.generator.seed++, assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "terrain.generator");
    s = scene, s.spectrum_path[0] = 'a', assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "spectrum_path");
    s = scene, s.spectrum.spread_s = 9.0, assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "scene.spectrum differs");
    s = scene, s.tiles_path[0] = 'a', assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "tiles_path");
    s = scene, s.object_count = 1, assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "object_count");
    s = scene, s.objects[1].model[8] = 'm', assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "objects.model");
    s = scene, s.objects[1].up = BOLAN_UP_Z, assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "objects.up");
    for (int axis = 0; axis < 3; axis++) {
        s = scene;
        (&s.objects[0].offset.x)[axis] = 1.0;
        assert_stays(world, &s, BOLAN_LOG_WORLD_ASSETS, "objects.offset");
    }
    s = scene, s.sky.visibility = 1.0, assert_stays(world, &s, BOLAN_LOG_OUT_OF_RANGE, "visibility");
    // Objects may move.
    s = scene, s.objects[1].position.x = 9.0, s.terrain.shown_by_object = true;
    assert_int_equal(bolan_world_set_scene(world, &s), BOLAN_OK);
    assert_true(bolan_world_scene(world)->objects[1].position.x == 9.0);
    bolan_world_destroy(&world);
}

static void another_raster_is_another_ground(void **state) {
    (void)state;
    bolan_scene scene = pond_scene();
    scene.terrain.kind = BOLAN_GROUND_RASTER;
    snprintf(scene.terrain.raster.path, sizeof scene.terrain.raster.path, "a.tif");
    bolan_world_assets assets = pond_assets();
    bolan_world *world = NULL;
    assert_int_equal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &world), BOLAN_OK);
    scene.terrain.generator.seed++; // it is not in use
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    scene.terrain.raster.radius = 2e5;
    assert_stays(world, &scene, BOLAN_LOG_WORLD_ASSETS, "terrain.raster");
    bolan_world_destroy(&world);
}

// Heights of the water under the places of the hull's formula, asked here one by one.
static double height_at(const bolan_water *water, double x, double y) {
    bolan_query_point p;
    bolan_query_surface(water, &(bolan_dvec2){x, y}, 1, &p);
    return (double)p.height;
}

static double dot(bolan_dvec3 a, bolan_dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static void floating_objects_ride_the_water(void **state) {
    (void)state;
    bolan_world *world = pond_world();
    const bolan_water *water = bolan_world_water(world);
    bolan_world_step(world, 4.0);
    const bolan_pose house = bolan_world_object_pose(world, 1);
    assert_true(house.origin.x == 60.0 && house.origin.y == 5.0 && house.origin.z == 3.0);
    assert_near(house.y.x, 1.0, 1e-12); // it looks east
    assert_near(house.x.y, -1.0, 1e-12);
    assert_near(house.z.z, 1.0, 0.0);

    const bolan_pose boat = bolan_world_object_pose(world, 0);
    bolan_vec3 low, high;
    bolan_model_bounds(bolan_world_object_models(world)[0], &low, &high);
    const double c = cos(bolan_radians(30.0)), s = sin(bolan_radians(30.0)); // ahead is (s, c), right is (c, -s)
    const double mx = 1.5 * 0.5 * (double)(low.x + high.x), my = 1.5 * 0.5 * (double)(low.y + high.y);
    const double hx = 1.5 * 0.4 * (double)(high.x - low.x), hy = 1.5 * 0.4 * (double)(high.y - low.y);
    const double at[5][2] = {{mx, my}, {mx, my + hy}, {mx, my - hy}, {mx + hx, my}, {mx - hx, my}};
    double h[5], mean = 0.0;
    for (int i = 0; i < 5; i++) {
        h[i] = height_at(water, 3.0 + at[i][0] * c + at[i][1] * s, -2.0 - at[i][0] * s + at[i][1] * c);
        mean += h[i] / 5.0;
    }
    assert_near(boat.origin.z, 0.1 + mean, 1e-6);
    assert_near(boat.y.z / hypot(boat.y.x, boat.y.y), 0.7 * (h[1] - h[2]) / (2.0 * hy), 1e-6); // bow up where it rises
    assert_near(dot(boat.x, boat.y), 0.0, 1e-12);
    assert_near(dot(boat.y, boat.z), 0.0, 1e-12);
    assert_near(dot(boat.z, boat.z), 1.0, 1e-12);
    const double roll = boat.x.z; // starboard up where the water is higher there
    assert_true(roll * (h[3] - h[4]) > 0.0);
    assert_near(roll, 0.7 * (h[3] - h[4]) / (2.0 * hx), 0.1 * fabs(roll));
    bolan_world_destroy(&world);
}

static void the_camera_is_lifted_out_of_the_ground(void **state) {
    (void)state;
    bolan_world *world = pond_world();
    bolan_camera camera = bolan_world_scene(world)->camera;
    camera.position = bolan_dv3(200.0, 0.0, -5.0); // in the meadow
    bolan_world_set_camera(world, &camera);
    const double land = (double)bolan_ground_elevation(bolan_world_water(world)->ground, 200.0, 0.0, 0.0);
    assert_true(land > 0.25);
    assert_near(bolan_world_camera_at(world, 0.0).position.z, land + 1.8, 1e-9);
    camera.position = bolan_dv3(0.0, 0.0, -50.0); // under the bed of the pond
    bolan_world_set_camera(world, &camera);
    const double bed = (double)bolan_ground_elevation(bolan_world_water(world)->ground, 0.0, 0.0, 0.0);
    assert_true(bed < 0.0);
    assert_near(bolan_world_camera_at(world, 0.0).position.z, bed + 0.3, 1e-9);
    camera.position.z = 12.0;
    bolan_world_set_camera(world, &camera);
    assert_near(bolan_world_camera_at(world, 0.0).position.z, 12.0, 0.0);
    // On a path.
    bolan_scene scene = *bolan_world_scene(world);
    scene.camera_key_count = 2;
    scene.camera_keys[0] = (bolan_camera_key){0.0, camera};
    scene.camera_keys[1] = (bolan_camera_key){10.0, camera};
    scene.camera_keys[1].camera.position = bolan_dv3(200.0, 0.0, -5.0);
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    assert_near(bolan_world_camera_at(world, 10.0).position.x, 200.0, 1e-9);
    assert_near(bolan_world_camera_at(world, 10.0).position.z, land + 1.8, 1e-9);
    bolan_world_destroy(&world);
}

static void an_eye_keeps_clear_of_the_water(void **state) {
    (void)state;
    bolan_world *world = pond_world();
    const bolan_water *water = bolan_world_water(world);
    bolan_world_step(world, 4.0);
    bolan_scene scene = *bolan_world_scene(world);
    scene.technique.optics = BOLAN_OPTICS_CREST;
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    for (int i = 0; i < 9; i++) {
        const double x = 3.1 * i, y = -1.7 * i, clear = height_at(water, x, y) + 0.3;
        const double heights[] = {-40.0, clear - 0.2, clear - 0.01, clear, clear + 0.01, 900.0};
        for (int k = 0; k < 6; k++) {
            const bolan_dvec3 eye = bolan_world_clear_eye(world, bolan_dv3(x, y, heights[k]));
            assert_true(eye.x == x && eye.y == y && eye.z == (k < 3 ? clear : heights[k]));
        }
    }
    // With views from below an eye under the level stays; one between crest and level does not.
    scene.technique.optics = BOLAN_OPTICS_MIRROR;
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    int lifted = 0;
    for (int i = 0; i < 9; i++) {
        const double x = 3.1 * i, clear = height_at(water, x, 4.0) + 0.3;
        assert_true(bolan_world_clear_eye(world, bolan_dv3(x, 4.0, 0.2499)).z == 0.2499);
        assert_true(bolan_world_clear_eye(world, bolan_dv3(x, 4.0, 0.2501)).z == fmax(0.2501, clear));
        lifted += clear > 0.2501;
    }
    assert_true(lifted > 4);
    // Drawn from everywhere, an eye stays everywhere.
    scene.technique.optics = BOLAN_OPTICS_PHYSICAL;
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    for (int i = 0; i < 9; i++) {
        const double z = height_at(water, 3.1 * i, 4.0) + 0.1 * (i - 4);
        assert_true(bolan_world_clear_eye(world, bolan_dv3(3.1 * i, 4.0, z)).z == z);
    }
    for (int kind = -1; kind <= BOLAN_OPTICS_KINDS; kind++)
        assert_true(bolan_optics_seen_from_below((bolan_optics_kind)kind) ==
                    (kind == BOLAN_OPTICS_MIRROR || kind == BOLAN_OPTICS_PHYSICAL));
    bolan_world_destroy(&world);
}

// ---- memory that runs out -------------------------------------------------------------------------------------------

static bolan_result create(void) {
    const bolan_scene scene = small_scene();
    bolan_world *world = (bolan_world *)&world;
    const bolan_result result = bolan_world_create(&(bolan_world_desc){.scene = &scene}, &world);
    assert_true((world == NULL) == (result != BOLAN_OK));
    bolan_world_destroy(&world);
    return result;
}

static void without_memory_there_is_no_world(void **state) {
    (void)state;
    assert_memory_failures(create);
}

static bolan_world *changed;

static bolan_result change(void) {
    static double wind = 10.0;
    bolan_scene scene = *bolan_world_scene(changed);
    bolan_scene_set_wind(&scene, wind, 40.0);
    const uint64_t serial = bolan_sea_serial(bolan_world_water(changed)->sea);
    const bolan_result result = bolan_world_set_scene(changed, &scene);
    if (result) assert_true(bolan_sea_serial(bolan_world_water(changed)->sea) == serial);
    return result;
}

static void without_memory_the_old_sea_stays(void **state) {
    (void)state;
    const bolan_hooks hooks = {.log = remember, .allocate = scarce_allocate, .release = scarce_release};
    allocations_left = -1;
    bolan_set_hooks(&hooks);
    changed = open_sea();
    assert_memory_failures(change);
    assert_true(bolan_world_scene(changed)->sea.sea_state.wind_speed == 10.0);
    bolan_world_destroy(&changed);
    assert_int_equal(bolan_memory_in_use(), 0);
}

static void steps_allocate_nothing(void **state) {
    (void)state;
    const bolan_hooks hooks = {.log = remember, .allocate = scarce_allocate, .release = scarce_release};
    allocations_left = -1;
    bolan_set_hooks(&hooks);
    bolan_world *world = pond_world();
    const bolan_scene scene = *bolan_world_scene(world);
    allocations_left = 0; // the next one fails and shows
    bolan_world_step(world, 3.0);
    bolan_world_settle(world, 9.0);
    bolan_world_set_camera(world, &scene.camera);
    bolan_world_object_pose(world, 0);
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    assert_int_equal(allocations_left, 0);
    bolan_world_destroy(&world);
    allocations_left = -1;
}

static void trains_of_the_scene_are_layers_of_the_water(void **state) {
    (void)state;
    bolan_scene scene = small_scene();
    scene.train_count = 2;
    scene.trains[0] = scene.trains[1] = bolan_wave_train_desc_default();
    scene.trains[1].from_deg = 120.0, scene.trains[1].length = 40.0, scene.trains[1].height = 0.7;
    bolan_world *world = NULL;
    assert_int_equal(bolan_world_create(&(bolan_world_desc){.scene = &scene}, &world), BOLAN_OK);
    bolan_wave_layer *layers[2];
    for (int i = 0; i < 2; i++) assert_int_equal(bolan_wave_layer_create_train(&scene.trains[i], &layers[i]), BOLAN_OK);
    bolan_water by_hand = *bolan_world_water(world);
    assert_int_equal(by_hand.layer_count, 2);
    by_hand.layers = (const bolan_wave_layer *const *)layers;
    const bolan_dvec2 places[3] = {{0.0, 0.0}, {31.0, -7.0}, {-500.0, 80.0}};
    float a[3], b[3], c[3];
    bolan_query_heights(bolan_world_water(world), places, 3, a);
    bolan_query_heights(&by_hand, places, 3, b);
    by_hand.layer_count = 0;
    bolan_query_heights(&by_hand, places, 3, c);
    assert_memory_equal(a, b, sizeof a);
    assert_memory_not_equal(a, c, sizeof a);

    // Another scene, other trains; one that breaks is refused and changes nothing.
    scene.train_count = 1;
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_OK);
    assert_int_equal(bolan_world_water(world)->layer_count, 1);
    scene.trains[0].length = 5.0;
    scene.trains[0].height = 2.0;
    assert_int_equal(bolan_world_set_scene(world, &scene), BOLAN_ERROR_ARGUMENT);
    assert_int_equal(bolan_world_water(world)->layer_count, 1);
    assert_near(bolan_world_scene(world)->trains[0].length, 100.0, 0.0);
    bolan_world_destroy(&world);
    assert_int_equal(bolan_world_create(&(bolan_world_desc){.scene = &scene}, &world), BOLAN_ERROR_ARGUMENT);
    assert_null(world);
    for (int i = 0; i < 2; i++) bolan_wave_layer_destroy(&layers[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_has_the_bits_of_its_parts),
        cmocka_unit_test(its_water_is_that_of_the_scene),
        cmocka_unit_test(it_takes_its_assets_over),
        cmocka_unit_test(an_object_needs_a_model),
        cmocka_unit_test(another_scene_state_makes_another_sea),
        cmocka_unit_test(what_the_assets_stand_for_does_not_change),
        cmocka_unit_test(another_raster_is_another_ground),
        cmocka_unit_test(floating_objects_ride_the_water),
        cmocka_unit_test(the_camera_is_lifted_out_of_the_ground),
        cmocka_unit_test(an_eye_keeps_clear_of_the_water),
        cmocka_unit_test(without_memory_there_is_no_world),
        cmocka_unit_test(without_memory_the_old_sea_stays),
        cmocka_unit_test(trains_of_the_scene_are_layers_of_the_water),
        cmocka_unit_test(steps_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
