// SPDX-License-Identifier: MIT
// From far away the mesh of the sea bed departs from the ground by more than the water is deep. The colour of the
// shallows must follow the ground all the same: water that gets shallower brightens, without rings.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "picture.h"

enum { CELLS = 61, WIDTH = 160, HEIGHT = 120 };
#define STEP 175.0 // [m]

// An island 40 m high and 3 km wide on a shelf that falls as beaches do, with distance^(2/3) (Dean 1977).
static bolan_ground *island_on_a_shelf(void) {
    static float heights[CELLS * CELLS];
    for (int n = 0; n < CELLS * CELLS; n++) {
        const double r = STEP * hypot(n % CELLS - CELLS / 2, n / CELLS - CELLS / 2) - 1500.0;
        heights[n] = (float)(r < 0.0 ? 40.0 * fmin(1.0, -r / 300.0) : -0.12 * pow(r, 2.0 / 3.0));
    }
    bolan_ground_desc d = bolan_ground_desc_default();
    const double corner = -STEP * (CELLS / 2);
    d.field = (bolan_heightfield){CELLS, CELLS, corner, corner, STEP, STEP, heights};
    d.detail = 0.0;
    d.edge_elevation = -40.0;
    bolan_ground *terrain = NULL;
    assert_int_equal(bolan_ground_create(&d, &terrain), BOLAN_OK);
    return terrain;
}

static void shallows_brighten_towards_the_beach(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene = bolan_scene_default();
    bolan_scene_set_wind(&scene, 3.0, 60.0);
    scene.sky.cloud_cover = 0.0;
    scene.sky.sun_azimuth_deg = 180.0;
    scene.sky.sun_elevation_deg = 50.0;
    scene.camera = (bolan_camera){.position = {0.0, -4200.0, 700.0}, .pitch_deg = -14.0, .fov_deg = 60.0};
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_MEDIUM, false));
    bolan_world_destroy(&s.world);
    bolan_world_assets assets = {.ground = island_on_a_shelf()};
    assert_int_equal(bolan_world_create(&(bolan_world_desc){&scene, &assets}, &s.world), BOLAN_OK);
    stage_settle(&s, scene.time);
    picture p = stage_draw(&s, WIDTH, HEIGHT, 4);
    static float rgb[WIDTH * HEIGHT * 3];
    bolan_renderer_read_linear(s.renderer, rgb, NULL);
    // Rows of the middle columns from the lower edge up to the beach at 1500 m. Green, which water takes least but for
    // blue.
    const double half = tan(bolan_radians(30.0));
    double brightest = 0.0;
    int rows = 0;
    for (int y = HEIGHT - 1; y >= 0; y--) {
        const double down = atan((2.0 * (y + 0.5) / HEIGHT - 1.0) * half) + bolan_radians(14.0);
        if (down <= 0.0 || 4200.0 - 700.0 / tan(down) < 1560.0) break;
        double green = 0.0;
        for (int x = WIDTH / 2 - 20; x < WIDTH / 2 + 20; x++) green += (double)rgb[3 * (y * WIDTH + x) + 1] / 40.0;
        // Patches of weed on the bed make rows of 40 pixels differ by some per cent.
        if (green < 0.85 * brightest) fail_msg("row %d has %.4f, a deeper one %.4f", y, green, brightest);
        brightest = fmax(brightest, green);
        rows++;
    }
    assert_true(rows > 25);
    picture_free(&p);
    stage_close(&s);
    bolan_context_destroy(&context);
}

// Mean difference of neighbours down the image over that of neighbours along it, of rows from..to - 1 from the top.
static double upright_contrast(const picture *p, uint32_t from, uint32_t to) {
    double down = 0.0, along = 0.0;
    for (uint32_t y = from; y + 1 < to; ++y)
        for (uint32_t x = 0; x + 1 < p->width; ++x) {
            const int here = p->rgb[3 * (y * p->width + x) + 1];
            down += abs(p->rgb[3 * ((y + 1) * p->width + x) + 1] - here);
            along += abs(p->rgb[3 * (y * p->width + x + 1) + 1] - here);
        }
    return down / along;
}

// Under the lower edge of the image lies bed that it lacks, and that its lowest rows show through the water.
static void the_bed_goes_on_beyond_the_image(void **state) {
    (void)state;
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    scene.technique.optics = BOLAN_OPTICS_PHYSICAL;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_MEDIUM, false));
    stage_settle(&s, scene.time);
    picture p = stage_draw(&s, 240, 160, 1);
    const double low = upright_contrast(&p, 152, 160), higher = upright_contrast(&p, 120, 145);
    print_message("contrast down over along: %.2f at the lower edge, %.2f over it\n", low, higher);
    // Waves have some of it. With one row of the bed drawn out over the lowest the quotient is 0.57, as it is now 0.90.
    assert_true(low > 0.75 * higher);
    picture_free(&p);
    stage_close(&s);
    bolan_context_destroy(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(shallows_brighten_towards_the_beach),
                                       cmocka_unit_test(the_bed_goes_on_beyond_the_image)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
