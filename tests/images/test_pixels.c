// SPDX-License-Identifier: MIT
// Images whose pixels compute shaders shade against those whose pixels fragment shaders shade.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

#define WIDTH 131 // no multiple of a group's width, so that groups reach over the edge
#define HEIGHT 75
// One source. Compute shaders round what is displayed to half floats, a twentieth of a level, so that the dither tips
// one level in some pixels; a compiler's order of operations may differ too [dB].
#define ENOUGH 60.0

typedef struct images {
    picture eye, under; // from the scene's camera; from an eye in the water
} images;

static images draw(const bolan_scene *scene, bolan_pixels pixels, bolan_quality quality, int size, bool under) {
    stage s;
    images out = {0};
    stage_pixels = pixels;
    assert_true(stage_open(&s, scene, quality, false));
    assert_int_equal(bolan_renderer_pixels(s.renderer), pixels);
    out.eye = stage_draw(&s, (uint32_t)size * WIDTH, (uint32_t)size * HEIGHT, 1);
    s.scene.camera.position.z = -3.0;
    if (under) out.under = stage_draw(&s, WIDTH, HEIGHT, 1);
    stage_close(&s);
    return out;
}

static void compare(const char *name, picture *fragment, picture *compute) {
    const double psnr = picture_psnr(fragment, compute);
    print_message("%s: %.1f dB\n", name, psnr);
    if (psnr < ENOUGH) picture_report("pixels", fragment, compute, psnr, ENOUGH);
    assert_true(psnr >= ENOUGH);
    picture_free(fragment);
    picture_free(compute);
}

static void check(const char *name, bolan_quality quality, int size, bool under) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    images fragment = draw(&scene, BOLAN_PIXELS_FRAGMENT, quality, size, under);
    images compute = draw(&scene, BOLAN_PIXELS_COMPUTE, quality, size, under);
    compare(name, &fragment.eye, &compute.eye);
    if (under) compare("from under it", &fragment.under, &compute.under);
}

static void open_water_is_one_image(void **state) {
    (void)state;
    check("open-sea", BOLAN_QUALITY_MEDIUM, 1, true); // rows with half-rate shading, and rows without
}

static void a_storm_is_one_image(void **state) {
    (void)state;
    check("storm", BOLAN_QUALITY_LOW, 1, false);
}

static void land_is_one_image(void **state) {
    (void)state;
    check("island", BOLAN_QUALITY_MEDIUM, 1, false);
}

static void a_glow_is_one_image(void **state) {
    (void)state;
    check("calm", BOLAN_QUALITY_HIGH, 4, false); // smaller images have no glow
}

static void a_software_rasterizer_takes_fragments(void **state) {
    (void)state;
    const bolan_gl_info info = bolan_gl_get_info();
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    bolan_renderer *renderer = NULL;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_OK);
    assert_int_equal(bolan_renderer_pixels(renderer), info.software ? BOLAN_PIXELS_FRAGMENT : BOLAN_PIXELS_COMPUTE);
    bolan_renderer_destroy(&renderer);
    desc.pixels = (bolan_pixels)BOLAN_PIXELS;
    assert_int_equal(bolan_renderer_create(&desc, &renderer), BOLAN_ERROR_ARGUMENT);
}

static int open_context(void **state, bolan_gl_api api) {
    bolan_context *context = NULL;
    if (bolan_context_create(api, &context) != BOLAN_OK || !bolan_gl_get_info().compute) {
        if (gl_is_required()) return -1;
        print_message("skipped: there are no compute shaders on this machine\n");
        exit(77);
    }
    *state = context;
    return 0;
}

static int open_core(void **state) { return open_context(state, BOLAN_GL_CORE); }
static int open_es(void **state) { return open_context(state, BOLAN_GL_ES); }

static int close_context(void **state) {
    bolan_context *context = *state;
    bolan_context_destroy(&context);
    return 0;
}

int main(void) {
    const struct CMUnitTest core[] = {
        cmocka_unit_test(open_water_is_one_image),
        cmocka_unit_test(land_is_one_image),
        cmocka_unit_test(a_software_rasterizer_takes_fragments),
    };
    const struct CMUnitTest es[] = {cmocka_unit_test(a_storm_is_one_image), cmocka_unit_test(a_glow_is_one_image)};
    const int failed = cmocka_run_group_tests_name("core", core, open_core, close_context);
    return failed + cmocka_run_group_tests_name("es", es, open_es, close_context);
}
