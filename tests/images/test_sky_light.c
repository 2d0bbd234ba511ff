// SPDX-License-Identifier: MIT
// The light of the sky is measured on the GPU: an image waits for it, a window goes on with that of an earlier frame.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 64
#define HEIGHT 48

static picture draw(stage *s, double elevation, bool progressive) {
    s->scene.sky.sun_elevation_deg = elevation;
    s->progressive = progressive;
    return stage_draw(s, WIDTH, HEIGHT, 1);
}

static bool is_same(const picture *a, const picture *b) {
    return memcmp(a->rgb, b->rgb, (size_t)3 * WIDTH * HEIGHT) == 0;
}

static void free_all(picture *all, int count) {
    for (int i = 0; i < count; ++i) picture_free(&all[i]);
}

static void a_window_shows_the_light_of_its_last_frame(void **state) {
    stage *s = *state;
    picture first = draw(s, 8.0, true), next = draw(s, 9.0, true); // reading back finishes both
    picture later = draw(s, 9.0, true), whole = draw(s, 9.0, false);
    assert_false(is_same(&next, &whole));
    assert_true(is_same(&later, &whole));
    free_all((picture[]){first, next, later, whole}, 4);
}

static void an_image_waits_for_its_light(void **state) {
    stage *s = *state;
    picture first = draw(s, 9.0, false), before = draw(s, 8.0, true); // whose light is under way
    picture again = draw(s, 9.0, false);
    assert_true(is_same(&first, &again));
    free_all((picture[]){first, before, again}, 3);
}

static void a_window_waits_for_another_sun(void **state) {
    stage *s = *state;
    picture low = draw(s, 9.0, true), high = draw(s, 30.0, true), whole = draw(s, 30.0, false);
    assert_true(is_same(&high, &whole));
    free_all((picture[]){low, high, whole}, 3);
}

static int open_stage(void **state) {
    static struct {
        bolan_context *context;
        stage stage;
    } own;
    if (bolan_context_create(BOLAN_GL_CORE, &own.context) != BOLAN_OK) {
        if (gl_is_required()) return -1;
        print_message("skipped: there is no OpenGL on this machine\n");
        exit(77);
    }
    bolan_scene scene;
    if (bolan_scene_load("open-sea", &scene) != BOLAN_OK) return -1;
    scene.sky.cloud_cover = 0.0; // a window makes new clouds over several frames
    scene.sea.resolution = 64;
    *state = &own.stage;
    return stage_open(&own.stage, &scene, BOLAN_QUALITY_LOW, false) ? 0 : -1;
}

static int close_stage(void **state) {
    stage_close(*state);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_shows_the_light_of_its_last_frame),
        cmocka_unit_test(an_image_waits_for_its_light),
        cmocka_unit_test(a_window_waits_for_another_sun),
    };
    return cmocka_run_group_tests(tests, open_stage, close_stage);
}
