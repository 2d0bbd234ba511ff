// SPDX-License-Identifier: MIT
// The sky as an equirectangular map: the sun's side of the sky is where the sun is, the zenith is on top, it is the sky
// that views show, and its light on a horizontal surface is what the renderer measures.
#include "picture.h"

#include "bolan/io.h"
#include "bolan/render.h"

enum { WIDTH = 256, HEIGHT = 128, FACE = 64 };

static bolan_context *context;
static bolan_renderer *renderer;
static float map[3 * WIDTH * HEIGHT];

static bolan_world *clear_world(double azimuth, double elevation) {
    bolan_scene scene;
    bolan_world *world = NULL;
    assert_int_equal(bolan_scene_load("open-sea", &scene), BOLAN_OK);
    scene.sea.resolution = 64;
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg = azimuth;
    scene.sky.sun_elevation_deg = elevation;
    assert_int_equal(bolan_world_load_scene(&scene, &world), BOLAN_OK);
    return world;
}

static bolan_sky_light read_map(const bolan_world *world) {
    const bolan_lighting lighting = bolan_lighting_from_scene(bolan_world_scene(world));
    bolan_sky_light light;
    bolan_renderer_prepare(renderer, bolan_world_water(world), &lighting);
    assert_int_equal(bolan_renderer_read_sky(renderer, bolan_dv3(0.0, 0.0, 5.0), WIDTH, HEIGHT, map, &light), BOLAN_OK);
    return light;
}

static const float *texel(double compass, double elevation) {
    const double x = fmod(compass / 360.0 + 0.5, 1.0) * WIDTH, y = (0.5 - elevation / 180.0) * HEIGHT;
    return map + 3 * ((size_t)fmin(y, HEIGHT - 1) * WIDTH + (size_t)fmin(x, WIDTH - 1));
}

static void the_brightest_sky_is_round_the_sun(void **state) {
    if (!renderer) skip_without_gl();
    (void)state;
    static const double azimuths[] = {10.0, 100.0, 235.0};
    for (int i = 0; i < 3; i++) {
        bolan_world *world = clear_world(azimuths[i], 40.0);
        const bolan_sky_light light = read_map(world);
        uint32_t best = 0;
        double sky = 0.0;
        for (uint32_t p = 0; p < WIDTH * HEIGHT / 2; p++) {
            const double elevation = BOLAN_PI * (0.5 - (p / WIDTH + 0.5) / HEIGHT);
            if (map[3 * p + 1] > map[3 * best + 1] && elevation > 0.35) best = p;
            sky += (double)map[3 * p + 1] * sin(elevation) * cos(elevation) * (BOLAN_PI / HEIGHT) *
                   (2.0 * BOLAN_PI / WIDTH);
        }
        const double compass = 360.0 * ((best % WIDTH + 0.5) / WIDTH - 0.5);
        assert_true(fabs(remainder(compass - azimuths[i], 360.0)) < 4.0);
        assert_true(fabs(180.0 * (0.5 - (best / WIDTH + 0.5) / HEIGHT) - 40.0) < 4.0);
        assert_true(fabs(sky / (double)light.sky_irradiance.y - 1.0) < 0.05);
        assert_true(light.sun_irradiance.y > 0.5f && light.sun_irradiance.y < 1.0f);
        bolan_world_destroy(&world);
    }
}

// The middle of a picture that looks there, without water.
static void views_show_the_same_sky(void **state) {
    if (!renderer) skip_without_gl();
    (void)state;
    static const double looks[][2] = {{30.0, 25.0}, {150.0, 60.0}, {280.0, 12.0}};
    static float rgb[3 * FACE * FACE];
    bolan_world *world = clear_world(200.0, 35.0);
    read_map(world);
    bolan_target *target = NULL;
    assert_int_equal(bolan_target_create(FACE, FACE, &target), BOLAN_OK);
    for (int i = 0; i < 3; i++) {
        const bolan_camera camera = {
            .position = {0.0, 0.0, 5.0}, .heading_deg = looks[i][0], .pitch_deg = looks[i][1], .fov_deg = 10.0};
        bolan_view view = bolan_view_from_camera(&camera, FACE, FACE);
        view.framebuffer = bolan_target_framebuffer(target);
        bolan_renderer_draw_world(renderer, world, &view);
        bolan_renderer_read_linear(renderer, rgb, NULL);
        const float *seen = rgb + 3 * (FACE / 2 * FACE + FACE / 2), *mapped = texel(looks[i][0], looks[i][1]);
        for (int c = 0; c < 3; c++) assert_float_equal(mapped[c] / seen[c], 1.0f, 0.04f);
    }
    bolan_target_destroy(&target);
    bolan_world_destroy(&world);
}

static int open_renderer(void **state) {
    (void)state;
    if (bolan_context_create(BOLAN_GL_CORE, &context)) return 0;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = BOLAN_QUALITY_LOW;
    return bolan_renderer_create(&desc, &renderer);
}

static int close_renderer(void **state) {
    (void)state;
    bolan_renderer_destroy(&renderer);
    bolan_context_destroy(&context);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_brightest_sky_is_round_the_sun),
        cmocka_unit_test(views_show_the_same_sky),
    };
    return cmocka_run_group_tests(tests, open_renderer, close_renderer);
}
