// SPDX-License-Identifier: MIT
// Tiles baked from a sea: normal maps as Ma, Zhu & Gong 2006 print them, and the light on the bottom against energy and
// optics.
#include "bolan/tiles.h"
#include "sea_support.h"

#include <math.h>
#include <string.h>

enum { N = 128 };
static float height[N * N], light[N * N];

static void sine(double amplitude, double length, double side) {
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++)
            height[j * N + i] = (float)(amplitude * cos(2.0 * BOLAN_PI * i * side / N / length));
}

static void normals_are_the_printed_cross_product(void **state) {
    (void)state;
    uint8_t rgb[8 * 8 * 3];
    float h[64] = {0};
    h[3 * 8 + 4] = 0.75f; // one texel stands out; texels of 1
    bolan_tile_normals(h, 8, 1.0, rgb);
    const uint8_t *west = rgb + 3 * (3 * 8 + 3), *south = rgb + 3 * (2 * 8 + 4), *top = rgb + 3 * (3 * 8 + 4);
    // (-0.75, 0, 1) / 1.25 = (-0.6, 0, 0.8): bytes 127.5 (1 + x), rounded
    assert_int_equal(west[0], 51);
    assert_int_equal(west[1], 128);
    assert_int_equal(west[2], 230);
    assert_int_equal(south[1], 51);
    assert_int_equal(top[2], 255);      // both its neighbours are alike: flat
    bolan_tile_normals(h, 8, 0.5, rgb); // the true slope: 0.375
    assert_int_equal(west[0], 83);      // 127.5 (1 - 0.375 / sqrt(1 + 0.375^2)) = 82.73
}

static double mean_light(void) {
    double sum = 0.0;
    for (int i = 0; i < N * N; i++) sum += (double)light[i];
    return sum / (N * N);
}

static void no_light_is_lost_on_the_way_to_the_bottom(void **state) {
    (void)state;
    const float s = sqrtf(0.5f);
    const bolan_vec3 suns[] = {{0.0f, 0.0f, 1.0f}, {s, 0.0f, s}, {-0.3f, 0.8f, 0.52f}};
    sine(0.05, 2.0, 8.0);
    for (int i = 0; i < 3; i++)
        for (double depth = 0.5; depth < 40.0; depth *= 3.0) {
            bolan_tile_caustics(height, N, 8.0, depth, bolan_v3_normalize(suns[i]), 1.333, light);
            assert_near(mean_light(), 1.0, 0.02); // the acceptance number; float sums cost 1e-5
        }
}

static void flat_water_lights_the_bottom_evenly(void **state) {
    (void)state;
    memset(height, 0, sizeof height);
    bolan_tile_caustics(height, N, 8.0, 3.0, bolan_v3_normalize(bolan_v3(0.4f, 0.2f, 0.8f)), 1.34, light);
    for (int i = 0; i < N * N; i++) assert_near(light[i], 1.0, 0.01); // rounding of landing places on texel centres
}

static double crest_light(double depth) {
    bolan_tile_caustics(height, N, 2.0, depth, bolan_v3(0.0f, 0.0f, 1.0f), 1.333, light);
    return (double)light[N / 2 * N]; // under the crest at i = 0
}

static void a_sine_gathers_light_at_its_first_focus(void **state) {
    (void)state;
    sine(0.05, 2.0, 2.0);
    // On the axis the light is 1 / |1 - (depth + a) / f|, f = n / ((n - 1) a k^2) = 8.112: the same in amplitude at
    // both sides of the focus. Far from it the raster does not matter, so the focus is found from there.
    for (double depth = 2.0; depth < 6.5; depth += 1.0)
        assert_near((depth + 0.05) / (1.0 - 1.0 / crest_light(depth)), 8.112, 0.05 * 8.112); // the acceptance number
    double best = 0.0, most = 0.0;
    for (double depth = 5.0; depth < 12.0; depth += 0.05) {
        const double l = crest_light(depth);
        if (l > most) most = l, best = depth;
    }
    // the brightest texel: beyond the focus, too, rays from either side cross within a texel's width
    assert_true(best > 0.95 * 8.062 && best < 1.1 * 8.062);
    assert_true(most > 8.0);
}

// The same waves along y, lit by the sun turned with them, give the same light turned.
static void light_on_the_bottom_turns_with_the_waves(void **state) {
    (void)state;
    static float turned[N * N], expected[N * N];
    const bolan_vec3 sun = bolan_v3_normalize(bolan_v3(0.5f, 0.2f, 0.8f)), turned_sun = {sun.y, sun.x, sun.z};
    sine(0.05, 2.0, 2.0);
    bolan_tile_caustics(height, N, 2.0, 3.0, sun, 1.333, light);
    memcpy(expected, light, sizeof light);
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) turned[j * N + i] = height[i * N + j];
    bolan_tile_caustics(turned, N, 2.0, 3.0, turned_sun, 1.333, light);
    double contrast = 0.0;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            assert_near(light[j * N + i], expected[i * N + j], 0.01); // rounding of landing places
            contrast = fmax(contrast, fabs((double)light[j * N + i] - 1.0));
        }
    assert_true(contrast > 0.3);
}

static bolan_sea *textures_sea(void) {
    bolan_sea_desc d = bolan_sea_desc_default();
    d.waves = BOLAN_WAVES_TEXTURES;
    d.sea_state = bolan_sea_state_from_wind(5.0, 240.0, 5e3);
    d.resolution = 64;
    d.textures.frames = 4;
    bolan_sea *sea = NULL;
    assert_int_equal(bolan_sea_create(&d, &sea), BOLAN_OK);
    return sea;
}

static void tiles_are_the_frames_of_the_sea(void **state) {
    (void)state;
    bolan_sea *sea = textures_sea();
    bolan_tiles *tiles = NULL;
    const bolan_tiles_desc desc = bolan_tiles_desc_default();
    bolan_sea_step(sea, 3.0);
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_OK);
    assert_near(bolan_sea_time(sea), 3.0, 0.0);
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    assert_int_equal(v.n, 64);
    assert_int_equal(v.frames, 4);
    for (double time = 0.1; time < 2.0 * v.period; time += 0.13 * v.period) {
        bolan_sea_step(sea, time);
        const uint32_t frame = bolan_tiles_frame(tiles, time, NULL);
        assert_int_equal(frame, bolan_sea_get_loop(sea).frame);
        static float nodes[64 * 64];
        const bolan_cascade_view shown = bolan_sea_cascade(sea, 0);
        test_nodes(&shown, nodes);
        for (int i = 0; i < 64 * 64; i++) assert_near(v.height[frame * 64 * 64 + i], nodes[i], 1e-5);
    }
    double slopes[2] = {0};
    const bolan_cascade_view c = bolan_sea_cascade(sea, 0);
    const uint32_t frame = bolan_sea_get_loop(sea).frame;
    for (uint32_t i = 0; i < 64 * 64;
         i++) { // the map's slopes are the sea's, less what a difference of two texels smooths
        const uint8_t *n = v.normal + 3 * (frame * 64 * 64 + i);
        const double s = -(n[0] - 127.5) / (n[2] - 127.5);
        slopes[0] += s * s, slopes[1] += (double)(c.slope_x[i] * c.slope_x[i]);
    }
    assert_true(slopes[0] < 1.05 * slopes[1] &&
                slopes[0] > 0.35 * slopes[1]); // 127 steps, and sin(k d)/(k d) of short waves
    bolan_tiles_destroy(&tiles);
    assert_null(tiles);
    bolan_sea_destroy(&sea);
}

static void bad_descriptions_are_refused_by_name(void **state) {
    (void)state;
    bolan_sea *sea = textures_sea();
    bolan_tiles *tiles = NULL;
    bolan_tiles_desc desc = bolan_tiles_desc_default();
    desc.depth = NAN;
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_ERROR_ARGUMENT);
    assert_null(tiles);
    desc = bolan_tiles_desc_default();
    desc.sun = bolan_v3(0.0f, 0.0f, -1.0f);
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_ERROR_ARGUMENT);
    bolan_sea_destroy(&sea);
    bolan_sea_desc fft = bolan_sea_desc_default();
    fft.resolution = 32;
    assert_int_equal(bolan_sea_create(&fft, &sea), BOLAN_OK);
    desc = bolan_tiles_desc_default();
    assert_int_equal(bolan_tiles_bake(sea, &desc, &tiles), BOLAN_ERROR_ARGUMENT);
    bolan_sea_destroy(&sea);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_the_printed_cross_product),
        cmocka_unit_test(no_light_is_lost_on_the_way_to_the_bottom),
        cmocka_unit_test(flat_water_lights_the_bottom_evenly),
        cmocka_unit_test(light_on_the_bottom_turns_with_the_waves),
        cmocka_unit_test(a_sine_gathers_light_at_its_first_focus),
        cmocka_unit_test(tiles_are_the_frames_of_the_sea),
        cmocka_unit_test(bad_descriptions_are_refused_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
