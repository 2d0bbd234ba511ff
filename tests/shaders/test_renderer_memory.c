// SPDX-License-Identifier: MIT
// Memory that runs out: each allocation of the renderer fails once, alone or with all that follow. Nothing crashes,
// nothing leaks, the result is MEMORY, the log says so in one sentence, and *out is NULL.
#include "gl_support.h"

#include "bolan/io.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

// ---- a memory that fails at will ------------------------------------------------------------------------------------

static struct {
    long until;                 // allocations that succeed before one fails
    bool on;                    // all that follow fail too
    long count;                 // allocations so far
    long failed;                // of those, refused
    long bytes;                 // in use
    long errors, memory_errors; // sentences
} world;

static void *allocate(void *user, size_t size, size_t align) {
    (void)user;
    const long n = world.count++;
    if (n == world.until || (world.on && n > world.until)) {
        world.failed++;
        return NULL;
    }
    void *memory = NULL;
    if (posix_memalign(&memory, align < sizeof(void *) ? sizeof(void *) : align, size) != 0) return NULL;
    world.bytes += (long)size;
    return memory;
}

static void release(void *user, void *memory, size_t size) {
    (void)user;
    world.bytes -= (long)size;
    free(memory);
}

static void note(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)sentence;
    if (level != BOLAN_LOG_ERROR) return;
    world.errors++;
    world.memory_errors += id == BOLAN_LOG_OUT_OF_MEMORY;
}

static void fail_at(long n, bool on) {
    world.until = n;
    world.on = on;
    world.count = world.failed = world.errors = world.memory_errors = 0;
}

static void succeed(void) { fail_at(LONG_MAX, false); }

static void install(void) {
    bolan_set_hooks(&(bolan_hooks){.allocate = allocate, .release = release, .log = note});
    memset(&world, 0, sizeof world);
    succeed();
}

// ---- what is made ---------------------------------------------------------------------------------------------------

static bolan_result make_renderer(void **out) {
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    return bolan_renderer_create(&desc, (bolan_renderer **)out);
}
static void unmake_renderer(void **out) { bolan_renderer_destroy((bolan_renderer **)out); }
static bolan_result make_target(void **out) { return bolan_target_create(WIDTH, HEIGHT, (bolan_target **)out); }
static void unmake_target(void **out) { bolan_target_destroy((bolan_target **)out); }

static void sweep_creation(bolan_result (*make)(void **), void (*unmake)(void **), bool on, long step) {
    static int something;
    const long before = world.bytes;
    if (test_is_short()) step *= 9;
    for (long n = 0;; n += step) {
        void *made = &something;
        fail_at(n, on);
        const bolan_result result = make(&made);
        const long failed = world.failed, errors = world.errors, sentences = world.memory_errors;
        succeed();
        if (failed == 0) {
            assert_int_equal(result, BOLAN_OK);
            assert_non_null(made);
            assert_true(n > 0);
            unmake(&made);
            assert_int_equal(world.bytes, before);
            return;
        }
        if (result != BOLAN_ERROR_MEMORY || sentences != 1 || errors != 1 || made != NULL || world.bytes != before)
            fail_msg("allocation %ld: result %d, %ld errors, %ld of memory, %s, %ld bytes left", n, (int)result, errors,
                     sentences, made ? "made" : "NULL", world.bytes - before);
    }
}

static void a_renderer_without_memory_is_refused(void **state) {
    (void)state;
    install();
    sweep_creation(make_renderer, unmake_renderer, false, 1);
    bolan_set_hooks(NULL);
}

static void a_renderer_without_any_more_memory_is_refused(void **state) {
    (void)state;
    install();
    sweep_creation(make_renderer, unmake_renderer, true, 11); // what follows a failure hardly varies
    bolan_set_hooks(NULL);
}

static void a_target_without_memory_is_refused(void **state) {
    (void)state;
    install();
    sweep_creation(make_target, unmake_target, false, 1);
    sweep_creation(make_target, unmake_target, true, 1);
    bolan_set_hooks(NULL);
}

// ---- what a frame makes ---------------------------------------------------------------------------------------------

typedef struct rig {
    bolan_scene scene;
    bolan_world *world;
    bolan_target *target;
    bolan_view view;
} rig;

static void open_rig(rig *r, const char *scene, const bolan_technique *technique) {
    memset(r, 0, sizeof *r);
    assert_int_equal(bolan_scene_load(scene, &r->scene), BOLAN_OK);
    r->scene.sea.resolution = 32;
    r->scene.sea.fft.cascade_count = 2;
    bolan_scene_set_technique(&r->scene, technique);
    assert_int_equal(bolan_world_load_scene(&r->scene, &r->world), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    bolan_world_step(r->world, 1.0);
    r->view = bolan_view_from_camera(&r->scene.camera, WIDTH, HEIGHT);
    r->view.framebuffer = bolan_target_framebuffer(r->target);
}

static void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    bolan_world_destroy(&r->world);
}

// Each allocation of a first frame fails, or all from it on: said, no error in GL, nothing leaked. The frame after it,
// with memory, is drawn. Returns how many allocations a first frame takes.
static long sweep_frame(rig *r, bool on, long step) {
    static float linear[WIDTH * HEIGHT * 3], distance[WIDTH * HEIGHT];
    const long before = world.bytes;
    if (test_is_short()) step *= 3;
    for (long n = 0;; n += step) {
        void *renderer = NULL;
        succeed();
        assert_int_equal(make_renderer(&renderer), BOLAN_OK);
        fail_at(n, on);
        bolan_renderer_draw_world(renderer, r->world, &r->view);
        const long in_frame = world.count;
        bolan_renderer_read_linear(renderer, linear, distance);
        const long failed = world.failed, sentences = world.memory_errors, errors = world.errors;
        succeed();
        bolan_renderer_draw_world(renderer, r->world, &r->view);
        bolan_renderer_read_linear(renderer, linear, distance);
        if (!watch_is_clean("a frame without memory")) fail_msg("allocation %ld leaves an error in GL", n);
        assert_int_equal(world.errors, 0);
        unmake_renderer(&renderer);
        if (world.bytes != before) fail_msg("allocation %ld leaves %ld bytes", n, world.bytes - before);
        if (failed == 0) {
            assert_true(in_frame > 0);
            return in_frame;
        }
        if (sentences < 1 || (!on && sentences != 1) || errors != sentences)
            fail_msg("allocation %ld: %ld refused, %ld sentences of memory, %ld errors", n, failed, sentences, errors);
    }
}

static void sweep_technique(const char *scene, const bolan_technique *technique, bool on, long step) {
    rig r;
    install();
    open_rig(&r, scene, technique);
    printf("%s, %s: %ld allocations\n", scene, technique->name, sweep_frame(&r, on, step));
    close_rig(&r);
    assert_int_equal(world.bytes, 0);
    bolan_set_hooks(NULL);
}

static void a_first_frame_without_memory_says_so(void **state) {
    (void)state;
    sweep_technique("open-sea", &bolan_technique_ocean, false, 1);
    sweep_technique("open-sea", &bolan_technique_flight_sim, true, 4);
}

// Land, objects, tiles and mirrored pictures: the pool of land alone takes hundreds.
static void a_first_frame_of_a_pond_without_memory_says_so(void **state) {
    (void)state;
    sweep_technique("pond", &bolan_technique_two_triangle, false, 83);
    sweep_technique("pond", &bolan_technique_nested_grid, true, 97);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_target_without_memory_is_refused, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_renderer_without_memory_is_refused, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_renderer_without_any_more_memory_is_refused, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_first_frame_without_memory_says_so, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(a_first_frame_of_a_pond_without_memory_says_so, gl_setup_core, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
