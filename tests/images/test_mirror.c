// SPDX-License-Identifier: MIT
// The mirror optics in pictures: Snell's window, what each effect does, two triangles, and nothing allocated on the
// way.
#include "picture.h"
#include "support.h"

enum { WIDTH = 192, HEIGHT = 144 };

static bolan_context *context;

static int open_context(void **state) {
    (void)state;
    return bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK ? 0 : -1;
}

static int close_context(void **state) {
    (void)state;
    bolan_context_destroy(&context);
    return 0;
}

static bolan_scene pond(void) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    return scene;
}

// Radiance of the middle row, from an eye 3 m under calm open water that looks straight up.
static void look_up(float *radiance, uint32_t size, double fov) {
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, 0.0, 0.0);
    bolan_scene_set_technique(&scene, &bolan_technique_two_triangle);
    scene.look.effects = BOLAN_EFFECTS_ALL & ~(unsigned)(BOLAN_EFFECT_FOG | BOLAN_EFFECT_GLITTER);
    scene.sky.cloud_cover = 0.0;
    scene.camera.position = bolan_dv3(0.0, 0.0, -3.0);
    scene.camera.pitch_deg = 90.0;
    scene.camera.fov_deg = fov;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    picture p = stage_draw(&s, size, size, 1);
    float *rgb = malloc(sizeof(float) * 3 * size * size);
    bolan_renderer_read_linear(s.renderer, rgb, NULL);
    for (uint32_t i = 0; i < size; ++i) radiance[i] = rgb[3 * ((size_t)(size / 2) * size + i) + 1];
    free(rgb);
    picture_free(&p);
    stage_close(&s);
}

static void snells_window_has_the_right_radius(void **state) {
    (void)state;
    enum { SIZE = 600 };
    float radiance[SIZE];
    const double fov = 110.0;
    look_up(radiance, SIZE, fov);
    uint32_t first = 0, last = SIZE - 1;
    const float inside = radiance[SIZE / 2], outside = radiance[2];
    assert_true(inside > 3.0f * outside);
    while (radiance[first] < 0.5f * (inside + outside) && first < SIZE / 2) ++first;
    while (radiance[last] < 0.5f * (inside + outside) && last > SIZE / 2) --last;
    const double half = 0.5 * SIZE / tan(bolan_radians(0.5 * fov));
    const double east = bolan_degrees(atan((last + 1 - 0.5 * SIZE) / half)),
                 west = bolan_degrees(atan((0.5 * SIZE - first) / half));
    // 48.268 degrees for an index of 1.34; the acceptance number is half a degree. The sky is brighter at its rim than
    // at the zenith, and Fresnel's reflectance takes half of it 0.2 degrees inside.
    assert_near(0.5 * (east + west), 48.268, 0.5);
    assert_near(east, west, 0.3);
}

static picture draw_pond(stage *s, const bolan_scene *scene) {
    s->scene = *scene;
    picture p = stage_draw(s, WIDTH, HEIGHT, 1);
    assert_int_equal(bolan_renderer_statistics(s->renderer).water_triangles, 2);
    return p;
}

static void every_effect_of_the_paper_shows_and_the_water_is_two_triangles(void **state) {
    (void)state;
    static const unsigned effects[] = {BOLAN_EFFECT_REFLECTION, BOLAN_EFFECT_REFRACTION, BOLAN_EFFECT_BUMP,
                                       BOLAN_EFFECT_DISTORTION, BOLAN_EFFECT_GLITTER,    BOLAN_EFFECT_CAUSTICS};
    stage s;
    bolan_scene scene = pond();
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_MEDIUM, false));
    for (int paper = 0; paper < 2; ++paper) {
        scene.look.paper = paper == 1;
        scene.sky.sun_azimuth_deg = 10.0; // ahead, so that it glitters
        for (size_t i = 0; i < (test_is_short() ? 2 : sizeof effects / sizeof *effects); ++i) {
            // the water's own texture is dark, and little of it shows where the bottom does
            const unsigned rest = effects[i] == BOLAN_EFFECT_BUMP
                                      ? BOLAN_EFFECTS_ALL & ~(unsigned)BOLAN_EFFECT_REFRACTION
                                      : BOLAN_EFFECTS_ALL;
            scene.look.effects = rest;
            picture with = draw_pond(&s, &scene);
            scene.look.effects = rest & ~effects[i];
            picture without = draw_pond(&s, &scene);
            const double psnr = picture_psnr(&with, &without);
            if (psnr > 60.0) print_message("effect %zu, paper %d: %.1f dB\n", i, paper, psnr);
            assert_true(psnr < 60.0); // equal pictures have more than 100 dB, one grey step everywhere 48
            picture_free(&with);
            picture_free(&without);
        }
    }
    stage_close(&s);
}

static void a_view_from_below_is_dim_and_keeps_the_colour_of_the_water(void **state) {
    (void)state;
    bolan_scene scene = pond();
    scene.camera.position = bolan_dv3(0.0, -8.0, -0.8);
    scene.camera.pitch_deg = 0.0;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_MEDIUM, false));
    picture fog = draw_pond(&s, &scene);
    scene.look.effects &= ~(unsigned)BOLAN_EFFECT_FOG;
    picture clear = draw_pond(&s, &scene);
    assert_true(picture_psnr(&fog, &clear) < 30.0);
    long red = 0, green = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; ++i) red += fog.rgb[3 * i], green += fog.rgb[3 * i + 1];
    assert_true(green > 2 * red); // coastal water of type 1C lets green through
    picture_free(&fog);
    picture_free(&clear);
    stage_close(&s);
}

static int allocations;

static void *counted(void *user, size_t size, size_t align) {
    (void)user;
    ++allocations;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void uncounted(void *user, void *memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

static void frames_after_the_first_allocate_nothing(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.allocate = counted, .release = uncounted});
    bolan_scene scene = pond();
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    for (int i = 0; i < 5; ++i) {
        if (i == 1) allocations = 0;
        s.scene.camera.heading_deg += 1.0;
        stage_update(&s);
        stage_step(&s, scene.time + 0.1 * i);
        const bolan_view view = stage_view(&s, target, WIDTH, HEIGHT);
        bolan_renderer_draw_world(s.renderer, s.world, &view);
    }
    assert_int_equal(allocations, 0);
    bolan_target_destroy(&target);
    stage_close(&s);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snells_window_has_the_right_radius),
        cmocka_unit_test(every_effect_of_the_paper_shows_and_the_water_is_two_triangles),
        cmocka_unit_test(a_view_from_below_is_dim_and_keeps_the_colour_of_the_water),
        cmocka_unit_test(frames_after_the_first_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
