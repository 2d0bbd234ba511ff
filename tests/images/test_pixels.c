// SPDX-License-Identifier: MIT
// Images whose pixels compute shaders shade against those whose pixels fragment shaders shade.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"
#include "render/pixel_tiles.h"

#include <epoxy/gl.h>

#define WIDTH 131 // no multiple of a group's width, so that groups reach over the edge
#define HEIGHT 75
// One source. Compute shaders round what is displayed to half floats, a twentieth of a level, so that the dither tips
// one level in some pixels; a compiler's order of operations may differ too [dB].
#define ENOUGH 60.0

typedef struct images {
    picture eye, away, under; // from the scene's camera; with the eye turned round; from an eye in the water
} images;

enum { AWAY = 1, UNDER = 2, LARGE = 4 }; // LARGE: the eye's image has a glow

static images draw(const bolan_scene *scene, bolan_pixels pixels, bolan_quality quality, unsigned more) {
    stage s;
    images out = {0};
    GLuint mine;
    GLint bound;
    glGenBuffers(1, &mine);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, mine);
    stage_pixels = pixels;
    assert_true(stage_open(&s, scene, quality, false));
    assert_int_equal(bolan_renderer_pixels(s.renderer), pixels);
    const uint32_t scale = more & LARGE ? 4 : 1;
    out.eye = stage_draw(&s, scale * WIDTH, scale * HEIGHT, 1);
    s.scene.camera.heading_deg += 180.0;
    if (more & AWAY) out.away = stage_draw(&s, WIDTH, HEIGHT, 1);
    s.scene.camera.heading_deg -= 180.0;
    s.scene.camera.position.z = -3.0;
    if (more & UNDER) out.under = stage_draw(&s, WIDTH, HEIGHT, 1);
    stage_close(&s);
    glGetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &bound);
    assert_int_equal(bound, mine);
    glDeleteBuffers(1, &mine);
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

static void check(const char *name, bolan_quality quality, unsigned more) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    images fragment = draw(&scene, BOLAN_PIXELS_FRAGMENT, quality, more);
    images compute = draw(&scene, BOLAN_PIXELS_COMPUTE, quality, more);
    compare(name, &fragment.eye, &compute.eye);
    if (more & AWAY) compare("with the eye turned round", &fragment.away, &compute.away);
    if (more & UNDER) compare("from under it", &fragment.under, &compute.under);
}

static void open_water_is_one_image(void **state) {
    (void)state;
    check("open-sea", BOLAN_QUALITY_MEDIUM, UNDER); // rows with half-rate shading, and rows without
}

static void a_storm_is_one_image(void **state) {
    (void)state;
    check("storm", BOLAN_QUALITY_LOW, 0);
}

static void land_is_one_image(void **state) {
    (void)state;
    check("island", BOLAN_QUALITY_MEDIUM, AWAY); // tiles of three classes
}

static void a_glow_is_one_image(void **state) {
    (void)state;
    check("calm", BOLAN_QUALITY_HIGH, LARGE);
}

// Draws it and reads how many tiles were in each list: the renderer leaves their buffer bound.
static void count_tiles(stage *s, GLuint run_of[TILE_CLASSES][4]) {
    GLint lists = 0;
    picture p = stage_draw(s, WIDTH, HEIGHT, 1);
    picture_free(&p);
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &lists);
    assert_int_not_equal(lists, 0);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, (GLuint)lists);
    const void *runs = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, TILE_CLASSES * sizeof run_of[0], GL_MAP_READ_BIT);
    assert_non_null(runs);
    memcpy(run_of, runs, TILE_CLASSES * sizeof run_of[0]);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    for (int i = 0; i < TILE_CLASSES; ++i) {
        print_message("class %d: %u tiles\n", i, run_of[i][3]);
        assert_true(run_of[i][0] * run_of[i][1] * run_of[i][2] >= run_of[i][3]);
    }
}

static void each_tile_takes_the_shader_of_its_class(void **state) {
    (void)state;
    stage s;
    bolan_scene scene;
    GLuint ahead[TILE_CLASSES][4], away[TILE_CLASSES][4];
    assert_int_equal(bolan_scene_load("island", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    stage_pixels = BOLAN_PIXELS_COMPUTE;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    bolan_renderer_destroy(&s.renderer);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW; // which shades all rows at once
    desc.pixels = BOLAN_PIXELS_COMPUTE;
    desc.restore = BOLAN_RESTORE_NONE;
    assert_int_equal(bolan_renderer_create(&desc, &s.renderer), BOLAN_OK);
    s.scene.camera.position = (bolan_dvec3){-6000.0, -6500.0, 2500.0};
    s.scene.camera.pitch_deg = -20.0;
    count_tiles(&s, ahead); // shallows round the island, and round them water with no bed in sight
    assert_true(ahead[TILES_OPEN][3] == 0 && ahead[TILES_DEEP][3] > 0 && ahead[TILES_NEAR][3] > 0);
    s.scene.camera.heading_deg += 180.0;
    count_tiles(&s, away); // the open sea
    assert_true(away[TILES_OPEN][3] > 0 && away[TILES_DEEP][3] == 0 && away[TILES_NEAR][3] == 0);
    stage_close(&s);
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
    const struct CMUnitTest es[] = {
        cmocka_unit_test(a_storm_is_one_image),
        cmocka_unit_test(a_glow_is_one_image),
        cmocka_unit_test(each_tile_takes_the_shader_of_its_class),
    };
    const int failed = cmocka_run_group_tests_name("core", core, open_core, close_context);
    return failed + cmocka_run_group_tests_name("es", es, open_es, close_context);
}
