// SPDX-License-Identifier: MIT
// Spindrift (shaders/shared/spray.glsl): none below Beaufort's force 9, more with the wind, with which it goes; a
// function of time. Where the sky stands behind it, foam on the water is not, so there it is seen alone.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 256
#define HEIGHT 64
#define PIXELS ((size_t)WIDTH * HEIGHT)
#define HEADING 40.0
#define CLEAR 3 // rows over the water that are left out: what shows there goes with the crest

static bolan_context *context;

// From low over the water of a clear day, across the waves of a violent storm, which run to the right.
static bolan_scene across(double wind) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("storm", &scene), BOLAN_OK);
    bolan_scene_set_wind(&scene, 31.0, HEADING - 90.0);
    scene.sea.sea_state.wind_speed = wind;
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg = HEADING + 60.0;
    scene.camera =
        (bolan_camera){.position = {0.0, 0.0, 4.0}, .heading_deg = HEADING, .pitch_deg = 2.0, .fov_deg = 13.0};
    return scene;
}

// What spray adds to the light of the sky in each pixel, at that time of the stage; 0 at water and close above it.
static void spray_of(stage *s, double time, int added[PIXELS]) {
    stage_settle(s, time);
    picture with, without;
    for (int on = 0; on < 2; ++on) {
        if (on)
            s->scene.look.effects |= BOLAN_EFFECT_FOAM;
        else
            s->scene.look.effects &= ~(uint32_t)BOLAN_EFFECT_FOAM;
        *(on ? &with : &without) = stage_draw(s, WIDTH, HEIGHT, 1);
    }
    for (size_t i = 0; i < PIXELS; ++i)
        added[i] = isfinite(without.distance[i + CLEAR * WIDTH < PIXELS ? i + CLEAR * WIDTH : i])
                       ? 0
                       : (int)with.rgb[3 * i + 1] - (int)without.rgb[3 * i + 1];
    picture_free(&with);
    picture_free(&without);
}

static int sum_of(const int added[PIXELS]) {
    int sum = 0;
    for (size_t i = 0; i < PIXELS; ++i) sum += abs(added[i]);
    return sum;
}

static void force_9_and_above_has_spray(void **state) {
    (void)state;
    const double winds[] = {18.0, 24.0, 30.0}; // forces 8, 9, 11
    int seen[3];
    for (int k = 0; k < 3; ++k) {
        static int added[PIXELS];
        const bolan_scene scene = across(winds[k]);
        stage s;
        assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
        seen[k] = 0;
        for (int t = 0; t < 3; ++t) { // crests stand here or there
            spray_of(&s, 20.0 + 4.0 * t, added);
            seen[k] += sum_of(added);
        }
        print_message("%.0f m/s: %d levels of all pixels\n", winds[k], seen[k]);
        stage_close(&s);
    }
    assert_int_equal(seen[0], 0);
    assert_true(seen[1] > 100);
    assert_true(seen[2] > 2 * seen[1]);
}

enum { MOST = 50 }; // pixels that spray is looked for at

// Adds how much `later` is like `before` where it is shifted to the right by -MOST to MOST pixels.
static void compare(const int before[PIXELS], const int later[PIXELS], double alike[2 * MOST + 1]) {
    for (int shift = -MOST; shift <= MOST; ++shift)
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = MOST; x < WIDTH - MOST; ++x)
                alike[shift + MOST] += (double)before[y * WIDTH + x] * later[y * WIDTH + x + shift];
}

// Over the same waves, with the wind from one side and from the other.
static void spray_goes_with_the_wind(void **state) {
    (void)state;
    enum { MOMENTS = 4 };
    static int added[2][MOMENTS][PIXELS], again[PIXELS];
    double alike[2 * MOST + 1] = {0.0};
    for (int left = 0; left < 2; ++left) {
        bolan_scene scene = across(31.0);
        if (left) scene.sea.sea_state.wind_from_deg += 180.0;
        stage s;
        assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
        for (int k = 0; k < MOMENTS; ++k) spray_of(&s, 20.0 + 3.0 * k, added[left][k]);
        spray_of(&s, 20.0, again);
        stage_close(&s);
        assert_memory_equal(added[left][0], again, sizeof again); // a function of time
    }
    for (int k = 0; k < MOMENTS; ++k) compare(added[0][k], added[1][k], alike);
    int best = 0;
    for (int i = 0; i <= 2 * MOST; ++i) best = alike[i] > alike[best] ? i : best;
    print_message("with the wind to the left spray lies %+d px to the right\n", best - MOST);
    assert_true(best <= MOST - 3);
}

// Down the wind veils are seen along their length: a mist, without the edges of single veils.
static void spray_is_a_mist_along_the_wind(void **state) {
    (void)state;
    static int added[PIXELS];
    bolan_scene scene = across(36.0);
    scene.camera.heading_deg = HEADING + 90.0;
    scene.sky.sun_azimuth_deg = HEADING + 270.0; // white before a blue sky
    scene.camera.fov_deg = 13.0;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    int most = 0;
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        spray_of(&s, 20.0 + 3.0 * k, added);
        sum += sum_of(added);
        for (size_t i = 0; i < PIXELS; ++i) most = abs(added[i]) > most ? abs(added[i]) : most;
    }
    stage_close(&s);
    const double mean = sum / (3.0 * PIXELS);
    print_message("down the wind: %.2f levels, at most %d\n", mean, most);
    assert_true(mean > 0.1);
    assert_true(most < 120.0 * mean); // 145 where each veil is as narrow as it is across the wind
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_9_and_above_has_spray),
        cmocka_unit_test(spray_goes_with_the_wind),
        cmocka_unit_test(spray_is_a_mist_along_the_wind),
    };
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    bolan_context_destroy(&context);
    return failed;
}
