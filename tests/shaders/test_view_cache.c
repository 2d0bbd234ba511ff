// SPDX-License-Identifier: MIT
// What is made once and shared: programs are compiled on request, before the first frame, and caches of views use the
// renderer's, also after a reload. Targets of views of different sizes that take turns are kept.
#include "gl_support.h"

#include "bolan/io.h"
#include "render/kept_sizes.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, BYTES = WIDTH * HEIGHT * 3 };

typedef struct rig {
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
    bolan_view view;
} rig;

static void open_rig(rig *r, const char *name, const bolan_technique *technique, const char *shaders) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0;
    bolan_scene_set_technique(&scene, technique);
    assert_int_equal(bolan_world_load_scene(&scene, &r->world), BOLAN_OK);
    bolan_world_step(r->world, 1.0);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    desc.shader_directory = shaders;
    assert_int_equal(bolan_renderer_create(&desc, &r->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    r->view = bolan_view_from_camera(&scene.camera, WIDTH, HEIGHT);
    r->view.eye = bolan_world_clear_eye(r->world, r->view.eye);
    r->view.framebuffer = bolan_target_framebuffer(r->target);
}

static void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    bolan_renderer_destroy(&r->renderer);
    bolan_world_destroy(&r->world);
}

static void draw(rig *r, const bolan_view *view, uint8_t rgb[BYTES]) {
    bolan_renderer_draw_world(r->renderer, r->world, view);
    bolan_renderer_read_rgb8(r->renderer, view->framebuffer, WIDTH, HEIGHT, rgb);
}

static uint32_t programs_of(const rig *r) { return bolan_renderer_statistics(r->renderer).programs; }

// ---- on request -----------------------------------------------------------------------------------------------------

typedef struct heard_progress {
    uint32_t calls, total;
} heard_progress;

static void hear_progress(void *user, uint32_t done, uint32_t total) {
    heard_progress *heard = user;
    assert_int_equal(done, ++heard->calls);
    if (heard->total > 0) assert_int_equal(total, heard->total);
    heard->total = total;
}

static void compile_and_draw(const char *scene, const bolan_technique *technique) {
    static uint8_t rgb[BYTES];
    heard_progress heard = {0}, again = {0};
    rig r;
    open_rig(&r, scene, technique, NULL);
    const bolan_water *water = bolan_world_water(r.world);
    const bolan_lighting lighting = bolan_lighting_from_scene(bolan_world_scene(r.world));
    assert_int_equal(bolan_renderer_compile(r.renderer, water, &lighting, hear_progress, &heard), BOLAN_OK);
    assert_true(heard.calls > 0 && heard.calls == heard.total);
    assert_int_equal(bolan_renderer_compile(r.renderer, water, &lighting, hear_progress, &again), BOLAN_OK);
    assert_int_equal(again.calls, 0);
    const uint32_t before = programs_of(&r);
    draw(&r, &r.view, rgb);
    if (programs_of(&r) != before)
        fail_msg("%s: the first frame compiled %u programs", technique->name, programs_of(&r) - before);
    close_rig(&r);
}

static void after_compile_the_first_frame_compiles_nothing(void **state) {
    (void)state;
    uint32_t count;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; ++i) compile_and_draw(i % 2 == 0 ? "pond" : "open-sea", &all[i]);
}

// ---- caches ---------------------------------------------------------------------------------------------------------

static void a_cache_compiles_nothing_and_draws_the_same(void **state) {
    (void)state;
    static uint8_t plain[BYTES], cached[BYTES];
    rig r;
    open_rig(&r, "pond", &bolan_technique_ocean, NULL);
    draw(&r, &r.view, plain);
    const uint32_t before = programs_of(&r);
    bolan_view_cache *caches[2] = {NULL, NULL};
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(bolan_view_cache_create(r.renderer, &caches[i]), BOLAN_OK);
        r.view.cache = caches[i];
        draw(&r, &r.view, cached);
        assert_memory_equal(cached, plain, BYTES);
    }
    assert_int_equal(programs_of(&r), before);
    bolan_view_cache_destroy(&caches[1]); // the renderer's and the other cache's programs stay
    r.view.cache = caches[0];
    draw(&r, &r.view, cached);
    assert_memory_equal(cached, plain, BYTES);
    bolan_view_cache_destroy(&caches[0]);
    r.view.cache = NULL;
    draw(&r, &r.view, cached);
    assert_memory_equal(cached, plain, BYTES);
    close_rig(&r);
}

// Sum of the differences of two images.
static long difference(const uint8_t a[BYTES], const uint8_t b[BYTES]) {
    long sum = 0;
    for (int i = 0; i < BYTES; ++i) sum += labs((long)a[i] - b[i]);
    return sum;
}

static void change_shader(const char *path, const char *edit) {
    char command[512];
    snprintf(command, sizeof command, "sed -i '%s' cache_shaders/%s", edit, path);
    assert_int_equal(system(command), 0);
}

static void a_reload_reaches_the_caches(void **state) {
    (void)state;
    static uint8_t before[BYTES], after[BYTES], cached[BYTES];
    assert_int_equal(system("rm -rf cache_shaders && cp -r " BOLAN_SOURCE_DIR "/shaders cache_shaders"), 0);
    rig r;
    open_rig(&r, "pond", &bolan_technique_ocean, "cache_shaders");
    bolan_view_cache *cache = NULL;
    assert_int_equal(bolan_view_cache_create(r.renderer, &cache), BOLAN_OK);
    bolan_view own = r.view, with = r.view;
    with.cache = cache;
    draw(&r, &own, before);
    draw(&r, &with, cached);
    assert_memory_equal(cached, before, BYTES);
    // Each change shows: the sky's radiance stands in a table that was made before, the background is drawn each time.
    static const char *const changes[][2] = {
        {"sky_view.glsl", "s/color = vec4(light +/color = vec4(vec3(4.0, 1.0, 1.0) * light +/"},
        {"sky.glsl", "s/return textureLod(panorama/return vec4(0.3, 3.0, 1.0, 1.0) * textureLod(panorama/"}};
    for (int i = 0; i < 2; ++i) {
        change_shader(changes[i][0], changes[i][1]);
        assert_int_equal(bolan_renderer_reload(r.renderer), BOLAN_OK);
        draw(&r, &own, after);
        draw(&r, &with, cached);
        assert_memory_equal(cached, after, BYTES);
        assert_true(difference(after, before) > BYTES);
        memcpy(before, after, BYTES);
    }
    bolan_view_cache_destroy(&cache);
    close_rig(&r);
    assert_int_equal(system("rm -rf cache_shaders"), 0);
}

// ---- sizes ----------------------------------------------------------------------------------------------------------

static void sizes_are_kept_by_turns(void **state) {
    (void)state;
    kept_sizes k = {.clock = 0};
    bool fresh = false;
    uint32_t over = 99, slots[KEPT_SIZES];
    for (uint32_t i = 0; i < KEPT_SIZES; ++i) {
        slots[i] = bolan_kept_sizes_use(&k, 100 + i, 50, &fresh);
        assert_true(fresh);
        for (uint32_t j = 0; j < i; ++j) assert_int_not_equal(slots[i], slots[j]);
    }
    for (uint32_t i = 0; i < 3 * KEPT_SIZES; ++i) {
        assert_int_equal(bolan_kept_sizes_use(&k, 100 + i % KEPT_SIZES, 50, &fresh), slots[i % KEPT_SIZES]);
        assert_false(fresh);
    }
    assert_int_equal(bolan_kept_sizes_use(&k, 100, 50, &fresh), slots[0]);
    assert_int_equal(bolan_kept_sizes_use(&k, 100, 51, &fresh), slots[1]); // the size used the longest time ago goes
    assert_true(fresh);
    assert_int_equal(bolan_kept_sizes_use(&k, 50, 100, &fresh), slots[2]); // neither way round is the other's size
    assert_true(fresh);
    assert_false(bolan_kept_sizes_over(&k, &over));
    // Large sizes are not kept beside each other.
    const uint32_t large = bolan_kept_sizes_use(&k, 4096, 4096, &fresh);
    assert_false(bolan_kept_sizes_over(&k, &over));
    const uint32_t larger = bolan_kept_sizes_use(&k, 8192, 4096, &fresh);
    assert_int_not_equal(larger, large);
    int freed = 0;
    while (bolan_kept_sizes_over(&k, &over)) {
        assert_int_not_equal(over, larger);
        ++freed;
    }
    assert_int_equal(freed, 2); // without the small ones, which are older, the large one has just what is allowed
    bolan_kept_sizes_forget(&k, larger);
    (void)bolan_kept_sizes_use(&k, 8192, 4096, &fresh);
    assert_true(fresh);
}

static void alternate(const char *scene, const bolan_technique *technique) {
    static uint8_t first[2][BYTES], rgb[BYTES];
    rig r;
    open_rig(&r, scene, technique, NULL);
    bolan_view views[2] = {r.view, r.view};
    views[1].width = WIDTH / 2;
    uint32_t made = 0;
    for (int i = 0; i < 8; ++i) {
        draw(&r, &views[i % 2], i < 2 ? first[i] : rgb);
        if (i == 1) made = bolan_gl_textures_made();
        if (i > 1) assert_memory_equal(rgb, first[i % 2], BYTES);
    }
    if (bolan_gl_textures_made() != made)
        fail_msg("%s, %s: %u textures were made anew", scene, technique->name, bolan_gl_textures_made() - made);
    close_rig(&r);
}

static void views_of_two_sizes_make_no_textures(void **state) {
    (void)state;
    uint32_t count;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; ++i) alternate("pond", &all[i]);
}

#define IN_CORE(f) cmocka_unit_test_setup_teardown(f, gl_setup_core, gl_teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_are_kept_by_turns),
        IN_CORE(a_cache_compiles_nothing_and_draws_the_same),
        IN_CORE(a_reload_reaches_the_caches),
        IN_CORE(after_compile_the_first_frame_compiles_nothing),
        IN_CORE(views_of_two_sizes_make_no_textures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
