// SPDX-License-Identifier: MIT
// Clouds before an eye at their base are not cut into slices of the heights at which they are sampled.
#include "picture.h"
#include "support.h"

enum { WIDTH = 256, HEIGHT = 144 };
#define FOV 24.0 // of its height [deg]: a pixel is narrower than half a slice

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

// Green radiance of a drawn view, the top row first.
static void draw(stage *s, float green[HEIGHT][WIDTH]) {
    static float rgb[HEIGHT * WIDTH * 3];
    picture p = stage_draw(s, WIDTH, HEIGHT, 1);
    bolan_renderer_read_linear(s->renderer, rgb, p.distance);
    for (int i = 0; i < HEIGHT * WIDTH; ++i) green[i / WIDTH][i % WIDTH] = rgb[3 * i + 1];
    picture_free(&p);
}

// How much two successive second differences of opposite sign weigh.
static double zigzag(float a, float b, float c, float d) {
    const double first = (double)a - 2.0 * (double)b + (double)c, next = (double)b - 2.0 * (double)c + (double)d;
    return sqrt(fmax(-first * next, 0.0));
}

// Up and down from row to row over that from column to column, between 1 and 11 degrees.
static double stripes(float green[HEIGHT][WIDTH], double per_degree) {
    double along_x = 0.0, along_y = 0.0;
    for (int y = HEIGHT / 2 - (int)(11.0 * per_degree); y < HEIGHT / 2 - (int)(1.0 * per_degree); ++y)
        for (int x = 1; x + 2 < WIDTH; ++x) {
            along_x += zigzag(green[y][x - 1], green[y][x], green[y][x + 1], green[y][x + 2]);
            along_y += zigzag(green[y - 1][x], green[y][x], green[y + 1][x], green[y + 2][x]);
        }
    return along_y / along_x;
}

static void clouds_are_not_cut_into_slices(void **state) {
    (void)state;
    static float green[HEIGHT][WIDTH];
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sky.sun_azimuth_deg = 225.0;
    scene.camera = (bolan_camera){.position = {0.0, 0.0, 1190.0}, .heading_deg = 225.0, .fov_deg = FOV};
    scene.sky.cloud_base = 1200.0;
    scene.sky.cloud_cover = 0.3;
    scene.sky.sun_elevation_deg = 50.0;
    scene.sky.visibility = 50000.0;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_HIGH, false));
    draw(&s, green);
    stage_close(&s);
    const double got = stripes(green, HEIGHT / FOV);
    print_message("contrast down over contrast across: %.2f\n", got);
    assert_true(got < 4.0); // clouds lie in layers at such angles: 1.8; in slices 9
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(clouds_are_not_cut_into_slices)};
    return cmocka_run_group_tests(tests, open_context, close_context);
}
