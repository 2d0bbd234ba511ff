// SPDX-License-Identifier: MIT
// Temporal antialiasing against supersampling: the same mean where nothing moves, no farther from the truth than a
// single sample where camera and sea do, and no trace of what is gone.
#include "picture.h"

#include "../shaders/gl_support.h"

enum { WIDTH = 192, HEIGHT = 108, BYTES = WIDTH * HEIGHT * 3, SAMPLES = 16 };

typedef struct rig {
    stage s;
    bolan_target *target;
    uint8_t rgb[BYTES], other[BYTES];
} rig;

static rig *open_rig(const char *name) {
    rig *r = calloc(1, sizeof *r);
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sky.cloud_cover = 0.0;
    scene.sea.resolution = 128;
    assert_true(stage_open(&r->s, &scene, BOLAN_QUALITY_LOW, false));
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    return r;
}

static void close_rig(rig *r) {
    bolan_target_destroy(&r->target);
    stage_close(&r->s);
    free(r);
}

static void draw(rig *r, bool temporal, uint32_t samples, bolan_view_cache *cache, uint8_t *rgb) {
    bolan_view view = stage_view(&r->s, r->target, WIDTH, HEIGHT);
    view.temporal = temporal;
    view.samples = samples;
    view.cache = cache;
    bolan_renderer_draw_world(r->s.renderer, r->s.world, &view);
    bolan_renderer_read_rgb8(r->s.renderer, view.framebuffer, WIDTH, HEIGHT, rgb);
}

static double rms_of(const uint8_t *a, const uint8_t *b, uint32_t from_row, uint32_t to_row) {
    double sum = 0.0;
    for (uint32_t i = from_row * WIDTH * 3; i < to_row * WIDTH * 3; i++) sum += pow((double)a[i] - b[i], 2.0);
    return sqrt(sum / ((to_row - from_row) * WIDTH * 3));
}

static void a_still_picture_becomes_the_mean_of_its_samples(void **state) {
    (void)state;
    rig *r = open_rig("island");
    for (uint32_t i = 0; i < SAMPLES / 2; i++) draw(r, true, 2, NULL, r->rgb);
    draw(r, false, SAMPLES, NULL, r->other);
    int worst = 0;
    for (uint32_t i = 0; i < BYTES; i++) worst = (int)fmax(worst, abs(r->rgb[i] - r->other[i]));
    print_message("largest difference of %d images: %d of 255\n", SAMPLES, worst);
    assert_true(worst <= 1); // the same samples in another order, rounded once
    close_rig(r);
}

static void move_on(rig *r, int frame) {
    bolan_camera *c = &r->s.scene.camera;
    c->position.x += 0.2;
    c->heading_deg += 0.15;
    stage_update(&r->s);
    stage_step(&r->s, r->s.scene.time + (frame + 1) / 30.0);
}

// Over a sea with glitter the history is some frames old, and the waves have changed their slopes since.
static void check_moving(const char *name, double height, double most) {
    rig *r = open_rig(name);
    bolan_view_cache *cache = NULL; // the truth has no history
    double single = 0.0, temporal = 0.0;
    r->s.scene.camera.position.z = height;
    assert_int_equal(bolan_view_cache_create(r->s.renderer, &cache), BOLAN_OK);
    uint8_t *truth = malloc(BYTES);
    for (int i = 0; i < 14; i++) {
        move_on(r, i);
        draw(r, true, 1, cache, r->rgb);
        if (i < 10) continue;
        draw(r, false, 1, NULL, r->other);
        draw(r, false, SAMPLES, NULL, truth);
        single += rms_of(r->other, truth, 0, HEIGHT) / 4.0;
        temporal += rms_of(r->rgb, truth, 0, HEIGHT) / 4.0;
    }
    print_message("%s: rms error %.2f of 255 with, %.2f without\n", name, temporal, single);
    assert_true(temporal <= most * single);
    free(truth);
    bolan_view_cache_destroy(&cache);
    close_rig(r);
}

static void moving_pictures_are_nearer_to_the_truth(void **state) {
    (void)state;
    check_moving("open-sea", 8.0, 1.0);
    check_moving("storm", 12.0, 1.0);
    check_moving("island", 12.0, 1.0);
}

static void two_runs_are_equal(void **state) {
    (void)state;
    uint8_t *first = malloc(BYTES);
    for (int run = 0; run < 2; run++) {
        rig *r = open_rig("open-sea");
        for (int i = 0; i < 4; i++) {
            move_on(r, i);
            draw(r, true, 1, NULL, r->rgb);
        }
        if (run == 0) memcpy(first, r->rgb, BYTES);
        if (run == 1) assert_memory_equal(first, r->rgb, BYTES);
        close_rig(r);
    }
    free(first);
}

// An object that has gone leaves what stands behind it: after so many frames nothing of it is left.
static void what_has_gone_leaves_no_ghost(void **state) {
    (void)state;
    enum { FRAMES = 3 };
    rig *r = open_rig("pond");
    r->s.scene.camera = (bolan_camera){.position = {9.0, 20.0, 2.5}, .fov_deg = 40.0}; // before the house, at (9, 42)
    for (int i = 0; i < 6; i++) draw(r, true, 1, NULL, r->rgb);
    uint8_t *there = malloc(BYTES);
    memcpy(there, r->rgb, BYTES);
    for (uint32_t i = 0; i < r->s.scene.object_count; i++)
        if (hypot(r->s.scene.objects[i].position.x - 9.0, r->s.scene.objects[i].position.y - 42.0) < 2.0)
            r->s.scene.objects[i].position.z -= 200.0;
    for (int i = 0; i < FRAMES; i++) {
        stage_step(&r->s, r->s.scene.time + (i + 1) / 30.0);
        draw(r, true, 1, NULL, r->rgb);
    }
    draw(r, false, SAMPLES, NULL, r->other);
    const double gone = rms_of(there, r->other, 30, 60), left = rms_of(r->rgb, r->other, 30, 60);
    print_message("the house: %.1f of 255; after %d frames %.1f are left\n", gone, FRAMES, left);
    assert_true(gone > 10.0 && left < 0.1 * gone);
    free(there);
    close_rig(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(a_still_picture_becomes_the_mean_of_its_samples),
        cmocka_unit_test_setup_teardown(moving_pictures_are_nearer_to_the_truth, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(two_runs_are_equal, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(what_has_gone_leaves_no_ghost, gl_setup_core, gl_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
