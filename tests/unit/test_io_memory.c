// SPDX-License-Identifier: MIT
// No memory: every creation and load of the core and of the files with its n-th allocation refused, alone and with all
// that follow. Each time the call returns MEMORY after exactly one sentence, gives nothing back and leaks nothing.
#include "bolan/io.h"
#include "content_support.h"
#include "io_support.h"

#include <unistd.h>

// ---- an allocator that refuses --------------------------------------------------------------------------------------

static long allocation, refuse_at; // counted from 1; 0: none is refused
static bool refuse_all_after;
static long refused;

static void *allocate(void *user, size_t size, size_t align) {
    (void)user;
    allocation++;
    const bool no = refuse_at > 0 && (allocation == refuse_at || (refuse_all_after && allocation > refuse_at));
    refused += no;
    return no ? NULL : aligned_alloc(align, (size + align - 1) / align * align);
}

static void release(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

static int warnings;

static void count(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    warnings += level == BOLAN_LOG_WARNING;
    remember(user, level, id, sentence);
}

static int listen(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.allocate = allocate, .release = release, .log = count});
    return 0;
}

/// Makes something of which *out is a part, and returns what the call returned.
typedef bolan_result maker(void **out);
typedef void destroyer(void **made);

// @p stride: only every so manieth allocation, where making the thing takes long; those that are refused alone lie
// between those that are refused with all that follow.
static void sweep_some(const char *name, maker *make, destroyer *destroy, long stride) {
    for (int all = 0; all < 2; all++) {
        long n = 1 + all * (stride / 2);
        for (;; n += stride) {
            void *out = &out; // must not stay
            const size_t before = bolan_memory_in_use();
            allocation = refused = 0, refuse_at = n, refuse_all_after = all == 1;
            error_count = 0, warnings = 0, last_sentence[0] = '\0';
            const bolan_result result = make(&out);
            const bool hit = refused > 0;
            refuse_at = 0;
            if (!hit) {
                assert_int_equal(result, BOLAN_OK);
                destroy(&out);
                assert_int_equal(bolan_memory_in_use(), before);
                break;
            }
            const bool good = result == BOLAN_ERROR_MEMORY && error_count == 1 && warnings == 0 &&
                              last_id == BOLAN_LOG_OUT_OF_MEMORY && !out;
            if (!good)
                print_error("%s, allocation %ld%s: result %d, %u errors, %d warnings, id %d, out %p, \"%s\"\n", name, n,
                            all ? " and on" : "", (int)result, error_count, warnings, (int)last_id, out, last_sentence);
            assert_true(good);
            assert_int_equal(bolan_memory_in_use(), before);
        }
        assert_true(n > 1); // it does ask for memory
    }
}

static void sweep(const char *name, maker *make, destroyer *destroy) { sweep_some(name, make, destroy, 1); }

// ---- seas and tiles -------------------------------------------------------------------------------------------------

static bolan_sea_desc small_sea(bolan_wave_model waves) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = waves;
    d.resolution = 32;
    d.textures.frames = 2;
    return d;
}

static bolan_wave_model model;

static bolan_result make_sea(void **out) {
    const bolan_sea_desc d = small_sea(model);
    return bolan_sea_create(&d, (bolan_sea **)out);
}
static void destroy_sea(void **sea) { bolan_sea_destroy((bolan_sea **)sea); }

static void seas(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        model = (bolan_wave_model)i;
        sweep(bolan_wave_model_names[i], make_sea, destroy_sea);
    }
}

static bolan_sea *loop;

static bolan_result bake_tiles(void **out) {
    const bolan_tiles_desc d = bolan_tiles_desc_default();
    return bolan_tiles_bake(loop, &d, (bolan_tiles **)out);
}
static bolan_result load_tiles(void **out) { return bolan_tiles_load("memory_tiles", (bolan_tiles **)out); }
static void destroy_tiles(void **tiles) { bolan_tiles_destroy((bolan_tiles **)tiles); }

static bolan_tiles *kept;

static bolan_result save_tiles(void **out) {
    *out = NULL;
    const bolan_result result = bolan_tiles_save(kept, "memory_copy");
    if (result) assert_int_not_equal(access("memory_copy", F_OK), 0);
    return result;
}
static void remove_copy(void **made) {
    (void)made;
    assert_int_equal(system("rm -r memory_copy"), 0);
}

static void tiles(void **state) {
    (void)state;
    const bolan_sea_desc d = small_sea(BOLAN_WAVES_TEXTURES);
    assert_int_equal(bolan_sea_create(&d, &loop), BOLAN_OK);
    sweep("bake", bake_tiles, destroy_tiles);
    void *made = NULL;
    assert_int_equal(bake_tiles(&made), BOLAN_OK);
    kept = made;
    if (access("memory_tiles", F_OK) == 0) assert_int_equal(system("rm -r memory_tiles"), 0);
    assert_int_equal(bolan_tiles_save(kept, "memory_tiles"), BOLAN_OK);
    sweep("tiles, load", load_tiles, destroy_tiles);
    sweep("tiles, save", save_tiles, remove_copy);
    assert_int_equal(system("rm -r memory_tiles"), 0);
    bolan_tiles_destroy(&kept);
    bolan_sea_destroy(&loop);
}

// ---- ground ---------------------------------------------------------------------------------------------------------

static bolan_result make_terrain(void **out) {
    static const float elevation[4] = {-1, -2, -3, -4};
    const bolan_ground_desc d = {.field = {2, 2, 0, 0, 10, 10, elevation}, .detail = 1, .edge_elevation = -10};
    return bolan_ground_create(&d, (bolan_ground **)out);
}
static bolan_result make_island(void **out) {
    const bolan_ground_generator d = generator_named("island");
    return bolan_content_create_ground(&d, (bolan_ground **)out);
}
static bolan_result make_pond(void **out) {
    const bolan_ground_generator generator = generator_named("pond");
    return bolan_content_create_ground(&generator, (bolan_ground **)out);
}
static void destroy_terrain(void **t) { bolan_ground_destroy((bolan_ground **)t); }

static void ground(void **state) {
    (void)state;
    sweep("terrain", make_terrain, destroy_terrain);
    sweep_some("island", make_island, destroy_terrain, 8);
    sweep("pond", make_pond, destroy_terrain);
}

// ---- files ----------------------------------------------------------------------------------------------------------

static bolan_result load_spectrum(void **out) {
    return bolan_spectrum_load("memory.spec", 0, (bolan_measured_spectrum **)out);
}
static void destroy_spectrum(void **s) { bolan_measured_spectrum_destroy((bolan_measured_spectrum **)s); }

static bolan_points points;

static bolan_result load_points(void **out) {
    const bolan_result result = bolan_points_load("memory.csv", &points);
    assert_int_equal(points.count, result ? 0 : 1000);
    *out = points.points;
    return result;
}
static void destroy_points(void **made) {
    (void)made;
    bolan_points_destroy(&points);
}

static bolan_result read_image(void **out) {
    uint32_t width, height;
    return bolan_image_read("memory.png", &width, &height, (uint8_t **)out);
}
static void release_image(void **made) { bolan_release(*made, 9 * 7 * 3); }

static bolan_result load_scene(void **out) {
    bolan_scene scene = {.time = -7};
    const bolan_result result = bolan_scene_load("./memory.yaml", &scene);
    assert_true(result ? scene.time == -7 : scene.time == 3);
    return *out = NULL, result;
}

static bolan_ground_kind world_ground;

static bolan_result load_world(void **out) {
    static bolan_scene scene;
    scene = bolan_scene_default();
    scene.sea.resolution = 32;
    snprintf(scene.spectrum_path, sizeof scene.spectrum_path, "memory.spec");
    scene.terrain.kind = world_ground;
    scene.terrain.generator = generator_named("pond");
    scene.object_count = 2;
    snprintf(scene.objects[0].model, sizeof scene.objects[0].model, "builtin:%s", bolan_content_model_name(0));
    snprintf(scene.objects[1].model, sizeof scene.objects[1].model, "builtin:%s", bolan_content_model_name(1));
    scene.objects[0].scale = scene.objects[1].scale = 1.0;
    return bolan_world_load_scene(&scene, (bolan_world **)out);
}
static void destroy_world(void **world) { bolan_world_destroy((bolan_world **)world); }

static bolan_result open_video(void **out) { return bolan_video_open("memory.mp4", 64, 36, 30, (bolan_video **)out); }
static void close_video(void **video) { bolan_video_close((bolan_video **)video, false); }

static bolan_result write_exr(void **out) {
    static float plane[100 * 100];
    for (int i = 0; i < 100 * 100; i++) plane[i] = (float)((i * 7919) % 10007) * 1.7f;
    const bolan_exr_channel channels[] = {{"R", plane}, {"G", plane}, {"B", plane}, {"Z", plane}};
    const bolan_result result = bolan_exr_write("memory.exr", 100, 100, channels, 4);
    if (result) assert_int_not_equal(access("memory.exr", F_OK), 0);
    return *out = NULL, result;
}
static void nothing(void **made) { (void)made; }
static void remove_exr(void **made) {
    (void)made;
    assert_int_equal(remove("memory.exr"), 0);
}

static void files(void **state) {
    (void)state;
    char path[64] = "";
    FILE *csv = fopen("memory.csv", "w");
    for (int i = 0; i < 1000; i++) fprintf(csv, "%d,%d\n", i, -i);
    fclose(csv);
    static const uint8_t rgb[9 * 7 * 3];
    assert_int_equal(bolan_png_write("memory.png", 9, 7, rgb), BOLAN_OK);
    write_text("memory.yaml", "time: 3\nsea: {wind: {speed: 5}}\n");
    snprintf(path, sizeof path, "memory.spec");
    assert_int_equal(system("cp '" BOLAN_SOURCE_DIR "/scenes/spectra/synthetic-bimodal.spec' memory.spec"), 0);
    sweep("spectrum", load_spectrum, destroy_spectrum);
    sweep("points", load_points, destroy_points);
    sweep("image", read_image, release_image);
    sweep("scene", load_scene, nothing);
    world_ground = BOLAN_GROUND_NONE;
    sweep("world", load_world, destroy_world);
    world_ground = BOLAN_GROUND_GENERATED; // whose own allocations have been refused one by one
    sweep_some("world with a ground", load_world, destroy_world, 8);
    sweep("video", open_video, close_video);
    sweep("exr", write_exr, remove_exr);
    assert_int_equal(system("rm memory.csv memory.png memory.yaml memory.spec; ! ls memory* 2> /dev/null"), 0);
}

// ---- models ---------------------------------------------------------------------------------------------------------

static const char *model_name;

static bolan_result make_model(void **out) { return bolan_content_create_model(model_name, (bolan_model **)out); }
static void destroy_model(void **m) { bolan_model_destroy((bolan_model **)m); }

static void models(void **state) {
    (void)state;
    for (uint32_t i = 0; (model_name = bolan_content_model_name(i)) != NULL; i++)
        sweep(model_name, make_model, destroy_model);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seas),  cmocka_unit_test(tiles),  cmocka_unit_test(ground),
        cmocka_unit_test(files), cmocka_unit_test(models),
    };
    return cmocka_run_group_tests(tests, listen, NULL);
}
