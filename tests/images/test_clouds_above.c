// SPDX-License-Identifier: MIT
// Clouds seen from above stay where they are while the eye flies on, although their map was made where it was before.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 200
#define HEIGHT 150

static bolan_scene high_scene(void) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 128;
    scene.sky.cloud_cover = 0.3;
    scene.camera =
        (bolan_camera){.position = {0.0, 0.0, 8000.0}, .heading_deg = 20.0, .pitch_deg = -30.0, .fov_deg = 50.0};
    bolan_scene_set_technique(&scene, &bolan_technique_flight_sim);
    return scene;
}

static void clouds_stay_while_the_eye_flies_on(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene = high_scene();
    stage flown, fresh;
    assert_true(stage_open(&flown, &scene, BOLAN_QUALITY_LOW, false));
    picture before = stage_draw(&flown, WIDTH, HEIGHT, 1);
    // less than a tenth of the way to the clouds, so that the map is kept
    scene.camera.position = (bolan_dvec3){200.0, 550.0, 7850.0};
    flown.scene.camera.position = scene.camera.position;
    flown.progressive = true;
    picture got = stage_draw(&flown, WIDTH, HEIGHT, 1);
    assert_true(stage_open(&fresh, &scene, BOLAN_QUALITY_LOW, false));
    picture expected = stage_draw(&fresh, WIDTH, HEIGHT, 1);
    // The clouds' sides and a map of other texels are what may differ.
    const double psnr = picture_psnr(&expected, &got), stuck = picture_psnr(&expected, &before);
    print_message("flown on: %.1f dB, stuck: %.1f dB\n", psnr, stuck);
    if (psnr < stuck + 5.0) picture_report("clouds_above", &expected, &got, psnr, stuck + 5.0);
    assert_true(psnr >= stuck + 5.0);
    picture_free(&before);
    picture_free(&got);
    picture_free(&expected);
    stage_close(&fresh);
    stage_close(&flown);
    bolan_context_destroy(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(clouds_stay_while_the_eye_flies_on)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
