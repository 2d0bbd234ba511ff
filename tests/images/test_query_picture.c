// SPDX-License-Identifier: MIT
// Query and picture are the same water: where the depth buffer shows the surface, the query finds it. By the eye, far
// from the origin, and over the sand of the lagoon, where each cascade is attenuated by the depth.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "bolan/earth.h"
#include "bolan/query.h"
#include "picture.h"

enum { WIDTH = 320, HEIGHT = 180, STEP = 3 };
static const double NEAR = 40.0; // [m]

// Direction of a pixel, row 0 at the top, east north up, of length 1 along the view axis.
static bolan_dvec3 pixel_ray(const bolan_camera *c, uint32_t x, uint32_t y) {
    const bolan_mat4 to_world = bolan_m4_transpose(bolan_m4_view(c->heading_deg, c->pitch_deg, c->roll_deg));
    const double t = tan(0.5 * bolan_radians(c->fov_deg));
    const double right = (2.0 * (x + 0.5) / WIDTH - 1.0) * t * WIDTH / HEIGHT,
                 up = (1.0 - 2.0 * (y + 0.5) / HEIGHT) * t;
    const bolan_vec4 d = bolan_m4_mul_v4(to_world, (bolan_vec4){(float)right, (float)up, -1.0f, 0.0f});
    return bolan_dv3((double)d.x, (double)d.y, (double)d.z);
}

typedef struct agreement {
    uint32_t pixels, wrong; // wrong: by more than 1 cm and a pixel
    uint32_t near, near_wrong;
} agreement;

static void compare_pixel(const stage *s, double along, uint32_t x, uint32_t y, agreement *sum) {
    const bolan_camera *c = &s->scene.camera;
    const bolan_dvec3 ray = pixel_ray(c, x, y);
    const double distance = along * sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
    if (!(distance < 1000.0)) return;
    const bolan_dvec2 at = {c->position.x + ray.x * along, c->position.y + ray.y * along};
    const double level = s->scene.water.level;
    if (stage_ground(s) && (double)bolan_ground_elevation(stage_ground(s), at.x, at.y, 2.0) > level - 0.3) return;
    const double drop = (ray.x * ray.x + ray.y * ray.y) * along * along / (2.0 * BOLAN_EARTH_RADIUS);
    bolan_query_point answer;
    bolan_query_surface(bolan_world_water(s->world), &at, 1, &answer);
    const double error = fabs(c->position.z + ray.z * along + drop - (double)answer.height);
    const double pixel = distance * 2.0 * tan(0.5 * bolan_radians(c->fov_deg)) / HEIGHT;
    sum->pixels++;
    sum->wrong += error > 0.01 + pixel;
    sum->near += distance < NEAR;
    // What the mesh cuts off a crest between its vertices, 2 pixels apart, and the half floats: a quarter of a pixel,
    // and 1 cm.
    sum->near_wrong += distance < NEAR && error > 0.01 + 0.25 * pixel;
}

// trains: how many of the two wave trains around the eye are added.
static void check(const char *name, double x, double y, double z, double pitch, uint32_t trains) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load(name, &scene), BOLAN_OK);
    scene.train_count = trains;
    scene.trains[0] = scene.trains[1] = bolan_wave_train_desc_default();
    scene.trains[0].from_deg = 250.0, scene.trains[0].length = 45.0, scene.trains[0].height = 2.0;
    scene.trains[0].centre = scene.trains[1].centre = (bolan_dvec2){x, y};
    scene.trains[1].from_deg = 330.0, scene.trains[1].length = 25.0, scene.trains[1].height = 0.8;
    scene.trains[1].half_length = 90.0, scene.trains[1].half_width = 60.0;
    scene.camera.position = bolan_dv3(x, y, z);
    scene.camera.pitch_deg = pitch;
    scene.sky.cloud_cover = 0.0; // clouds are most of the time such a picture takes
    bolan_context *context = NULL;
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) skip_without_gl();
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_ULTRA, false));
    picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
    agreement sum = {0};
    for (uint32_t row = 0; row < HEIGHT; row += STEP)
        for (uint32_t column = 0; column < WIDTH; column += STEP)
            compare_pixel(&s, (double)p.distance[row * WIDTH + column], column, row, &sum);
    print_message("%s at %g, %g: %u of %u pixels differ, %u of %u near the eye\n", name, x, y, sum.wrong, sum.pixels,
                  sum.near_wrong, sum.near);
    assert_true(sum.pixels > 2000 && sum.near > 1000);
    // At a crest's outline a pixel belongs to two places.
    assert_true(sum.wrong * 500 <= sum.pixels);
    assert_true(sum.near_wrong * 50 <= sum.near);
    picture_free(&p);
    stage_close(&s);
    bolan_context_destroy(&context);
}

static void test_the_query_finds_the_surface_of_the_picture(void **state) {
    (void)state;
    check("open-sea", 0.0, 0.0, 6.0, -14.0, 0);
}

static void test_and_a_thousand_kilometres_from_the_origin(void **state) {
    (void)state;
    check("open-sea", 1e6, -7e5, 6.0, -14.0, 0);
}

static void test_and_over_the_sand_of_the_lagoon(void **state) {
    (void)state;
    check("island", -1500.0, -1500.0, 10.0, -14.0, 0);
}

static void test_and_with_wave_trains(void **state) {
    (void)state;
    check("open-sea", 1e6, -7e5, 6.0, -14.0, 2);
    check("island", -1500.0, -1500.0, 10.0, -14.0, 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_query_finds_the_surface_of_the_picture),
        cmocka_unit_test(test_and_a_thousand_kilometres_from_the_origin),
        cmocka_unit_test(test_and_over_the_sand_of_the_lagoon),
        cmocka_unit_test(test_and_with_wave_trains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
