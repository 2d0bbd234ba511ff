// SPDX-License-Identifier: MIT
// The land in the water: a mirror's picture in glass, by Fresnel's law; the same light in a breeze at every quality.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "bolan/optics.h"
#include "picture.h"

enum { CELLS = 61, WIDTH = 160, HEIGHT = 120, FROM = 50, TO = 110 };
#define STEP 100.0 // [m]
#define EYE 1.0    // [m]
#define FOV 40.0   // [degrees]

// A round hill 400 m high, its foot 1.3 km north of the eye, in deep water.
static bolan_ground *hill(void) {
    static float heights[CELLS * CELLS];
    for (int n = 0; n < CELLS * CELLS; n++) {
        const double r = STEP * hypot(n % CELLS - CELLS / 2, n / CELLS - CELLS / 2) / 1200.0;
        heights[n] = (float)(r < 1.0 ? 400.0 * (1.0 - r * r) : -200.0 * (r - 1.0) - 20.0);
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    const double corner = -STEP * (CELLS / 2);
    d.field = (bolan_heightfield){CELLS, CELLS, corner, corner + 2500.0, STEP, STEP, heights};
    d.detail = 0.0;
    d.edge_elevation = -200.0;
    bolan_ground *ground = NULL;
    assert_int_equal(bolan_ground_create(&d, &ground), BOLAN_OK);
    return ground;
}

static void draw(stage *s, double wind, bolan_quality quality, float *rgb, float *distance) {
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, wind, 180.0);
    scene.sea.sea_state.system_count = 0;
    scene.look.effects = BOLAN_EFFECT_REFLECTION;
    scene.sky =
        (bolan_sky){.sun_azimuth_deg = 180.0, .sun_elevation_deg = 40.0, .visibility = 300e3, .cloud_base = 1200};
    scene.camera = (bolan_camera){.position = {0.0, 0.0, EYE}, .fov_deg = FOV};
    assert_true(stage_open(s, &scene, quality, false));
    bolan_world_destroy(&s->world);
    bolan_world_assets assets = {.ground = hill()};
    assert_int_equal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &s->world), BOLAN_OK);
    stage_settle(s, 0.0);
    picture p = stage_draw(s, WIDTH, HEIGHT, quality == BOLAN_QUALITY_HIGH ? 4 : 1);
    bolan_renderer_read_linear(s->renderer, rgb, distance);
    picture_free(&p);
    stage_close(s);
}

static double row_mean(const float *rgb, int row, int channel) {
    double sum = 0.0;
    for (int x = FROM; x < TO; x++) sum += (double)rgb[3 * (row * WIDTH + x) + channel] / (TO - FROM);
    return sum;
}

static double row_angle(int below) { return atan((below + 0.5) / (HEIGHT / 2) * tan(bolan_radians(FOV / 2))); }

static void glass_mirrors_the_land(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    for (bolan_quality quality = BOLAN_QUALITY_MEDIUM; quality <= BOLAN_QUALITY_HIGH; quality++) {
        static float rgb[WIDTH * HEIGHT * 3], distance[WIDTH * HEIGHT];
        stage s;
        draw(&s, 0.0, quality, rgb, distance);
        // The hill is 9 degrees high; rows 5..22 mirror it.
        int rows = 0;
        for (int row = 5; row < 23; row++) {
            const int water = HEIGHT / 2 + row, land = HEIGHT / 2 - 1 - row;
            bool all = true; // of the row above is land
            for (int x = FROM; x < TO; x++) all = all && isfinite(distance[land * WIDTH + x]);
            if (!all) continue;
            const double fresnel = (double)bolan_fresnel((float)sin(row_angle(row)), 1.34f);
            for (int c = 0; c < 2; c++) { // the air before the water adds a tenth to the little blue of the hill
                const double want = fresnel * row_mean(rgb, land, c), got = row_mean(rgb, water, c);
                // the eye's metre is a twentieth of a degree at the hill, and a row of the hill differs from the next
                // by some percent
                if (fabs(got / want - 1.0) > 0.08)
                    fail_msg("quality %d, row %d, channel %d: %.5f instead of %.5f", quality, row, c, got, want);
            }
            rows++;
        }
        assert_true(rows >= 12);
    }
    bolan_context_destroy(&context);
}

// One lobe with three texture fetches, or three with three each: the same light, and no row stands out from its
// neighbours as the outline of a hill does in glass.
static void a_breeze_blurs_the_land_alike_at_every_quality(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    static float medium[WIDTH * HEIGHT * 3], high[WIDTH * HEIGHT * 3], distance[WIDTH * HEIGHT];
    stage s;
    draw(&s, 5.0, BOLAN_QUALITY_MEDIUM, medium, distance);
    draw(&s, 5.0, BOLAN_QUALITY_HIGH, high, distance);
    for (int row = HEIGHT / 2 + 3; row < HEIGHT / 2 + 30; row++)
        for (int c = 0; c < 3; c++) {
            const double a = row_mean(medium, row, c), b = row_mean(high, row, c);
            if (fabs(a / b - 1.0) > 0.12) fail_msg("row %d, channel %d: %.5f at medium, %.5f at high", row, c, a, b);
        }
    bolan_context_destroy(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(glass_mirrors_the_land),
                                       cmocka_unit_test(a_breeze_blurs_the_land_alike_at_every_quality)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
