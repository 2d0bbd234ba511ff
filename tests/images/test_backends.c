// SPDX-License-Identifier: MIT
// Pictures whose waves compute shaders make against those whose waves the CPU makes.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 160
#define HEIGHT 90
#define ENOUGH 45.0 // [dB]

static picture draw(const bolan_scene *scene, bolan_backend backend) {
    stage s;
    stage_backend = backend;
    assert_true(stage_open(&s, scene, BOLAN_QUALITY_MEDIUM, false));
    assert_int_equal(bolan_renderer_backend(s.renderer), backend);
    picture first = stage_draw(&s, WIDTH, HEIGHT, 1);
    picture_free(&first);
    stage_step(&s, scene->time + 0.4); // past a tick of the foam
    picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
    stage_close(&s);
    return p;
}

static void check(const char *name, const bolan_technique *technique, double height) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    if (technique) bolan_scene_set_technique(&scene, technique);
    if (height > 0.0) scene.camera.position.z = height;
    scene.sea.resolution = 128;
    picture cpu = draw(&scene, BOLAN_BACKEND_CPU), compute = draw(&scene, BOLAN_BACKEND_COMPUTE);
    const double psnr = picture_psnr(&cpu, &compute);
    print_message("%s by %s: %.1f dB\n", name, scene.technique.name, psnr);
    if (psnr < ENOUGH) picture_report("backends", &cpu, &compute, psnr, ENOUGH);
    assert_true(psnr >= ENOUGH);
    picture_free(&cpu);
    picture_free(&compute);
}

static void the_sea_is_one_picture(void **state) {
    (void)state;
    check("open-sea", NULL, 0.0);
    check("storm", NULL, 0.0);
    check("open-sea", NULL, 900.0);
}

static void land_is_one_picture(void **state) {
    (void)state;
    check("island", NULL, 0.0);
}

static void papers_are_one_picture(void **state) {
    (void)state;
    check("storm", &bolan_technique_flight_sim, 0.0); // foam by the same law
    check("open-sea", &bolan_technique_two_triangle, 0.0);
}

static void mixes_are_one_picture(void **state) {
    (void)state;
    bolan_technique mixed = bolan_technique_nested_grid; // lit, over textures that are not packed
    mixed.waves = BOLAN_WAVES_FFT;
    check("storm", &mixed, 0.0);
}

static int setup(void **state) {
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK || !bolan_gl_get_info().compute) {
        if (gl_is_required()) return -1;
        print_message("skipped: there are no compute shaders on this machine\n");
        exit(77);
    }
    *state = context;
    return 0;
}

static int teardown(void **state) {
    bolan_context *context = *state;
    bolan_context_destroy(&context);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sea_is_one_picture),
        cmocka_unit_test(land_is_one_picture),
        cmocka_unit_test(papers_are_one_picture),
        cmocka_unit_test(mixes_are_one_picture),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
