// SPDX-License-Identifier: MIT
// A picture is a function of what is asked for: a renderer that drew other skies, eyes, suns and seas before draws the
// same bytes as a new one. What is kept between frames is made for places of a lattice, never for where the eye
// happened to be.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 160
#define HEIGHT 90

static bolan_context *context;

// Small steps that a kept table would have survived, and large ones that it would not.
typedef struct moved {
    double x, y, z, turn, sun_azimuth, sun_elevation, cover;
} moved;

static void place(stage *s, const bolan_scene *home, const moved *m) {
    s->scene = *home;
    s->scene.camera.position.x += m->x;
    s->scene.camera.position.y += m->y;
    s->scene.camera.position.z += m->z;
    s->scene.camera.heading_deg += m->turn;
    s->scene.sky.sun_azimuth_deg += m->sun_azimuth;
    s->scene.sky.sun_elevation_deg += m->sun_elevation;
    s->scene.sky.cloud_cover = fmax(0.0, home->sky.cloud_cover + m->cover);
}

static stage used; // by every scene of every test, one after the other: each finds what the others left

static void use(const bolan_scene *scene) {
    if (used.renderer == NULL)
        assert_true(stage_open(&used, scene, BOLAN_QUALITY_LOW, false));
    else
        stage_settle_scene(&used, scene);
}

static void check_history(const char *name, const bolan_technique *technique, double height) {
    static const moved before[] = {
        {0.0, 0.0, 0.4, 90.0, 0.0, 0.0, 0.0},
        {60.0, 0.0, 0.0, 0.0, 0.3, 0.08, 0.0},
        {900.0, -700.0, 35.0, 10.0, 4.0, -3.0, 0.0},
        {0.0, 0.0, 2500.0, 0.0, 0.0, 0.0, -0.1},
    };
    bolan_scene home;
    assert_int_equal(bolan_scene_load(name, &home), BOLAN_OK);
    home.sea.resolution = 64;
    bolan_scene_set_technique(&home, technique);
    if (height > 0.0) home.camera.position.z = height;
    home.sky.cloud_cover = 0.35;
    stage fresh;
    use(&home);
    for (size_t i = 0; i < (test_is_short() ? 2 : sizeof before / sizeof *before); i++) {
        place(&used, &home, &before[i]);
        picture p = stage_draw(&used, WIDTH, HEIGHT, 1);
        picture_free(&p);
    }
    assert_true(stage_open(&fresh, &home, BOLAN_QUALITY_LOW, false));
    for (int i = -1; i < 1; i++) { // at home, and in the first place once more
        const moved nowhere = {0};
        place(&used, &home, i < 0 ? &nowhere : &before[i]);
        place(&fresh, &home, i < 0 ? &nowhere : &before[i]);
        picture got = stage_draw(&used, WIDTH, HEIGHT, 1), expected = stage_draw(&fresh, WIDTH, HEIGHT, 1);
        int worst = 0;
        for (size_t k = 0; k < (size_t)WIDTH * HEIGHT * 3; k++) {
            const int d = abs((int)got.rgb[k] - (int)expected.rgb[k]);
            worst = d > worst ? d : worst;
        }
        if (worst > 0) {
            print_message("%s by %s from %g m, place %d: %d of 255\n", name, technique->name, home.camera.position.z, i,
                          worst);
            picture_report("same_picture", &expected, &got, picture_psnr(&expected, &got), 1e9);
        }
        assert_int_equal(worst, 0); // the same operations on the same numbers
        picture_free(&got);
        picture_free(&expected);
    }
    stage_close(&fresh);
}

static void the_sea_forgets_what_was_drawn_before(void **state) {
    (void)state;
    check_history("open-sea", &bolan_technique_ocean, 0.0);
    check_history("open-sea", &bolan_technique_flight_sim, 3000.0); // above the clouds
}

static void the_shore_forgets_what_was_drawn_before(void **state) {
    (void)state;
    check_history("island", &bolan_technique_ocean, 0.0);
    check_history("island", &bolan_technique_exp_cosine, 820.0); // near where the shore map's texels double
}

static void the_pond_forgets_what_was_drawn_before(void **state) {
    (void)state;
    check_history("pond", &bolan_technique_two_triangle, 0.0);
}

// What the eye's place changes between two cells of the lattice must stay too small to see.
static void a_step_across_the_lattice_is_invisible(void **state) {
    (void)state;
    bolan_scene home;
    assert_int_equal(bolan_scene_load("open-sea", &home), BOLAN_OK);
    home.sea.resolution = 64;
    home.sky.cloud_cover = 0.0;
    home.camera.pitch_deg = 2.0; // mostly sky
    use(&home);
    picture last = {0};
    for (int i = 0; i < (test_is_short() ? 2 : 12); i++) { // 0.12 degrees of the sun, a lattice step, in twelfths
        used.scene.sky.sun_elevation_deg = home.sky.sun_elevation_deg + 0.01 * i;
        picture p = stage_draw(&used, WIDTH, HEIGHT, 1);
        // One step is a fifth of the sun's diameter: the sky's light changes by less than a level of 255 everywhere but
        // at the sun, which is not in view; 46 dB is an rms of 1.3 levels.
        if (last.rgb) assert_true(picture_psnr(&last, &p) > 46.0);
        picture_free(&last);
        last = p;
    }
    picture_free(&last);
}

// The linear picture of several samples is their mean, and its distance is that of the pixels' middles.
static void radiance_of_several_samples_is_their_mean(void **state) {
    (void)state;
    enum { W = 48, H = 32, SAMPLES = 5 };
    bolan_scene home;
    assert_int_equal(bolan_scene_load("open-sea", &home), BOLAN_OK);
    home.sea.resolution = 64;
    use(&home);
    static float mean[W * H * 3], single[W * H * 3], expected[W * H * 3], middle[W * H], distance[W * H];
    double before = 0.0;
    for (uint32_t n = 1; n <= SAMPLES; n++) {
        picture p = stage_draw(&used, W, H, n);
        bolan_renderer_read_linear(used.renderer, n == 1 ? single : mean, n == 1 ? middle : distance);
        picture_free(&p);
        if (n == 1) memcpy(expected, single, sizeof expected);
        if (n == 2) { // the second sample alone is twice the mean less the first; it must not be black, nor the first
            double same = 0.0, sum = 0.0;
            for (int i = 0; i < W * H * 3; i++) {
                const double second = 2.0 * (double)mean[i] - (double)single[i];
                assert_true(second > -1e-4);
                same += fabs(second - (double)single[i]);
                sum += second;
            }
            assert_true(same > 1e-3 * sum);
        }
        double total = 0.0;
        for (int i = 0; n > 1 && i < W * H * 3; i++) total += (double)mean[i];
        if (n > 2) assert_true(fabs(total / before - 1.0) < 0.1); // a mean, not a sum: neither grows nor fades with n
        before = total;
        // Half a pixel off, distances differ by per cents near the horizon; here they are the same bits.
        if (n > 1) assert_memory_equal(middle, distance, sizeof middle);
    }
}

// Draws @p samples more into the target's mean. Returns how many are in it.
static uint32_t add_samples(const bolan_view *from, uint32_t samples, bool accumulate, uint8_t *rgb) {
    bolan_view view = *from;
    view.samples = samples;
    view.accumulate = accumulate;
    bolan_renderer_draw_world(used.renderer, used.world, &view);
    bolan_renderer_read_rgb8(used.renderer, view.framebuffer, view.width, view.height, rgb);
    return bolan_renderer_statistics(used.renderer).samples;
}

// Sums of floats in another order: a value between two levels of 255 may fall to either.
static void check_one_level(const uint8_t *a, const uint8_t *b, size_t bytes) {
    for (size_t i = 0; i < bytes; i++) assert_in_range(abs(a[i] - b[i]), 0, 1);
}

static void samples_of_several_views_are_those_of_one(void **state) {
    (void)state;
    enum { W = 48, H = 32, BYTES = W * H * 3 };
    static uint8_t one[BYTES], five[BYTES], got[BYTES];
    bolan_scene home;
    assert_int_equal(bolan_scene_load("open-sea", &home), BOLAN_OK);
    home.sea.resolution = 64;
    use(&home);
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(W, H, &target), BOLAN_OK);
    bolan_view view = stage_view(&used, target, W, H);
    assert_int_equal(add_samples(&view, 1, false, one), 1);
    assert_int_equal(add_samples(&view, 5, false, five), 5);
    double differ = 0.0;
    for (int i = 0; i < BYTES; i++) differ += abs(one[i] - five[i]);
    assert_true(differ > BYTES);                           // by more than what is allowed below
    assert_int_equal(add_samples(&view, 1, true, got), 1); // not of the five before it
    check_one_level(got, one, BYTES);
    for (uint32_t n = 2; n <= 3; n++) assert_int_equal(add_samples(&view, 1, true, got), n);
    assert_int_equal(add_samples(&view, 2, true, got), 5);
    check_one_level(got, five, BYTES);
    assert_int_equal(add_samples(&view, 1, false, got), 1);
    assert_memory_equal(got, one, BYTES);
    assert_int_equal(add_samples(&view, 3, true, got), 3);
    view.output = BOLAN_OUTPUT_LINEAR; // two outputs have no mean
    assert_int_equal(add_samples(&view, 1, true, got), 1);
    view.output = BOLAN_OUTPUT_SRGB;
    view.width -= 1;
    assert_int_equal(add_samples(&view, 1, true, got), 1);
    bolan_target_destroy(&target);
}

static int open_context(void **state) {
    (void)state;
    return bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK ? 0 : 77;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sea_forgets_what_was_drawn_before),
        cmocka_unit_test(the_shore_forgets_what_was_drawn_before),
        cmocka_unit_test(the_pond_forgets_what_was_drawn_before),
        cmocka_unit_test(a_step_across_the_lattice_is_invisible),
        cmocka_unit_test(radiance_of_several_samples_is_their_mean),
        cmocka_unit_test(samples_of_several_views_are_those_of_one),
    };
    if (open_context(NULL) != 0) return 77;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    if (used.renderer != NULL) stage_close(&used);
    bolan_context_destroy(&context);
    return failed;
}
