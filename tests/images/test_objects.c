// SPDX-License-Identifier: MIT
// The pond and its things in whole pictures.
#include "picture.h"

#include "../shaders/gl_support.h"

enum { WIDTH = 192, HEIGHT = 108 };

// The scene with the default water, whose pictures the other tests know.
static bolan_scene pond(void) {
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    bolan_scene_set_technique(&scene, &bolan_technique_ocean);
    return scene;
}

static void the_scene_is_the_paper_s_size(void **state) {
    (void)state;
    const bolan_scene scene = pond();
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
    const bolan_frame_statistics statistics = bolan_renderer_statistics(s.renderer);
    assert_int_equal(statistics.triangles - statistics.water_triangles, 13912); // Ma, Zhu & Gong 2006, table 2
    picture_free(&p);
    stage_close(&s);
}

// At this distance [m] along the view axis something stands in the pixel.
static float distance_at(const picture *p, double x, double y) {
    return p->distance[(size_t)(y * HEIGHT) * WIDTH + (size_t)(x * WIDTH)];
}

static void house_and_meadow_stand_where_the_scene_puts_them(void **state) {
    (void)state;
    bolan_scene scene = pond();
    scene.camera = (bolan_camera){.position = {9.0, 20.0, 2.5}, .fov_deg = 40.0}; // before the house, at (9, 42)
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    picture p = stage_draw(&s, WIDTH, HEIGHT, 1);
    // Its front wall is 3.5 m this side of its middle; it is turned by 12 degrees, and has a step.
    assert_true(fabs((double)distance_at(&p, 0.5, 0.5) - 18.4) < 1.0);
    assert_true(distance_at(&p, 0.5, 0.02) > 40.0f); // above the ridge the wood or the sky
    picture_free(&p);
    stage_close(&s);
}

static void without_objects_the_terrain_is_drawn(void **state) {
    (void)state;
    bolan_scene scene = pond();
    scene.object_count = 0;
    scene.camera.pitch_deg = -30.0;
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    picture without = stage_draw(&s, WIDTH, HEIGHT, 1);
    const bolan_frame_statistics statistics = bolan_renderer_statistics(s.renderer);
    assert_true(statistics.triangles > statistics.water_triangles);
    picture_free(&without);
    stage_close(&s);
}

static void frames_with_objects_allocate_nothing(void **state) {
    (void)state;
    const bolan_scene scene = pond();
    stage s;
    assert_true(stage_open(&s, &scene, BOLAN_QUALITY_LOW, false));
    picture first = stage_draw(&s, WIDTH, HEIGHT, 1), second = stage_draw(&s, WIDTH, HEIGHT, 1);
    const size_t before = bolan_memory_in_use();
    picture third = stage_draw(&s, WIDTH, HEIGHT, 1);
    assert_int_equal(bolan_memory_in_use(), before);
    assert_memory_equal(second.rgb, third.rgb, (size_t)WIDTH * HEIGHT * 3);
    picture_free(&first), picture_free(&second), picture_free(&third);
    stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_scene_is_the_paper_s_size),
        IN_BOTH_APIS(house_and_meadow_stand_where_the_scene_puts_them),
        IN_BOTH_APIS(without_objects_the_terrain_is_drawn),
        IN_BOTH_APIS(frames_with_objects_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
