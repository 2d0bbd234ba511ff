// SPDX-License-Identifier: MIT
// The small image of the air over the water (src/render/water_air.c) is made down to its last row, which the water at
// the horizon reads: no image shows what the one before it saw.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

enum { WIDTH = 128, HEIGHT = 97 }; // the last texel of a column covers one row alone

static bolan_context *context;

// Away from the sun; or towards it and further down, with the horizon higher in the image.
static picture draw(stage *s, double pitch, bool towards) {
    s->scene.camera.pitch_deg = towards ? -25.0 : pitch;
    s->scene.camera.heading_deg = s->scene.sky.sun_azimuth_deg + (towards ? 0.0 : -180.0);
    return stage_draw(s, WIDTH, HEIGHT, 1);
}

static void the_horizon_shows_its_own_air(void **state) {
    (void)state;
    bolan_scene scene;
    stage s;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0;
    scene.sky.visibility = 5e3;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 30.0}, .fov_deg = 40.0};
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    for (int k = 0; k < 5; ++k) {              // the horizon in each row of a texel
        const double pitch = -15.0 + 0.21 * k; // a pixel is 0.42 degrees high
        picture away = draw(&s, pitch, false), towards = draw(&s, pitch, true), again = draw(&s, pitch, false);
        assert_memory_equal(away.rgb, again.rgb, 3 * WIDTH * HEIGHT);
        picture_free(&away);
        picture_free(&towards);
        picture_free(&again);
    }
    stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_horizon_shows_its_own_air)};
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}
