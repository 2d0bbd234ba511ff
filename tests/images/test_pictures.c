// SPDX-License-Identifier: MIT
// Whole pictures: the same in both APIs, with and without clip control, and without holes. What they should look like
// is in test_references.c.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <unistd.h>

#include <cmocka.h>

#include "bolan/earth.h"
#include "picture.h"

#define WIDTH 320
#define HEIGHT 180

static bolan_scene load(const char *name) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    return scene;
}

static picture draw(const bolan_scene *scene, bolan_gl_api api, bool no_clip_control) {
    bolan_context *context = NULL;
    if (bolan_context_create(api, &context) != BOLAN_OK) skip_without_gl();
    stage s;
    assert_true(stage_open(&s, scene, BOLAN_QUALITY_MEDIUM, no_clip_control));
    picture p = stage_draw(&s, WIDTH, HEIGHT, 2);
    stage_close(&s);
    bolan_context_destroy(&context);
    return p;
}

static void core_and_es_draw_the_same_picture(void **state) {
    (void)state;
    bolan_scene scene = load("island");
    picture core = draw(&scene, BOLAN_GL_CORE, false), es = draw(&scene, BOLAN_GL_ES, false);
    double psnr = picture_psnr(&core, &es);
    if (psnr < 40.0) picture_report("core_es", &core, &es, psnr, 40.0);
    assert_true(psnr >= 40.0); // the same driver and code: only the precision of constants may differ
    picture_free(&core);
    picture_free(&es);
}

static void the_picture_does_not_need_clip_control(void **state) {
    (void)state;
    if (test_is_short()) return; // on the CPU it is the same picture
    bolan_scene scene = load("island");
    picture with = draw(&scene, BOLAN_GL_CORE, false), without = draw(&scene, BOLAN_GL_CORE, true);
    double psnr = picture_psnr(&with, &without);
    if (psnr < 35.0) picture_report("clip_control", &with, &without, psnr, 35.0);
    assert_true(psnr >= 35.0); // the waterline may move where the coarser depth rounds
    picture_free(&with);
    picture_free(&without);
}

// Eye-relative direction of pixel (x, y), row 0 at the top, scaled so that its part along the view axis is 1.
static bolan_dvec3 pixel_ray(const bolan_camera *c, double x, double y) {
    bolan_mat4 camera = bolan_m4_transpose(bolan_m4_view(c->heading_deg, c->pitch_deg, c->roll_deg));
    double t = tan(0.5 * bolan_radians(c->fov_deg));
    bolan_vec4 d = {(float)((2.0 * (x + 0.5) / WIDTH - 1.0) * t * WIDTH / HEIGHT),
                    (float)((1.0 - 2.0 * (y + 0.5) / HEIGHT) * t), -1.0f, 0.0f};
    d = bolan_m4_mul_v4(camera, d);
    return bolan_dv3(d.x, d.y, d.z);
}

// No hole: below the horizon every pixel shows water, from any place at any time.
static void the_sea_has_no_holes(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene = load("storm");
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    double vertical, horizontal;
    bolan_sea_bounds(stage_sea(&s), &vertical, &horizontal);
    srand(11);
    for (int k = 0; k < (test_is_short() ? 3 : 24); ++k) {
        bolan_camera *c = &s.scene.camera;
        c->position = bolan_dv3(2000.0 * rand() / RAND_MAX, 2000.0 * rand() / RAND_MAX,
                                vertical * 0.5 + pow(10.0, 0.2 + 3.8 * rand() / RAND_MAX));
        c->heading_deg = 360.0 * rand() / RAND_MAX;
        c->pitch_deg = -80.0 * rand() / RAND_MAX;
        c->roll_deg = 30.0 * rand() / RAND_MAX - 15.0;
        picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
        double dip =
            acos(BOLAN_EARTH_RADIUS / (BOLAN_EARTH_RADIUS + c->position.z + vertical)) + 0.01; // 0.01 rad: two pixels
        for (uint32_t i = 0; i < WIDTH * HEIGHT; ++i) {
            bolan_dvec3 ray = pixel_ray(c, i % WIDTH, i / WIDTH);
            if (atan2(ray.z, hypot(ray.x, ray.y)) < -dip) assert_true(isfinite(p.distance[i]));
        }
        picture_free(&p);
    }
    stage_close(&s);
    bolan_context_destroy(&context);
}

static int allocations;

static void *counted(void *user, size_t size, size_t align) {
    (void)user;
    ++allocations;
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void uncounted(void *user, void *memory, size_t size) {
    (void)user;
    (void)size;
    free(memory);
}

static void frames_after_the_first_allocate_nothing(void **state) {
    (void)state;
    bolan_set_hooks(&(bolan_hooks){.allocate = counted, .release = uncounted});
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene = load("island");
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &target), BOLAN_OK);
    for (int i = 0; i < 6; ++i) {
        if (i == 2) allocations = 0;
        s.scene.camera.position.x += 3.0;
        s.scene.camera.heading_deg += 1.0;
        stage_update(&s);
        stage_step(&s, scene.time + 0.1 * i);
        const bolan_view view = stage_view(&s, target, WIDTH, HEIGHT);
        bolan_renderer_draw_world(s.renderer, s.world, &view);
    }
    assert_int_equal(allocations, 0);
    bolan_target_destroy(&target);
    stage_close(&s);
    bolan_context_destroy(&context);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(core_and_es_draw_the_same_picture),
        cmocka_unit_test(the_picture_does_not_need_clip_control),
        cmocka_unit_test(the_sea_has_no_holes),
        cmocka_unit_test(frames_after_the_first_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
