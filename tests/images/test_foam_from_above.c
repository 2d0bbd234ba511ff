// SPDX-License-Identifier: MIT
// Foam in the image itself, seen straight down from 100 m, against the covers that were observed from there: breaking
// crests by Monahan (1993), whitecaps of all ages by Callaghan et al. (2008).
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"
#include "shared/foam.glsl"

enum { SIDE = 192, PIXELS = SIDE * SIDE, MOMENTS = 6 };

static bolan_context *context;

static void draw(stage *s, float *rgb) {
    picture p = stage_draw(s, SIDE, SIDE, 1);
    bolan_renderer_read_linear(s->renderer, rgb, NULL);
    picture_free(&p);
}

typedef struct shares {
    double white, foamy; // of the pixels whose opacity is above a half, and above a quarter
} shares;

// Of black water under an even sky: the red that is seen is foam, bubbles are green. Its radiance over that of a closed
// cover is its opacity.
static shares look_down(double wind) {
    static float rgb[3 * PIXELS];
    bolan_scene scene;
    stage s;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    bolan_scene_set_wind(&scene, wind, 240.0);
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_elevation_deg = -2.0;
    scene.look.effects = BOLAN_EFFECT_FOAM;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 100.0}, .pitch_deg = -89.0, .fov_deg = 90.0};
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_MEDIUM, false));
    shares sum = {0.0, 0.0};
    stage_settle(&s, 20.0);
    s.scene.water.foam = 2.0; // twice the opacity: what covers a half is closed
    draw(&s, rgb);
    float closed = 0.0f;
    for (int i = 0; i < PIXELS; ++i) closed = fmaxf(closed, rgb[3 * i]);
    s.scene.water.foam = 1.0;
    for (int t = 0; t < MOMENTS; ++t) {
        stage_settle(&s, 20.0 + 13.0 * t);
        draw(&s, rgb);
        for (int i = 0; i < PIXELS; ++i) {
            sum.white += (rgb[3 * i] > 0.5f * closed) / (double)(MOMENTS * PIXELS);
            sum.foamy += (rgb[3 * i] > 0.25f * closed) / (double)(MOMENTS * PIXELS);
        }
    }
    stage_close(&s);
    return sum;
}

static void the_image_is_as_white_as_the_sea_was_seen(void **state) {
    (void)state;
    static const double winds[] = {10.0, 20.0};
    for (int k = 0; k < 2; ++k) {
        const double u = winds[k], breaking = bolan_breaker_cover(u), all = bolan_callaghan_cover(u);
        const shares seen = look_down(u);
        print_message("%.0f m/s: white %.4f, foamy %.4f; breaking crests %.4f, whitecaps %.4f\n", u, seen.white,
                      seen.foamy, breaking, all);
        // A crest that breaks is white, and the densest of the foam that it leaves; the thinnest is not.
        assert_true(seen.white > breaking && seen.white < all);
        // Thin edges and torn films are below a quarter, and the few waves in sight are a third more or less than the
        // mean. In a gale there are streaks too.
        assert_true(seen.foamy > 0.4 * all && seen.foamy < 1.5 * all + streak_share(u));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_image_is_as_white_as_the_sea_was_seen)};
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}
